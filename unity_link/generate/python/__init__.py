"""Python: a module with the classes that `unity_link.load` makes at run time, for editors and type checkers.

The classes have only annotations and docstrings, and the core APIs as base classes. The behaviour is in
`unity_link.data`, which reads the checked model from JSON at the end of the module, so that no spec is compiled at run
time. If a core beside the spec has a Python API, its file is copied beside the module.

- `classes`: the declarations of an interface as Python classes
- `model`: the checked model as JSON text
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
    """Yield the module of an interface, and copies of the core APIs that it needs."""
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
