"""The bridge to Zenoh as a process, with sessions of Zenoh in this process and links over Zenoh."""

from __future__ import annotations

import asyncio
import contextlib
import itertools
import os
import signal
import socket
import subprocess
import sys
import threading
import time
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import msgspec
import pytest

import unity_link
from support.bridge_programs import PATIENCE, PROGRAM, Noted, program, wait_for, wait_until
from unity_link import ArgumentError, ConnectError, LinkLostError, OutOfRangeError, blocking
from unity_link.transport.zenoh_session import Network, close_session, open_session

if TYPE_CHECKING:
    from collections.abc import Iterator

    import zenoh

    from unity_link import Sample, Subscription

SPEC = str(Path(__file__).parents[2] / "examples" / "scara.ul")
GATEWAY = "sim:scara?base_frequency_millihertz=20000000"
POS_SP, COUNTS = 0x8C, 50 * 4000 / 360


def free_endpoint() -> str:
    with socket.create_server(("127.0.0.1", 0)) as free:
        return f"tcp/127.0.0.1:{free.getsockname()[1]}"


@contextmanager
def bridge(endpoint: str, link: str = GATEWAY, prefix: str = "robot/1") -> Iterator[subprocess.Popen[str]]:
    """Run a bridge that listens on an endpoint; yield the process."""
    with program("zenoh", SPEC, "--link", link, "--prefix", prefix, "--listen", endpoint) as process:
        yield process


@contextmanager
def session(endpoint: str) -> Iterator[zenoh.Session]:
    opened = open_session(Network(connect=(endpoint,)))
    try:
        yield opened
    finally:
        close_session(opened)


def ask(peer: zenoh.Session, key: str, payload: object = None) -> Any:
    """Return the only answer to a query, also if it is a refusal."""
    given = None if payload is None else msgspec.json.encode(payload)
    for _ in range(100):
        for reply in peer.get(key, payload=given):
            answer = reply.ok if reply.ok is not None else reply.err
            assert answer is not None
            return msgspec.json.decode(answer.payload.to_bytes())
        time.sleep(0.05)
    pytest.fail(f"nothing answers at {key}")


def url(endpoint: str, prefix: str = "robot/1") -> str:
    return f"zenoh:{prefix}?connect={endpoint}"


# Keys


def test_signals_are_read_and_written_by_keys_in_batches_and_by_wildcards() -> None:
    place = free_endpoint()
    with bridge(place) as process, session(place) as peer:
        wait_for(process, "scara at robot/1")

        assert ask(peer, "robot/1/signals/j1/cpos") == 0
        assert ask(peer, "robot/1/read", ["j1.cpos", "j2.cpos"]) == {"j1.cpos": 0, "j2.cpos": 0}
        assert len(ask(peer, "robot/1/read")) == 16
        assert ask(peer, "robot/1/write", [{"j1.pos_sp": 5}, {"j1.pos_sp": 7.2, "j2.pos_sp": 1}]) == {"written": 3}
        assert ask(peer, "robot/1/signals/j1/pos_sp", 9) == {"written": 1}
        assert ask(peer, "robot/1/signals/j1/pos_sp") == 9
        assert len(list(peer.get("robot/*/signals/*/pos_sp"))) == 4
        assert ask(peer, "robot/1/info")["signals"]["j1.pos_sp"]["limits"] == [-130, 130]


@pytest.mark.slow
@pytest.mark.parametrize(
    ("key", "payload", "words"),
    [
        ("write", {"j1.pos_sp": 500}, "outside of its limits, -130 to 130 deg"),
        ("write", [{"j1.pos_sp": 5}, {"j1.pos_spp": 6}], "did you mean 'j1.pos_sp'"),
        ("write", 7, "an object such as"),
        ("write", {"j1.cpos": 1}, "j1.cpos cannot be written through Zenoh"),
        ("write", {"j1.pos_sp": None}, "j1.pos_sp"),
        ("read", {"j1.cpos": 1}, "a list of paths was expected"),
        ("read", ["j9.cpos"], "no signal 'j9.cpos'"),
        ("signals/j1/cpos", 5, "can only be read"),
        ("signals/j1/*", 5, "4 signals"),
        ("signals/nothing", None, "no signal at"),
    ],
)
def test_invalid_write_request_is_refused_and_nothing_is_written(
    key: str, payload: object, words: str, refusing: zenoh.Session
) -> None:
    assert words in ask(refusing, f"robot/1/{key}", payload)["error"]
    assert ask(refusing, "robot/1/signals/j1/pos_sp") == 0


SIGNALS = [f"signals/j{joint}/{name}" for joint in (1, 2, 3, 4) for name in ("cpos", "spd", "pos_sp", "spd_sp")]


@pytest.mark.parametrize(
    ("key", "payload", "answers"),
    [
        ("robot/**/info", None, ["info"]),
        ("**/info", None, ["info"]),
        ("robot/**/read", None, ["read"]),
        ("robot/**/read", ["j1.cpos"], ["read"]),
        ("robot/*/read", ["j1.cpos"], ["read"]),
        ("robot/**/write", {"j2.pos_sp": 1}, ["write"]),
        ("robot/**/write", None, []),
        ("robot/**/cpos", None, SIGNALS[::4]),
        ("robot/**/signals/j2/cpos", None, ["signals/j2/cpos"]),
        ("robot/*/signals/j2/pos_sp", 1, ["signals/j2/pos_sp"]),
        ("robot/*/signals/gripper", None, []),
        ("robot/*/signals/gripper", 1, []),
        ("robot/**/pos_sp", 1, []),
        ("robot/*/*", ["j1.cpos"], ["info"]),
        ("robot/**", {"j2.pos_sp": 1}, ["info"]),
        ("robot/**", None, ["info", "read", *SIGNALS]),
    ],
)
def test_wildcards_get_answers_and_no_errors(
    key: str, payload: object, answers: list[str], refusing: zenoh.Session
) -> None:
    given = None if payload is None else msgspec.json.encode(payload)
    replies = list(refusing.get(key, payload=given))
    assert [reply.err.payload.to_string() for reply in replies if reply.err is not None] == []
    keys = [str(reply.ok.key_expr) for reply in replies if reply.ok is not None]
    assert sorted(keys) == sorted(f"robot/1/{answer}" for answer in answers)


@pytest.fixture(scope="module")
def refusing() -> Iterator[zenoh.Session]:
    place = free_endpoint()
    with bridge(place) as process, session(place) as peer:
        wait_for(process, "scara at robot/1")
        # A query before the session knows the keys of the bridge gets no answer; `ask` repeats it until it gets one.
        ask(peer, "robot/1/info")
        yield peer


@pytest.mark.slow
def test_publications_are_written_in_order_and_values_off_limits_reported() -> None:
    place = free_endpoint()
    with bridge(place) as process, session(place) as peer:
        wait_for(process, "scara at robot/1")
        ask(peer, "robot/1/info")

        for value in range(100):
            peer.put("robot/1/write", msgspec.json.encode([{"j1.pos_sp": value}, {"j2.pos_sp": value}]))
        peer.put("robot/1/write", b'{"j1.pos_sp": 500}')

        assert "j1.pos_sp: 500 is outside of its limits" in wait_for(process, "told once")
        wait_until(lambda: ask(peer, "robot/1/read", ["j1.pos_sp", "j2.pos_sp"]) == {"j1.pos_sp": 99, "j2.pos_sp": 99})
        process.send_signal(signal.SIGINT)
        assert "200 values written" in wait_for(process, "values written")
        assert process.wait(PATIENCE) == 130


@pytest.mark.slow
def test_every_sample_arrives_once_in_order_many_in_one_publication() -> None:
    place = free_endpoint()
    seen: list[dict[str, Any]] = []
    with (
        program("zenoh", SPEC, "--link", GATEWAY, "--prefix", "r", "--listen", place, "--every", "0.1") as process,
        session(place) as peer,
    ):
        peer.declare_subscriber(
            "r/samples/state", lambda sample: seen.append(msgspec.json.decode(bytes(sample.payload)))
        )
        wait_for(process, "scara at r")
        wait_until(lambda: len(seen) >= 10)

    numbers = [number for message in seen for number in message["sequence"]]
    times = [instant for message in seen for instant in message["time"]]
    assert numbers == list(range(numbers[0], numbers[0] + len(numbers)))
    assert all(later - earlier == pytest.approx(0.005) for earlier, later in itertools.pairwise(times))
    assert len(numbers) > 2 * len(seen)
    assert {len(column) for column in seen[0]["signals"].values()} == {len(seen[0]["sequence"])}
    assert sum(sum(message["lost"]) for message in seen) == 0


# Links


async def first_of(subscription: Subscription, count: int) -> list[Sample]:
    return [await anext(subscription) for _ in range(count)]


def test_a_link_over_zenoh_is_a_link_like_any_other() -> None:
    async def use(place: str) -> None:
        async with (
            unity_link.connect(url(place), timeout=PATIENCE) as link,
            link.subscribe([0x80], rate_hz=100) as mine,
        ):
            # Take samples while the requests run: a busy machine needs long for the requests, and samples not taken are
            # lost.
            samples = asyncio.create_task(first_of(mine, 100))
            await link.write_block(0x8C, [1, 2, 3, 4])
            assert (await link.read_block(0x8C, 4)).tolist() == [1, 2, 3, 4]
            assert len(await link.read_many([0x8C] * 5000)) == 5000
            for value in range(200):
                await link.post(POS_SP, value)
            await link.fence()
            assert await link.read(POS_SP) == 199
            numbers = [sample.sequence for sample in await samples]
            assert numbers == list(range(numbers[0], numbers[0] + 100))

    place = free_endpoint()
    with bridge(place) as process:
        wait_for(process, "scara at robot/1")
        asyncio.run(use(place))


@pytest.mark.slow
def test_error_without_a_bridge_names_the_command_that_starts_it() -> None:
    with pytest.raises(ConnectError, match="no bridge answers at robot/1: is `unity-link zenoh --prefix robot/1`"):
        blocking.connect(url(free_endpoint()), timeout=PATIENCE)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("bad", "words"),
    [
        ("zenoh:", "names no prefix"),
        ("zenoh://robot/1", "names no prefix"),
        ("zenoh:robot/*", "no prefix of keys"),
        ("zenoh:robot/1?mode=router2", 'does not take "router2" for mode: unknown variant'),
        ("zenoh:robot/1?connect=nowhere", "connect/endpoints: Endpoints must be"),
        ("zenoh:robot/1?config=/no/such/file", "no configuration of Zenoh"),
    ],
)
def test_a_url_that_makes_no_sense_is_explained(bad: str, words: str) -> None:
    with pytest.raises((ArgumentError, ConnectError), match=words) as told:
        blocking.connect(bad, timeout=PATIENCE)
    assert ".rs:" not in str(told.value)


def gets_a_sample(link: blocking.BlockingLink) -> bool:
    """Return True if a group is free, and publishes."""
    with contextlib.suppress(OutOfRangeError), link.subscribe([0x80], rate_hz=100) as mine:
        return bool(next(iter(mine)).values.shape == (1,))
    return False


@pytest.mark.slow
def test_killed_client_frees_its_groups_and_no_write_executes_twice() -> None:
    script = (
        "import asyncio, sys, unity_link\n"
        "async def main():\n"
        f"    async with unity_link.connect(sys.argv[1], timeout=60) as link, link.subscribe([0x80], rate_hz=100):\n"
        "        for value in range(10**9):\n"
        f"            await link.write({POS_SP}, value % 1000)\n"
        "            if value == 100: print('busy', flush=True)\n"
        "asyncio.run(main())\n"
    )
    place = free_endpoint()
    # The bridge has one group, so that the next client gets it only after the group of the killed client was freed.
    with bridge(place, GATEWAY + "&groups=2") as process:
        wait_for(process, "scara at robot/1")
        for _ in range(2):
            with subprocess.Popen([sys.executable, "-c", script, url(place)], stdout=subprocess.PIPE) as client:
                assert client.stdout is not None
                assert client.stdout.readline() == b"busy\n"
                client.kill()
            with blocking.connect(url(place), timeout=PATIENCE) as link:
                # On a busy machine, the report of the killed client and its last write arrive late.
                wait_until(lambda: gets_a_sample(link))
                before = link.read(POS_SP)
                assert [link.read(POS_SP) for _ in range(20)] == [before] * 20


async def read_for_ever(link: unity_link.Link) -> None:
    while True:
        await link.read(0x80)
        await asyncio.sleep(0.01)


@pytest.mark.slow
def test_link_notices_a_killed_bridge_at_once_and_reconnects_to_the_next() -> None:
    async def use(place: str) -> None:
        with_one = unity_link.connect(url(place), timeout=PATIENCE)
        patient = await unity_link.connect(url(place), timeout=PATIENCE, reconnect=True)
        async with with_one as link:
            process.kill()
            with pytest.raises(LinkLostError, match="the bridge has gone"):
                await read_for_ever(link)
        with bridge(place) as second:
            await asyncio.to_thread(wait_for, second, "scara at robot/1")
            assert await patient.read(POS_SP) == 0
            assert patient.statistics.reconnections == 1
            await patient.aclose()

    place = free_endpoint()
    with bridge(place) as process:
        wait_for(process, "scara at robot/1")
        asyncio.run(use(place))


# Other clients, bridges and routers


@pytest.mark.slow
def test_gateway_may_start_late_and_restart(tmp_path: Path) -> None:
    place, gateway = free_endpoint(), tmp_path / "gateway"
    with bridge(place, f"unix:{gateway}") as process, session(place) as peer:
        wait_for(process, "waiting for the gateway")
        for turn in range(2):
            with program("serve", "sim:scara", "--unix", str(gateway)):
                wait_for(process, "scara at robot/1" if turn == 0 else "the gateway answers")
                if turn > 0 and "error" in (answer := ask(peer, "robot/1/write", {"j1.pos_sp": 7})):
                    # The gateway is a new one, without the values set before. The outcome of a retransmitted request is
                    # unknown.
                    assert answer["error"].startswith("the gateway was reset; the request is ")
                assert ask(peer, "robot/1/write", {"j1.pos_sp": 9}) == {"written": 1}
                assert ask(peer, "robot/1/signals/j1/pos_sp") == 9
            wait_for(process, "the gateway is away")
        assert "the gateway is away" in ask(peer, "robot/1/write", {"j1.pos_sp": 5})["error"]


@pytest.mark.slow
def test_gateway_that_leaves_and_returns_gets_no_value_twice(tmp_path: Path) -> None:
    place, gateway = free_endpoint(), Noted(tmp_path)
    command = ["zenoh", gateway.spec, "--link", gateway.url, "--prefix", "robot/1", "--listen", place]
    with program(*command) as process, session(place) as peer, counting_up(peer):
        with gateway.running():
            wait_for(process, "plain at robot/1")
            gateway.wait_for_more()
        wait_for(process, "the gateway is away")
        with gateway.running():
            gateway.wait_for_more()
            process.send_signal(signal.SIGINT)
            wait_for(process, "values written")
    assert gateway.values == sorted(set(gateway.values))


@pytest.mark.slow
def test_client_killed_during_queries_has_written_once_and_others_continue(
    tmp_path: Path,
) -> None:
    script = (
        "import sys\n"
        "from unity_link.transport.zenoh_session import Network, open_session\n"
        "session = open_session(Network(connect=(sys.argv[1],)))\n"
        "for value in range(1_000_000):\n"
        "    list(session.get('robot/1/signals/target', payload=str(value)))\n"
    )
    place, gateway = free_endpoint(), Noted(tmp_path)
    command = ["zenoh", gateway.spec, "--link", gateway.url, "--prefix", "robot/1", "--listen", place]
    with gateway.running(), program(*command) as process, session(place) as peer:
        wait_for(process, "plain at robot/1")
        with subprocess.Popen([sys.executable, "-c", script, place]) as client:
            gateway.wait_for_more()
            client.kill()
        assert ask(peer, "robot/1/write", {"target": 999_999}) == {"written": 1}
        values = gateway.values
        process.send_signal(signal.SIGINT)
        assert f"{len(values)} values written" in wait_for(process, "values written")
    assert values == sorted(set(values))


@contextmanager
def counting_up(peer: zenoh.Session) -> Iterator[None]:
    """Put 0, 1, 2 and so on into the write topic of the bridge until the end of the block."""
    ended = threading.Event()

    def put() -> None:
        for value in itertools.count():
            peer.put("robot/1/write", msgspec.json.encode({"target": value}))
            if ended.wait(0.001):
                return

    thread = threading.Thread(target=put)
    thread.start()
    try:
        yield
    finally:
        ended.set()
        thread.join()


ROUTER = """
import json, sys, time, zenoh
config = zenoh.Config()
given = {"mode": "router", "listen/endpoints": [sys.argv[1]], "scouting/multicast/enabled": False}
for key, value in given.items():
    config.insert_json5(key, json.dumps(value))
session = zenoh.open(config)
print("ready", flush=True)
time.sleep(600)
"""


@contextmanager
def router(endpoint: str) -> Iterator[None]:
    with subprocess.Popen([sys.executable, "-c", ROUTER, endpoint], stdout=subprocess.PIPE) as process:
        assert process.stdout is not None
        assert process.stdout.readline() == b"ready\n"
        try:
            yield
        finally:
            process.kill()


@pytest.mark.slow
def test_links_and_queries_survive_a_router_that_starts_late_and_restarts() -> None:
    async def use(place: str) -> None:
        with router(place):
            await asyncio.to_thread(wait_for, process, "scara at robot/1")
            link = await unity_link.connect(f"{url(place)}&mode=client", timeout=PATIENCE, reconnect=True)
            await link.write(POS_SP, 5)
        await asyncio.sleep(0)
        with router(place):
            assert await link.read(POS_SP) == 5
            assert link.statistics.reconnections >= 1
            with session(place) as peer:
                assert await asyncio.to_thread(ask, peer, "robot/1/signals/j1/pos_sp") == pytest.approx(5 / COUNTS)
            await link.aclose()

    place = free_endpoint()
    command = ["zenoh", SPEC, "--link", GATEWAY, "--prefix", "robot/1", "--mode", "client", "--connect", place]
    with program(*command) as process:
        wait_for(process, "waiting for the router")
        asyncio.run(use(place))


@pytest.mark.slow
def test_router_that_leaves_and_returns_causes_no_second_write(tmp_path: Path) -> None:
    place, gateway = free_endpoint(), Noted(tmp_path)
    command = ["zenoh", gateway.spec, "--link", gateway.url, "--prefix", "robot/1", "--mode", "client"]
    with gateway.running(), program(*command, "--connect", place) as process, contextlib.ExitStack() as putting:
        wait_for(process, "waiting for the router")
        with router(place):
            wait_for(process, "plain at robot/1")
            putting.enter_context(counting_up(putting.enter_context(session(place))))
            gateway.wait_for_more()
        with router(place):
            gateway.wait_for_more(500)
    assert gateway.values == sorted(set(gateway.values))


@pytest.mark.slow
@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["--prefix", "robot/*"], "'robot/*' is no prefix of keys"),
        (["--prefix", "@robot/1"], "'@robot/1' is no prefix of keys"),
        (["--prefix", "robot/@1"], "as in robot/1; no wildcard includes a name that begins with @"),
        (["--prefix", "robot/1", "--link", "sim:delta"], "no robot 'delta' is known"),
        (["--prefix", "robot/1", "--connect", "nowhere"], "connect/endpoints: Endpoints must be"),
        (["--prefix", "robot/1", "--mode", "client"], "a client of Zenoh needs a router: connect to one, such as"),
        (["--prefix", "robot/1", "--every", "-1"], "0 or more seconds were expected"),
        (["--prefix", "robot/1", "--every", "inf"], "0 or more seconds were expected"),
        (["--prefix", "robot/1", "--poll", "inf"], "more than 0 Hz was expected"),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, list) else "",
)
def test_wrong_use_is_reported_in_one_sentence_and_nothing_else(arguments: list[str], words: str) -> None:
    result = subprocess.run(
        [PROGRAM, "zenoh", SPEC, "--link", "sim:scara", *arguments],
        capture_output=True,
        text=True,
        timeout=PATIENCE,
        check=False,
    )
    assert result.returncode == 2
    assert words in result.stderr
    assert result.stderr.count("\n") == 1


@pytest.mark.slow
def test_two_bridges_do_not_share_a_prefix() -> None:
    place = free_endpoint()
    with bridge(place) as process:
        wait_for(process, "scara at robot/1")
        second = subprocess.run(
            [PROGRAM, "zenoh", SPEC, "--link", "sim:scara", "--prefix", "robot/1", "--connect", place],
            capture_output=True,
            text=True,
            timeout=PATIENCE,
            check=False,
        )
    assert second.returncode == 1
    assert "another bridge has the prefix robot/1" in second.stderr


@pytest.mark.slow
def test_bridge_is_closed_to_other_machines_by_default() -> None:
    opened = open_session(Network(), meeting=True)
    try:
        listening = subprocess.run(["ss", "-Hlntup"], capture_output=True, text=True, check=True).stdout
    finally:
        close_session(opened)
    own = [line.split()[4] for line in listening.splitlines() if f"pid={os.getpid()}," in line]
    assert own
    assert {address.rpartition(":")[0] for address in own} == {"127.0.0.1"}


@pytest.mark.slow
def test_second_bridge_of_a_machine_ends_while_the_first_continues() -> None:
    arguments = ["zenoh", "examples/scara.ul", "--link", "sim:scara", "--prefix"]
    with program(*arguments, "first") as first, program(*arguments, "second") as second:
        for process in (first, second):
            wait_for(process, "published")
        second.send_signal(signal.SIGINT)
        wait_for(second, "samples published")
        assert second.wait(PATIENCE) == 130
        assert second.stderr is not None
        assert second.stderr.read() == ""
        assert first.poll() is None


@pytest.mark.slow
def test_bridges_of_one_machine_meet_without_a_word_and_outlive_the_first() -> None:
    first = open_session(Network(), meeting=True)
    second = open_session(Network(), meeting=True)
    second.declare_queryable("here", lambda query: query.reply("here", b"yes"))
    close_session(first)
    try:
        third = open_session(Network())
        try:
            wait_until(lambda: [reply for reply in third.get("here") if reply.ok is not None])
        finally:
            close_session(third)
    finally:
        close_session(second)
