"""The command line: `unity-link`.

One file for each family of commands. They parse, show and explain; what they do, a program does by
`unity_link.connect`.

- `families` says which file has which command, and imports it when the command is typed
- `running` runs a command's coroutine until it is done or a signal comes, `output` says what stdout and stderr are for
- `arguments` and `words` read and write addresses and values, `wrong_use` says which of them cannot be
- `signals` has get and set, by names; `completion` tells a shell how an argument may go on,
  `manual` makes the manual page of all commands; `watched` is what `watch` watches
- `doctor` finds what is slow or wrong, `find` which boards are on the network
- `info`, `access` (read, write), `watch`, `simulate`, `terminal`, `demo` with `demo_view` are commands
- `spec` has the commands about specs: check, fmt, show, import; `generate` writes code from one
- `build` makes bitstreams of boards, `gateware` gives the VHDL away
- `recording` has record and replay; `export` is about recordings and specs; `ros` has the bridges to ROS
- `zenoh` has the bridge to Zenoh
- `snoop` has explain and retrace, for files of what passed on a connection
- `ft232h` has those about the chip's EEPROM
- `live` shows signals on a page; `serve` shares a link; `service` tells systemd of a command that runs for long
- `plots` draws curves, `full_screen` gives a picture the whole terminal for a while

Modules import at their top only what each of their commands needs, and this one what every command needs; what is slow
to load is imported where it is used.

Exit codes: 0 done; 1 failed, as the one sentence on stderr says; 2 wrong use; 128 and the number of the signal where
one ended it (130 for Ctrl-C).
"""

from __future__ import annotations

import errno
import io
import os
import signal
import sys
from pathlib import Path
from typing import Annotated, NoReturn

import typer

import unity_link
from unity_link.cli.completion import remember_used, words_of_bash
from unity_link.cli.families import MARKUP, Commands
from unity_link.cli.output import print_error, quote_logs
from unity_link.cli.running import INTERRUPTED, SIGNALLED, SIGNALS
from unity_link.errors import ArgumentError, UnityLinkError

FAILED = 1
WRONG_USE = 2
NAME = "unity-link"

app = typer.Typer(
    name=NAME,
    cls=Commands,
    help="Connect to an FPGA: read, write and watch its bus, or try all of it on a virtual gateway.",
    epilog="URL is where the gateway is: serial:/dev/ttyUSB0?baud=12000000, tcp://host:port, unix:/path, "
    "udp://host:port; or sim: and sim:scara, which need no hardware, and rtl: and rtl:scara, the gateware compiled.",
    no_args_is_help=True,
    rich_markup_mode=MARKUP,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)


def _print_version(wanted: bool) -> None:
    if wanted:
        typer.echo(f"unity-link {unity_link.__version__}")
        raise typer.Exit


@app.callback()
def _options(
    version: Annotated[
        bool, typer.Option("--version", callback=_print_version, is_eager=True, help="Print the version and exit.")
    ] = False,
) -> None:
    """Take the options that stand before a command."""


_UNWRITABLE = {errno.EBADF, errno.EDQUOT, errno.EFBIG, errno.EIO, errno.ENOSPC, errno.EPIPE}
"""Errors of a file, pipe or terminal that cannot take a write."""


def main(program: typer.Typer = app, name: str = NAME) -> None:
    """Run a command line, and exit with its code; `name` is what users type to get there."""
    for number in SIGNALS:
        # What `nohup` ignores stays ignored.
        if signal.getsignal(number) is signal.SIG_DFL:
            signal.signal(number, signal.default_int_handler if number == signal.SIGINT else _end)
    _open_what_is_closed()
    with words_of_bash():
        sys.exit(_run(program, name))


def _end(number: int, _: object) -> NoReturn:
    """End the program by a signal as by an error, so that `finally` blocks remove unfinished files."""
    sys.exit(SIGNALLED + number)


def _open_what_is_closed() -> None:
    """Open what takes all that is printed, for a program that was started without stdout or stderr."""
    for name in ("stdout", "stderr"):
        if getattr(sys, name) is None:
            setattr(sys, name, Path(os.devnull).open("w"))  # noqa: SIM115  (it stays open to the end)


def _run(program: typer.Typer, name: str = NAME) -> int:
    # A character that the terminal does not know, such as the µ of µs, is no reason to end.
    if isinstance(sys.stdout, io.TextIOWrapper):
        sys.stdout.reconfigure(errors="backslashreplace")
    quote_logs()
    try:
        code: int | None = program(standalone_mode=False, prog_name=name)
        sys.stdout.flush()
    except typer.TyperException as error:
        from unity_link.cli.wrong_use import sentence_about

        # Without any argument the help has been printed, and there is nothing to add.
        if message := sentence_about(error):
            print_error(message, hint=_usage_hint(error))
        return error.exit_code
    except ArgumentError as error:
        print_error(str(error))
        return WRONG_USE
    except UnityLinkError as error:
        print_error(str(error))
        return FAILED
    except OSError as error:
        _tell(error)
        return FAILED
    except KeyboardInterrupt:
        return INTERRUPTED
    if code in (0, None, INTERRUPTED):
        remember_used()
    return code or 0


def _tell(error: OSError) -> None:
    """Print what the system refused."""
    # What a command writes to files it answers for itself; what was open before it is stdout.
    if error.filename is not None or error.errno not in _UNWRITABLE:
        place = f"{error.filename}: " if error.filename is not None else ""
        print_error(f"{place}{error.strerror or error}")
        return
    # What is still buffered must not be tried again at exit.
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    # If the reader of the output has gone, there is nothing to tell.
    if not isinstance(error, BrokenPipeError):
        print_error(f"standard output cannot be written: {error.strerror}")


def _usage_hint(error: typer.TyperException) -> str:
    context = getattr(error, "ctx", None)
    return f"Try: {context.command_path} --help" if context is not None else ""
