"""Nodes of one port, each served at its own address."""

from __future__ import annotations

import asyncio
from contextlib import AsyncExitStack
from typing import TYPE_CHECKING

import numpy as np
import pytest

import unity_link
from unity_link.bridges.serve import serve
from unity_link.cli.serve import _places
from unity_link.errors import ArgumentError
from unity_link.virtual.build import compiled_node
from unity_link.virtual.rtl import configurations
from unity_link.virtual.serving import serve_pty
from unity_link.virtual.shared_line import SharedLine, build_shared_line

if TYPE_CHECKING:
    from pathlib import Path

NODES = (1, 2, 5, 0xFE)


def test_clients_of_four_nodes_have_each_their_own_groups(tmp_path: Path) -> None:
    asyncio.run(_clients_of_four_nodes(tmp_path, build_shared_line(NODES, 2_000_000)))


@pytest.mark.campaign
@pytest.mark.rtl
def test_clients_of_four_compiled_nodes_have_each_their_own_groups(tmp_path: Path) -> None:
    info = configurations()["default"].info
    asyncio.run(_clients_of_four_nodes(tmp_path, build_shared_line(NODES, 2_000_000, info, build=compiled_node)))


async def _clients_of_four_nodes(folder: Path, line: SharedLine) -> None:
    async with AsyncExitStack() as stack:
        port = await stack.enter_async_context(serve_pty(line))
        for node in NODES:
            url = f"{port}?baud=2000000&node={node}"
            await stack.enter_async_context(serve(url, unix=folder / f"{node}.sock"))

        async def use(node: int, first: int) -> None:
            async with unity_link.connect(f"unix:{folder}/{node}.sock") as link:
                addresses = np.arange(first, first + 20)
                await asyncio.gather(link.write_many(addresses, addresses + node), link.post(first + 30, node))
                assert list(await link.read_many(addresses)) == list(addresses + node)
                assert list(await link.read_block(first, 20)) == list(addresses + node)
                async with link.subscribe([first]) as samples:
                    await samples.publish()
                    assert (await anext(samples)).values[0] == first + node
                await link.fence()
                assert await link.read(first + 30) == node

        await asyncio.gather(*[use(node, first) for node in NODES for first in (0, 0x80)])


def test_each_node_has_its_own_socket_and_port(tmp_path: Path) -> None:
    unix = tmp_path / "robot.sock"
    assert _places("serial:/dev/ttyS9?baud=9600", [5, 7], unix, 7001) == [
        (5, "serial:/dev/ttyS9?baud=9600&node=5", tmp_path / "robot-5.sock", 7001),
        (7, "serial:/dev/ttyS9?baud=9600&node=7", tmp_path / "robot-7.sock", 7002),
    ]
    assert [port for *_, port in _places("serial:/dev/ttyS9", [5, 7], None, 0)] == [0, 0]
    assert _places("serial:/dev/ttyS9?node=5", [], unix, None) == [(None, "serial:/dev/ttyS9?node=5", unix, None)]
    with pytest.raises(ArgumentError, match=r"leave node= out"):
        _places("serial:/dev/ttyS9?node=5", [6], unix, None)
    with pytest.raises(ArgumentError, match="twice"):
        _places("serial:/dev/ttyS9", [6, 6], unix, None)
