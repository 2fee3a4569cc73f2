"""Addresses of a link that a program writes under a lease, and the check that the program still holds the lease.

A write to such an address ends with the session in which it was submitted. If it waited for the next session, it could
act under a lease that another program has armed there.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from collections.abc import Iterable

    from unity_link.errors import NotArmedError


class Guard(Protocol):
    """The part of a lease that a link uses."""

    def refusal(self, address: int) -> NotArmedError | None:
        """Return the error of a write to the address if the program has lost the lease, otherwise None."""


class Guarded(Protocol):
    """The part of a link that this module uses."""

    _guards: dict[int, Guard]
    """The lease under which the program writes to each address."""


def guard(link: Guarded, addresses: Iterable[int], by: Guard) -> None:
    """Refuse writes to these addresses of a link once the lease `by` is over."""
    link._guards.update(dict.fromkeys(addresses, by))  # noqa: SLF001  (the same package)


def release(link: Guarded, by: Guard) -> None:
    """Stop refusing writes because of the lease `by`."""
    guards = link._guards  # noqa: SLF001  (the same package)
    for address in [address for address, other in guards.items() if other is by]:
        del guards[address]


def guard_of(link: Guarded, address: int) -> Guard | None:
    """Return the lease under which a program writes to an address; None if it has none."""
    return link._guards.get(address)  # noqa: SLF001  (the same package)
