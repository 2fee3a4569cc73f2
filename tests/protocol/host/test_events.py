"""The events of a session are a closed set."""

from __future__ import annotations

import inspect
from typing import get_args

from unity_link.protocol.host import events


def test_each_class_of_events_is_in_the_closed_set() -> None:
    classes = [kind for _, kind in inspect.getmembers(events, inspect.isclass) if kind.__module__ == events.__name__]
    assert set(classes) == set(get_args(events.Event))
    assert all((kind.__doc__ or "").startswith("Event: ") for kind in classes)
