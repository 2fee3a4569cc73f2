"""The walking robot walks with the gateware as with the model, on simulated time."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

from support.by_path import imported
from support.simulated_time import run_simulated

if TYPE_CHECKING:
    from types import ModuleType

PATH = Path(__file__).parents[2] / "examples" / "walker.py"
CLOSE = 0.05
"""Largest difference of an angle, in radians."""


@pytest.fixture
def example(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    module = imported(PATH)
    monkeypatch.setattr(module, "STEPS", 1)
    return module


def gait(example: ModuleType, url: str) -> tuple[Any, Any]:
    """Walk; return the instants of the samples relative to the first one, and the positions of all joints."""
    batches = run_simulated(example.walk(url)).batches
    positions = [signal for signal in batches[0].proxies if signal.path.endswith(".cpos")]
    times = np.concatenate([batch.time for batch in batches])
    lost = sum(int(batch.lost.sum()) for batch in batches)
    assert lost == 0
    return times - times[0], np.concatenate([np.stack([batch[one] for one in positions], 1) for batch in batches])


@pytest.mark.rtl
def test_the_gait_on_the_gateware_equals_that_on_the_model_without_a_loss(example: ModuleType) -> None:
    times, angles = gait(example, "sim:walker")
    rtl_times, rtl_angles = gait(example, "rtl:walker")
    assert angles.shape[1] == rtl_angles.shape[1] == 18
    # 1000 samples per second for 0.8 s, except for the beginning.
    assert min(len(times), len(rtl_times)) > 780
    assert np.diff(rtl_times) == pytest.approx(0.001)
    expected = np.stack([np.interp(rtl_times, times, column) for column in angles.T], 1)
    assert np.abs(expected - rtl_angles).max() < CLOSE
    assert np.ptp(rtl_angles, 0).max() > 0.5
