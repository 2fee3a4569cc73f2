"""The documentation: Markdown (MyST) through Sphinx, built by `make docs`, where a warning is an error.

Pages follow Diataxis: tutorials teach, how-to guides help with a task, reference pages are looked up, explanations say
why. Python and console blocks in them are tests; the conftest.py at the top of the repository says how.
"""

from importlib.metadata import version as installed_version

project = "Unity-Link"
author = "the Unity-Link authors"
project_copyright = f"2026, {author}"
version = release = installed_version("unity-link")

extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon"]
exclude_patterns = ["_build"]
nitpicky = False

myst_enable_extensions = ["colon_fence", "deflist"]
myst_heading_anchors = 4

autodoc_class_signature = "separated"
autodoc_member_order = "bysource"
autodoc_typehints = "description"
autodoc_typehints_format = "short"

html_theme = "furo"
html_title = "Unity-Link"
html_show_sphinx = False
html_copy_source = False
