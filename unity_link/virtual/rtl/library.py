"""Loads the compiled gateware, and declares the C interface of `shim.cc`."""

from __future__ import annotations

import ctypes
import functools
from ctypes import POINTER, c_double, c_int, c_int64, c_size_t, c_uint8, c_uint32, c_uint64, c_void_p

from unity_link.errors import ConnectError
from unity_link.virtual.rtl.compiling import compiled
from unity_link.virtual.rtl.configurations import Configuration  # noqa: TC001  (the argument of a cached function)

DeviceFunction = ctypes.CFUNCTYPE(c_int, c_void_p, c_uint64, c_int, POINTER(c_uint64))
"""`Device` of shim.cc: context, address, whether it is a write, word; returns an Answer."""


class Reply(ctypes.Structure):
    """`Reply` of shim.cc: word, cycles after the strobe, and an Answer."""

    _fields_ = (("word", c_uint64), ("after", c_uint32), ("answer", c_uint32))


SlaveFunction = ctypes.CFUNCTYPE(c_int, c_void_p, c_uint64, c_int, c_uint64, POINTER(Reply))
"""`Slave` of shim.cc: context, address, whether it is a write, written word, replies; returns the number of replies."""

EventFunction = ctypes.CFUNCTYPE(None, c_void_p, c_int)
"""`Event` of shim.cc: context, and number of a watch, or negative for the alarm."""

_PROTOTYPES: dict[str, tuple[type | None, tuple[type, ...]]] = {
    "ul_create": (c_void_p, ()),
    "ul_destroy": (None, (c_void_p,)),
    "ul_reset": (None, (c_void_p,)),
    "ul_run": (None, (c_void_p, c_uint64)),
    "ul_run_until_quiet": (c_uint64, (c_void_p, c_uint64, c_uint64)),
    "ul_run_at_pins": (c_uint64, (c_void_p, c_uint64, c_int)),
    "ul_set_pace": (None, (c_void_p, c_double)),
    "ul_ticking": (c_int, (c_void_p,)),
    "ul_stalled": (c_int, (c_void_p,)),
    "ul_skip": (None, (c_void_p, c_uint64)),
    "ul_cycles": (c_uint64, (c_void_p,)),
    "ul_flushes": (c_uint64, (c_void_p,)),
    "ul_push": (None, (c_void_p, ctypes.c_char_p, c_size_t)),
    "ul_waiting": (c_size_t, (c_void_p,)),
    "ul_take_back": (None, (c_void_p,)),
    "ul_lose": (None, (c_void_p,)),
    "ul_set_room": (None, (c_void_p, c_size_t)),
    "ul_available": (c_size_t, (c_void_p,)),
    "ul_pull": (c_size_t, (c_void_p, ctypes.c_char_p, c_size_t)),
    "ul_set_trigger": (None, (c_void_p, c_int)),
    "ul_choose_trigger": (None, (c_void_p, c_int)),
    "ul_read_memory": (c_uint64, (c_void_p, c_uint64)),
    "ul_write_memory": (None, (c_void_p, c_uint64, c_uint64)),
    "ul_used_memory": (c_size_t, (c_void_p, POINTER(c_uint64), c_size_t)),
    "ul_set_behind": (None, (c_void_p, c_uint64, c_uint8)),
    "ul_set_device": (None, (c_void_p, DeviceFunction, c_void_p)),
    "ul_set_slave": (None, (c_void_p, SlaveFunction, c_void_p)),
    "ul_set_stalls": (None, (c_void_p, c_uint64)),
    "ul_set_only_device": (None, (c_void_p,)),
    "ul_sample_word": (c_int, (c_void_p,)),
    "ul_ports": (c_size_t, (c_void_p,)),
    "ul_port_name": (ctypes.c_char_p, (c_void_p, c_size_t)),
    "ul_port_is_input": (c_int, (c_void_p, c_size_t)),
    "ul_port_bits": (c_size_t, (c_void_p, c_size_t)),
    "ul_port_data": (c_void_p, (c_void_p, c_size_t)),
    "ul_set_at": (None, (c_void_p, c_uint64, c_size_t, POINTER(c_uint32))),
    "ul_count": (None, (c_void_p, c_size_t)),
    "ul_take_counts": (None, (c_void_p, c_size_t, POINTER(c_uint64), POINTER(c_uint64))),
    "ul_steps": (c_int64, (c_void_p, c_size_t, c_size_t)),
    "ul_connect": (None, (c_void_p, c_size_t)),
    "ul_set_event": (None, (c_void_p, EventFunction, c_void_p)),
    "ul_watch": (c_int, (c_void_p, c_int, c_int)),
    "ul_set_alarm": (None, (c_void_p, c_uint64)),
    "ul_pulse": (None, (c_void_p, c_int, c_uint64)),
    "ul_never_rests": (None, (c_void_p, c_int)),
    "ul_open_waveform": (c_int, (c_void_p, ctypes.c_char_p)),
    "ul_close_waveform": (c_int, (c_void_p,)),
    "ul_show": (None, (c_void_p, c_int)),
    "ul_set_time": (None, (c_void_p, c_double, c_double)),
}


@functools.cache
def load(configuration: Configuration) -> ctypes.CDLL:
    """Return the library of a configuration; compile it if the cache does not have it.

    Raises:
        ArgumentError: if this installation does not have the C++ of the configuration.
        ConnectError: if no C++ compiler is installed, the compiler fails, or the library cannot be stored or loaded.
    """
    path = compiled(configuration)
    try:
        library = ctypes.CDLL(str(path))
    except OSError as error:
        raise ConnectError(
            f"{path} can't be loaded ({error}): remove it, or name another folder in XDG_CACHE_HOME"
        ) from error
    for function_name, (result, arguments) in _PROTOTYPES.items():
        function = getattr(library, function_name)
        function.restype, function.argtypes = result, arguments
    return library
