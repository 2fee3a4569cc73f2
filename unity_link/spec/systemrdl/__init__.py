"""Conversion from and to SystemRDL, a common language for registers.

An interface is exported as one flat address map with a register for each word. Properties that SystemRDL lacks (IDs,
units, scales, publishing) are exported as user-defined properties, `ul_...`, which other tools ignore and `import_file`
reads. Such a map is imported with all its signals, paths and groups; arrays become single components, ``legs[2]``
becomes ``legs_2``, and modules are lost.

Any other SystemRDL is imported with its own hierarchy: address maps, register files and registers of several fields
become components, arrays become arrays, and memories become `MEMORY`. Byte addresses become word addresses.

The extra ``rdl`` installs the SystemRDL compiler; it is imported only by this package.
"""

from __future__ import annotations

from unity_link.spec.systemrdl.exporting import export_text
from unity_link.spec.systemrdl.importing import Imported, import_file

__all__ = ["Imported", "export_text", "import_file"]
