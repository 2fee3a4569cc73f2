"""Layer 3, hardware proxies: the modules on a gateway's bus, each by addresses of its own.

- `bus`: what they stand on
- `module`: what all have in common; a module without a class of its own is one
- `memory`, `tosnet`, `fifo`, `gpio`, `pwm`, `counter`, `quadrature`: one file for a kind, which states its registers;
  `channels` is what the last three share

A proxy stands on a link and a base address, with or without a spec::

    motors = Pwm(link, 0x40, channels=2, width=12)
    await motors.set(0, 0.25)

A new kind is a subclass of `Module`. Given a ``word``, it can be named in specs too.
"""

from unity_link.hardware.bus import Bus, link_under
from unity_link.hardware.counter import Counter
from unity_link.hardware.fifo import Fifo
from unity_link.hardware.gpio import Gpio
from unity_link.hardware.memory import Memory
from unity_link.hardware.module import Module, module_type
from unity_link.hardware.pwm import Pwm
from unity_link.hardware.quadrature import Quadrature
from unity_link.hardware.tosnet import TosnetNetwork, TosnetNode, TosnetState

__all__ = [
    "Bus",
    "Counter",
    "Fifo",
    "Gpio",
    "Memory",
    "Module",
    "Pwm",
    "Quadrature",
    "TosnetNetwork",
    "TosnetNode",
    "TosnetState",
    "link_under",
    "module_type",
]
