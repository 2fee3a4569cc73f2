"""The files of a checkout that belong to the project."""

import re
import subprocess
from pathlib import Path


def tracked_files(root: Path) -> list[Path]:
    """Return the files that git lists; in a copy without history all files except hidden and built ones.

    Args:
        root: folder of the checkout.
    """
    if not (root / ".git").exists():
        own = re.compile(r"(?!.*(/\.|/_?build/|__pycache__|egg-info))")
        return [path for path in root.rglob("*") if path.is_file() and own.match(f"/{path.relative_to(root)}")]
    listing = subprocess.run(["git", "ls-files", "-z"], cwd=root, check=True, capture_output=True, text=True).stdout
    return [path for name in listing.split("\0") if name and (path := root / name).is_file()]
