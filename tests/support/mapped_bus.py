"""A bus that is mapped into memory: a file that a test and a link share."""

from __future__ import annotations

import itertools
import mmap
from collections.abc import MutableMapping
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, cast

import unity_link
from unity_link import GatewayInfo

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator
    from pathlib import Path

    from support.makers import Maker
    from unity_link.virtual import BareGateway
    from unity_link.virtual.bus import Device

FAILS = "mapped memory does not refuse an access: the system ends the program"
CONFIGURATION = "mapped memory has no configuration"
EMPTY = {
    "test_a_long_block_is_split_at_the_gateways_limit": CONFIGURATION,
    "test_an_error_in_a_batch_is_raised_and_the_others_are_done": FAILS,
    "test_a_refused_access_raises_and_names_the_request": FAILS,
    "test_an_address_without_a_slave_raises_its_own_error": FAILS,
    "test_the_words_of_a_block_before_its_error_are_written": FAILS,
    "test_a_fence_raises_the_first_error_of_posts_and_counts_the_others": FAILS,
    "test_one_failed_posted_write_needs_no_note": FAILS,
    "test_errors_of_posted_writes_without_a_fence_take_no_memory": FAILS,
    "test_a_request_for_a_missing_feature_raises_and_is_not_sent": CONFIGURATION,
    "test_a_link_has_the_configuration_of_its_gateway": CONFIGURATION,
    "test_statistics_count_requests_bytes_and_errors": FAILS,
    "test_a_range_error_of_the_gateway_is_an_error_of_its_own": "nothing is sent that could be out of range",
    "test_a_subscription_returns_the_words_of_its_addresses": "a timer of the host is not exact: test_mapped.py",
    "test_all_groups_can_be_in_use_and_are_free_again_afterwards": CONFIGURATION,
    "test_the_error_for_a_missing_feature_names_it": CONFIGURATION,
    "test_timestamps_are_used_if_the_gateway_has_them": CONFIGURATION,
}
"""Tests of guarantees that a mapped bus does not give, and the reasons."""
_connect = unity_link.connect


class _Words(MutableMapping[int, int]):
    """The words of a file, by address."""

    def __init__(self, path: Path) -> None:
        with path.open("r+b") as file:
            self._words = memoryview(mmap.mmap(file.fileno(), 0)).cast("I")

    def __getitem__(self, address: int) -> int:
        return self._words[address]

    def __setitem__(self, address: int, value: int) -> None:
        self._words[address] = value

    def __delitem__(self, address: int) -> None:
        raise NotImplementedError

    def __iter__(self) -> Iterator[int]:
        return iter(range(len(self._words)))

    def __len__(self) -> int:
        return len(self._words)


class FileGateway:
    """A mapped bus of 256 words as the test accesses it, with the methods of a gateway."""

    def __init__(self, path: Path) -> None:
        path.write_bytes(bytes(1024))
        self.url = f"mmio:{path}?base_frequency_millihertz=100000000"
        self.info = GatewayInfo()
        self.memory = _Words(path)

    def attach(self, device: Device, addresses: Iterable[int]) -> None:
        """Do nothing: tests that need a device are not run on a mapped bus."""

    def detach(self, addresses: Iterable[int]) -> None:
        """Do nothing."""


@contextmanager
def mapped_files(folder: Path) -> Iterator[tuple[Maker, Callable[..., Any]]]:
    """Yield a factory of mapped buses, and a substitute for `unity_link.connect`."""
    numbers = itertools.count()

    def make(**_: int) -> BareGateway:
        return cast("BareGateway", FileGateway(folder / f"bus{next(numbers)}"))

    def connect(target: Any, **options: Any) -> Any:
        return _connect(target.url if isinstance(target, FileGateway) else target, **options)

    yield make, connect
