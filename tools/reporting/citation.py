# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""How to cite the program and the scheme of a run."""

import pathlib
import re

from .schemes import COMPARISON

REFERENCES = pathlib.Path(__file__).resolve().parents[2] / "doc" / "references.bib"


def entries(run):
    """BibTeX: the program in the version that the log names, then the sources of the scheme."""
    match = re.match(r"signorini ([^,]+), commit ([^\s,]+)(?:.*?, (\d{4})-)?", run.log.program)
    version = f", version {match[1]}, commit {match[2]}" if match else ""
    year = f",\n  year   = {{{match[3]}}}" if match and match[3] else ""
    program = (
        "@misc{signorini,\n  author = {{The signorini authors}},\n"
        "  title  = {signorini: elastic bodies in dynamic contact"
        f"{version}}}{year}\n}}"
    )
    sources = run.scheme.sources if run.scheme else ()
    return [program, *(reference(key) for key in (*sources, COMPARISON))]


def reference(key):
    """An entry of doc/references.bib."""
    text = REFERENCES.read_text(encoding="utf-8")
    return re.search(rf"^@\w+\{{{key},.*?^\}}", text, re.MULTILINE | re.DOTALL)[0]
