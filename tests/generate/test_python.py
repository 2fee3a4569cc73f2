"""The generated module: mypy --strict accepts its types, and it works as `unity_link.load` does."""

from __future__ import annotations

import importlib.util
import subprocess
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

import msgspec
import pytest

import unity_link
from generate.every_kind import WORD_BITS, every_kind, good_values
from support.simulated_time import on_simulated_time
from support.spec_examples import FIGURE_1
from unity_link import ArgumentError
from unity_link.data import Group, read_interface
from unity_link.generate import generate, write
from unity_link.generate.python.model import model_text
from unity_link.protocol.wire.configuration import GatewayInfo
from unity_link.quoting import python_docstring
from unity_link.spec import Access, Spec, compile_file, compile_text
from unity_link.virtual import VirtualGateway

if TYPE_CHECKING:
    from types import ModuleType

    from unity_link.spec.model import Interface

EXAMPLES = Path(__file__).parents[2] / "examples"
AWKWARD = """\
/// A "quoted" \\ doc string with '''three''' quotes, ending in "
enum state { off, class, real, name_ = 9, name }
enum Robot { one }
public robot(class, link, self) {
  TOSNET(CTRL=class, COMM=link) { lambda: TOSNET_NODE(NODE=1) { @def = 0: READ(); } }
  @groups = 0x80[3:0]: state READWRITE(UNIT="it's", ID="a 'name'");
  @int = 0x81: READWRITE();
  @data = 0x82: float READ();
  @__hidden = 0x83: Robot 2 READ();
  @port = 0x84: signed READWRITE(FIFO);
  @status = 0x85: READ(POLL(2));
  Component[2]: Readable(1 + i) @(0x90 + i);
  tables[2]: MEMORY(BASE=0xA0 + 2 * i, SIZE=2);
  net: TOSNET(BASE=0xC0, SIZE=4);
  pool: MEMORY(BASE=0xB0, SIZE=8);
}
Readable(scale): @(base) { @value = base: READ(SCALE=scale); link: link() @(base + 0x10); }
link(): @(base) { @import_ = base: bool WRITE(); }
"""
PROGRAM = """\
from typing import assert_type
import unity_link
from robot import Robot_, Readable_, State
from scara import Joint, Scara
from unity_link.data import Readable
from unity_link.network import TosnetState

async def main(link: unity_link.Link) -> None:
    scara = Scara(link, ctrl=1)
    assert_type(scara.j1, Joint)
    assert_type(await scara.j1.cpos.get(), float)
    assert_type(scara.j1.cpos.value, float | None)
    await scara.j1.pos_sp.set(3)
    async for position in scara.j1.cpos:
        assert_type(position, float)
    values = await scara.groups["state"].get()
    assert_type(values[scara.j2.spd], float)
    robot = Robot_(link, class_=3, link_=4, self_=5)
    assert_type(await robot.groups_.get(), State | int)
    await robot.groups_.set(State.class_)
    assert_type(await robot.int_.get(), int)
    assert_type(await robot.Component[1].value.get(), float)
    await robot.Component[1].link_.import_.set(True)
    assert_type(await robot.port.get(), int)
    assert_type(await robot.pool.read(3), int)
    await robot.tables[1].store([1, 2])
    assert_type(await robot.net.state(), TosnetState)
"""
WRONG = """\
import unity_link
from robot import Robot_
from scara import Scara

async def main(link: unity_link.Link) -> None:
    scara = Scara(link, ctrl="x")
    scara.j5
    await scara.j1.cpos.set(1)
    await scara.j1.pos_sp.set("far")
    await Robot_(link).Component[0].link_.import_.get()
"""


def generated(spec: Spec, directory: Path) -> Path:
    (path,) = write(generate("python", spec), directory)
    return path


def imported(spec: Spec, directory: Path) -> ModuleType:
    path = generated(spec, directory)
    described = importlib.util.spec_from_file_location(f"generated_{path.stem}", path)
    assert described is not None
    assert described.loader is not None
    module = importlib.util.module_from_spec(described)
    sys.modules[module.__name__] = module
    described.loader.exec_module(module)
    return module


def mypy(directory: Path, *files: str) -> subprocess.CompletedProcess[str]:
    options = ["--strict", "--config-file=", f"--cache-dir={Path(__file__).parents[2] / '.mypy_cache'}"]
    return subprocess.run(
        [sys.executable, "-m", "mypy", *options, *files], cwd=directory, capture_output=True, text=True, check=False
    )


@pytest.mark.slow
def test_generated_modules_and_programs_with_them_pass_mypy_strict(tmp_path: Path) -> None:
    for spec in (compile_text(AWKWARD), compile_file(EXAMPLES / "scara.ul"), compile_file(EXAMPLES / "walker.ul")):
        generated(spec, tmp_path)
    (tmp_path / "program.py").write_text(PROGRAM)
    done = mypy(tmp_path, "robot.py", "scara.py", "walker.py", "program.py")
    assert done.returncode == 0, done.stdout + done.stderr


def test_mypy_finds_the_faults_of_a_program(tmp_path: Path) -> None:
    for spec in (compile_text(AWKWARD), compile_file(EXAMPLES / "scara.ul")):
        generated(spec, tmp_path)
    (tmp_path / "wrong.py").write_text(WRONG)
    done = mypy(tmp_path, "wrong.py")
    lines = [int(line.split(":")[1]) for line in done.stdout.splitlines() if ": error:" in line]
    assert lines == [6, 7, 8, 9, 10], done.stdout


@pytest.mark.parametrize("word_bits", WORD_BITS)
def test_the_generated_robot_is_the_one_of_load(word_bits: int, tmp_path: Path) -> None:
    spec = every_kind(word_bits)
    module = imported(spec, tmp_path)

    @on_simulated_time
    async def check() -> None:
        async with unity_link.connect(VirtualGateway(GatewayInfo(data_bits=word_bits))) as link:
            robot, loaded = module.Robot_(link), unity_link.load(spec)(link)
            assert [(type(signal), signal.path) for signal in robot.signals] == [
                (type(signal), signal.path) for signal in loaded.signals
            ]
            for signal in robot.signals:
                if signal.signal.access is Access.READWRITE:
                    for value in good_values(signal.signal)[:3]:
                        await signal.set(value)
                        assert await loaded[signal.path].get() == value  # type: ignore[attr-defined]

    check()


def test_the_model_survives_the_module() -> None:
    def stripped(value: Any) -> Any:
        """Return a description without the places in the source."""
        if isinstance(value, dict):
            return {key: stripped(item) for key, item in value.items() if key != "span"}
        return [stripped(item) for item in value] if isinstance(value, list) else value

    def same(interface: Interface) -> None:
        back, given = (
            msgspec.json.decode(msgspec.json.encode(model))
            for model in (read_interface(model_text(interface)), interface)
        )
        assert stripped(back) == stripped(given)

    for spec in (compile_text(AWKWARD), compile_text(FIGURE_1), compile_file(EXAMPLES / "walker.ul"), every_kind(12)):
        same(spec.interface())


def test_limits_of_64_bits_are_exact_in_the_module() -> None:
    interface = compile_text("""
public large() {
  GATEWAY(DATA_BITS=8);
  @a0 = 0: unsigned 64 READWRITE(MAX=18446744073709551614);
  @a1 = 8: signed 64 READWRITE(MIN=-9223372036854775807);
  @a2 = 16: unsigned 64 READWRITE(MAX=9007199254740993);
  @a3 = 24: float READWRITE(MIN=-2.5, MAX=3);
}
""").interface()
    made = read_interface(model_text(interface))
    limits = {path: signal.limits for path, signal in made.signals.items()}
    assert limits == {path: signal.limits for path, signal in interface.signals.items()}
    assert limits["a2"][1] == 9007199254740993
    made.signals["a2"].encode(9007199254740993)
    for path, value in (("a0", 18446744073709551615), ("a1", -9223372036854775808), ("a2", 9007199254740994)):
        with pytest.raises(ArgumentError):
            made.signals[path].encode(value)


@pytest.mark.asyncio
async def test_the_generated_scara_reads_writes_and_is_published(tmp_path: Path) -> None:
    module = imported(compile_file(EXAMPLES / "scara.ul"), tmp_path)
    async with unity_link.connect("sim:scara") as link:
        robot = module.Scara(link, ctrl=None)
        assert isinstance(robot.j1, module.Joint)
        await robot.j1.spd_sp.set(300)
        await robot.j1.pos_sp.set(9)
        async for position in robot.j1.cpos:
            if position == 9:
                break
        assert (await Group(robot.j1).get())[robot.j1.cpos] == 9


def test_names_that_python_has_taken_get_an_underscore(tmp_path: Path) -> None:
    module = imported(compile_text(AWKWARD), tmp_path)

    @on_simulated_time
    async def check() -> None:
        async with unity_link.connect(VirtualGateway()) as link:
            robot = module.Robot_(link, class_=0xF0)
            assert robot._given == {"class": 0xF0, "link": None, "self": None}
            await robot.groups_.set(module.State.real_)
            assert await robot.groups_.get() is module.State.real_
            assert robot._hidden.path == "__hidden"
            assert robot.lambda_.node == 1
            assert robot.Component[1].link_.import_.signal.address == 0xA1

    check()


def test_class_name_may_begin_with_an_underscore_and_a_digit(tmp_path: Path) -> None:
    text = (
        "enum _1st { a } public _9x() { @a = 1: _1st READ(); b: _2nd() @(2); } _2nd(): @(base) { @c = base: READ(); }"
    )
    module = imported(compile_text(text), tmp_path)
    assert module.__all__ == ["_1st", "_2nd", "_9x"]


def test_the_module_needs_no_compiler_of_specs(tmp_path: Path) -> None:
    generated(compile_file(EXAMPLES / "scara.ul"), tmp_path)
    program = "import sys, scara; sys.exit(any(name.split('.')[0] in ('lark', 'jinja2') for name in sys.modules))"
    subprocess.run([sys.executable, "-c", program], cwd=tmp_path, check=True)


def test_classes_and_attributes_have_the_docstrings_of_their_declarations() -> None:
    (file,) = generate("python", compile_file(EXAMPLES / "scara.ul"))
    servo = "A servo axis: it moves to its set point, not faster than its speed set point."
    assert f'class Joint(Component):\n    """{servo}"""\n' in file.text
    assert '    j2: Joint\n    """Elbow."""\n' in file.text


@pytest.mark.parametrize("text", ["", "plain", 'ends in "', "back \\ slash", 'three """ quotes', "two\n\nlines"])
def test_any_text_is_a_docstring(text: str) -> None:
    assert eval(python_docstring(text, 0)).strip() == text.strip()


@pytest.mark.parametrize("name", ["string", "asyncio", "lambda", "unity_link"])
def test_the_module_hides_none_that_its_program_imports(name: str) -> None:
    (made,) = generate("python", compile_text(f"public {name}() {{ @a = 1: READ(); }}"))
    assert made.name == f"{name}_.py"
