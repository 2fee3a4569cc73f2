"""Diagnosis of faults and slowness between a program and its gateway, with advice: `unity-link doctor`.

- `findings`: the result of one check, with the name of the fault
- `computer`: Python, packages, drivers, ports, and how late this computer runs tasks that are due
- `media`: the port, chip or network that a URL names, before a link is opened on it
- `answers`: the device at the other end, if no gateway answers
- `garbage`: an estimate of how far the speeds of the two ends of a serial line differ
- `gateways`: an open link, compared with the limits of its medium
- `network`: the path to a gateway over UDP
- `examination`: all checks, in the order in which they depend on each other

The checks send only ``Q``, ``K``, ``h`` and ``H`` to a gateway: no module on its bus is read or written.
"""

from unity_link.doctor.examination import examine
from unity_link.doctor.findings import FaultName, Finding

__all__ = ["FaultName", "Finding", "examine"]
