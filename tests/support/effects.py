"""A robot with every kind of access effect. A program requests events by a write to `make`; `shots` counts pulses."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import msgspec

from unity_link.spec import compile_text
from unity_link.virtual import VirtualGateway
from unity_link.virtual.generics import generics_of, info_of
from unity_link.virtual.simulated import SimulatedRobot
from unity_link.virtual.simulating import SimulatedGateway, make_robot

if TYPE_CHECKING:
    from unity_link.protocol.wire.configuration import Feature

TEXT = """\
group flags(RATE=100);
public robot() {
  @seen = 0x10[7:0]: READ(EFFECT=CLEAR_ON_READ);
  @hit = 0x11[3]: bool READ(EFFECT=CLEAR_ON_READ);
  @alarm[2] = 0x12[i]: bool READWRITE(EFFECT=WRITE_1_TO_CLEAR, PUBLISH(flags));
  @lost = 0x12[15:8]: unsigned READWRITE(EFFECT=WRITE_1_TO_CLEAR, PUBLISH(flags));
  @shoot = 0x12[16]: bool WRITE(EFFECT=PULSE);
  @mode = 0x13[3:0]: READWRITE();
  @start = 0x13[8]: bool READWRITE(EFFECT=PULSE);
  /// Events: the bits of seen, hit, both of alarm, those of lost.
  @make = 0x20[18:0]: WRITE();
  @shots = 0x21: READ();
  @starts = 0x22: READ();
}
"""
SPEC = compile_text(TEXT, "robot.ul")
ALL = info_of(generics_of(SPEC.interface())).features


class Effects(SimulatedRobot):
    """Makes the requested events, and counts pulses."""

    def written(self, path: str, value: Any) -> None:
        if path == "make":
            self.seen, self.hit = value & 0xFF, bool(value >> 8 & 1)
            self.alarm, self.lost = [bool(value >> 9 & 1), bool(value >> 10 & 1)], value >> 11 & 0xFF
        elif path == "shoot":
            self.shots += value
        elif path == "start":
            self.starts += value


def effects_gateway(features: Feature = ALL) -> SimulatedGateway[Any]:
    """Return the robot with a gateway that has the given features."""
    interface = SPEC.interface()
    info = msgspec.structs.replace(info_of(generics_of(interface)), features=features)
    return SimulatedGateway(VirtualGateway(info), make_robot(interface, Effects))


def events(seen: int = 0, hit: int = 0, alarm: int = 0, lost: int = 0) -> int:
    """Return the word that makes these events if it is written to `make`."""
    return seen | hit << 8 | alarm << 9 | lost << 11
