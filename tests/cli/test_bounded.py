"""A call in its own process is ended at its limits of time and memory, however much its parent has used."""

from __future__ import annotations

import itertools
import mmap

import pytest

from unity_link.cli.bounded import TooMuchError, call_bounded
from unity_link.errors import ArgumentError

GIB = 1 << 30


def test_memory_that_this_process_has_is_not_counted() -> None:
    with mmap.mmap(-1, 5 * GIB):
        assert call_bounded(lambda: len(bytes(GIB // 2)), "it", 60) == GIB // 2
        with pytest.raises(TooMuchError, match=r"^it takes more than 2 GiB of memory$"):
            call_bounded(lambda: len(bytes(3 * GIB)), "it", 60)


@pytest.mark.slow
def test_call_beyond_its_time_is_ended() -> None:
    with pytest.raises(TooMuchError, match=r"^it takes more than 1 s of processor time; `--seconds` gives it more$"):
        call_bounded(lambda: sum(itertools.repeat(0)), "it", 1)


def test_error_of_a_bounded_call_is_raised() -> None:
    def fail() -> None:
        raise ArgumentError("this is wrong")

    with pytest.raises(ArgumentError, match=r"^this is wrong$"):
        call_bounded(fail, "it", 60)
