#!/usr/bin/env bash
# PeakRDL-ipxact 3.5.0 writes a field with `singlepulse` as a plain read-write field, and says nothing. After the way
# from SystemRDL through IP-XACT to SystemRDL the field keeps what is written: a command that was to last one clock
# cycle stays. `onwrite` and `onread` of the fields beside it survive.
#
# Expected: a warning, as the exporter gives one for a memory inside a hierarchy, or the access that comes nearest.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" --quiet --disable-pip-version-check install peakrdl-ipxact==3.5.0 systemrdl-compiler==1.33.0
cd "$folder"
cat >motor.rdl <<'RDL'
addrmap motor {
    reg {
        field { sw = rw; hw = r; singlepulse; } start[0:0] = 0;
        field { sw = rw; hw = r; onwrite = woclr; } fault[1:1] = 0;
        field { sw = r; hw = w; onread = rclr; } edges[9:2];
    } control @ 0x0;
};
RDL
venv/bin/python - <<'PYTHON' 2>&1 | tee seen
from peakrdl_ipxact.exporter import IPXACTExporter
from peakrdl_ipxact.importer import IPXACTImporter
from systemrdl import RDLCompiler
from systemrdl.node import FieldNode


def show(words, root):
    for node in root.descendants():
        if isinstance(node, FieldNode):
            kept = [name for name in ("singlepulse", "onwrite", "onread") if node.get_property(name)]
            print(words, node.inst_name, *kept)


first = RDLCompiler()
first.compile_file("motor.rdl")
root = first.elaborate()
show("before:", root)
IPXACTExporter().export(root.top, "motor.xml")
second = RDLCompiler()
IPXACTImporter(second).import_file("motor.xml")
show("after:", second.elaborate())
PYTHON
printf '%s\n' 'before: start singlepulse' 'before: fault onwrite' 'before: edges onread' \
    'after: start' 'after: fault onwrite' 'after: edges onread' | diff - seen
