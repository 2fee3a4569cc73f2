"""SystemRDL, the register language of the field: a spec out of it, and out of a spec.

Out of an interface goes one flat address map, a register for each word. What SystemRDL has no word for (IDs, units,
scales, publishing) goes along in properties of our own, `ul_...`, which other tools pass over and which `import_file`
reads again. Such a map comes back with all its signals, paths and groups; arrays come back as single components,
``legs[2]`` as ``legs_2``, and modules do not.

Any other SystemRDL comes in with its own tree: address maps and register files become components, arrays arrays, a
register of several fields a component, memories `MEMORY`. Addresses become word addresses.

The extra ``rdl`` installs the compiler, which is imported only here.
"""

from __future__ import annotations

from unity_link.spec.systemrdl.exporting import export_text
from unity_link.spec.systemrdl.importing import Imported, import_file

__all__ = ["Imported", "export_text", "import_file"]
