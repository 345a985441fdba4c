# SPDX-License-Identifier: BSD-3-Clause
# Sphinx: the pages as a site (docs/adr/0153). docs/site/build lays out the sources and calls it.
import os

project = "relievo"
author = "the relievo authors"
copyright = f"2026, {author}"
version = release = os.environ["RELIEVO_VERSION"]
language = "en"

extensions = ["myst_parser"]
source_suffix = {".md": "markdown"}
root_doc = "index"
templates_path = ["templates"]
# The headings have the anchors that forges give them.
myst_heading_anchors = 6
# Some pages begin a section two steps below the one around it.
suppress_warnings = ["myst.header"]
# Commands and their output; colours of a programming language would be wrong for most of them.
highlight_language = "none"
pygments_style = "none"

# What Debian's packages of themes lack, docs/adr/0153 says.
html_theme = "basic"
html_title = f"relievo {version}"
html_short_title = html_title
html_sidebars = {"**": ["contents.html"]}
html_static_path = ["site.css", "site.js"]
html_css_files = ["site.css"]
html_js_files = [("site.js", {"priority": 100})]
html_permalinks_icon = "#"
html_show_sphinx = False
html_copy_source = False
html_show_sourcelink = False
html_last_updated_fmt = None
html_use_index = False
# The text of a hit would be read over HTTP, which pages that are files do not have.
html_show_search_summary = False
