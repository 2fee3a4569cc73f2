"""Python: a module with the classes that `unity_link.load` makes at run time, for editors and type checkers.

Its classes have annotations, docstrings and nothing else, but for the verbs of cores, which are their bases: what
happens is in `unity_link.data`, which finds the rest in the checked model that stands at the module's end as JSON. So
it needs no compiler of specs at run time. The Python of a core that lies beside the spec is copied beside the module.

- `classes`: the declarations of an interface as classes of Python
- `model`: the checked model as text
- `module.jinja`: the module
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from unity_link.generate import GeneratedFile
from unity_link.generate.python.classes import core_modules, describe, module_name
from unity_link.generate.python.model import model_text

if TYPE_CHECKING:
    from collections.abc import Iterator

    from unity_link.generate import Templates
    from unity_link.spec import Interface

DOC = "a typed module: the robot's classes, for completion in an editor and mypy --strict"


def files(interface: Interface, templates: Templates) -> Iterator[GeneratedFile]:
    """Make the file of an interface."""
    module = describe(interface)
    text = templates.render(
        "module",
        module=module,
        parameters_keep_their_names=all(name == given for name, given in module.parameters),
        model=model_text(interface),
    )
    yield GeneratedFile(f"{module_name(interface)}.py", text)
    for python, name in core_modules(interface).items():
        if python.endswith(".py"):
            yield GeneratedFile(f"{name}.py", Path(python).read_text(encoding="utf-8"))
