"""Checks the subject of a commit: ``python commit_message.py FILE``, for the hook that `make hooks` installs.

The subject is the first paragraph of the message, as in git, and has at most `LONGEST` characters.
"""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]
LONGEST = 72
# git squashes these commits into others, and drops their subjects.
_TEMPORARY = ("fixup! ", "squash! ", "amend! ")
_HOOK = """\
#!/bin/sh
# Written by `make hooks` of Unity-Link: refuses an empty or long subject of a commit.
check="$(git rev-parse --show-toplevel)/tests/support/commit_message.py"
[ ! -f "$check" ] || exec python3 -I "$check" "$1"
"""


def fault_of(message: str) -> str | None:
    """Return a sentence on the fault of a subject, or None if the subject is right.

    Args:
        message: the whole message of the commit, without comments.
    """
    lines = message.strip().partition("\n\n")[0].split("\n")
    subject = " ".join(lines)
    if not subject:
        return "The subject of the commit is empty: say in one line what changes."
    if len(subject) > LONGEST and not subject.startswith(_TEMPORARY):
        rest = " Leave a blank line after the subject." if len(lines) > 1 else ""
        return f"The subject of the commit has {len(subject)} characters, at most {LONGEST}: {subject}{rest}"
    return None


def install(root: Path) -> str:
    """Write the commit-msg hook of a checkout unless the user has one; return a sentence on the result.

    Args:
        root: folder of the checkout.
    """
    call = 'python3 tests/support/commit_message.py "$1"'
    if own := _git(root, "config", "core.hooksPath"):
        return f"core.hooksPath is {own}, so no hook was written: call {call} from its commit-msg."
    hook = root / _git(root, "rev-parse", "--git-path", "hooks/commit-msg")
    if hook.exists() and hook.read_text(encoding="utf-8") != _HOOK:
        return f"{hook} is a hook of your own and was not changed: call {call} from it."
    hook.parent.mkdir(parents=True, exist_ok=True)
    hook.write_text(_HOOK, encoding="utf-8")
    hook.chmod(0o755)
    return f"Wrote {hook}."


def _git(root: Path, *arguments: str) -> str:
    done = subprocess.run(["git", *arguments], cwd=root, check=False, capture_output=True, text=True)
    return done.stdout.strip()


def main(arguments: list[str]) -> int:
    """Check the message in a file, or install the hook if there is no argument; return 1 if the message is refused."""
    if not arguments:
        print(install(ROOT))  # noqa: T201  (a command for people)
        return 0
    written = Path(arguments[0]).read_bytes()
    message = subprocess.run(["git", "stripspace", "--strip-comments"], input=written, check=True, capture_output=True)
    if fault := fault_of(message.stdout.decode("utf-8", "replace")):
        print(fault, file=sys.stderr)  # noqa: T201  (a command for people)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
