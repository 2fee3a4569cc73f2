"""Velocities of joints get a sign if the gateway has only their magnitude."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import unity_link
from support.simulated_time import on_simulated_time
from unity_link.bridges.topics import VelocitySigns, published_groups

SCARA = unity_link.load(Path(__file__).parents[2] / "examples" / "scara.ul")
NUMBERS = st.integers(-2, 2).map(float)


@given(rows=st.lists(st.tuples(NUMBERS, NUMBERS), min_size=1, max_size=12), cut=st.integers(1, 12))
def test_velocity_has_the_sign_of_the_last_move_however_batches_are_cut(
    rows: list[tuple[float, float]], cut: int
) -> None:
    positions = np.array(rows)
    direction = VelocitySigns([1])
    parts = [part for part in (positions[:cut], positions[cut:]) if len(part)]
    signed = np.concatenate([direction.signed(part, np.full((len(part), 2), 3.0)) for part in parts])
    sign, expected = 1.0, []
    for before, (_, position) in zip([rows[0], *rows], rows, strict=False):
        sign = math.copysign(1, position - before[1]) if position != before[1] else sign
        expected.append([3.0, 3.0 * sign])
    assert signed.tolist() == expected


@on_simulated_time
async def test_the_states_of_a_scara_that_moves_back_have_negative_velocities() -> None:
    async with unity_link.connect("sim:scara") as link:
        robot = SCARA(link)
        (published,) = published_groups(robot)
        assert published.joints is not None
        await robot.j1.pos_sp.set(-30)
        await robot.j3.pos_sp.set(100)
        seen = []
        async with published.group.subscribe() as samples:
            at = 0.0
            while abs(at + 30) > 0.01:
                batch = await samples.take()
                seen.append(published.joints.columns(batch))
                at = batch[robot.j1.cpos][-1]
    positions, velocities = (np.concatenate([part[name] for part in seen]) for name in ("position", "velocity"))
    moving = np.abs(velocities) > 0.01
    assert (velocities[:, 0][moving[:, 0]] < 0).mean() > 0.99
    assert (velocities[:, 2][moving[:, 2]] > 0).all()
    # In radians per second, from the positions: the group has a thousand samples a second.
    assert velocities[:, 0].min() == pytest.approx(np.diff(positions[:, 0]).min() * 1000, rel=0.1)
