"""The command line: `unity-link`.

Each module has one family of commands. A command parses its arguments, uses the same Python API as programs
(`unity_link.connect`), and prints the result.

- `families` lists which module has which command, and imports the module when the command is used
- `running` runs the coroutine of a command until it ends or a signal arrives; `output` writes stdout and stderr
- `arguments` and `words` parse addresses and values; `wrong_use` words the errors of wrong command lines
- `signals` has get and set; `completion` completes arguments in a shell; `manual` makes the manual page;
  `watched` has the sources of `watch`
- `doctor` checks for slow or wrong settings; `find` lists the boards on the network
- `info`, `access` (read, write), `watch`, `simulate`, `stop`, `terminal`, `demo` with `demo_view` are commands
- `spec` has the commands for specs: check, fmt, show, import; `generate` writes code from a spec
- `build` makes bitstreams for boards; `gateware` copies the VHDL; `example` writes the examples
- `recording` has record and replay; `export` exports recordings and specs; `ros` has the bridges to ROS
- `zenoh` has the bridge to Zenoh
- `snoop` has explain and retrace, for recorded traffic of a connection
- `ft232h` has the commands for the EEPROM of FT232H chips
- `live` serves plots of signals; `serve` shares a link; `service` notifies systemd
- `plots` draws curves; `full_screen` shows a picture on the whole terminal

Modules import at their top only modules that each of their commands needs, and this module only modules that every
command needs; slow imports are inside functions.

Exit codes: 0 success; 1 failure, with one sentence on stderr; 2 wrong use; 128 plus the number of a signal that ended
the command (130 for Ctrl-C).
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
    """Accept the options before the command."""


_UNWRITABLE = {errno.EBADF, errno.EDQUOT, errno.EFBIG, errno.EIO, errno.ENOSPC, errno.EPIPE}
"""Errors of writes to a file, pipe or terminal."""


def main(program: typer.Typer = app, name: str = NAME) -> None:
    """Run a command line and exit with its code; `name` is the command that users type."""
    for number in SIGNALS:
        # A signal that `nohup` ignores stays ignored.
        if signal.getsignal(number) is signal.SIG_DFL:
            signal.signal(number, signal.default_int_handler if number == signal.SIGINT else _end)
    _open_what_is_closed()
    with words_of_bash():
        sys.exit(_run(program, name))


def _end(number: int, _: object) -> NoReturn:
    """End the program by SystemExit, so that `finally` blocks remove unfinished files."""
    sys.exit(SIGNALLED + number)


def _open_what_is_closed() -> None:
    """Open the null device as stdout or stderr if the program was started without it."""
    for name in ("stdout", "stderr"):
        if getattr(sys, name) is None:
            setattr(sys, name, Path(os.devnull).open("w"))  # noqa: SIM115  (it stays open until the process exits)


def _run(program: typer.Typer, name: str = NAME) -> int:
    # Escape characters that the terminal's encoding lacks, such as the µ of µs, instead of failing.
    if isinstance(sys.stdout, io.TextIOWrapper):
        sys.stdout.reconfigure(errors="backslashreplace")
    quote_logs()
    try:
        code: int | None = program(standalone_mode=False, prog_name=name)
        sys.stdout.flush()
    except typer.TyperException as error:
        from unity_link.cli.wrong_use import sentence_about

        # Without arguments the help was printed, and the message is empty.
        if message := sentence_about(error):
            print_error(message, hint=_usage_hint(error))
        return error.exit_code
    except ArgumentError as error:
        print_error(str(error))
        return WRONG_USE
    except UnityLinkError as error:
        print_error(str(error), hint="; ".join(getattr(error, "__notes__", [])))
        return FAILED
    except OSError as error:
        _print_os_error(error)
        return FAILED
    except KeyboardInterrupt:
        return INTERRUPTED
    if code in (0, None, INTERRUPTED):
        remember_used()
    return code or 0


def _print_os_error(error: OSError) -> None:
    """Print an error of the operating system."""
    # Commands report errors of files that they write; without a file name, an unwritable stdout is the cause.
    if error.filename is not None or error.errno not in _UNWRITABLE:
        place = f"{error.filename}: " if error.filename is not None else ""
        print_error(f"{place}{error.strerror or error}")
        return
    # Replace stdout, so that the interpreter does not write the buffered rest again at exit.
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    # If the reader of a pipe has closed it, print no error: that is how `head` ends a command.
    if not isinstance(error, BrokenPipeError):
        print_error(f"standard output cannot be written: {error.strerror}")


def _usage_hint(error: typer.TyperException) -> str:
    context = getattr(error, "ctx", None)
    return f"Try: {context.command_path} --help" if context is not None else ""
