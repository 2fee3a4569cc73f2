"""Fixtures of tests at the kernel's own network stack, for modules that name this one in `pytest_plugins`.

The names of their tests have the line that this machine gives: "tap", or "veth" where it has no TAP devices.
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
    """Return a gateway with RMII at the stack of the kernel, in whose namespace this thread is."""
    with own_network(), plugged() as gateway:
        yield gateway
