# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Sphinx's configuration of the site: the pages as they are, MyST as parser of their Markdown. Run by contrib/site."""
import re
from pathlib import Path

from pygments.lexer import RegexLexer, bygroups
from pygments.token import Comment, Keyword, Name, Operator, String, Text

ROOT = Path(__file__).resolve().parents[2]

project = "vfife"
author = "the vfife authors"
release = re.search(r"^project\(vfife VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text(), re.M).group(1)
version = release
copyright = "the vfife authors; LGPL 2.1 or later"  # noqa: A001 (Sphinx's name)

extensions = ["myst_parser", "sphinx.ext.mathjax"]
source_suffix = {".md": "markdown"}
root_doc = "index"
# Of the folder that contrib/site lays out: links to other files of the project stay links to these.
include_patterns = ["*.md", "doc/**.md"]
exclude_patterns = ["doc/site/**"]

# As GitHub reads the pages: formulas between $$, headings of all levels linked to by their words.
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 4

html_theme = "furo"
html_title = f"vfife {release}"
html_static_path = ["static"]
html_css_files = ["site.css"]
html_copy_source = False
html_show_sphinx = False
# Nothing from a network: MathJax of Debian, which contrib/site puts beside the pages.
mathjax_path = "mathjax/MathJax.js?config=TeX-AMS_CHTML"
mathjax2_config = {"CommonHTML": {"linebreaks": {"automatic": True}}, "messageStyle": "none", "showMathMenu": False,
                   "tex2jax": {"processClass": "math"}}  # MyST tells MathJax to leave all else alone
myst_update_mathjax = False
pygments_style = "friendly"
highlight_language = "none"


class ParameterFile(RegexLexer):
    """Cases, deal.II's parameter files."""
    name = "prm"
    tokens = {"root": [
        (r"#.*$", Comment),
        (r"^(\s*)(include)(\s+)(.*)$", bygroups(Text, Keyword, Text, String)),
        (r"^(\s*)(subsection)(\s+)(.*)$", bygroups(Text, Keyword, Text, Name.Class)),
        (r"^(\s*)(end)\b", bygroups(Text, Keyword)),
        (r"^(\s*)(set)(\s+)([^=\n]+)(=)([^#\n]*)", bygroups(Text, Keyword, Text, Name.Attribute, Operator, String)),
        (r"\s+|.", Text)]}


def setup(app):
    app.add_lexer("prm", ParameterFile)
