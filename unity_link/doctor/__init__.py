"""Diagnosis of faults and slowness between a program and its gateway, with advice: `unity-link doctor`.

- `findings`: what is found, in words, with the name of the fault
- `computer`: Python, packages, drivers, ports, and how soon this computer runs what waits
- `media`: the port or chip that a URL names, before a link is opened on it
- `answers`: what is at the other end where no gateway answers
- `garbage`: by what factor the speeds of two ends of a serial line differ
- `gateways`: an open link, against what its medium allows
- `examination`: all of it, in the order in which one thing needs another

It asks a gateway for nothing but ``Q``, ``K`` and ``h``: no module on its bus is read or written.
"""

from unity_link.doctor.examination import examine
from unity_link.doctor.findings import FaultName, Finding

__all__ = ["FaultName", "Finding", "examine"]
