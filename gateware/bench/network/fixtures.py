"""Fixtures for tests with the kernel's own network stack, for modules that name this one in `pytest_plugins`.

The test IDs contain the kind of line on this machine: "tap", or "veth" if it has no TAP devices.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from gateware.bench.network.tap import LINE, own_network, plugged

if TYPE_CHECKING:
    from collections.abc import Iterator

    from gateware.bench.network.tap import Plugged


@pytest.fixture(params=[LINE])
def network() -> Iterator[None]:
    """Move this thread into a network namespace of its own."""
    with own_network():
        yield


@pytest.fixture(params=[LINE])
def gateway() -> Iterator[Plugged]:
    """Return a gateway with RMII that is connected to the kernel's stack in this thread's namespace."""
    with own_network(), plugged() as gateway:
        yield gateway
