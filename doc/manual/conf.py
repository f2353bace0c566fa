# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""How Sphinx builds the manual. tools/manual/build.py puts its pages together before."""

import pathlib
import re

from pygments.lexer import RegexLexer, bygroups
from pygments.token import Comment, Keyword, Name, Operator, Text

HERE = pathlib.Path(__file__).resolve().parent


def version_of_program():
    """The version that CMakeLists.txt gives."""
    text = (HERE.parents[1] / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"project\(signorini VERSION (\S+)", text)[1]


class PrmLexer(RegexLexer):
    """Colours of a scene file."""

    name = "prm"
    aliases = ["prm"]
    tokens = {
        "root": [
            (r"#.*", Comment),
            (r"(\s*)(subsection)([^#\n]*)", bygroups(Text, Keyword, Name.Namespace)),
            (r"(\s*)(end)\b", bygroups(Text, Keyword)),
            (r"(\s*)(set)([^=\n]*)(=)", bygroups(Text, Keyword, Name.Attribute, Operator)),
            (r"[^#\n]+", Text),
            (r"\n", Text),
        ]
    }


project = "signorini"
author = "the signorini authors"
copyright = "2026, the signorini authors"
version = release = version_of_program()
language = "en"

extensions = ["myst_parser", "sphinx.ext.mathjax"]
source_suffix = {".md": "markdown"}
root_doc = "doc/manual/index"
exclude_patterns = ["doc/*.sed"]
highlight_language = "text"
myst_enable_extensions = ["dollarmath", "colon_fence"]
myst_heading_anchors = 4

# Debian's MathJax, as for the reference of the classes: no network is needed.
mathjax_path = "file:///usr/share/javascript/mathjax/MathJax.js?config=TeX-AMS_SVG"
myst_update_mathjax = False  # it speaks to version 3; Debian has version 2
mathjax2_config = {
    "tex2jax": {
        "inlineMath": [["\\(", "\\)"]],
        "displayMath": [["\\[", "\\]"]],
        "processClass": "math",
    },
    "messageStyle": "none",
}

html_theme = "furo"
html_title = f"signorini {release}"
html_static_path = ["_static"]
html_css_files = ["manual.css"]
html_copy_source = False
html_additional_pages = {"index": "first_page.html"}
templates_path = ["_templates"]


def want_formulas_on_the_single_page(app):
    """Sphinx asks the first page whether there are formulas, and it has none of its own."""
    if app.builder.name == "singlehtml":
        app.set_html_assets_policy("always")


def setup(app):
    app.add_lexer("prm", PrmLexer)
    app.connect("builder-inited", want_formulas_on_the_single_page)
