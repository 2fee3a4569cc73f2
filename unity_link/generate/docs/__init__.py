"""The register map as a document: in HTML, which is self-contained and can be printed, and in Markdown.

`pages` converts the model to texts; the two templates lay them out.
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
    """Yield the documents of an interface."""
    page = Page(interface)
    for suffix in ("html", "md"):
        yield GeneratedFile(f"{interface.name}.{suffix}", templates.render(f"page.{suffix}", page=page))
