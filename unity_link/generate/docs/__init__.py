"""The register map as a page to read: in HTML, which needs nothing else and prints well, and in Markdown.

`pages` puts the model into words; the two templates lay them out.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.generate import GeneratedFile
from unity_link.generate.docs.pages import Page

if TYPE_CHECKING:
    from collections.abc import Iterator

    from unity_link.generate import Templates
    from unity_link.spec import Interface

DOC = "documents in HTML and Markdown: the register map with groups, leases, safe values, schedules and pins"


def files(interface: Interface, templates: Templates) -> Iterator[GeneratedFile]:
    """Make the files of an interface."""
    page = Page(interface)
    for suffix in ("html", "md"):
        yield GeneratedFile(f"{interface.name}.{suffix}", templates.render(f"page.{suffix}", page=page))
