"""The generated client in C works as the protocol and the documents state, with real gateways on real media."""

from __future__ import annotations

import itertools
import math
import re
import socket
import statistics
import subprocess
import sys
import time
from collections import Counter
from itertools import pairwise
from typing import TYPE_CHECKING, Literal

import msgspec
import numpy as np
import pytest
from hypothesis import Phase, example, given, settings

from generate import random_answers
from generate.awkward_names import (
    FUNCTIONS_OF_A_FAMILY,
    GROUPS_BY_KEYWORDS,
    INTERFACE_AS_A_PARAMETER,
    NOTHING_AT_ALL,
    NOTHING_INSIDE,
    PARAMETERS_OF_NETWORKS,
    TRIGRAPHS,
    awkward_specs,
)
from generate.every_kind import LIMIT_TRIALS, LIMITS_BEYOND_DOUBLES, WORD_BITS, bad_values, every_kind, written
from generate.peers import (
    MEDIA,
    Fault,
    FaultyLine,
    Medium,
    ObservedGateway,
    answer,
    damage,
    double,
    lose,
    serve,
    simulate,
)
from generate.programs import (
    CPP,
    HERE,
    PATIENCE,
    SANITIZED,
    C,
    Driven,
    Simulated,
    SimulatedLine,
    checked,
    compiled,
    generated,
    linked,
    output,
)
from support.recorded_bus import RecordedBus
from support.searching import examples
from support.simulated_host import LineOfASession, SimulatedHost, outcome_of
from support.spec_examples import FIGURE_1, specs
from support.valve import Uncounting
from unity_link.errors import Outcome, UnsupportedError
from unity_link.generate.c.layout import Layout
from unity_link.protocol.host.batches import WordBatch
from unity_link.protocol.window.constants import (
    DONE_FOR_ONE_MORE,
    FEWEST_IN_FLIGHT,
    LONGEST_SILENCE,
    LONGEST_TIMEOUT,
    QUICK_TIMEOUT,
)
from unity_link.protocol.wire.configuration import Feature, GatewayInfo
from unity_link.protocol.wire.crc import Crc, seed_of
from unity_link.protocol.wire.frames import Framing
from unity_link.protocol.wire.messages import ErrorCode
from unity_link.spec import KindName, compile_file, compile_text
from unity_link.spec.printer import print_file
from unity_link.virtual import VirtualGateway
from unity_link.virtual.build import build_gateway
from unity_link.virtual.faults import Failing, Noise, NoisyLine

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from unity_link.spec import Signal, Value
    from unity_link.spec.syntax import File

BUS_ERROR, BUS_TIMEOUT = "4 ", "5 "
LOST, LOST_EXECUTED, LOST_NOT_EXECUTED, UNANSWERED, NO_CONNECTION, UNSUPPORTED, BAD_ARGUMENT, NO_SAMPLE = (
    f"{number} " for number in range(32, 40)
)
SILENT = (
    "the gateway does not answer any more: is it powered and connected, or does another program read its answers?; "
    "the request is"
)
EXAMPLES = HERE.parents[1] / "examples"
DEFAULT_INFO = GatewayInfo()


@pytest.fixture(scope="session")
def small_driver(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the client with a small window and short frames, for a machine with little memory."""
    directory = tmp_path_factory.mktemp("small_driver")
    generated("c", compile_text(FIGURE_1), directory)
    sources = [directory / "unity_link.c", directory / "unity_link_posix.c", HERE / "driver.c"]
    sizes = ("-DUL_WINDOW=4", "-DUL_LONGEST_FRAME=192")
    return linked(C, compiled(C, sources, directory, *SANITIZED, *sizes), directory / "driver", *SANITIZED)


# Compiling


@pytest.mark.slow
@pytest.mark.parametrize("word_bits", [None, *WORD_BITS])
def test_generated_c_and_its_headers_in_cpp_compile_without_warnings(word_bits: int | None, tmp_path: Path) -> None:
    spec = compile_text(FIGURE_1) if word_bits is None else every_kind(word_bits)
    files = generated("c", spec, tmp_path)
    compiled(C, [path for path in files if path.suffix == ".c"], tmp_path)
    name = spec.interface().name
    (tmp_path / "program.cc").write_text(f'#include "{name}.h"\nint main() {{ return sizeof {name} == 0; }}\n')
    compiled(CPP, [tmp_path / "program.cc"], tmp_path)


def test_the_protocol_needs_nothing_of_posix(tmp_path: Path) -> None:
    generated("c", compile_text(FIGURE_1), tmp_path)
    headers = re.findall(r"#include <(\S+)>", (tmp_path / "unity_link.c").read_text())
    assert headers == ["stdio.h", "string.h"]
    assert "alloc" not in (tmp_path / "unity_link.c").read_text().replace("allocated", "")


@pytest.mark.slow
def test_names_that_c_or_cpp_keep_for_themselves_get_an_underscore(tmp_path: Path) -> None:
    spec = compile_text(
        "enum class { int, double, union, large = 0xFFFFFFFFFF }\n"
        "group template;\n"
        "public signal() {\n"
        "  @int = 1: READWRITE(GROUP(template)); @int_ = 2: READWRITE(); @errno = 8: class 40 READWRITE();\n"
        '  new: struct(); @linux = 5: READWRITE(UNIT="*/ ??/ \\\\ \\"");\n'
        "}\n"
        "/// Not the end: */ ??/\n"
        "struct() { @while = 4: float READWRITE(GROUP(template)); }\n"
    )
    files = generated("c", spec, tmp_path)
    (tmp_path / "program.c").write_text(
        '#include "signal_.h"\n'
        "int main(void) { return (int)(signal_.int_.signal.address + signal_.int__.signal.address\n"
        "    + signal_.errno_.signal.address + signal_.new_.while_.signal.address + SIGNAL__CLASS_UNION\n"
        "    + (SIGNAL__CLASS_LARGE >> 40)); }\n"
    )
    sources = [*(path for path in files if path.suffix == ".c"), tmp_path / "program.c"]
    compiled(C, sources, tmp_path)
    (tmp_path / "program.cc").write_text((tmp_path / "program.c").read_text().replace("(void)", "()"))
    compiled(CPP, [tmp_path / "program.cc"], tmp_path)


@pytest.mark.slow
@settings(max_examples=examples(12), phases=[Phase.explicit, Phase.reuse, Phase.generate])
@given(specs())
def test_any_spec_makes_code_that_compiles(tmp_path_factory: pytest.TempPathFactory, file: File) -> None:
    directory = tmp_path_factory.mktemp("any")
    spec = compile_text(print_file(file))
    files = generated("cpp", spec, directory)
    own, header = files[3], files[0]
    compiled(C, [own], directory, "-fsyntax-only")
    (directory / "program.cc").write_text(f'#include "{header.name}"\n')
    compiled(CPP, [directory / "program.cc"], directory, "-fsyntax-only")


@pytest.mark.slow
@settings(max_examples=examples(4), phases=[Phase.explicit, Phase.reuse, Phase.generate])
@given(awkward_specs())
@example(GROUPS_BY_KEYWORDS)
@example(INTERFACE_AS_A_PARAMETER)
@example(FUNCTIONS_OF_A_FAMILY)
@example(PARAMETERS_OF_NETWORKS)
@example(NOTHING_INSIDE)
@example(NOTHING_AT_ALL)
@example(TRIGRAPHS)
def test_any_names_make_code_that_compiles(tmp_path_factory: pytest.TempPathFactory, text: str) -> None:
    directory = tmp_path_factory.mktemp("names")
    files = generated("cpp", compile_text(text), directory)
    own, header = files[3], files[0]
    assert len({path.name.lower() for path in files}) == len(files)
    (directory / "program.cc").write_text(f'#include "{header.name}"\n')
    checked(C, own, directory)
    checked(CPP, directory / "program.cc", directory)


@pytest.mark.slow
def test_ten_thousand_signals_are_generated(tmp_path: Path) -> None:
    joints = "joint() : @(base) { " + " ".join(f"@s{number} = base + {number}: READ();" for number in range(50)) + " }"
    spec = compile_text(f"public big() {{ GATEWAY(ADDRESS_BITS=16); legs[200]: joint() @(50 * i); }} {joints}")
    files = generated("c", spec, tmp_path)
    compiled(C, [path for path in files if path.name == "big.c"], tmp_path, "-O0")


# Words


@pytest.mark.parametrize("medium", MEDIA)
def test_words_blocks_batches_and_posted_writes_arrive(client: Driven, medium: Medium) -> None:
    with simulate(medium) as url:
        client.words(f"connect {url} 5")
        client.words("write 10 2A")
        assert client.words("read 10") == [42]
        assert client.words("masked 10 FF F0") == [42]
        assert client.words("read 10") == [0xFA]
        client.words("wblock 20 " + " ".join(f"{3 * index:X}" for index in range(100)))
        assert client.words("rblock 20 64") == [3 * index for index in range(100)]
        assert client.words("rmany 20 22 21 FF") == [0, 6, 3, 0]
        client.words("wmany 30 1 31 2 32 3")
        assert client.words("rblock 30 3") == [1, 2, 3]
        assert client.words("batch 30 FFFFFFFF") == [1, 0xFFFFFFFF]
        for index in range(300):
            client.words(f"post 40 {index:X}")
        client.words("fence")
        assert client.words("read 40") == [299]
        client.words("immediate 1")
        assert client("end") == "0"
        client.words("close")
        closed = "the link was closed"
        assert (
            client("read 40") == f"{LOST_NOT_EXECUTED}read at 0x40: {closed}; the request is known not to be executed"
        )
        assert client("end") == f"0 {closed}"


@pytest.mark.slow
def test_a_unix_socket_is_as_good(client: Driven, tmp_path: Path) -> None:
    with simulate("unix", str(tmp_path / "socket")) as url:
        client.words(f"connect {url} 5")
        client.words("write 10 1")
        assert client.words("read 10") == [1]


@pytest.mark.slow
def test_blocks_longer_than_the_gateway_takes_travel_in_parts(client: Driven) -> None:
    with simulate("tcp", "--set", "block_words=7", "--set", "data_bits=64", "--set", "address_bits=12") as url:
        client.words(f"connect {url} 5")
        values = [(0x9E3779B97F4A7C15 * index) % 2**64 for index in range(600)]
        client.words("wblock 100 " + " ".join(f"{value:X}" for value in values))
        assert client.words("rblock 100 258") == values


@pytest.mark.slow
@pytest.mark.parametrize(
    "settings",
    [
        {"data_bits": 8, "crc_bits": 8, "id_digits": 2},
        {"data_bits": 13, "address_bits": 17, "crc_bits": 32},
        {"data_bits": 64, "address_bits": 32, "crc_polynomial": 0x1D},
        {"data_bits": 33, "crc_bits": 16, "crc_polynomial": 0x8005, "features": 0x60, "receive_fifo_bytes": 64},
    ],
    ids=str,
)
def test_gateways_of_any_width_are_understood(client: Driven, settings: dict[str, int]) -> None:
    most, last = (1 << settings["data_bits"]) - 1, (1 << settings.get("address_bits", 8)) - 1
    with simulate("tcp", *(f"--set={name}={value}" for name, value in settings.items())) as url:
        client.words(f"connect {url} 5")
        client.words(f"write {last:X} {most:X}")
        assert client.words(f"read {last:X}") == [most]
        assert client.words("rmany " + f"{last:X} " * 300) == [most] * 300
        for _ in range(50):
            client.words(f"post 0 {most:X}")
        client.words("fence")
        assert client.words("read 0") == [most]
        if last < 2**32 - 1:
            assert client(f"write {last + 1:X} 0").startswith(BAD_ARGUMENT)
        if most < 2**64 - 1:
            assert client(f"write 0 {most + 1:X}").startswith(BAD_ARGUMENT)
            assert client(f"wblock 0 0 {most + 1:X}").startswith(BAD_ARGUMENT)
        # Only damage is checked: a slow machine may cause retransmissions.
        assert client.words("statistics")[4] == 0


def test_a_gateway_on_a_shared_medium_is_reached_by_its_number(client: Driven) -> None:
    with serve(build_gateway(node=5)) as url:
        client.words(f"connect {url}?node=5 5")
        client.words("write 10 7")
        assert client.words("read 10") == [7]
        client.words("subscribe 0 0 - 10")
        client.words("publish 0")
        assert client("next 0 5").startswith("0 0 0 ")
    with serve(build_gateway(node=6)) as url:
        assert client(f"connect {url}?node=5 0.5").startswith(NO_CONNECTION)


@pytest.mark.slow
def test_little_memory_is_enough(small_driver: Path) -> None:
    with simulate("tcp") as url, Driven(small_driver) as client:
        client.words(f"connect {url} 5")
        client.words("wblock 20 " + " ".join(f"{3 * index:X}" for index in range(100)))
        assert client.words("rblock 20 64") == [3 * index for index in range(100)]
        assert client.words("rmany " + "21 " * 300) == [3] * 300
        for index in range(100):
            client.words(f"post 40 {index:X}")
        client.words("fence")
        assert client.words("read 40") == [99]
        client.words("subscribe 0 0 t " + " ".join(f"{index:X}" for index in range(18)))
        client.words("publish 0")
        assert client("next 0 5").startswith("0 0 0 ")
        assert client("subscribe 1 0 t " + " ".join(f"{index:X}" for index in range(19))).startswith(BAD_ARGUMENT)


# Errors


@pytest.mark.parametrize("medium", MEDIA)
def test_bus_error_names_the_request_and_affects_no_other(client: Driven, medium: Medium) -> None:
    with simulate(medium, "--robot", "scara") as url:
        client.words(f"connect {url} 5")
        assert client("write 88 1") == "4 write at 0x88: the bus refused the access"
        assert client("wmany 10 1 88 2 11 3") == "4 write at 0x88: the bus refused the access"
        assert client.words("rmany 10 11") == [1, 3]
        client.words("post 12 1")
        client.words("post 89 1")
        client.words("post 13 1")
        assert client("fence") == "4 posted write at 0x89: the bus refused the access"
        client.words("fence")
        assert client.words("rmany 12 13") == [1, 1]


def test_posted_writes_are_counted_by_outcome(driver: Path) -> None:
    gateway = ObservedGateway()
    gateway.detach([0x88, 0x89])
    gateway.attach(Failing(ErrorCode.BUS_ERROR), [0x88, 0x89])
    with Simulated(driver, gateway.receive) as client:
        client.words("connect test: 5")
        for address in (0x10, 0x89, 0x88, 0x11):
            client.words(f"post {address:X} 1")
        assert client.words("posts") == [0, int(BUS_ERROR), 0x89, 2, 0, 0]
        assert client.words("posts") == [0, 0, 0, 0, 0, 0]
        for value in range(3):
            client.words(f"post 10 {value}")
        gateway.reset_before = 0
        assert client.words("posts") == [int(LOST_NOT_EXECUTED), int(LOST_NOT_EXECUTED), 0x10, 0, 0, 3]
        client("close")


def test_every_error_code_has_a_sentence(client: Driven) -> None:
    gateway = VirtualGateway()
    gateway.attach(Failing(ErrorCode.BUS_TIMEOUT), [0x20])
    gateway.attach(Failing(ErrorCode.BUS_ERROR), [0x22])
    with serve(gateway) as url:
        client.words(f"connect {url} 5")
        assert client("read 20") == "5 read at 0x20: nothing on the bus answered"
        assert client("rblock 1F 3").startswith(BUS_TIMEOUT)
        client.words("write 21 5")
        assert client("wblock 21 9 9 9").startswith(BUS_ERROR)
        assert client.words("read 21") == [9]
        assert client("immediate 3") == (
            "6 choice of send-immediate at 0x03: the gateway says that a value is out of its range"
        )


def test_feature_that_the_gateway_lacks_is_named(client: Driven) -> None:
    with simulate("tcp", "--set", "features=0") as url:
        client.words(f"connect {url} 5")
        for command in ("masked 0 1 1", "rqueue 0 2", "wqueue 0 1", "immediate 1", "subscribe 0 10 - 10"):
            assert client(command).startswith(UNSUPPORTED)
        assert client.words("read 0") == [0]


def test_request_beyond_the_gateways_widths_is_refused_before_it_is_sent(client: Driven) -> None:
    with simulate("tcp", "--set", "data_bits=16") as url:
        client.words(f"connect {url} 5")
        sent = client.words("statistics")[0]
        assert client("read 100") == "38 read at 0x100: the gateway has no such address"
        assert client("write 10 10000") == "38 write at 0x10: the gateway's words have fewer bits"
        assert client("post 10 10000") == "38 posted write at 0x10: the gateway's words have fewer bits"
        assert client("wblock 10 1 10000") == "38 block write at 0x10: the gateway's words have fewer bits"
        assert client("rblock FF 2") == "38 block read at 0xFF: it would pass the gateway's last address"
        assert client("rblock FF 0") == "38 block read at 0xFF: at least one word is needed"
        for command, name in (("wblock", "block write"), ("wqueue", "queue write")):
            refused = f"38 {name} at 0x00: the gateway's words have fewer bits"
            # The last word belongs to a request of its own.
            assert client(f"{command} 0 {'1 ' * 0xFF}10000") == refused
            assert client(f"{command} 0 10000{' 1' * 0xFF}") == refused
        assert client.words("statistics")[0] == sent


@pytest.mark.parametrize(
    ("url", "status", "words"),
    [
        ("http://robot", BAD_ARGUMENT, "'http://robot' is no URL of a gateway: serial:PORT"),
        ("tcp://robot", BAD_ARGUMENT, "'tcp://robot' is no URL of a gateway: serial:PORT"),
        (
            "serial:/dev/x?speed=9600",
            BAD_ARGUMENT,
            "'speed=9600' is no option of this URL: NAME=NUMBER with a name of baud",
        ),
        ("serial:/dev/x?node=5&baud=fast", BAD_ARGUMENT, "'baud=fast' is no option of this URL: NAME=NUMBER"),
        ("serial:/dev/x?rtscts=2", BAD_ARGUMENT, "'rtscts=2' is no option of this URL: 0 or 1 was expected"),
        ("serial:/dev/x?baud=0", BAD_ARGUMENT, "'baud=0' is no option of this URL: a rate from 1 to 2147483647 was"),
        ("serial:/dev/x?baud=2147483648", BAD_ARGUMENT, "'baud=2147483648' is no option of this URL: a rate from 1 to"),
        ("serial:/dev/x?baud=99999999999999999999", BAD_ARGUMENT, "'baud=99999999999999999999' is no option of this"),
        ("tcp://localhost:65537", BAD_ARGUMENT, "'tcp://localhost:65537' is no URL of a gateway: serial:PORT"),
        ("tcp://localhost:-1", BAD_ARGUMENT, "'tcp://localhost:-1' is no URL of a gateway: serial:PORT"),
        ("tcp://localhost:1?node=255", BAD_ARGUMENT, "'node=255' is no option of this URL: a number from 0 to 254"),
        (
            "tcp://localhost:1?baud=9600",
            BAD_ARGUMENT,
            "'baud=9600' is no option of this URL: node=NUMBER, echo=1, compact=0 or map=",
        ),
        ("tcp://localhost:1?map=all", BAD_ARGUMENT, "'map=all' is no option of this URL: map=any was expected"),
        ("tcp://localhost:1?map=anything", BAD_ARGUMENT, "'map=anything' is no option of this URL: map=any was"),
        ("serial:/dev/nosuch", NO_CONNECTION, "serial:/dev/nosuch cannot be opened: there is no such port"),
        ("unix:/nosuch", NO_CONNECTION, "unix:/nosuch cannot be opened: there is no such socket; is it served?"),
        ("tcp://127.0.0.1:1", NO_CONNECTION, "tcp://127.0.0.1:1 cannot be opened: nothing accepts the connection"),
    ],
)
def test_url_that_cannot_be_opened_is_reported_in_a_sentence(client: Driven, url: str, status: str, words: str) -> None:
    assert client(f"connect {url} 1").startswith(status + words)
    assert client("read 0").startswith(LOST_NOT_EXECUTED)


@pytest.mark.parametrize("timeout", ["nan", "inf", "1e10"])
def test_a_time_out_that_is_no_number_or_longer_than_thirty_years_is_refused(client: Driven, timeout: str) -> None:
    with simulate("tcp") as url:
        assert client(f"connect {url} {timeout}") == "38 timeout: 1e9 seconds at most were expected"


@pytest.mark.parametrize("url", ["", "serial:/dev/ttyNOPE", "nosuch:"], ids=["never", "no port", "no URL"])
def test_every_call_on_a_link_that_never_opened_reports_it(client: Driven, url: str) -> None:
    if url:
        assert not client(f"connect {url} 1").startswith("0")
    calls = (
        *("read 10", "write 10 1", "post 10 1", "masked 10 1 1", "rblock 10 3", "wblock 10 1 2", "rqueue 10 2"),
        *("wqueue 10 1 2", "rmany 10 11", "wmany 10 1 11 2", "batch 10 1", "fence", "immediate 1"),
        *("subscribe 0 100 - 10", "next 0 0.01", "next 0 0", "await 0 1 0.01", "poll 0", "poll 0.01"),
    )
    assert {call: client(call)[:3] for call in calls} == dict.fromkeys(calls, LOST_NOT_EXECUTED)
    assert (
        client("next 0 0")
        == f"{LOST_NOT_EXECUTED}subscription: the link was lost; the request is known not to be executed"
    )
    assert client("publish 0").startswith(BAD_ARGUMENT)
    for call in ("unsubscribe 0", "end", "close"):
        assert client(call) == "0"


INTERRUPTED = """\
#define _XOPEN_SOURCE 700
#include "unity_link.h"
#include <signal.h>
#include <stdio.h>
#include <sys/time.h>
static ul_link the_link;
static volatile sig_atomic_t handled;
static void handle(int number) { (void)number; handled++; }
int main(int count, char **arguments) {
    struct sigaction action = {.sa_handler = handle};
    struct itimerval often = {{0, 10000}, {0, 10000}}, never = {{0, 0}, {0, 0}};
    (void)count;
    sigaction(SIGALRM, &action, NULL);
    setitimer(ITIMER_REAL, &often, NULL);
    ul_connect(&the_link, arguments[1], 0.5);
    setitimer(ITIMER_REAL, &never, NULL);
    printf("%d %s\\n", (int)handled, ul_error(&the_link));
    return 0;
}
"""


def test_a_signal_that_the_program_handles_leaves_a_connection_its_time(runtime: list[Path], tmp_path: Path) -> None:
    (tmp_path / "program.c").write_text(INTERRUPTED)
    objects = compiled(C, [tmp_path / "program.c"], tmp_path, *SANITIZED, f"-I{runtime[0].parent}")
    program = linked(C, [*runtime, *objects], tmp_path / "program", *SANITIZED)
    with socket.create_server(("127.0.0.1", 0), backlog=0) as full, socket.create_connection(full.getsockname()):
        # The backlog has room for one connection, which is taken, so that the next connection is not accepted.
        handled, error = output(program, f"tcp://127.0.0.1:{full.getsockname()[1]}").split(" ", 1)
    assert error.rstrip().endswith("cannot be opened: the connection was not accepted in time")
    assert int(handled) > 10


PATIENT = """\
#define _POSIX_C_SOURCE 200809L
#include "unity_link.h"
#include <netdb.h>
#include <netinet/in.h>
#include <poll.h>
#include <stdio.h>
#include <sys/socket.h>
#include <time.h>
int __real_getaddrinfo(const char *, const char *, const struct addrinfo *, struct addrinfo **);
int __wrap_getaddrinfo(const char *, const char *, const struct addrinfo *, struct addrinfo **);
int __wrap_clock_gettime(clockid_t, struct timespec *);
int __wrap_poll(struct pollfd *, nfds_t, int);
int __real_poll(struct pollfd *, nfds_t, int);
static double the_time;
static ul_link the_link;
/* Time passes with each look at the clock, and while the program waits; what is there is there at once. */
int __wrap_clock_gettime(clockid_t which, struct timespec *time) {
    (void)which;
    the_time += 1e-6;
    time->tv_sec = (time_t)the_time;
    time->tv_nsec = (long)((the_time - (double)time->tv_sec) * 1e9);
    return 0;
}
int __wrap_poll(struct pollfd *polled, nfds_t count, int milliseconds) {
    int ready = __real_poll(polled, count, 0);
    if (ready == 0) the_time += milliseconds * 1e-3;
    return ready;
}
/* To look up a name takes its time, and it has the same address twice. */
int __wrap_getaddrinfo(const char *host, const char *port, const struct addrinfo *hints, struct addrinfo **found) {
    int status = __real_getaddrinfo(host, port, hints, found);
    the_time += 2;
    if (status == 0 && (*found)->ai_next == NULL) __real_getaddrinfo(host, port, hints, &(*found)->ai_next);
    return status;
}
int main(int count, char **arguments) {
    (void)count;
    ul_connect(&the_link, arguments[1], 5.0);
    printf("%.1f %s\\n", the_time, ul_error(&the_link));
    return 0;
}
"""


@pytest.mark.parametrize(
    ("backlog", "sentence"),
    [(8, "no gateway answered: check"), (0, "cannot be opened: the connection was not accepted in time")],
    ids=["silent", "not accepted"],
)
def test_the_time_out_is_that_of_all_addresses_and_of_the_answer_together(
    runtime: list[Path], tmp_path: Path, backlog: int, sentence: str
) -> None:
    (tmp_path / "program.c").write_text(PATIENT)
    objects = compiled(C, [tmp_path / "program.c"], tmp_path, *SANITIZED, f"-I{runtime[0].parent}")
    wrapped = [f"-Wl,--wrap={name}" for name in ("getaddrinfo", "clock_gettime", "poll")]
    program = linked(C, [*runtime, *objects], tmp_path / "program", *SANITIZED, *wrapped)
    with (
        socket.create_server(("127.0.0.1", 0), backlog=backlog) as server,
        socket.create_connection(server.getsockname()),
    ):
        passed, error = output(program, f"tcp://127.0.0.1:{server.getsockname()[1]}").split(" ", 1)
    assert sentence in error
    assert passed == "5.0"


HANDED_DOWN = """\
#include "unity_link.h"
#include <stdio.h>
#include <stdlib.h>
static ul_link the_link;
int main(int count, char **arguments) {
    (void)count;
    if (ul_connect(&the_link, arguments[1], 5.0)) return puts(ul_error(&the_link));
    return system("ls -l /proc/self/fd | grep -e socket: -e eventpoll -e /dev/pts/");
}
"""


@pytest.mark.slow
@pytest.mark.skipif(sys.platform != "linux", reason="looks into /proc")
@pytest.mark.parametrize("medium", ["tcp", "unix", "pty"])
def test_child_program_does_not_keep_the_connection_open(
    runtime: list[Path], tmp_path: Path, medium: Literal["tcp", "unix", "pty"]
) -> None:
    (tmp_path / "program.c").write_text(HANDED_DOWN)
    objects = compiled(C, [tmp_path / "program.c"], tmp_path, *SANITIZED, f"-I{runtime[0].parent}")
    program = linked(C, [*runtime, *objects], tmp_path / "program", *SANITIZED)
    with simulate(medium, *([str(tmp_path / "socket")] if medium == "unix" else [])) as url:
        told = subprocess.run([program, url], capture_output=True, text=True, timeout=PATIENCE, check=False)
    assert not told.stdout


def test_a_time_out_may_be_longer_than_the_system_can_wait_at_once(client: Driven) -> None:
    with simulate("tcp") as url:
        # In milliseconds, half more than the largest int.
        client.words(f"connect {url} 2147483.6475")
        client.words("close")
        client.words(f"connect {url} 1e9")


def test_a_time_out_that_is_no_number_has_passed(client: Driven) -> None:
    with simulate("tcp") as url:
        client.words(f"connect {url} 5")
        client.words("subscribe 0 0 - 10")
        assert client("await 0 1 nan").startswith(NO_SAMPLE)
        client.words("poll nan")
        assert client("next 0 nan").startswith(NO_SAMPLE)


def test_port_without_answers_is_no_gateway(client: Driven) -> None:
    with socket.create_server(("127.0.0.1", 0)) as silent:
        assert client(f"connect tcp://127.0.0.1:{silent.getsockname()[1]} 0.3").startswith(NO_CONNECTION)


def test_connection_that_ends_before_the_first_answer_is_reported_as_such(client: Driven) -> None:
    with socket.create_server(("127.0.0.1", 0)) as server:
        client.send(f"connect tcp://127.0.0.1:{server.getsockname()[1]} 5")
        server.accept()[0].close()
        assert client.answer() == f"{NO_CONNECTION}the connection was lost before the gateway answered"


def test_idle_link_is_closed_without_a_request(driver: Path) -> None:
    gateway = FallingSilent()
    with Simulated(driver, gateway) as client:
        client.words("connect test: 5")
        client.words("post 10 1")
        client.words("fence")
        gateway.is_silent, before = True, client.words("statistics")[0]
        client.words("close")
        assert client.words("statistics")[0] == before


def test_port_in_use_by_another_program_is_reported(driver: Path) -> None:
    with simulate("pty") as url, Driven(driver) as first, Driven(driver) as second:
        first.words(f"connect {url}?baud=1234567&rtscts=0 5")
        assert second(f"connect {url} 5") == f"{NO_CONNECTION}{url} cannot be opened: in use by another program"
        first.words("close")
        second.words(f"connect {url} 5")


# Exactly once


@pytest.mark.slow
@pytest.mark.parametrize("medium", MEDIA)
@pytest.mark.parametrize("fault", [lose, damage])
def test_lost_answer_is_requested_again_and_nothing_executes_twice(
    client: Driven, medium: Medium, fault: Callable[[str], Fault]
) -> None:
    with simulate("tcp") as gateway, FaultyLine(gateway, medium, [fault("^w000"), fault("^r002")]) as line:
        client.words(f"connect {line.url} 5")
        client.words("write 10 1")
        client.words("write 10 2")
        assert client.words("read 10") == [2]
        assert line.count("^w000") >= 2
        assert line.count("^r002") >= 2
        client.words("close")


class Counting:
    """A queue that returns 0, 1, 2 and so on, and stores written words."""

    def __init__(self) -> None:
        self.given = 0
        self.taken: list[int] = []

    def read(self, offset: int, now: float) -> int:
        self.given += 1
        return self.given - 1

    def write(self, offset: int, value: int, now: float) -> None:
        self.taken.append(value)


def test_request_with_side_effects_executes_once_and_its_answer_is_repeated(client: Driven) -> None:
    gateway, queue = VirtualGateway(), Counting()
    gateway.attach(queue, [0x20])
    with serve(gateway) as url, FaultyLine(url, "tcp", [lose("^rq"), lose("^wk"), lose("^wq")]) as line:
        client.words(f"connect {line.url} 5")
        assert client.words("rqueue 20 2") == [0, 1]
        assert client.words("rqueue 20 2") == [2, 3]
        assert client.words("masked 30 F 3") == [0]
        assert client.words("read 30") == [3]
        client.words("wqueue 20 7 8 9")
        assert queue.taken == [7, 8, 9]


@pytest.mark.parametrize("fault", [lose, damage, double])
def test_damaged_requests_are_retransmitted_in_order(client: Driven, fault: Callable[[str], Fault]) -> None:
    gateway, queue = VirtualGateway(), Counting()
    gateway.attach(queue, [0x20])
    faults = [fault(f"^ws?{number:03X}") for number in (1, 5, 6, 20, 21, 60)]
    with serve(gateway) as url, FaultyLine(url, "tcp", requests=faults) as line:
        client.words(f"connect {line.url} 5")
        client.words("wmany " + " ".join(f"20 {value:X}" for value in range(30)))
        for value in range(30, 100):
            client.words(f"post 20 {value:X}")
        client.words("fence")
        assert queue.taken == list(range(100))


def test_lost_posted_write_is_retransmitted_before_later_requests_execute(client: Driven) -> None:
    with simulate("tcp") as gateway, FaultyLine(gateway, "tcp", requests=[lose("^ws000")]) as line:
        client.words(f"connect {line.url} 5")
        client.words("post 10 7")
        assert client.words("read 10") == [7]
        assert line.count("^ws000") >= 2


def test_request_that_the_gateway_rejects_is_given_up_and_later_ones_go_on(client: Driven) -> None:
    malformed = answer("^w000", b"w%b", 99)
    with simulate("tcp") as gateway, FaultyLine(gateway, "tcp", requests=[malformed]) as line:
        client.words(f"connect {line.url} 5")
        assert client("wmany 10 7 11 8") == "3 write at 0x10: the gateway expects fields of another width"
        assert client.words("rmany 10 11") == [0, 8]
        assert line.count("^w000") >= 3
        assert line.count("^h000") >= 1


class Babbling:
    """A gateway that opens a session, and then gives the same answer to every request."""

    def __init__(self, answer: bytes) -> None:
        self._gateway, self._answer = VirtualGateway(), answer
        self.stops = False

    def __call__(self, data: bytes, now: float) -> bytes:
        """Return the answers to bytes."""
        frames = [frame for frame in re.split(rb"(?<=[\r\n])", data) if frame.strip()]
        return b"".join(self._answer if frame[0] in b"ghirw" else self._gateway.receive(frame, now) for frame in frames)


REFUSAL = Framing(Crc()).checked(b"X02")
DAMAGED_ANSWER = b"w0000\n"


@pytest.mark.parametrize(
    ("answer", "first"),
    [
        (REFUSAL, "2 {} at 0x10: the gateway does not know the command"),
        (DAMAGED_ANSWER, "35 {} at 0x10: every try was damaged on the way; the request is perhaps executed"),
    ],
    ids=["refused", "damaged"],
)
@pytest.mark.parametrize(
    ("command", "name"), [("read 10", "read"), ("wblock 10 1 2 3", "block write"), ("rblock 10 3", "block read")]
)
def test_request_given_up_fails_and_a_gateway_without_fence_answers_is_lost(
    driver: Path, answer: bytes, first: str, command: str, name: str
) -> None:
    with Simulated(driver, Babbling(answer)) as client:
        client.words("connect test: 5")
        assert client(command) == first.format(name)
        assert client("write 20 1") == f"{LOST}write at 0x20: {SILENT} perhaps executed"
        assert client("read 21").startswith(f"{LOST_NOT_EXECUTED}read at 0x21: ")
        client("close")


@pytest.mark.parametrize("answer", [REFUSAL, DAMAGED_ANSWER], ids=["refused", "damaged"])
def test_requests_in_flight_end_with_their_failed_call(driver: Path, answer: bytes) -> None:
    with Simulated(driver, Babbling(answer)) as client:
        client.words("connect test: 5")
        for value in range(10):
            client.words(f"post 10 {value}")
        assert client("rmany 10 11 12").startswith(LOST)
        client("close")
        client.words("connect test: 5")
        assert client("subscribe 0 100 - 10 11 12").startswith(("2 ", UNANSWERED))
        assert client("close").startswith(LOST)


@pytest.mark.parametrize(("url", "repeats"), [("test:", False), ("test:0.002", True)])
def test_timeout_covers_the_latency_of_a_usb_chip_unless_the_medium_has_less(
    driver: Path, url: str, repeats: bool
) -> None:
    with Simulated(driver, VirtualGateway().receive, latency=0.0005) as client:
        client.words(f"connect {url} 5")
        for _ in range(50):
            client.words("read 10")
        client.latency = 0.016
        client.words("read 10")
        assert (client.words("statistics")[3] > 0) == repeats


class Faulty:
    """A gateway that damages each answer that a pattern matches `times` times."""

    def __init__(self, pattern: bytes, times: int, info: GatewayInfo = DEFAULT_INFO) -> None:
        self._gateway, self._pattern, self._times = VirtualGateway(info), re.compile(pattern), times
        self._damaged: Counter[bytes] = Counter()

    def __call__(self, data: bytes, now: float) -> bytes:
        """Return the bytes that arrive."""
        answers = self._gateway.receive(data, now).splitlines(keepends=True)
        return b"".join(self._after_faults(answer) for answer in answers)

    def _after_faults(self, answer: bytes) -> bytes:
        if not self._pattern.match(answer) or self._damaged[answer] == self._times:
            return answer
        self._damaged[answer] += 1
        return answer[:-2] + bytes([answer[-2] ^ 1]) + answer[-1:]


@pytest.mark.parametrize("times", [1, 2])
def test_damaged_answers_and_their_repetitions_are_requested_again_at_once(driver: Path, times: int) -> None:
    with Simulated(driver, Faulty(b"r..[05A]", times)) as client:
        client.words("connect test: 5")
        for _ in range(100):
            client.words("read 10")
        requests, _, repetitions, timeouts, damaged, _ = client.words("statistics")
        assert (requests, timeouts, damaged) == (100, 0, repetitions)
        assert repetitions >= 18 * times
        assert client.words("rmany " + "10 " * 300) == [0] * 300
        assert client.words("statistics")[3] == 0


def test_losses_among_many_requests_are_detected_almost_without_timeouts(driver: Path) -> None:
    line = NoisyLine(VirtualGateway(), Noise(1, loss=0.001, flip=0.001), Noise(2, loss=0.001, flip=0.001))
    with Simulated(driver, line.receive) as client:
        client.words("connect test: 30")
        for turn in range(20):
            client.words("wmany " + " ".join(f"{index:X} {index + turn:X}" for index in range(250)))
            assert client.words("rmany " + " ".join(f"{index:X}" for index in range(250))) == [
                index + turn for index in range(250)
            ]
        _, _, _, timeouts, damaged, _ = client.words("statistics")
        assert damaged > 100
        # If the last line end of a batch is lost, no later answer reveals it; only then a time-out is needed.
        assert timeouts < damaged / 50
        assert client.now < 1.1


# Errors on a line, as chances for each byte.
SPOILED = [
    {"flip": 0.01},
    {"loss": 0.01},
    {"flip": 0.002, "loss": 0.002},
    {"flip": 0.03},
    {"flip": 0.005, "double": 0.01},
]
TWO_DIGITS = GatewayInfo(id_digits=2)
"""Half of its sequence space is as many requests as the client has places for."""
COMPACT = GatewayInfo(id_digits=2, features=GatewayInfo().features | Feature.COMPACT)
BOTH_FORMS = pytest.mark.parametrize("info", [TWO_DIGITS, COMPACT], ids=["text", "compact"])
OUTCOMES = {None: 0, Outcome.UNKNOWN: 32, Outcome.EXECUTED: 33, Outcome.NOT_EXECUTED: 34}


@pytest.mark.slow
@pytest.mark.parametrize("together", [False, True], ids=["one by one", "together"])
@pytest.mark.parametrize("chances", SPOILED, ids=str)
@BOTH_FORMS
def test_client_sends_the_same_bytes_at_the_same_times_as_the_python_host(
    driver: Path, chances: dict[str, float], info: GatewayInfo, *, together: bool
) -> None:
    count = 200
    for seed in range(2):
        line, reference = (LineOfASession(VirtualGateway(info), seed, **chances) for _ in range(2))
        with Simulated(driver, line.receive) as client:
            client.words(f"connect test:{QUICK_TIMEOUT} 5")
            if together:
                client.words(f"apart 10 {count:X}")
            else:
                for value in range(count):
                    client.words(f"write 10 {value:X}")
            counted = client.words("statistics")
        assert line.chosen is not None
        host = SimulatedHost(reference.receive, QUICK_TIMEOUT, line.chosen)
        writes = [host.request("W", 0x10, value) for value in range(count)]
        if together:
            host.do(*writes)
        else:
            for write in writes:
                host.do(write)
        began, reference_began = line.sent[0][0], reference.sent[0][0]
        assert [(round(when - began, 6), data) for when, data in line.sent] == [
            (round(when - reference_began, 6), data) for when, data in reference.sent
        ]
        counters = host.session.counters
        assert counted[2:5] == [counters.repetitions, counters.timeouts, counters.damaged]


@pytest.mark.slow
@BOTH_FORMS
def test_outcomes_of_requests_at_a_reset_equal_those_of_the_python_host(driver: Path, info: GatewayInfo) -> None:
    for seed in range(24):
        chances = {"flip": 0.004 * (seed % 3), "loss": 0.002 * (seed % 4)}
        gateway, other = ObservedGateway(info), ObservedGateway(info)
        line, reference = LineOfASession(gateway, seed, **chances), LineOfASession(other, seed, **chances)
        with Simulated(driver, line.receive) as client:
            client.words(f"connect test:{QUICK_TIMEOUT} 5")
            gateway.reset_before = 11 * seed
            told = client.words(f"apart 10 {200:X}")
            client("close")
        assert line.chosen is not None
        host = SimulatedHost(reference.receive, QUICK_TIMEOUT, line.chosen)
        other.reset_before = 11 * seed
        writes = [host.request("W", 0x10, value) for value in range(200)]
        host.do(*writes)
        # The Python host sends the rest in a new session; the client has ended.
        ended = [OUTCOMES[outcome_of(write)] for write in writes]
        sent = [status for status in told if status != int(LOST_NOT_EXECUTED)]
        assert told[: len(sent)] == ended[: len(sent)] == sent
        assert {*ended[len(sent) :]} <= {0, int(LOST_NOT_EXECUTED)}


def test_batch_costs_as_many_retransmissions_as_in_the_python_host(driver: Path) -> None:
    mine = reference = 0
    for seed in range(3):
        line, other = (LineOfASession(VirtualGateway(TWO_DIGITS), seed, flip=0.01) for _ in range(2))
        with Simulated(driver, line.receive) as client:
            client.words(f"connect test:{QUICK_TIMEOUT} 5")
            client.words("rmany " + "10 " * 2000)
            mine += client.words("statistics")[2]
        host = SimulatedHost(other.receive, QUICK_TIMEOUT)
        codec = host.session.codec
        host.do(WordBatch(codec, "R", [(np.full(2000, 0x10), codec.info.address_digits)]))
        reference += host.session.counters.repetitions
    assert 0.8 < mine / reference < 1.2


def test_retransmission_begins_with_half_the_window_and_grows_with_answers(driver: Path) -> None:
    gateway, sizes = VirtualGateway(), list[int]()

    def losing_two(data: bytes, now: float) -> bytes:
        if reads := data.count(b"r"):
            sizes.append(reads)
        return b"" if reads and len(sizes) <= 2 else gateway.receive(data, now)

    with Simulated(driver, losing_two) as client:
        client.words("connect test: 5")
        assert client.words("rmany " + "10 " * 128) == [0] * 128
        # Two bursts are lost completely. After that, each `DONE_FOR_ONE_MORE` answers allow one more retransmission at
        # a time.
        assert sizes[:2] == [128, 64]
        came = 0
        for size in sizes[2:]:
            assert size == min(FEWEST_IN_FLIGHT + came // DONE_FOR_ONE_MORE, 128 - came)
            came += size
        client.words("close")


def test_answered_requests_are_not_retransmitted_nor_taken_for_signs_of_loss(driver: Path) -> None:
    gateway, waiting, sent = ObservedGateway(), list[bytes](), list[bytes]()

    def one_by_one(data: bytes, now: float) -> bytes:
        sent.extend(re.findall(rb"r[^\n]*", data))
        answers = gateway.receive(data, now).splitlines(keepends=True)
        if len(sent) == 4:
            # The answers to the first three requests are lost.
            answers = answers[-1:]
        waiting.extend(answers)
        return waiting.pop(0) if waiting else b""

    with Simulated(driver, one_by_one) as client:
        client.words("connect test: 5")
        assert client.words("rmany 10 11 12 13") == [0] * 4
        assert sent[4:] == sent[:3]
        assert client.words("statistics")[3] == 0
        client.words("close")


def test_each_damaged_answer_costs_one_retransmission_without_flow_control(driver: Path) -> None:
    info = GatewayInfo(features=Feature(0x7F) & ~Feature.FLOW_CONTROL, receive_fifo_bytes=64)
    with Simulated(driver, Faulty(b"r", 3, info)) as client:
        client.words("connect test: 5")
        client.words("read 10")
        repetitions, timeouts = client.words("statistics")[2:4]
        assert (repetitions, timeouts) == (3, 0)
        client.words("close")


@pytest.mark.slow
@pytest.mark.parametrize("flow_control", [True, False])
@pytest.mark.parametrize("program", ["driver", "small_driver"])
def test_posted_and_answered_writes_execute_once_and_in_order_on_a_bad_line(
    request: pytest.FixtureRequest, program: str, *, flow_control: bool
) -> None:
    features = Feature(0x7F) if flow_control else Feature(0x7F) & ~Feature.FLOW_CONTROL
    info = GatewayInfo(crc_bits=32, crc_polynomial=0x04C11DB7, features=features, receive_fifo_bytes=127)
    for seed in range(4):
        gateway = ObservedGateway(info)
        chances = {"loss": 0.0015 * (seed + 1), "flip": 0.0015 * (seed + 1)}
        line = NoisyLine(gateway, Noise(2 * seed, **chances), Noise(2 * seed + 1, **chances))
        with Simulated(request.getfixturevalue(program), line.receive) as client:
            client.words("connect test: 60")
            for first in (0, 300):
                for value in range(first, first + 150):
                    client.words(f"post 20 {value:X}")
                client.words("wmany " + " ".join(f"20 {value:X}" for value in range(first + 150, first + 300)))
            assert client.words("rmany " + "20 " * 200) == [599] * 200
            assert client.words("statistics")[2] > 0
            client.words("close")
        assert [word for _, word in gateway.bus_log.writes] == list(range(600))


def test_link_opens_without_timeouts_if_one_byte_in_a_hundred_is_damaged(driver: Path) -> None:
    took = []
    for seed in range(12):
        line = NoisyLine(VirtualGateway(), Noise(2 * seed, flip=0.01), Noise(2 * seed + 1, flip=0.01))
        with Simulated(driver, line.receive) as client:
            client.words(f"connect test:{QUICK_TIMEOUT} 5")
            took.append(client.now)
            client("close")
    # A round trip takes a millisecond, and an attempt without an answer a hundred.
    assert statistics.median(took) < 0.02
    assert max(took) < 1


def test_an_opening_that_noise_has_drawn_out_does_not_have_later_losses_wait(driver: Path) -> None:
    gateway, losses = VirtualGateway(), Counter({b"K": 4, b"r": 1})

    def losing(data: bytes, now: float) -> bytes:
        answers = gateway.receive(data, now)
        losses[answers[:1]] -= 1
        return b"" if losses[answers[:1]] >= 0 else answers

    with Simulated(driver, losing) as client:
        client.words("connect test: 30")
        began = client.now
        assert client.words("rmany " + "10 " * 128) == [0] * 128
        assert client.now - began < 2 * LONGEST_TIMEOUT
        client.words("close")


def test_a_gateway_without_flow_control_gets_no_more_than_its_fifo_holds(driver: Path) -> None:
    # The way back has room for one answer at a time, so that requests wait before the gateway.
    built = {
        "features": Feature(0x7F) & ~Feature.FLOW_CONTROL,
        "receive_fifo_bytes": 64,
        "transmit_fifo_bytes": 16,
    }
    with SimulatedLine(driver, build_gateway(configuration=built, bytes_per_second=20_000)) as client:
        client.words("connect test: 10")
        for value in range(100):
            client.words(f"post 10 {value:X}")
        assert client.words("rmany " + "10 " * 50) == [99] * 50
        client.words("wblock 20 " + " ".join(f"{value:X}" for value in range(6)))
        assert client.words("statistics")[2:] == [0, 0, 0, 0]
        client.words("close")


@pytest.mark.slow
@pytest.mark.parametrize("medium", MEDIA)
def test_a_noisy_line_loses_nothing(client: Driven, medium: Medium) -> None:
    noise = ("--set", "crc_bits=32", "--loss", "0.0002", "--flip", "0.0002", "--double", "0.0002", "--seed", "3")
    with simulate(medium, *noise) as url:
        client.words(f"connect {url} 30")
        client.words("wmany " + " ".join(f"{index:X} {index:X}" for index in range(256)))
        for turn in range(5):
            assert client.words("rmany " + " ".join(f"{index:X}" for index in range(256))) == [
                index + turn for index in range(256)
            ]
            client.words("wmany " + " ".join(f"{index:X} {index + turn + 1:X}" for index in range(256)))
        assert client.words("statistics")[2] > 0


@pytest.mark.slow
def test_a_gateway_that_goes_away_ends_the_calls(client: Driven) -> None:
    with simulate("tcp") as url:
        client.words(f"connect {url} 5")
        client.words("write 10 1")
    assert client("write 10 1").startswith((LOST, LOST_NOT_EXECUTED))
    gone = "the connection was lost (its port, or its other side, is gone)"
    assert client("read 10") == f"{LOST_NOT_EXECUTED}read at 0x10: {gone}; the request is known not to be executed"
    client.words("close")
    with simulate("tcp") as url:
        client.words(f"connect {url} 5")
        assert client.words("read 10") == [0]


class FallingSilent:
    """A gateway that stops answering requests at some instant, and continues to publish."""

    def __init__(self) -> None:
        self._gateway = VirtualGateway()
        self.is_silent = False

    def __call__(self, data: bytes, now: float) -> bytes:
        """Return the bytes that the gateway sends."""
        return self._gateway.advance(now) if self.is_silent else self._gateway.receive(data, now)


@pytest.mark.parametrize("publishes", [False, True])
def test_a_gateway_that_falls_silent_is_given_up_after_the_longest_silence(driver: Path, *, publishes: bool) -> None:
    gateway = FallingSilent()
    with Simulated(driver, gateway) as client:
        client.words("connect test: 5")
        if publishes:
            client.words("subscribe 0 100 - 10")
        client.words("write 10 1")
        gateway.is_silent, began = True, client.now
        assert client("write 10 2") == f"{LOST}write at 0x10: {SILENT} perhaps executed"
        assert LONGEST_SILENCE <= client.now - began < LONGEST_SILENCE + LONGEST_TIMEOUT
        assert client("write 10 3").startswith(LOST_NOT_EXECUTED)
        client("close")


# Sessions


WAS_RESET = "the gateway was reset, which ends the link; the request is"


def test_gateway_reset_on_an_open_line_executes_no_write(driver: Path) -> None:
    gateway, losses = ObservedGateway(), iter([True])

    def losing_one(data: bytes, now: float) -> bytes:
        answers = gateway.receive(data, now)
        return b"" if answers.startswith(b"w") and next(losses, False) else answers

    with Simulated(driver, losing_one) as client:
        client.words("connect test: 5")
        for value in range(150):
            client.words(f"write 10 {value:X}")
        # The retransmitted request was answered, so that its outcome is certain.
        assert client.words("statistics")[2] == 1
        gateway.reset()
        for value in range(1, 95):
            answer = client(f"write 20 {value:X}")
            assert answer == f"{LOST_NOT_EXECUTED}write at 0x20: {WAS_RESET} known not to be executed"
        assert (0x20, 1) not in gateway.bus_log.writes
        client.words("close")
        client.words("connect test: 5")
        client.words("write 20 5F")
        assert client.words("read 20") == [0x5F]
        client.words("close")


def test_write_retransmitted_to_a_reset_gateway_is_perhaps_executed(driver: Path) -> None:
    gateway = ObservedGateway()

    def losing(data: bytes, now: float) -> bytes:
        answers = gateway.receive(data, now)
        if not answers.startswith(b"w"):
            return answers
        gateway.reset()
        return b""

    with Simulated(driver, losing) as client:
        client.words("connect test: 5")
        assert client("write 10 7") == f"{LOST}write at 0x10: {WAS_RESET} perhaps executed"
        assert gateway.bus_log.writes == [(0x10, 7)]
        client.words("close")


def test_fence_reports_posted_writes_that_a_reset_gateway_did_not_execute(driver: Path) -> None:
    gateway = ObservedGateway()
    with Simulated(driver, gateway.receive) as client:
        client.words("connect test: 5")
        for value in range(3):
            client.words(f"post 10 {value}")
        gateway.reset_before = 0
        assert client("fence") == f"{LOST_NOT_EXECUTED}posted write at 0x10: {WAS_RESET} known not to be executed"
        assert client("post 10 3") == f"{LOST_NOT_EXECUTED}posted write at 0x10: {WAS_RESET} known not to be executed"
        assert client("close").startswith(f"{LOST_NOT_EXECUTED}posted write")
        assert gateway.bus_log.writes == []


def test_posted_writes_continue_if_every_fence_gets_an_error(driver: Path) -> None:
    gateway = Uncounting(TWO_DIGITS)
    bus = RecordedBus(gateway)
    with Simulated(driver, gateway.receive) as client:
        client.words("connect test: 5")
        for value in range(400):
            client.words(f"post 10 {value:X}")
        assert client.words("fence") == []
        client.words("close")
    assert bus.writes == [(0x10, value) for value in range(400)]


def test_reported_outcomes_of_writes_at_a_reset_are_true_on_bad_lines(driver: Path) -> None:
    statuses: Counter[int] = Counter()
    for seed in range(60):
        gateway = ObservedGateway(GatewayInfo(crc_bits=32, crc_polynomial=0x04C11DB7))
        chances = {"loss": 0.001 * (seed % 3), "flip": 0.001 * (seed % 3)}
        line = NoisyLine(gateway, Noise(2 * seed, **chances), Noise(2 * seed + 1, **chances))
        with Simulated(driver, line.receive) as client:
            client.words("connect test: 30")
            gateway.reset_before = 7 * seed
            told = client.words(f"apart 20 {200:X}")
            client("close")
        statuses.update(told)
        executed = [word for _, word in gateway.bus_log.writes]
        assert executed == list(range(len(executed)))
        for word, status in enumerate(told):
            is_executed = word < len(executed)
            assert f"{status} " in ({"0 ", LOST, LOST_EXECUTED} if is_executed else {LOST, LOST_NOT_EXECUTED})
    assert {0, int(LOST), int(LOST_NOT_EXECUTED)} <= statuses.keys()


def test_every_write_is_executed_once_or_reported_whatever_a_gateway_answers(driver: Path) -> None:
    scenarios = [random_answers.play(driver, seed) for seed in range(4, 12)]
    statuses = {status for scenario in scenarios for status in scenario.writes}
    assert {"posted", "0", LOST.strip(), LOST_NOT_EXECUTED.strip()} <= statuses


@pytest.mark.campaign
def test_every_write_is_executed_once_or_reported_for_twenty_minutes(driver: Path) -> None:
    until, seeds = time.monotonic() + 1200, itertools.count(10_000)
    while time.monotonic() < until:
        random_answers.play(driver, next(seeds))


def test_later_answer_proves_that_a_request_with_a_lost_answer_was_executed(driver: Path) -> None:
    gateway = ObservedGateway()
    lost = 0

    def losing(data: bytes, now: float) -> bytes:
        nonlocal lost
        first, *others = gateway.receive(data, now).splitlines(keepends=True) or [b""]
        if not first.startswith(b"w"):
            return b"".join((first, *others))
        lost += 1
        gateway.reset()
        return b"".join(others)

    with Simulated(driver, losing) as client:
        client.words("connect test: 5")
        assert client.words("apart 20 3") == [int(LOST_EXECUTED), 0, 0]
        assert lost == 1
        client("close")


def test_unanswered_request_before_a_reset_is_perhaps_executed(driver: Path) -> None:
    gateway = ObservedGateway()

    def losing(data: bytes, now: float) -> bytes:
        answers = gateway.receive(data, now)
        return answers[answers.index(b"\n") + 1 :] if answers.startswith(b"w") else answers

    with Simulated(driver, losing) as client:
        client.words("connect test: 5")
        gateway.reset_before = 1
        assert client.words("apart 20 3") == [int(LOST), int(LOST_NOT_EXECUTED), int(LOST_NOT_EXECUTED)]
        assert gateway.bus_log.writes == [(0x20, 0)]
        client("close")


def test_samples_stop_at_a_reset_which_is_reported_and_resume_on_a_new_link(driver: Path) -> None:
    gateway = ObservedGateway(GatewayInfo(groups=2))
    with Simulated(driver, gateway.receive) as client:
        client.words("connect test: 5")
        client.words("subscribe 0 100 - 10")
        client.words("subscribe 1 100 - 11")
        assert client("next 0 1").startswith("0 0 ")
        gateway.reset()
        while (answer := client("next 0 0.3")).startswith("0 "):
            pass
        assert answer.startswith(NO_SAMPLE)
        assert client("next 0 1") == f"{LOST}subscription: {WAS_RESET} perhaps executed"
        client.words("close")
        client.words("connect test: 5")
        client.words("write 11 5")
        # This subscription takes the group that the other one had, and the other one gets a new group.
        client.words("subscribe 1 100 - 11")
        client.words("again 0")
        assert client("next 0 1") == "0 0 0 0x0p+0 0"
        assert client("next 1 1") == "0 0 0 0x0p+0 5"
        client.words("close")


def test_samples_of_the_previous_user_of_a_group_are_never_delivered(driver: Path) -> None:
    gateway, unknown = VirtualGateway(GatewayInfo(groups=1)), Framing(Crc()).checked(b"J")

    def not_stopping(data: bytes, now: float) -> bytes:
        return gateway.receive(re.sub(rb"gx[^\n]*\n", unknown, data), now)

    with Simulated(driver, not_stopping, latency=0.05) as client:
        client.words("connect test: 5")
        client.words("write 10 1")
        client.words("write 11 2")
        for turn in range(6):
            client.words(f"subscribe {turn % 2:X} 1000 - {0x10 + turn % 2:X}")
            for _ in range(5):
                assert client(f"next {turn % 2} 1").split()[-1] == str(1 + turn % 2)
            assert client(f"unsubscribe {turn % 2}").startswith("2 ")
        client.words("close")


def test_each_session_has_a_different_number(driver: Path) -> None:
    gateway = ObservedGateway()
    with Simulated(driver, gateway.receive) as client:
        for _ in range(40):
            client.words("connect test: 5")
            client.words("write 10 1")
            client.words("close")
        assert len(set(gateway.sessions())) > 30
    seeded = set()
    for seed in range(20):
        gateway = ObservedGateway()
        with Simulated(driver, gateway.receive) as client:
            client.words(f"connect test:0:{seed:X} 5")
            client.words("close")
        seeded |= set(gateway.sessions())
    assert len(seeded) > 15


def test_requests_wait_for_the_answer_that_begins_their_session(driver: Path) -> None:
    gateway = ObservedGateway()
    late: list[bytes] = []

    def late_at_first(data: bytes, now: float) -> bytes:
        answers = gateway.receive(data, now)
        if not answers.startswith(b"K"):
            return answers
        if late:
            return late.pop() + answers
        late.append(answers)
        return b""

    with Simulated(driver, late_at_first) as client:
        client.words("connect test: 5")
        client.words("write 10 1")
        client.words("close")
        client.words("connect test: 5")
        client.words("write 10 2")
        client.words("close")
    first, second = gateway.sessions()[1], gateway.sessions()[3]
    assert len({session[3:] for session in gateway.sessions()}) == len(gateway.sessions()) == 4
    numbered = [frame for frame in gateway.heard if frame.startswith("w")]
    assert [frame[1:4] for frame in numbered] == [first[:3], second[:3]]


def test_ids_go_round_their_ring_in_sessions_of_either_width(driver: Path) -> None:
    for info in (GatewayInfo(), GatewayInfo(id_digits=2, crc_bits=8, crc_polynomial=7)):
        gateway = ObservedGateway(info)
        with Simulated(driver, gateway.receive) as client:
            client.words("connect test: 5")
            for _ in range(3):
                client.words(f"apart 20 {1500:X}")
            assert client.words("statistics")[2:] == [0, 0, 0, 0]
            client.words("close")
        assert [word for _, word in gateway.bus_log.writes] == [*range(1500)] * 3


@pytest.mark.parametrize("version", ["01", "02"])
def test_gateway_of_another_version_is_reported_with_a_remedy_and_left_alone(driver: Path, version: str) -> None:
    gateway = ObservedGateway()
    with Simulated(
        driver, lambda data, now: gateway.receive(data, now).replace(b"Q03", f"Q{version}".encode())
    ) as client:
        assert client("connect test: 5") == (
            f"{UNSUPPORTED}the gateway speaks version {version} of the protocol and this program version 03: build the "
            f"gateway anew with this version of unity-link, or generate the client with one that speaks {version}"
        )
    assert [frame for frame in gateway.heard if frame] == ["Q"] * 3


def reporting(reported: bytes) -> Callable[[bytes, float], bytes]:
    """Return a gateway that reports another configuration than its own."""
    gateway, check, told = VirtualGateway(), Framing(Crc()).checked, GatewayInfo().to_hex()

    def receive(data: bytes, now: float) -> bytes:
        answers = gateway.receive(data, now)
        return answers.replace(check(b"Q" + told), check(b"Q" + reported)).replace(told, reported)

    return receive


@pytest.mark.parametrize(
    "reported",
    [
        {"data_bits": 7},
        {"data_bits": 65},
        {"address_bits": 33},
        {"id_digits": 4},
        {"block_words": 0},
        {"groups": 257},
        {"clock_hz": 0},
        {"base_frequency_millihertz": 0},
        {"crc_bits": 24},
        {"crc_polynomial": 0x11021},
        {"crc_polynomial": 0},
    ],
    ids=lambda reported: " ".join(map(str, *reported.items())),
)
def test_numbers_that_no_gateway_has_are_refused_in_the_words_of_python(driver: Path, reported: dict[str, int]) -> None:
    told = msgspec.structs.replace(GatewayInfo(), **reported)
    with pytest.raises(UnsupportedError) as refused:
        told.check()
    with Simulated(driver, reporting(told.to_hex())) as client:
        assert client("connect test: 5") == f"{UNSUPPORTED}{refused.value}"


def test_a_gateway_without_groups_may_have_no_base_frequency(driver: Path) -> None:
    told = msgspec.structs.replace(GatewayInfo(), base_frequency_millihertz=0, features=Feature(0))
    with Simulated(driver, reporting(told.to_hex())) as client:
        client.words("connect test: 5")
        client("close")


def test_version_damaged_twice_in_the_same_way_is_requested_again(driver: Path) -> None:
    gateway, damaged = VirtualGateway(), [b"Q02"] * 2

    def damaging(data: bytes, now: float) -> bytes:
        answers = gateway.receive(data, now)
        return answers.replace(b"Q03", damaged.pop()) if answers.startswith(b"Q") and damaged else answers

    with Simulated(driver, damaging) as client:
        client.words("connect test: 5")
        client.words("close")


def test_half_duplex_medium_carries_one_answered_request_at_a_time(driver: Path) -> None:
    gateway = ObservedGateway(GatewayInfo(features=Feature(0x7F) | Feature.HALF_DUPLEX))
    with Simulated(driver, gateway.receive) as client:
        client.words("connect test: 5")
        assert client.words("apart 20 30") == [0] * 0x30
        for value in range(5):
            client.words(f"post 10 {value}")
        client.words("fence")
        client.words("close")
    assert gateway.most_at_once == 1
    assert gateway.bus_log.writes[-5:] == [(0x10, value) for value in range(5)]


@pytest.mark.parametrize("code", ["00", "08", "20", "22", "28", "FF"])
def test_an_error_that_the_protocol_does_not_have_is_an_error_of_the_gateway(driver: Path, code: str) -> None:
    gateway, checked = ObservedGateway(), Framing(Crc()).checked

    def failing(data: bytes, now: float) -> bytes:
        answers, asked = gateway.receive(data, now), re.search(rb"r(...)10", data)
        session = int(gateway.sessions()[-1][3:], 16) if asked else 0
        return checked(b"x%b%b" % (asked[1], code.encode()), seed_of(session, from_gateway=True)) if asked else answers

    with Simulated(driver, failing) as client:
        client.words("connect test: 5")
        status, sentence = client("read 10").split(" ", 1)
        assert sentence == "read at 0x10: an error of the gateway that this version does not know"
        assert int(status) not in range(1, 11)
        assert client.words("read 11") == [0]
        client.words("close")


# Sessions, and how requests ended


TAKEN = "another program has begun a session with the gateway, and this one's is over: let both use it through"


def test_session_of_another_program_ends_the_link_which_does_not_retake_it(
    driver: Path,
) -> None:
    gateway = ObservedGateway()
    with Simulated(driver, gateway.receive) as client:
        client.words("connect test: 5")
        client.words("write 10 1")
        gateway.receive(Framing(Crc()).checked(b"K4004321"), client.now)
        began, told = client.now, client("write 10 2")
        assert told.startswith(f"{LOST}write at 0x10: {TAKEN} `unity-link serve`")
        assert client.now - began < 1
        assert client("read 10").startswith(f"{LOST_NOT_EXECUTED}read at 0x10: {TAKEN}")
        client("close")
    assert gateway.bus_log.writes == [(0x10, 1)]
    assert len([frame for frame in gateway.heard if frame.startswith("K4004321")]) == 1


def test_session_of_another_program_is_detected_if_the_query_is_lost_too(driver: Path) -> None:
    gateway, lost = ObservedGateway(), iter([True] * 3)

    def losing(data: bytes, now: float) -> bytes:
        answers = gateway.receive(data, now).splitlines(keepends=True)
        return b"".join(line for line in answers if len(line) != 10 or line[:1] != b"K" or not next(lost, False))

    with Simulated(driver, losing) as client:
        client.words("connect test: 5")
        gateway.receive(Framing(Crc()).checked(b"K4004321"), client.now)
        began, told = client.now, client("write 10 2")
        assert told.startswith(f"{LOST}write at 0x10: {TAKEN}")
        assert client.now - began < 1
        client("close")


@pytest.mark.parametrize("lost", [rb"x[^\n]*\n", rb"(x|h)[^\n]*\n"], ids=["errors", "errors and fences"])
def test_fence_reports_a_failed_posted_write_even_if_its_error_was_lost(driver: Path, lost: bytes) -> None:
    gateway, losses = ObservedGateway(), iter([True] * 2)
    gateway.detach([0x89])
    gateway.attach(Failing(ErrorCode.BUS_TIMEOUT), [0x89])

    def losing(data: bytes, now: float) -> bytes:
        answers = gateway.receive(data, now)
        return re.sub(lost, lambda frame: b"" if next(losses, False) else frame[0], answers)

    with Simulated(driver, losing) as client:
        client.words("connect test: 5")
        for address in (0x10, 0x89, 0x11, 0x89, 0x12):
            client.words(f"post {address:X} 1")
        assert client.words("posts") == [0, int(BUS_TIMEOUT), 0x89, 2, 0, 0]
        client.words("post 10 2")
        assert client.words("posts") == [0] * 6
        assert client.words("read 10") == [2]
        client.words("close")


def test_a_write_that_failed_and_of_which_the_error_was_lost_is_an_error(driver: Path) -> None:
    gateway, losses = ObservedGateway(), iter([True] * 3)
    gateway.detach([0x89])
    gateway.attach(Failing(ErrorCode.BUS_ERROR), [0x89])

    def losing(data: bytes, now: float) -> bytes:
        answers = gateway.receive(data, now)
        return b"" if answers.startswith(b"x") and next(losses, False) else answers

    with Simulated(driver, losing) as client:
        client.words("connect test: 5")
        assert client("write 89 1") == "4 write at 0x89: the bus refused the access"
        client.words("close")


@pytest.mark.parametrize(
    ("flip", "counts"), [(0.004, (1, 3, 7, 40)), (0.0004, (255, 1, 100, 254))], ids=["few", "many"]
)
def test_no_event_of_a_queue_is_lost_or_doubled_on_a_bad_line(
    driver: Path, flip: float, counts: tuple[int, ...]
) -> None:
    info = GatewayInfo(crc_bits=32, crc_polynomial=0x04C11DB7)
    for seed in range(4):
        gateway, queue = VirtualGateway(info), Counting()
        gateway.attach(queue, [0x20])
        line = NoisyLine(gateway, Noise(2 * seed, flip=flip), Noise(2 * seed + 1, loss=flip / 2, flip=flip))
        taken: list[int] = []
        with Simulated(driver, line.receive) as client:
            client.words("connect test: 60")
            for count in counts:
                for _ in range(6):
                    taken += client.words(f"rqueue 20 {count:X}")
            client("close")
        assert taken == list(range(len(taken)))


def test_plain_answers_and_those_of_another_session_are_ignored(driver: Path) -> None:
    gateway, checked = ObservedGateway(), Framing(Crc()).checked
    wrong: list[Callable[[bytes], bytes]] = [
        lambda number: b"r%b0000BAD0\r\n" % number,
        lambda number: checked(b"r%b0000BAD0" % number),
        lambda number: checked(b"r%b0000BAD0" % number, seed_of(0x4321, from_gateway=True)),
        lambda number: b"x%b0A0000\r\n" % number,
        lambda number: checked(b"x%b0A1234" % number),
    ]

    def mixed(data: bytes, now: float) -> bytes:
        answers, asked = gateway.receive(data, now), re.search(rb"r(...)10", data)
        return wrong.pop()(asked[1]) if asked and wrong else answers

    with Simulated(driver, mixed) as client:
        client.words("connect test: 5")
        client.words("write 10 7")
        for _ in range(8):
            assert client.words("read 10") == [7]
        client.words("close")
    assert not wrong


# Samples


@pytest.mark.parametrize("medium", MEDIA)
def test_samples_come_in_order_with_their_times(client: Driven, medium: Medium) -> None:
    with simulate(medium, "--robot", "scara") as url:
        client.words(f"connect {url} 5")
        client.words("write 10 63")
        client.words("subscribe 0 100 t 10 88")
        samples = [client("next 0 10").split() for _ in range(5)]
        assert [int(sample[1]) for sample in samples] == list(range(5))
        times = [float.fromhex(sample[3]) for sample in samples]
        assert [round(later - sooner, 6) for sooner, later in pairwise(times)] == [0.01] * 4
        assert all(sample[2] == "0" and sample[4:] == ["99", "0"] for sample in samples)
        client.words("unsubscribe 0")
        assert client("next 1 0").startswith(NO_SAMPLE)


def test_samples_lost_on_the_way_and_in_the_storage_are_counted(client: Driven) -> None:
    lost = [lose(r"^P..0[23]", times=2), damage(r"^P..05")]
    with simulate("tcp") as gateway, FaultyLine(gateway, "tcp", lost) as line:
        client.words(f"connect {line.url} 5")
        client.words("subscribe 0 0 - 10 11")
        for _ in range(8):
            client.words("publish 0")
        seen = [client("next 0 5").split()[1:3] for _ in range(5)]
        assert seen == [["0", "0"], ["1", "0"], ["4", "2"], ["6", "1"], ["7", "0"]]
        assert client.words("lost 0") == [3]
        # The storage of this client has room for 8 samples.
        for _ in range(11):
            client.words("publish 0")
        assert client("next 0 5").split()[1:3] == ["11", "3"]
        assert client.words("lost 0") == [6]
        assert [client("next 0 5").split()[1] for _ in range(7)] == [str(number) for number in range(12, 19)]
        assert client("next 0 0").startswith(NO_SAMPLE)


@pytest.mark.slow
def test_a_number_of_samples_is_awaited(client: Driven) -> None:
    with simulate("tcp") as url:
        client.words(f"connect {url} 5")
        client.words("subscribe 0 100 - 10")
        client.words("await 0 5 60")
        assert [client("next 0 0").split()[1] for _ in range(5)] == [str(number) for number in range(5)]
        assert client("await 0 100 0.05").startswith(NO_SAMPLE)
        client.words("close")
        assert client("await 0 100 1").startswith(LOST)


def test_callbacks_get_each_sample_and_may_use_the_link(client: Driven) -> None:
    with simulate("tcp") as url:
        client.words(f"connect {url} 5")
        client.words("subscribe 0 0 b 10")
        client.words("subscribe 1 0 - 11")
        for _ in range(3):
            client.words("publish 0")
        client.words("publish 1")
        assert client.words("poll 0") == [0, 1, 2]
        assert client.words("read 7F") == [2]
        client.words("publish 0")
        assert client.words("poll 0.05") == [3]
        assert client("next 1 5").startswith("0 0 0 ")


def test_a_callback_may_close_the_link_and_its_medium_is_not_used_again(driver: Path) -> None:
    with Simulated(driver, VirtualGateway().receive) as client:
        client.words("connect test: 5")
        client.words("subscribe 0 0 z 10")
        client.words("publish 0")
        client.words("publish 0")
        assert client("poll 1").startswith(LOST)
        assert client("next 0 1").startswith("0 1 ")
        assert client("next 0 1").startswith(LOST)
        assert client("read 0").startswith(LOST_NOT_EXECUTED)
        client.words("close")


def test_samples_on_change_come_only_with_one(client: Driven) -> None:
    with simulate("tcp") as url:
        client.words(f"connect {url} 5")
        client.words("subscribe 0 1000 c 10")
        assert client("next 0 5") == "0 0 0 0x0p+0 0"
        client.words("write 10 5")
        assert client("next 0 5") == "0 1 0 0x0p+0 5"


def test_a_subscription_that_cannot_be_is_refused(client: Driven) -> None:
    with simulate("tcp", "--set", "groups=1", "--set", "group_words=3") as url:
        client.words(f"connect {url} 5")
        for command in ("subscribe 0 1e9 - 10", "subscribe 0 10 -", "subscribe 0 10 - 1 2 3 4", "subscribe 0 10 - 100"):
            assert client(command).startswith(BAD_ARGUMENT)
        client.words("subscribe 0 10 - 10")
        assert client("subscribe 1 10 - 10") == (
            f"{UNSUPPORTED}subscription: all 1 groups of the gateway are in use: end a subscription first"
        )
        assert client("subscribe 1 10 1 10") == (
            f"{BAD_ARGUMENT}subscription: group 0 of the gateway is in use, or there is none"
        )
        client.words("unsubscribe 0")
        client.words("subscribe 1 10 - 10")


class Hearing:
    """A gateway that stores the flags and divisors of configured groups."""

    def __init__(self) -> None:
        self._gateway = VirtualGateway()
        self.schedules: list[tuple[int, int]] = []

    def __call__(self, data: bytes, now: float) -> bytes:
        """Return the bytes that arrive."""
        for flags, divisor in re.findall(rb"gs.{5}(..)(....)", data):
            self.schedules.append((int(flags, 16), int(divisor, 16)))
        return self._gateway.receive(data, now)


PERIODIC, TRIGGER = 1, 2


@pytest.mark.parametrize(
    ("asked", "flags", "divisor"),
    [("0 -", 0, 1), ("0 e", TRIGGER, 1), ("100 -", PERIODIC, 1000), ("20 d", PERIODIC, 20)],
    ids=["request", "trigger", "rate", "divisor"],
)
def test_the_same_structure_subscribes_the_same_again_also_on_another_link(
    driver: Path, asked: str, flags: int, divisor: int
) -> None:
    gateway = Hearing()
    with Simulated(driver, gateway) as client:
        client.words("connect test: 5")
        client.words(f"subscribe 0 {asked} 10")
        client.words("unsubscribe 0")
        client.words("again 0")
        client.words("close")
        client.words("connect test: 5")
        client.words("again 0")
        assert gateway.schedules == [(flags, divisor)] * 3
        client.words("close")


def test_old_or_refused_settings_of_a_subscription_do_not_affect_a_new_one(driver: Path) -> None:
    gateway = Hearing()
    with Simulated(driver, gateway) as client:
        client.words("connect test: 5")
        assert client("subscribe 0 1e9 - 10").startswith(BAD_ARGUMENT)
        for rate in ("0", "100", "1000", "0"):
            client.words(f"rate 0 {rate}")
            client.words("again 0")
            client.words("unsubscribe 0")
        # The address is refused after the rate was accepted.
        assert client("subscribe 0 100 - 100").startswith(BAD_ARGUMENT)
        client.words("subscribe 0 0 - 10")
        assert gateway.schedules == [(0, 1), (PERIODIC, 1000), (PERIODIC, 100), (0, 1), (0, 1)]
        client.words("close")


def test_queued_samples_survive_a_refused_new_subscription(client: Driven) -> None:
    with simulate("tcp") as url:
        client.words(f"connect {url} 5")
        client.words("subscribe 0 0 - 10")
        for _ in range(3):
            client.words("publish 0")
        client.words("unsubscribe 0")
        client.words("rate 0 nan")
        assert client("again 0").startswith(BAD_ARGUMENT)
        client.words("storage 0 0")
        client.words("rate 0 0")
        assert client("again 0").startswith(BAD_ARGUMENT)
        assert [client("next 0 0").split()[1] for _ in range(3)] == ["0", "1", "2"]


# Signals


def takes_number(signal: Signal, value: float) -> bool:
    """Return True if the type in C can represent a number, even if the signal refuses it."""
    if signal.kind.is_float:
        return True
    low, high = (-(2**63), 2**63) if signal.kind.is_signed else (0, 2**64)
    return signal.kind.name is not KindName.BOOL and low <= value < high


def c_value(signal: Signal, value: Value) -> str:
    if math.isnan(value):
        return "NAN"
    if signal.kind.is_float:
        return float(value).hex() if abs(value) != float("inf") else f"{'-' if value < 0 else ''}INFINITY"
    cast = "int64_t" if signal.kind.is_signed else "uint64_t"
    return f"({cast})UINT64_C({int(value) % 2**64})"


def accessor(signal: Signal) -> tuple[str, str, str]:
    """Return the type, printf format and function name for a signal of `every_kind`."""
    if signal.kind.is_float:
        return "double", "%a", "ul_{}_real"
    if signal.kind.name is KindName.BOOL:
        return "bool", "%d", "ul_{}_bool"
    if signal.kind.enumeration is not None:
        return "robot_mode", '%" PRIu64 "', "robot_mode_{}"
    if signal.kind.is_signed:
        return "int64_t", '%" PRId64 "', "ul_{}_signed"
    return "uint64_t", '%" PRIu64 "', "ul_{}_unsigned"


def step(signal: Signal, expression: str, value: Value) -> str:
    """Return C code that sets a signal, and prints the status, the words on the bus, and the value read back."""
    kind, form, function = accessor(signal)
    return (
        f"{{ {kind} value = {c_value(signal, value)}; uint64_t words[8];\n"
        f'  printf("%d", {function.format("set")}(&the_link, &{expression}, value));\n'
        f"  check(ul_fence(&the_link)); check(ul_read_block(&the_link, {signal.address}, words, {signal.words}));\n"
        f'  for (int index = 0; index < {signal.words}; index++) printf(" %" PRIu64, words[index]);\n'
        f'  check({function.format("get")}(&the_link, &{expression}, &value)); printf(" {form}\\n", value); }}\n'
    )


PROGRAM = """\
#include "robot.h"
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
static ul_link the_link;
static void check(ul_status status) {{ if (status) printf(" %s\\n", ul_error(&the_link)); }}
{functions}
int main(int count, char **arguments) {{
    (void)count;
    check(ul_connect(&the_link, arguments[1], 5.0));
    {calls}
    check(ul_close(&the_link));
    return 0;
}}
"""


TWICE = """\
#include "feeder.h"
#include <stdio.h>
static ul_link the_link;
static feeder_first_subscription first;
static feeder_second_subscription second;
int main(int count, char **arguments) {
    feeder_first one;
    feeder_second two;
    (void)count;
    if (ul_connect(&the_link, arguments[1], 5.0)) return puts(ul_error(&the_link));
    printf("%d %d", feeder_first_subscribe(&the_link, &first), feeder_second_subscribe(&the_link, &second));
    for (int turn = 0; turn < 2; turn++) {
        ul_publish(&the_link, &first.base);
        ul_publish(&the_link, &second.base);
        if (turn == 0) printf(" %d", feeder_first_subscribe(&the_link, &first));
        printf(" %d", feeder_first_next(&the_link, &first, &one, NULL, 5.0));
        printf(" %d", feeder_second_next(&the_link, &second, &two, NULL, 5.0));
    }
    printf("\\n%s\\n", ul_error(&the_link));
    ul_unsubscribe(&the_link, &first.base);
    printf("%d\\n", feeder_first_subscribe(&the_link, &first));
    return ul_close(&the_link);
}
"""


@pytest.mark.slow
def test_second_subscription_to_a_group_is_refused_and_the_first_goes_on(runtime: list[Path], tmp_path: Path) -> None:
    spec = compile_text(
        "group first(1, TRIGGER); group second(2, TRIGGER);\n"
        "public feeder() { @a = 1: READ(PUBLISH(first)); @b = 2: READ(PUBLISH(second)); }\n"
    )
    generated("c", spec, tmp_path)
    (tmp_path / "program.c").write_text(TWICE)
    objects = compiled(C, [tmp_path / "feeder.c", tmp_path / "program.c"], tmp_path, *SANITIZED, "-O0")
    program = linked(C, [*runtime, *objects], tmp_path / "program", *SANITIZED)
    with simulate("tcp") as url:
        assert output(program, url).splitlines() == ["0 0 38 0 0 0 0", "subscription: it has begun already", "0"]


TWO_LINKS = """\
#include "unity_link.h"
#include <stdio.h>
static ul_link one, other;
static uint64_t storage[UL_STORAGE(4, 1)];
static void say(ul_status status) { printf("%d ", status); }
int main(int count, char **arguments) {
    uint32_t address = 0x10;
    ul_subscription samples = {
        .addresses = &address, .count = 1, .storage = storage, .storage_words = UL_STORAGE(4, 1)};
    ul_sample sample;
    (void)count;
    if (ul_connect(&one, arguments[1], 5.0)) return puts(ul_error(&one));
    if (ul_connect(&other, arguments[2], 5.0)) return puts(ul_error(&other));
    say(ul_unsubscribe(&other, &samples));
    say(ul_subscribe(&one, &samples));
    say(ul_unsubscribe(&other, &samples));
    puts(ul_error(&other));
    say(ul_publish(&one, &samples));
    say(ul_next(&one, &samples, &sample, 5.0));
    say(ul_unsubscribe(&one, &samples));
    say(ul_unsubscribe(&one, &samples));
    say(ul_subscribe(&other, &samples));
    say(ul_close(&other));
    say(ul_unsubscribe(&other, &samples));
    say(ul_subscribe(&one, &samples));
    return ul_close(&one);
}
"""


@pytest.mark.slow
def test_only_the_link_of_a_subscription_can_end_it(runtime: list[Path], tmp_path: Path) -> None:
    (tmp_path / "program.c").write_text(TWO_LINKS)
    objects = compiled(C, [tmp_path / "program.c"], tmp_path, *SANITIZED, f"-I{runtime[0].parent}")
    program = linked(C, [*runtime, *objects], tmp_path / "program", *SANITIZED)
    with simulate("tcp") as one, simulate("tcp") as other:
        assert output(program, one, other).splitlines() == [
            "0 0 38 subscription: it was begun on another link, which alone ends it",
            "0 0 0 0 0 0 0 0 ",
        ]


FAR_RATES = """\
#include "feeder.h"
#include <stdio.h>
static ul_link the_link;
static feeder_slow_subscription slow;
static feeder_fast_subscription fast;
int main(int count, char **arguments) {
    (void)count;
    if (ul_connect(&the_link, arguments[1], 5.0)) return puts(ul_error(&the_link));
    printf("%d %d ", feeder_slow_subscribe(&the_link, &slow), feeder_fast_subscribe(&the_link, &fast));
    printf("%.6f %.6f\\n", slow.base.actual_rate_hz, fast.base.actual_rate_hz);
    return ul_close(&the_link);
}
"""


def test_group_with_a_rate_beyond_the_gateways_range_is_refused(runtime: list[Path], tmp_path: Path) -> None:
    spec = compile_text(
        "group slow(RATE=5); group fast(RATE=300000);\n"
        "public feeder() { @a = 1: READ(PUBLISH(slow)); @b = 2: READ(PUBLISH(fast)); }\n"
    )
    generated("c", spec, tmp_path)
    (tmp_path / "program.c").write_text(FAR_RATES)
    objects = compiled(C, [tmp_path / "feeder.c", tmp_path / "program.c"], tmp_path, *SANITIZED, "-O0")
    program = linked(C, [*runtime, *objects], tmp_path / "program", *SANITIZED)
    with simulate("tcp") as url:
        assert output(program, url) == f"0 {BAD_ARGUMENT.strip()} 5.000000 0.000000\n"


MAPPED = """\
#include "scara.h"
#include <stdio.h>
static ul_link arm;
int main(int count, char **arguments) {
    double value = 0;
    scara_state state;
    (void)count;
    if (ul_connect(&arm, arguments[1], 5.0)) return puts(ul_error(&arm));
    printf("%d ", ul_set_real(&arm, &scara.j1.pos_sp, 30));
    printf("%d ", ul_post_real(&arm, &scara.j1.pos_sp, 30));
    printf("%d ", ul_get_real(&arm, &scara.j1.pos_sp, &value));
    printf("%d ", scara_state_read(&arm, &state));
    printf("%d %d\\n", scara_check_map(&arm), (int)arm.statistics.requests);
    ul_allow_any_map(&arm);
    printf("%d\\n", ul_set_real(&arm, &scara.j1.pos_sp, 30));
    return ul_close(&arm);
}
"""


@pytest.mark.slow
def test_signals_of_another_map_are_refused_before_writes_unless_map_is_any(
    runtime: list[Path], tmp_path: Path
) -> None:
    spec = compile_file(EXAMPLES / "scara.ul")
    generated("c", spec, tmp_path)
    (tmp_path / "program.c").write_text(MAPPED)
    objects = compiled(C, [tmp_path / "scara.c", tmp_path / "program.c"], tmp_path, *SANITIZED, "-O0")
    program = linked(C, [*runtime, *objects], tmp_path / "program", *SANITIZED)
    mapped = ("--set", f"features={int(DEFAULT_INFO.features | Feature.FINGERPRINT)}", "--set")
    refused = " ".join([UNSUPPORTED.strip()] * 5)
    with simulate("tcp", *mapped, "build_id=0xCAFE") as url:
        assert output(program, url).splitlines() == [f"{refused} 0", "0"]
        assert output(program, f"{url}?map=any").splitlines()[0].startswith("0 0 0 0 0 ")
    with simulate("tcp", *mapped, f"build_id={spec.interface().fingerprint}") as url:
        assert output(program, url).splitlines()[0].startswith("0 0 0 0 0 ")


def test_limits_that_no_double_holds_are_kept_exactly(runtime: list[Path], tmp_path: Path) -> None:
    interface = LIMITS_BEYOND_DOUBLES.interface()
    steps = [step(interface.signals[name], f"robot.{name}", value) for name, value, _ in LIMIT_TRIALS]
    functions = "".join(f"static void f{index}(void) {text}" for index, text in enumerate(steps))
    calls = " ".join(f"f{index}();" for index in range(len(steps)))
    (tmp_path / "program.c").write_text(PROGRAM.format(functions=functions, calls=calls))
    generated("c", LIMITS_BEYOND_DOUBLES, tmp_path)
    objects = compiled(C, [tmp_path / "robot.c", tmp_path / "program.c"], tmp_path, *SANITIZED, "-O0")
    program = linked(C, [*runtime, *objects], tmp_path / "program", *SANITIZED)
    with simulate("tcp", "--set", "data_bits=64") as url:
        lines = output(program, url).splitlines()
    for line, (name, value, is_taken) in zip(lines, LIMIT_TRIALS, strict=True):
        status, _, held = line.split()
        assert status == ("0" if is_taken else BAD_ARGUMENT.strip()), (name, value)
        assert (int(held) == value) == is_taken, (name, value)


def test_refused_number_and_its_limits_are_reported_exactly(runtime: list[Path], tmp_path: Path) -> None:
    calls = [
        ("unsigned", "a", "UINT64_MAX", "a: 18446744073709551615 is outside of 0 to 18446744073709551614"),
        (
            "signed",
            "b",
            "INT64_MIN",
            "b: -9223372036854775808 is outside of -9223372036854775807 to 9223372036854775807",
        ),
        ("unsigned", "c", "9007199254740994u", "c: 9007199254740994 is outside of 0 to 9007199254740993"),
        ("signed", "f", "INT64_MAX", "f: 9223372036854775807 is outside of -2 to 2"),
        ("unsigned", "g", "1234567890123456789u", "g: 1234567890123456789 is outside of 0 to 1152921504606846975"),
    ]
    lines = "".join(
        f"    ul_set_{coding}(&link, &robot.{name}, {value}); puts(ul_error(&link));\n"
        for coding, name, value, _ in calls
    )
    (tmp_path / "program.c").write_text(
        '#include "robot.h"\n#include <stdio.h>\nint main(void) {\n    static ul_link link;\n' + lines + "}\n"
    )
    generated("c", LIMITS_BEYOND_DOUBLES, tmp_path)
    objects = compiled(C, [tmp_path / "robot.c", tmp_path / "program.c"], tmp_path, *SANITIZED, "-O0")
    program = linked(C, [*runtime, *objects], tmp_path / "program", *SANITIZED)
    assert output(program).splitlines() == [said for *_, said in calls]


@pytest.mark.slow
@pytest.mark.parametrize("word_bits", WORD_BITS)
def test_values_of_every_kind_are_encoded_and_decoded_as_in_python(
    word_bits: int, runtime: list[Path], tmp_path: Path
) -> None:
    spec = every_kind(word_bits)
    expressions = Layout(spec.interface()).expressions
    steps, expected = [], []
    for signal, value in written(spec.interface()):
        steps.append(step(signal, expressions[signal.path], value))
        expected.append(("0", signal, value))
    for signal in spec.interface().signals.values():
        for value in bad_values(signal) if signal.access.writes and signal.access.reads else []:
            if takes_number(signal, value):
                steps.append(step(signal, expressions[signal.path], value))
                expected.append(("38", signal, value))
    functions = "".join(f"static void f{index}(void) {text}" for index, text in enumerate(steps))
    calls = " ".join(f"f{index}();" for index in range(len(steps)))
    (tmp_path / "program.c").write_text(PROGRAM.format(functions=functions, calls=calls))
    generated("c", spec, tmp_path)
    objects = compiled(C, [tmp_path / "robot.c", tmp_path / "program.c"], tmp_path, *SANITIZED, "-O0")
    program = linked(C, [*runtime, *objects], tmp_path / "program", *SANITIZED)
    with simulate("tcp", "--set", f"data_bits={word_bits}") as url:
        lines = output(program, url).splitlines()
    assert len(lines) == len(expected)
    held: dict[int, int] = {}
    for line, (status, signal, value) in zip(lines, expected, strict=True):
        if status == "0":
            mask = signal.mask if signal.is_field else (1 << signal.words * word_bits) - 1
            for index, word in enumerate(signal.encode(value)):
                kept = held.get(signal.address + index, 0) & ~(mask >> index * word_bits)
                held[signal.address + index] = kept | word
        words = [held.get(address, 0) for address in signal.addresses]
        got_status, *got_words, got_value = line.split()
        assert (got_status, got_words) == (status, [str(word) for word in words]), (signal.path, value, line)
        decoded = signal.decode(words)
        assert (float.fromhex(got_value) if signal.kind.is_float else int(got_value)) == decoded, (signal.path, line)
