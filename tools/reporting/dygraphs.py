# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Dygraphs, which draws the curves, as Debian's libjs-dygraphs has it."""

import pathlib

FOLDER = pathlib.Path("/usr/share/javascript/dygraphs")
#: A page that contains Dygraphs has to contain its licence.
LICENCE = pathlib.Path(__file__).resolve().parents[2] / "LICENSES" / "MIT-dygraphs.txt"
MISSING = (
    "The curves need Dygraphs, which was not there when this page was made. On Debian: "
    "apt-get install libjs-dygraphs, then make the page again. The pictures show some of them."
)


def embedded():
    """(style sheet, program) for a page, both empty if Dygraphs is not installed."""
    try:
        style, program = (
            (FOLDER / name).read_text(encoding="utf-8")
            for name in ("dygraph.min.css", "dygraph.min.js")
        )
    except OSError:
        return "", ""
    licence = LICENCE.read_text(encoding="utf-8")
    return style, f"/* Dygraphs:\n{licence}*/\n{program}"
