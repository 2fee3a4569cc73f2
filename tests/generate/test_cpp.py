"""The generated client in C++: types that the compiler checks, errors by class, samples by callback."""

from __future__ import annotations

import hashlib
import math
import subprocess
from typing import TYPE_CHECKING

import pytest

from generate.every_kind import LIMIT_TRIALS, LIMITS_BEYOND_DOUBLES, WORD_BITS, every_kind, written
from generate.peers import MEDIA, FaultyLine, Medium, ObservedGateway, lose, replace, serve, simulate
from generate.programs import CPP, SANITIZED, C, compiled, generated, linked, output
from support.spec_examples import FIGURE_1
from unity_link.generate import generate
from unity_link.protocol.wire.configuration import Feature, GatewayInfo
from unity_link.protocol.wire.crc import Crc
from unity_link.protocol.wire.frames import Framing
from unity_link.spec import KindName, compile_text

if TYPE_CHECKING:
    from pathlib import Path

    from unity_link.spec import Signal, Value

HEAD = """\
#include <iostream>
#include <cmath>
using namespace std::chrono_literals;
#define CHECK(what) if (!(what)) { std::cerr << "line " << __LINE__ << ": " #what << std::endl; return 1; } else (void)0
#define THROWS(kind, ...) \\
    try { __VA_ARGS__; CHECK(!"it throws"); } catch (const unity_link::kind &error) { last = error.what(); }
int main(int, char **arguments) try {
    std::string last;
    unity_link::Link link{arguments[1]};
"""
TAIL = """
    return 0;
} catch (const std::exception &error) {
    std::cerr << error.what() << std::endl;
    return 1;
}
"""
WALKER = compile_text("""\
/// What the walker does.
enum mode { off, walking = 4, class }
group state(1, 100, TIMESTAMPS);
group targets;
group slow(RATE=2);
public walker() {
  GATEWAY(ADDRESS_BITS=8, DATA_BITS=32);
  @mode = 0x60[3:0]: mode READWRITE(PUBLISH(state));
  @on = 0x60[4]: bool READWRITE(PUBLISH(state));
  @speed = 0x60[15:8]: signed READWRITE(SCALE=0.5, MIN=-10, MAX=10, UNIT="mm/s");
  @clock = 0x61: unsigned 64 READWRITE(PUBLISH(state));
  @age = 0x65: READ(PUBLISH(slow));
  @samples = 0x63: signed 16 READWRITE(FIFO);
  @gain = 0x64: float READWRITE();
  legs[3]: leg() @(0x10 * i);
  pool: MEMORY(BASE=0x70, SIZE=16);
  tables[2]: MEMORY(BASE=0x80 + 4 * i, SIZE=4);
}
/// A leg.
leg(): @(base) { joints[2]: joint() @(base + 4 * i); }
joint(): @(base) {
  /// Angle.
  @pos = base: signed 16 READWRITE(SCALE=0.01, UNIT="rad", PUBLISH(state));
  @target = base + 1: signed READWRITE(MIN=-1000, MAX=1000, GROUP(targets));
  @position = base + 2: READ();
  @command = base + 3: unsigned 8 WRITE();
}
""")


@pytest.fixture(scope="session")
def runtime(tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    """Compile the C files of the walker once; return the objects, with the headers in the same folder."""
    directory = tmp_path_factory.mktemp("walker")
    files = generated("cpp", WALKER, directory)
    return compiled(C, [path for path in files if path.suffix == ".c"], directory, *SANITIZED)


def program(body: str, objects: list[Path]) -> Path:
    """Compile a program whose body uses the walker as `robot`; compile each body only once."""
    directory = objects[0].parent
    source = directory / f"program_{hashlib.sha256(body.encode()).hexdigest()[:16]}.cc"
    made = source.with_suffix("")
    if not made.exists():
        source.write_text(f'#include "walker.hpp"\n{HEAD}    Walker robot{{link}};\n{body}{TAIL}')
        linked(CPP, [*objects, *compiled(CPP, [source], directory, *SANITIZED, "-O0")], made, *SANITIZED)
    return made


@pytest.mark.slow
@pytest.mark.parametrize("word_bits", [None, *WORD_BITS])
def test_the_headers_compile_without_a_warning(word_bits: int | None, tmp_path: Path) -> None:
    spec = compile_text(FIGURE_1) if word_bits is None else every_kind(word_bits)
    generated("cpp", spec, tmp_path)
    name = spec.interface().name
    uses = "own.j1.cpos.get();" if name == "scara" else "own.scaled.set(own.arms[1].position.get());"
    text = f'#include "{name}.hpp"\nvoid use(unity_link::Link &link) {{ {name.title()} own{{link}}; {uses} }}\n'
    (tmp_path / "program.cc").write_text(text)
    compiled(CPP, [tmp_path / "program.cc"], tmp_path)


@pytest.mark.slow
def test_a_value_of_an_enumeration_may_have_all_64_bits(tmp_path: Path) -> None:
    spec = compile_text(
        "enum big { none, middle = 0x80000000, high = 0x8000000000000000, all = 0xFFFFFFFFFFFFFFFF }\n"
        "public robot() { GATEWAY(DATA_BITS=64); @b = 0: big 64 READWRITE(); }\n"
    )
    files = generated("cpp", spec, tmp_path)
    source = tmp_path / "program.cc"
    body = """
    Robot own{link};
    own.b.set(Robot::Big::all);
    CHECK(link.read(0) == ~std::uint64_t{0} && own.b.get() == Robot::Big::all);
    own.b.set(Robot::Big::high);
    CHECK(link.read(0) == std::uint64_t{1} << 63 && std::string(to_string(own.b.get())) == "high");
    """
    source.write_text(f'#include "robot.hpp"\n{HEAD}{body}{TAIL}')
    objects = compiled(C, [path for path in files if path.suffix == ".c"], tmp_path, *SANITIZED)
    objects += compiled(CPP, [source], tmp_path, *SANITIZED, "-O0")
    with simulate("tcp", "--set", "data_bits=64") as url:
        output(linked(CPP, objects, tmp_path / "program", *SANITIZED), url)


def test_the_files_in_c_are_those_of_the_target_c() -> None:
    files = {file.name: file.text for file in generate("cpp", WALKER)}
    assert {file.name: file.text for file in generate("c", WALKER)}.items() <= files.items()
    assert generate("cpp", WALKER) == generate("cpp", WALKER)


@pytest.mark.slow
@pytest.mark.parametrize("medium", MEDIA)
def test_signals_are_read_and_written_by_their_paths(medium: Medium, runtime: list[Path]) -> None:
    body = """
    robot.legs[2].joints[1].pos.set(1.25);
    CHECK(link.read(0x24) == 125);
    CHECK(std::abs(robot.legs[2].joints[1].pos.get() - 1.25) < 1e-9);
    CHECK(std::string(robot.legs[2].joints[1].pos.path()) == "legs[2].joints[1].pos");
    CHECK(std::string(robot.legs[2].joints[1].pos.unit()) == "rad");
    robot.legs[0].joints[0].target.set(-1000);
    std::int32_t target = robot.legs[0].joints[0].target.get();
    CHECK(target == -1000 && link.read(1) == 0xFFFFFC18);
    THROWS(ArgumentError, robot.legs[0].joints[0].target.set(-1001));
    CHECK(last == "legs[0].joints[0].target: -1001 is outside of -1000 to 1000");
    THROWS(ArgumentError, robot.legs[0].joints[0].target.set(1LL << 32));
    THROWS(ArgumentError, robot.legs[0].joints[0].command.set(-1));
    robot.legs[0].joints[0].command.post(255u);

    robot.mode.set(Walker::Mode::walking);
    robot.on.set(true);
    robot.speed.set(-3.25);     // goes to the even number of -6 and -7
    CHECK(link.read(0x60) == 0xFA14);
    CHECK(robot.mode.get() == Walker::Mode::walking && robot.on.get());
    CHECK(robot.speed.get() == -3.0);
    CHECK(std::string(to_string(robot.mode.get())) == "walking" && to_string(Walker::Mode{9}) == nullptr);
    CHECK(std::string(to_string(Walker::Mode::class_)) == "class");
    robot.mode.set(Walker::Mode::class_);
    robot.on.post(false);
    link.fence();
    CHECK(link.read(0x60) == 0xFA05);
    THROWS(ArgumentError, robot.speed.set(10.5));
    THROWS(ArgumentError, robot.speed.set(std::nan("")));

    robot.clock.set(0x123456789ABCDEF0u);
    CHECK(link.read(0x61) == 0x9ABCDEF0 && link.read(0x62) == 0x12345678);
    CHECK(robot.clock.get() == 0x123456789ABCDEF0u);
    robot.clock.post(1u);
    CHECK(robot.clock.get() == 1);
    robot.gain.set(0.1);
    CHECK(robot.gain.get() == static_cast<double>(0.1f));
    THROWS(ArgumentError, robot.gain.set(1e39));
    robot.samples.put({1, -2});
    CHECK((robot.samples.take(2) == std::vector<std::int32_t>{-2, -2}));

    robot.pool.write_block(4, {7, 8});
    CHECK(link.read(0x75) == 8 && robot.pool.read(5) == 8 && robot.pool.words() == 16);
    THROWS(ArgumentError, robot.pool.read(16));
    CHECK(robot.tables[1].address() == 0x84);

    Walker::Targets targets{};
    targets.legs_2_joints_1_target = 77;
    robot.targets.write(targets);
    CHECK(robot.targets.read().legs_2_joints_1_target == 77 && link.read(0x25) == 77 && link.read(1) == 0);
    targets.legs_0_joints_0_target = 2000;
    targets.legs_2_joints_1_target = 5;
    THROWS(ArgumentError, robot.targets.write(targets));
    CHECK(link.read(0x25) == 77);
    """
    with simulate(medium) as url:
        output(program(body, runtime), url)


def cpp_value(signal: Signal, value: Value) -> str:
    if signal.kind.is_float:
        return float(value).hex() if math.isfinite(value) else f"{'-' if value < 0 else ''}INFINITY"
    if signal.kind.enumeration is not None:
        return f"Robot::Mode{{{int(value)}u}}"
    if signal.kind.name is KindName.BOOL:
        return str(bool(value)).lower()
    return f"std::{'int' if signal.kind.is_signed else 'uint'}64_t(UINT64_C({int(value) % 2**64}))"


def test_values_of_every_kind_are_encoded_and_decoded_as_in_python(tmp_path: Path) -> None:
    spec = every_kind(16)
    steps, expected = [], []
    for signal, value in written(spec.interface()):
        path = signal.path.replace("double", "double_")
        steps.append(
            f"    own.{path}.set({cpp_value(signal, value)}); show(link, {signal.address}, own.{path}.get());\n"
        )
        expected.append((signal, value))
    show = (
        "template <class T> void show(unity_link::Link &link, std::uint32_t address, T value) {\n"
        "    for (std::uint64_t word : link.read_block(address, 4)) std::cout << word << ' ';\n"
        "    if constexpr (std::is_enum_v<T>) std::cout << static_cast<std::uint64_t>(value) << '\\n';\n"
        "    else std::cout << value << '\\n';\n}\n"
    )
    files = generated("cpp", spec, tmp_path)
    source = tmp_path / "program.cc"
    text = f"{HEAD}    Robot own{{link}};\n    std::cout << std::hexfloat;\n{''.join(steps)}{TAIL}"
    source.write_text(f'#include "robot.hpp"\n#include <iostream>\n{show}{text}')
    objects = compiled(C, [path for path in files if path.suffix == ".c"], tmp_path, *SANITIZED)
    objects += compiled(CPP, [source], tmp_path, *SANITIZED, "-O0")
    made = linked(CPP, objects, tmp_path / "program", *SANITIZED)
    with simulate("tcp", "--set", "data_bits=16") as url:
        lines = output(made, url).splitlines()
    for line, (signal, value) in zip(lines, expected, strict=True):
        *words, shown = line.split()
        own = [int(word) for word in words[: signal.words]]
        decoded = signal.decode(own)
        assert decoded == signal.decode(signal.encode(value)), (signal.path, line)
        assert (float.fromhex(shown) if signal.kind.is_float else int(shown)) == decoded, (signal.path, line)


@pytest.mark.slow
def test_limits_that_no_double_holds_are_kept_exactly(tmp_path: Path) -> None:
    signals = LIMITS_BEYOND_DOUBLES.interface().signals
    body = "    Robot own{link};\n"
    for name, value, is_taken in LIMIT_TRIALS:
        number = f"{cpp_value(signals[name], value)}"
        call = f"own.{name}.set({number})"
        body += (
            f"    {call}; CHECK(own.{name}.get() == {number});\n"
            if is_taken
            else f"    THROWS(ArgumentError, {call});\n"
            f'    CHECK(last.rfind("{name}: {value} is outside of ", 0) == 0);\n'
        )
    files = generated("cpp", LIMITS_BEYOND_DOUBLES, tmp_path)
    source = tmp_path / "program.cc"
    source.write_text(f'#include "robot.hpp"\n{HEAD}{body}{TAIL}')
    objects = compiled(C, [path for path in files if path.suffix == ".c"], tmp_path, *SANITIZED)
    objects += compiled(CPP, [source], tmp_path, *SANITIZED, "-O0")
    with simulate("tcp", "--set", "data_bits=64") as url:
        output(linked(CPP, objects, tmp_path / "program", *SANITIZED), url)


@pytest.mark.slow
@pytest.mark.parametrize(
    "wrong",
    [
        "robot.legs[0].joints[0].position.set(1);",
        "robot.legs[0].joints[0].command.get();",
        "robot.legs[0].joints[0].target.set(1.5);",
        "robot.on.set(1);",
        "robot.mode.set(4);",
        "robot.legs[0].joints[0].target.set(true);",
        "robot.mode.take(2);",
    ],
)
def test_compiler_refuses_invalid_uses(wrong: str, runtime: list[Path], tmp_path: Path) -> None:
    source = tmp_path / "program.cc"
    source.write_text(f'#include "walker.hpp"\nvoid use(Walker &robot) {{ {wrong} }}\n')
    command = [*CPP, "-fsyntax-only", f"-I{runtime[0].parent}", str(source)]
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    assert result.returncode != 0
    assert "error" in result.stderr
    source.write_text(source.read_text().replace(wrong, ""))
    assert subprocess.run(command, check=False).returncode == 0


@pytest.mark.slow
@pytest.mark.parametrize("medium", MEDIA)
def test_words_blocks_posts_and_batches_arrive(medium: Medium, runtime: list[Path]) -> None:
    body = """
    link.write(0x10, 42);
    CHECK(link.read(0x10) == 42 && link.write_masked(0x10, 0xFF, 0xF0) == 42 && link.read(0x10) == 0xFA);
    link.write_block(0x20, {1, 2, 3});
    CHECK((link.read_block(0x20, 3) == unity_link::Words{1, 2, 3}));
    CHECK((link.read_many({0x22, 0x20}) == unity_link::Words{3, 1}));
    link.write_many({0x30, 0x31}, {8, 9});
    THROWS(ArgumentError, link.write_many({0x30, 0x31}, {8}));
    for (unsigned value = 0; value < 500; value++) link.post(0x40, value);
    CHECK(link.read(0x40) == 499);
    std::uint64_t first = 0, second = 0;
    unity_link::Batch batch{link};
    batch.read(0x30, &first);
    batch.write(0x30, 5);
    batch.read(0x30, &second);
    batch.finish();
    CHECK(first == 8 && second == 5);
    link.send_immediate(unity_link::SendImmediate::always);
    CHECK(link.info().data_bits == 32 && link.statistics().damaged == 0);
    link.close();
    THROWS(LinkLostError, link.read(0));
    """
    with simulate(medium) as url:
        output(program(body, runtime), url)


@pytest.mark.slow
def test_errors_have_classes_codes_and_a_sentence(runtime: list[Path]) -> None:
    body = """
    THROWS(BusError, link.write(0x88, 1));
    CHECK(last == "write at 0x88: the bus refused the access");
    try { link.write(0x88, 1); } catch (const std::system_error &error) {
        CHECK(error.code().category() == unity_link::category() && error.code().value() == UL_BUS_ERROR);
        CHECK(error.code().message() == "the bus refused the access");
    }
    link.post(0x88, 1);
    THROWS(GatewayError, link.fence());
    link.fence();
    THROWS(ArgumentError, link.read(0x100));
    THROWS(ConnectError, unity_link::Link{"tcp://127.0.0.1:1"});
    THROWS(ArgumentError, unity_link::Link{"nosuch:1"});
    """
    with simulate("tcp", "--robot", "scara") as url:
        output(program(body, runtime), url)


@pytest.mark.slow
def test_lost_answers_are_repeated_with_their_old_values(runtime: list[Path]) -> None:
    body = """
    CHECK(link.write_masked(0x10, 1, 1) == 0);      // the word as it was before is given again
    CHECK(link.read(0x10) == 1);
    robot.on.set(true);         // nobody wants the answer of this masked write
    CHECK(robot.on.get());
    robot.samples.get();        // what was taken from a queue comes again
    robot.legs[0].joints[0].pos.set(1);
    CHECK(robot.legs[0].joints[0].pos.get() == 1.0 && link.statistics().repetitions >= 5);
    """
    with simulate("tcp") as gateway:
        faults = [lose("^wk000"), lose("^wk002"), lose("^rq004"), lose("^w005"), lose("^r006")]
        with FaultyLine(gateway, "tcp", faults) as line:
            output(program(body, runtime), line.url)
            assert line.count("^wk") >= 4
            assert line.count("^w005") >= 2
            assert line.count("^rq004") >= 2


@pytest.mark.slow
def test_gateway_that_rejects_every_request_is_an_error_and_then_lost(runtime: list[Path]) -> None:
    body = """
    std::uint64_t word = 0;
    {
        unity_link::Batch batch{link};
        batch.read(0x10, &word);
        THROWS(UnsupportedError, batch.finish());
        CHECK(last == "read at 0x10: the gateway does not know the command");
    }
    THROWS(LinkLostError, link.write_block(0x10, {1, 2}));
    CHECK(last == "block write at 0x10: the gateway does not answer any more: is it powered and connected, or does "
                  "another program read its answers?; the request is perhaps executed");
    THROWS(LinkLostError, link.read(0x11));
    """
    unknown = Framing(Crc()).checked(b"J")
    with (
        simulate("tcp") as gateway,
        FaultyLine(gateway, "tcp", requests=[replace("^[g-z]", unknown, 10**6)]) as line,
    ):
        output(program(body, runtime), line.url)


@pytest.mark.slow
def test_unanswered_call_reports_its_outcome(runtime: list[Path]) -> None:
    body = """
    std::cout << "ready" << std::endl;
    std::cin.get();
    try { for (;;) link.write(0x10, 1); } catch (const unity_link::LinkLostError &error) {
        CHECK(error.outcome() != unity_link::Outcome::executed);
    }
    try { link.write(0x10, 1); } catch (const unity_link::LinkLostError &error) {
        CHECK(error.outcome() == unity_link::Outcome::not_executed);
    }
    """
    made = program(body, runtime)
    with simulate("tcp") as url:
        process = subprocess.Popen([made, url], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        assert process.stdout is not None
        assert process.stdout.readline() == "ready\n"
    process.communicate("\n", timeout=60)
    assert process.returncode == 0


@pytest.mark.slow
def test_a_gateway_that_was_reset_is_a_lost_link_and_a_new_one_goes_on(runtime: list[Path]) -> None:
    body = """
    link.write(0x10, 7);
    unity_link::Subscription samples{link, {0x10}, {100}};
    CHECK(samples.next(5s));
    std::cout << "ready" << std::endl;
    std::cin.get();
    for (unsigned value = 0; value < 50; value++) {
        try { link.write(0x20, value); CHECK(!"it throws"); } catch (const unity_link::LinkLostError &error) {
            // On a busy machine the first may have been repeated, and then its outcome is unknown.
            const bool again = value == 0 && link.statistics().repetitions > 0;
            CHECK(error.outcome() == unity_link::Outcome::not_executed
                  || (again && error.outcome() == unity_link::Outcome::unknown));
            last = error.what();
        }
    }
    CHECK(last == "write at 0x20: the gateway was reset, which ends the link; the request is known not to be executed");
    link.close();
    unity_link::Link again{arguments[1]};
    again.write(0x20, 1);
    CHECK(again.read(0x10) == 7);
    unity_link::Subscription anew{again, {0x20}, {100}};
    CHECK((anew.next(5s)->words == unity_link::Words{1}));
    """
    made, gateway = program(body, runtime), ObservedGateway()
    with serve(gateway) as url:
        process = subprocess.Popen([made, url], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        assert process.stdout is not None
        assert process.stdout.readline() == "ready\n"
        gateway.reset()
        process.communicate("\n", timeout=60)
    assert process.returncode == 0
    assert gateway.bus_log.writes == [(0x10, 7), (0x20, 1)]
    assert len(set(gateway.sessions())) == 2


@pytest.mark.slow
@pytest.mark.parametrize("medium", MEDIA)
def test_groups_come_by_callback_and_one_by_one(medium: Medium, runtime: list[Path]) -> None:
    body = """
    robot.clock.set(77u);
    robot.mode.set(Walker::Mode::walking);
    robot.legs[1].joints[0].pos.set(-0.5);
    CHECK(robot.state.read().clock == 77);
    std::vector<std::uint64_t> seen;
    unity_link::Seconds before{0};
    {
        auto feed = robot.state.subscribe([&](const Walker::State &values, const unity_link::Sample &sample) {
            if (values.clock != 77 || values.mode != Walker::Mode::walking) return;
            if (values.legs_1_joints_0_pos != -0.5) return;
            if (!(before < sample.time)) return;
            before = sample.time;
            seen.push_back(sample.sequence - sample.lost);
            robot.legs[0].joints[0].command.post(seen.size());     // a callback may use the link
        });
        CHECK(feed.subscription().rate_hz() == 1000);
        while (seen.size() < 5) link.poll(10ms);
        CHECK(link.read(3) == seen.size());
        CHECK(feed.subscription().received() >= 5);
    }
    auto feed = robot.state.subscribe();
    auto next = feed.next(5s);
    CHECK(next && next->first.clock == 77 && next->second.sequence == 0);
    CHECK(std::abs(robot.slow.subscribe().subscription().rate_hz() - 2.0) < 1e-9);
    THROWS(ArgumentError, (unity_link::Subscription{link, {0x61}, {0.5}}));
    THROWS(ArgumentError, robot.state.subscribe());
    CHECK(last == "subscription: group 1 of the gateway is in use, or there is none" && feed.next(5s));
    feed.subscription().stop();

    unity_link::Subscription samples{link, {0x61, 0x62}};
    samples.publish();
    auto sample = samples.next(5s);
    CHECK(sample && (sample->words == unity_link::Words{77, 0}) && sample->lost == 0);
    CHECK(!samples.next(0s));
    auto moved = std::move(samples);
    moved.publish();
    CHECK(moved.next(5s)->sequence == 1);
    THROWS(ArgumentError, (unity_link::Subscription{link, {0x61}, {1e12}}));

    unity_link::Subscription throwing{link, {0x61}, {}, [](const auto &) { throw std::runtime_error("mine"); }};
    throwing.publish();
    try { link.poll(0s); CHECK(!"it throws"); } catch (const std::runtime_error &error) { last = error.what(); }
    CHECK(last == "mine");
    """
    with simulate(medium) as url:
        output(program(body, runtime), url)


@pytest.mark.slow
def test_callback_may_end_its_subscription_and_then_throw(runtime: list[Path]) -> None:
    body = """
    std::unique_ptr<unity_link::Subscription> once;
    int calls = 0;
    once = std::make_unique<unity_link::Subscription>(link, std::vector<std::uint32_t>{0x61}, unity_link::Schedule{},
        [&](const unity_link::Sample &) { calls++; once.reset(); throw std::runtime_error("mine"); });
    once->publish();
    once->publish();
    try { link.poll(0s); CHECK(!"it throws"); } catch (const std::runtime_error &error) { last = error.what(); }
    CHECK(last == "mine");
    link.poll(0s);
    CHECK(calls == 1);
    """
    with simulate("tcp") as url:
        output(program(body, runtime), url)


@pytest.mark.slow
def test_a_spec_for_words_of_another_width_is_noticed(runtime: list[Path]) -> None:
    body = "    THROWS(UnsupportedError, robot.legs[0].joints[0].target.get());\n"
    with simulate("tcp", "--set", "data_bits=16") as url:
        output(program(body, runtime), url)


@pytest.mark.slow
def test_gateway_of_another_map_is_refused_before_writes_unless_map_is_any(runtime: list[Path]) -> None:
    fingerprint = WALKER.interface().fingerprint
    body = f"""
    THROWS(UnsupportedError, link.check_map(0xCAFE, "walker"));
    CHECK(last == "the gateway was built for the map {fingerprint:08X}, and walker describes the map 0000CAFE: "
                  "generate the client from the spec that the gateway was built from, or build the gateway anew, or "
                  "write map=any in the URL");
    Walker known{{link, unity_link::any_map}};
    known.on.set(true);
    link.check_map(0xCAFE, "walker");
    """
    features = int(GatewayInfo().features | Feature.FINGERPRINT)
    made = program(body, runtime)
    with simulate("tcp", "--set", f"features={features}", "--set", f"build_id={fingerprint}") as url:
        output(made, url)
    with simulate("tcp", "--set", f"features={features}", "--set", "build_id=0xCAFE") as url:
        refused = subprocess.run([made, url], capture_output=True, text=True, check=False)
        unlike = program('THROWS(Error, throw unity_link::Error(UL_LOST, ""));', runtime)
        output(unlike, f"{url}?map=any")
    assert refused.returncode != 0
    assert f"the map 0000CAFE, and walker describes the map {fingerprint:08X}" in refused.stdout + refused.stderr
