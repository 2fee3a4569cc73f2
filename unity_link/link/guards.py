"""Addresses of a link that a program writes under a lease, and what checks that the program still has the lease.

A write to such an address ends with the session in which it was asked for. If it waited for the next session, it could
act under a lease that another program has armed there.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from collections.abc import Iterable

    from unity_link.errors import NotArmedError


class Guard(Protocol):
    """A lease, as a link knows it."""

    def refusal(self, address: int) -> NotArmedError | None:
        """Return the error for a write under a lease that the program has no more; None while it may have it."""


class Guarded(Protocol):
    """A link, as this module knows it."""

    _guards: dict[int, Guard]
    """The lease under which the program writes to each address."""


def guard(link: Guarded, addresses: Iterable[int], by: Guard) -> None:
    """Refuse writes to addresses of a link once a lease is over."""
    link._guards.update(dict.fromkeys(addresses, by))  # noqa: SLF001  (the same package)


def release(link: Guarded, by: Guard) -> None:
    """Refuse no writes for a lease any more."""
    guards = link._guards  # noqa: SLF001  (the same package)
    for address in [address for address, other in guards.items() if other is by]:
        del guards[address]


def guard_of(link: Guarded, address: int) -> Guard | None:
    """Return the lease under which a program writes to an address; None if it has none."""
    return link._guards.get(address)  # noqa: SLF001  (the same package)
