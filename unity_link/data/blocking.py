"""Robots for code that is not asynchronous: scripts, notebooks, other threads.

::

    from unity_link import blocking
    from unity_link.data.blocking import Group, put

    with blocking.connect("sim:scara") as link:
        robot = put(Scara, link)
        robot.j1.pos_sp.set(30)
        print(robot.j1.cpos.get())
        for position in robot.j1.cpos:
            print(position)

A `View` wraps an object of the robot and has its attributes. It calls methods in the thread of the link, and waits for
the results of coroutines. Callbacks run in that thread, too, and must not call the robot.
"""

from __future__ import annotations

import functools
from types import AsyncGeneratorType
from typing import TYPE_CHECKING, Any, Self, SupportsIndex

from unity_link.blocking import BlockingLink, noting
from unity_link.cores.lease import Lease
from unity_link.cores.timeline import Done, Timeline
from unity_link.data import groups
from unity_link.data.callbacks import Registration
from unity_link.data.describing import robot_behind
from unity_link.data.proxies import OPERATORS, Proxy
from unity_link.data.robot import Component, Robot
from unity_link.data.sampling import GroupSubscription
from unity_link.errors import ArgumentError, OfLink
from unity_link.link.interrupts import DEFERRED, BlockingBlock
from unity_link.modules import Module

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from types import TracebackType


_SHOWN = (
    Component,
    Proxy,
    Module,
    groups.Group,
    GroupSubscription,
    Registration,
    Lease,
    Timeline,
    Done,
    AsyncGeneratorType,
)
"""Types that are wrapped in a view; all other values are returned unchanged."""


class View(OfLink):
    """An object of a robot, used without `await`. A view equals its object, so it also finds values of a `Values`."""

    _thing: Any
    _link: BlockingLink
    _block: BlockingBlock | None = None

    def __init__(self, thing: Any, link: BlockingLink) -> None:
        self.__dict__.update(_thing=thing, _link=link)

    def __setattr__(self, name: str, value: object) -> None:
        """Set an attribute of the object; assigning to a signal raises an error."""
        try:
            setattr(self._thing, name, _plain(value))
        except ArgumentError as error:
            raise ArgumentError(str(error).replace(": await ", ": ")) from None

    def __getattr__(self, name: str) -> Any:
        """Return an attribute of the object; a method is wrapped so that it runs in the thread of the link."""
        attribute = getattr(self._thing, name)
        if not callable(attribute) or isinstance(attribute, type):
            return _shown(attribute, self._link)
        call = _call_of(self._thing)
        return functools.wraps(attribute)(
            lambda *arguments, **options: call(self._link, attribute, *arguments, **options)
        )

    def __reduce_ex__(self, protocol: SupportsIndex) -> Any:
        """Pickle the object in place of the view, if it can be pickled."""
        return self._thing.__reduce_ex__(protocol)

    def __dir__(self) -> list[str]:
        """Return the names for completion: those of the object."""
        return dir(self._thing)

    def __getitem__(self, key: Any) -> Any:
        """Return a signal by its path or its ID."""
        return _shown(self._thing[key], self._link)

    def __len__(self) -> int:
        """Return the number of signals of a group."""
        return len(self._thing)

    def __bool__(self) -> bool:
        """Return True, whatever the length of the object; a signal raises an error, because it is no value."""
        return bool(self._thing) if isinstance(self._thing, Proxy) else True

    def __iter__(self) -> Iterator[Any]:
        """Iterate over samples. Each one costs a change to the link's thread and back."""
        samples = _call_of(self._thing)(self._link, aiter, self)
        try:
            while True:
                try:
                    following = _take(self._link, anext, samples)
                except StopAsyncIteration:
                    return
                yield following
        except GeneratorExit:
            DEFERRED.finalize(functools.partial(self._leave, samples))
            raise
        except BaseException:
            self._leave(samples)
            raise

    def _leave(self, samples: Any) -> None:
        """End an iteration."""
        # Close the iterator here, unless in a callback, which cannot wait: the garbage collector would do so late.
        begun = _plain(samples)
        if begun is not self._thing and not self._link._runtime.is_running_here():  # noqa: SLF001  (as below)
            _take(self._link, begun.aclose)

    def __enter__(self) -> Self:
        enter = getattr(self._thing, "__aenter__", None) or self._thing.__enter__
        entered: list[bool] = []
        if isinstance(self._thing, Lease | Timeline):
            # Outputs move during the block, so an operating system signal must not prevent the call that ends it.
            self.__dict__["_block"] = BlockingBlock()
        try:
            if self._block is not None:
                DEFERRED.begin(self._block)
            self._link._call(noting(entered, lambda: _awaited(enter, (), {})))  # noqa: SLF001  (as below)
            return self  # noqa: TRY300  (a signal handler may raise until the return)
        except BaseException as error:
            if entered:
                self.__exit__(type(error), error, error.__traceback__)
            elif self._block is not None:
                DEFERRED.end(self._block)
            raise

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        try:
            leave = getattr(self._thing, "__aexit__", None) or self._thing.__exit__
            # Not by `_call`, which raises if the link is closed: a closed link has ended the block, which is no error.
            self._link._runtime.run(_awaited, leave, (kind, error, trace), {})  # noqa: SLF001  (as below)
        finally:
            if self._block is not None:
                DEFERRED.end(self._block)

    def __eq__(self, other: object) -> bool:
        return bool(self._thing == _plain(other))

    def __hash__(self) -> int:
        return hash(self._thing)

    def __repr__(self) -> str:
        """Return the text of the object."""
        return repr(self._thing)

    def _repr_html_(self) -> str | None:
        """Return the object as a table, if it has such a form."""
        shown = getattr(self._thing, "_repr_html_", None)
        return None if shown is None else shown()


def _operator(name: str) -> Any:
    """Return an operator that calls that of the object; on a signal it raises an error, as a signal is no value."""
    return lambda view, *others: getattr(view._thing, name)(*others)  # noqa: SLF001  (its own module)


for _name in OPERATORS:
    if _name != "__bool__":
        setattr(View, _name, _operator(_name))


def put(robot: type[Robot], link: BlockingLink, /, **parameters: int | None) -> Any:
    """Return a view of the robot of a spec on a blocking link. Checks and errors are those of `unity_link.robot`."""
    if not isinstance(link, BlockingLink):
        raise ArgumentError(f"put needs a blocking link, by `unity_link.blocking.connect`, not {link!r:.80}")
    given: object = robot
    if not (isinstance(given, type) and issubclass(given, Robot)):
        raise ArgumentError(f"put needs the class of a robot, by `unity_link.load`, not {robot!r:.80}")
    return _call(link, robot_behind, link._link, robot, **parameters)  # noqa: SLF001  (a view of the same link)


def Group(*members: View, rate_hz: float | None = None, name: str = "a group") -> Any:  # noqa: N802  (as the class)
    """Return a view of a new group; the arguments and errors are those of `unity_link.data.Group`.

    Raises:
        ArgumentError: also for members on several links, because each link has a thread of its own.
    """
    if not members or any(member._link is not members[0]._link for member in members):  # noqa: SLF001
        raise ArgumentError(f"{name}: members on one link were expected, at least one")
    return _shown(groups.Group(*_plain(members), rate_hz=rate_hz, name=name), members[0]._link)  # noqa: SLF001


def _call(link: BlockingLink, function: Any, *arguments: Any, **options: Any) -> Any:
    """Call a function in the thread of the link, wait for its result, and wrap that in views."""
    return _shown(link._call(_awaited, function, arguments, options), link)  # noqa: SLF001  (a view of the same link)


def _take(link: BlockingLink, function: Any, *arguments: Any, **options: Any) -> Any:
    """Call a function as `_call` does, on a closed link, too: samples that arrived before can still be taken."""
    return _shown(link._runtime.run(_awaited, function, arguments, options), link)  # noqa: SLF001  (as above)


def _call_of(thing: Any) -> Callable[..., Any]:
    return _take if isinstance(thing, GroupSubscription) else _call


async def _awaited(function: Any, arguments: tuple[object, ...], options: dict[str, object]) -> Any:
    given = function(*_plain(arguments), **_plain(options))
    return await given if hasattr(given, "__await__") and not isinstance(given, _SHOWN) else given


def _shown(thing: Any, link: BlockingLink) -> Any:
    """Wrap objects with coroutines in views, also inside of tuples and dictionaries."""
    if isinstance(thing, _SHOWN):
        return View(thing, link)
    if type(thing) is tuple:
        return tuple(_shown(item, link) for item in thing)
    if isinstance(thing, dict):
        return type(thing)({key: _shown(item, link) for key, item in thing.items()})
    return thing


def _plain(thing: Any) -> Any:
    """Replace views by their objects, also inside of tuples, lists and dictionaries."""
    if isinstance(thing, View):
        return thing._thing  # noqa: SLF001  (its own module)
    if type(thing) in {tuple, list}:
        return type(thing)(_plain(item) for item in thing)
    if type(thing) is dict:
        return {_plain(key): _plain(item) for key, item in thing.items()}
    return thing
