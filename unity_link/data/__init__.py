"""Layer 4, data proxies: the signals of a spec as typed values.

::

    Scara = unity_link.load("examples/scara.ul")

    async with unity_link.connect("sim:scara") as link:
        robot = Scara(link)
        await robot.j1.pos_sp.set(30)  # degrees
        async for position in robot.j1.cpos:
            print(position)

- `proxies`, `signals`, `ports`: one signal: a value, or a queue
- `groups`: many signals at once, of one or several gateways; `layout` has their words, `writing` writes them
- `sampling`, `batch`: samples of groups, one by one and many at a time; `tables`: batches for numpy, pandas and polars
- `feed`: samples that several readers and callbacks share
- `robot`, `loading`: the tree of components that `unity_link.load` and generated modules make from a checked model
"""

from unity_link.data.batch import Batch, GroupSample, Values
from unity_link.data.callbacks import Registration
from unity_link.data.groups import Group
from unity_link.data.loading import LoadedRobot, load, read_interface
from unity_link.data.ports import Port, ReadPort, WritePort
from unity_link.data.proxies import Proxy
from unity_link.data.robot import Component, Robot, python_names
from unity_link.data.sampling import GroupSubscription
from unity_link.data.signals import Readable, ReadWrite, Writable
from unity_link.data.tables import Table
from unity_link.spec.kinds import NamedNumber

__all__ = [
    "Batch",
    "Component",
    "Group",
    "GroupSample",
    "GroupSubscription",
    "LoadedRobot",
    "NamedNumber",
    "Port",
    "Proxy",
    "ReadPort",
    "ReadWrite",
    "Readable",
    "Registration",
    "Robot",
    "Table",
    "Values",
    "Writable",
    "WritePort",
    "load",
    "python_names",
    "read_interface",
]
