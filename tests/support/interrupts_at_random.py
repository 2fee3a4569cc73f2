"""Interrupts programs at random instants by signals from another process, as a terminal or `kill` sends them.

A program writes a byte when it may be interrupted, and 0 in its `finally`. At its end it prints what went wrong:
another exception than that of the handler, a write that was not executed, a thread that died. A program that hangs is
an
error, and the stacks of its threads are printed.
"""

from __future__ import annotations

import os
import random
import select
import signal
import subprocess
import sys
import time
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from pathlib import Path

LONGEST = 0.003
"""Longest time from the byte to the signal, in seconds."""
PATIENCE = 60.0
"""Seconds without output after which a program is considered to hang."""
SPEC = """group state(RATE=1000, TIMESTAMPS);
public rover() {
  GATEWAY(ADDRESS_BITS=12);
  drive: LEASE(TIMEOUT=10) @(0xE0);
  @duty = 0x0F: unsigned 16 READWRITE();
  @voltage = 0x10: signed 12 READWRITE(SCALE=0.01, MIN=-12, MAX=12, SAFE(0, drive));
  @position = 0x20: signed READ(PUBLISH(state));
}
"""
_HEAD = """
import faulthandler, gc, logging, os, random, signal, sys, threading, time, traceback
faulthandler.register(signal.SIGUSR1, all_threads=True)

import unity_link
from unity_link import blocking
from unity_link.data.blocking import Group, put
from unity_link.spec import compile_text

url, rounds, ready, spec, way, beside = sys.argv[1], int(sys.argv[2]), int(sys.argv[3]), *sys.argv[4:7]
NUMBER = getattr(signal, way)
Rover = unity_link.load(compile_text(spec))
wrong = []

class Stopped(BaseException):
    pass

def stop(number, frame):
    if number == signal.SIGTERM:
        sys.exit(3)
    raise Stopped

class Log(logging.Handler):
    def emit(self, record):
        wrong.append(f"log: {record.getMessage()} {record.exc_info}")

logging.getLogger("unity_link").addHandler(Log(logging.ERROR))
threading.excepthook = lambda args: wrong.append(f"a thread has died: {args.exc_value!r}")


def note_unraisable(args):
    where = " ".join(f"{frame.filename}:{frame.lineno}" for frame in traceback.extract_tb(args.exc_traceback))
    wrong.append(f"unraisable: {args.exc_value!r} {args.object!r} {where}")
    # What is lost here may be what was to end the round.
    print(wrong[-1], flush=True)

sys.unraisablehook = note_unraisable
EXPECTED = {"SIGINT": KeyboardInterrupt, "SIGTERM": SystemExit, "SIGALRM": Stopped}[way]

def say():
    # Whoever sends the signal may send it from here on.
    if way == "SIGALRM":
        signal.setitimer(signal.ITIMER_REAL, random.uniform(0.00001, 0.003))
    os.write(ready, b".")

def install():
    # A program that was started in the background of a script ignores Ctrl-C.
    signal.signal(NUMBER, signal.default_int_handler if way == "SIGINT" else stop)

def compute(ended):
    while not ended.is_set():
        sum(range(1000))

ended = threading.Event()
if beside == "computing":
    # This thread takes the signal, and the interpreter runs the handler in the main thread all the same.
    sys.setswitchinterval(0.0005)
    threading.Thread(target=compute, args=(ended,), daemon=True).start()
    signal.pthread_sigmask(signal.SIG_BLOCK, {NUMBER})
"""
_TAIL = """
ended.set()
for line in wrong[:5]:
    print(line, flush=True)
print(f"{done} rounds, {len(wrong)} wrong", flush=True)
os._exit(bool(wrong))
"""
BLOCKING = f"""{_HEAD}
def set_in_a_loop():
    value = 0
    while True:
        value = value % 1000 + 1
        robot.duty.set(value)

def write_and_post():
    value = 0
    while True:
        value = value % 1000 + 1
        link.write(0x0F, value)
        for following in range(value, value + 16):
            link.post(0x0F, following)
        link.write(0x0F, value)
        assert link.read(0x0F) == value

def take_samples():
    with link.subscribe([0x20, 0x0F], rate_hz=2000) as samples:
        for sample in samples:
            link.write(0x0F, sample.sequence % 1000 + 1)

def wait_for_samples():
    # None come, because there is no register at 0x21.
    with link.subscribe([0x20, 0x21], rate_hz=2000) as samples:
        link.write(0x0F, 5)
        next(samples)

def kick_in_a_loop():
    with robot.drive.armed(timeout=5) as lease:
        for sample in lease.each(robot.groups["state"]):
            robot.voltage.set(3)
            link.write(0x0F, 5)

def arm_again_and_again():
    while True:
        link.write(0x0F, 5)
        with robot.drive.armed(timeout=5):
            robot.voltage.set(3)

def open_again_and_again():
    while True:
        link.write(0x0F, 5)
        with blocking.connect(url) as other:
            other.read(0x0F)

BODIES = [
    set_in_a_loop,
    write_and_post,
    take_samples,
    wait_for_samples,
    kick_in_a_loop,
    arm_again_and_again,
    open_again_and_again,
]
done = 0
with blocking.connect(url) as link:
    robot = put(Rover, link)
    install()
    if beside == "reading":
        def read(ended):
            while not ended.is_set():
                link.read(0x0F)
        reader = threading.Thread(target=read, args=(ended,), daemon=True)
        reader.start()
    handlers = signal.getsignal(NUMBER)
    for done in range(1, rounds + 1):
        body = BODIES[done % len(BODIES)]
        try:
            try:
                say()
                body()
            finally:
                link.write(0x0F, 0)
        except EXPECTED:
            pass
        except BaseException as error:
            wrong.append(f"{{body.__name__}}: {{error!r}}")
        try:
            if link.read(0x0F) != 0:
                wrong.append(f"{{body.__name__}}: the write was not executed")
            if robot["drive.armed"].get():
                wrong.append(f"{{body.__name__}}: still armed")
            if signal.getsignal(NUMBER) is not handlers:
                wrong.append(f"{{body.__name__}}: the handler is {{signal.getsignal(NUMBER)!r}}")
        except BaseException as error:
            wrong.append(f"after {{body.__name__}}: {{error!r}}")
        if wrong:
            break
    ended.set()
    if beside == "reading":
        reader.join()
gc.collect()
{_TAIL}"""

TRIO = f"""{_HEAD}
import trio

async def set_in_a_loop(link, robot):
    value = 0
    while True:
        value = value % 1000 + 1
        await robot.duty.set(value)

async def write_in_tasks(link, robot):
    async def write(address):
        while True:
            await link.write(address, 5)

    async with trio.open_nursery() as nursery:
        for _ in range(3):
            nursery.start_soon(write, 0x0F)
        await write(0x0F)

async def take_samples(link, robot):
    async with link.subscribe([0x20, 0x0F], rate_hz=2000) as samples:
        async for sample in samples:
            await link.write(0x0F, sample.sequence % 1000 + 1)

async def kick_in_a_loop(link, robot):
    async with robot.drive.armed(timeout=5) as lease:
        async for sample in lease.each(robot.groups["state"]):
            await robot.voltage.set(3)
            await link.write(0x0F, 5)

async def arm_again_and_again(link, robot):
    while True:
        await link.write(0x0F, 5)
        async with robot.drive.armed(timeout=5):
            await robot.voltage.set(3)

async def open_again_and_again(link, robot):
    while True:
        await link.write(0x0F, 5)
        async with unity_link.connect(url) as other:
            await other.read(0x0F)

async def sleep(link, robot):
    await link.write(0x0F, 5)
    await trio.sleep_forever()

BODIES = [
    set_in_a_loop, write_in_tasks, take_samples, kick_in_a_loop, arm_again_and_again, open_again_and_again, sleep
]
# What other handlers raise ends the block of the link.
PER_LINK = 50 if way == "SIGINT" else 1
done = 0

def leaves(error):
    if not isinstance(error, BaseExceptionGroup):
        return [error]
    return [leaf for each in error.exceptions for leaf in leaves(each)]

async def one(link, robot, body):
    try:
        say()
        await body(link, robot)
    finally:
        with trio.CancelScope(shield=True):
            await link.write(0x0F, 0)

def check(body, error):
    if error is None or any(type(leaf) is not EXPECTED for leaf in leaves(error)):
        wrong.append(f"{{body.__name__}}: {{error!r}} {{leaves(error) if error else ''}}")
    if checker.read(0x0F) != 0:
        wrong.append(f"{{body.__name__}}: the write was not executed")
    if checker.read(ARMED.address) & 1:
        wrong.append(f"{{body.__name__}}: still armed")

async def main():
    global done
    while done < rounds and not wrong:
        body = error = None
        try:
            async with unity_link.connect(url) as link:
                robot = Rover(link)
                for _ in range(min(PER_LINK, rounds - done)):
                    done += 1
                    body = BODIES[done % len(BODIES)]
                    error = None
                    try:
                        await one(link, robot, body)
                    except BaseException as raised:
                        error = raised
                        if PER_LINK == 1:
                            raise
                    check(body, error)
        except BaseException as raised:
            error = raised
        if PER_LINK == 1:
            check(body, error)
        elif error is not None and any(type(leaf) is not EXPECTED for leaf in leaves(error)):
            wrong.append(f"at the end: {{error!r}}")

with blocking.connect(url) as checker:
    ARMED = put(Rover, checker)["drive.armed"].signal
    install()
    try:
        trio.run(main)
    except BaseException as error:
        wrong.append(f"trio.run raised {{error!r}} {{error.__cause__!r}}")
{_TAIL}"""


def interrupt(
    program: str, url: str, rounds: int, *, way: str, beside: str = "", seed: int = 1, folder: Path | None = None
) -> str:
    """Interrupt a program at random instants; return its output.

    Args:
        program: source of the program.
        url: of its gateway.
        rounds: number of signals.
        way: name of the signal; with SIGALRM the program sets its own timer.
        beside: work of another thread of the program: "computing", "reading", or empty for none.
        seed: of the random instants.
        folder: working folder of the program.
    """
    chance = random.Random(seed)
    readable, writable = os.pipe()
    command = [
        sys.executable,
        "-X",
        "dev",
        "-W",
        "default",
        "-c",
        program,
        url,
        str(rounds),
        str(writable),
        SPEC,
        way,
        beside,
    ]
    with subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, pass_fds=[writable], cwd=folder
    ) as process:
        os.close(writable)
        try:
            while select.select([readable], [], [], PATIENCE)[0]:
                if not os.read(readable, 1):
                    break
                end = time.perf_counter() + chance.uniform(0, LONGEST)
                while time.perf_counter() < end:
                    pass
                if way != "SIGALRM":
                    process.send_signal(getattr(signal, way))
            else:
                process.send_signal(signal.SIGUSR1)
                time.sleep(1)
        finally:
            os.close(readable)
            if process.poll() is None:
                try:
                    process.wait(10)
                except subprocess.TimeoutExpired:
                    process.kill()
        return process.communicate()[0]
