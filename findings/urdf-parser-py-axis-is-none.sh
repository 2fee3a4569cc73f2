#!/usr/bin/env bash
# urdf_parser_py 0.0.4 gives a revolute joint without an <axis> the axis None. The URDF format says that the axis is
# (1, 0, 0) then, and yourdfpy 0.0.60 reads the same file so. A program that takes the axis from urdf_parser_py fails on
# the file, or draws the joint without rotation.
#
# Expected: the default of the format, as the parser gives it for a joint's <origin>.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" --quiet --disable-pip-version-check install urdf_parser_py==0.0.4 yourdfpy==0.0.60
cd "$folder"
cat >arm.urdf <<'XML'
<robot name="arm">
  <link name="base"/>
  <link name="upper"/>
  <joint name="shoulder" type="revolute">
    <parent link="base"/>
    <child link="upper"/>
    <limit lower="-1" upper="1" effort="1" velocity="1"/>
  </joint>
</robot>
XML
venv/bin/python - <<'PYTHON'
import warnings

warnings.simplefilter("ignore")
from urdf_parser_py.urdf import URDF as Parser
from yourdfpy import URDF as Loader

(parsed,) = Parser.from_xml_string(open("arm.urdf").read()).joints
(loaded,) = Loader.load("arm.urdf").robot.joints
print("urdf_parser_py:", parsed.axis, " yourdfpy:", loaded.axis.tolist())
raise SystemExit((parsed.axis, loaded.axis.tolist()) != (None, [1.0, 0.0, 0.0]))
PYTHON
