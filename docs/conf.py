"""The documentation: Markdown (MyST) through Sphinx, built by `make docs`. A warning is an error.

Pages follow Diataxis: tutorials teach, how-to guides help with a task, reference pages are looked up, explanations give
reasons. Python and console blocks in them are tests: see conftest.py at the top of the repository.
"""

import re
import sys
from importlib.metadata import version as installed_version
from pathlib import Path

from sphinx.application import Sphinx

sys.path.insert(0, str(Path(__file__).parents[1]))
import unity_link.link.publishing
from docs.ul_lexer import UlLexer
from unity_link.protocol.wire.arrays import Words

# Only type checkers know this name, because numpy is imported late; the signature of a sample needs it here.
vars(unity_link.link.publishing)["Words"] = Words

_DIRECTIVE = re.compile(r"^<!-- (\{[\w-]+\}.*?)^-->$", re.DOTALL | re.MULTILINE)
_DATASHEET = re.compile(r"\]\((?:\.\./)+gateware/cores/(\w+)/README\.md")
_CORES = Path(__file__).parents[1] / "gateware" / "cores"

project = "Unity-Link"
author = "the Unity-Link authors"
project_copyright = f"2026, {author}"
version = release = installed_version("unity-link")

extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon"]
exclude_patterns = ["_build"]
nitpicky = False

myst_enable_extensions = ["colon_fence", "deflist", "html_image"]
myst_heading_anchors = 4

autoclass_content = "both"
autodoc_default_options = {"members": True, "undoc-members": True}
autodoc_member_order = "bysource"
autodoc_typehints = "description"
autodoc_typehints_format = "short"

html_theme = "furo"
html_title = "Unity-Link"
html_show_sphinx = False
html_copy_source = False


def write_pages_of_cores(folder: Path) -> None:
    """Write a page for each core, which includes the datasheet in the folder of the core."""
    folder.mkdir(exist_ok=True)
    for datasheet in sorted(_CORES.glob("*/README.md")):
        name = datasheet.parent.name
        (folder / f"{name}.md").write_text(f"```{{include}} ../../../../gateware/cores/{name}/README.md\n```\n")


def show_directives(_: Sphinx, __: str, text: list[str]) -> None:
    """Convert a page that is readable on a forge into one for Sphinx.

    Directives are in comments, `<!-- {toctree}` to `-->`, which a forge hides. Links to the datasheets of cores and
    to the list of changes lead to files outside of this folder; Sphinx has pages for them.
    """
    shown = _DIRECTIVE.sub(r"```\1```", text[0]).replace("](../CHANGELOG.md)", "](/changelog.md)")
    text[0] = _DATASHEET.sub(r"](/reference/cores/pages/\1.md", shown)


def setup(app: Sphinx) -> None:
    """Register the lexer for blocks of `ul`, uncomment directives, and write the pages of the cores."""
    app.connect("source-read", show_directives)
    app.add_lexer("ul", UlLexer)
    # A test makes single pages, from a copy of this file.
    if _CORES.is_dir():
        write_pages_of_cores(Path(app.srcdir, "reference", "cores", "pages"))
