"""A batch of many messages, and its outcome if the gateway refuses some of them."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest

from unity_link.errors import BusError
from unity_link.protocol.host.batches import WordBatch
from unity_link.protocol.host.host_codec import HostCodec
from unity_link.protocol.wire.configuration import GatewayInfo

if TYPE_CHECKING:
    from unity_link.protocol.host.events import Events

CODEC = HostCodec(GatewayInfo())


@pytest.mark.parametrize("refused", [(4, 3), (3, 4)], ids=["the later first", "in order"])
def test_a_batch_reports_the_error_of_its_first_refused_message(
    refused: tuple[int, int],
) -> None:
    batch = WordBatch(CODEC, "R", [(np.arange(8), CODEC.info.address_digits)])
    ended: Events = []
    before, behind = batch.take(3, ended), batch.take(5, ended)
    for offset in range(3):
        assert before.accept(offset, b"r00000000007", 4, ended)
    for place in refused:
        behind.fail_part(place - 3, 1, BusError(str(place), 4), ended)
    for offset in range(2, 5):
        assert behind.accept(offset, b"r00000000007", 4, ended)
    assert ended == [batch]
    assert str(batch.error) == "3"


def test_a_retransmitted_part_has_the_frames_of_that_part() -> None:
    batch = WordBatch(CODEC, "R", [(np.arange(30), CODEC.info.address_digits)])
    run = batch.take(30, [])
    frames = run.encode().splitlines(keepends=True)
    assert run.frames_of(7, 20) == b"".join(frames[7:27])
