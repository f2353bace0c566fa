# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""What all generated pages need of Markdown."""

import re


def escape(text):
    """Plain text as Markdown: what is between backticks stays, the rest has no markup."""
    parts = re.split(r"(`[^`]*`)", text)
    parts[::2] = [re.sub(r"([\\*_<>\[\]$|#])", r"\\\1", part) for part in parts[::2]]
    return "".join(parts)


def table(head, rows):
    """A table; cells are Markdown, in which no stroke stands by itself."""
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    lines += ["| " + " | ".join(row) + " |" for row in rows]
    return "\n".join(lines) + "\n"


def code(text):
    """A value as code. A stroke in it does not end the cell of a table."""
    return f"`{text}`".replace("|", r"\|") if text else ""


def toctree(pages, caption=None, depth=1):
    """A table of contents of pages, relative to the page that has it."""
    options = [f":maxdepth: {depth}"] + ([f":caption: {caption}"] if caption else [])
    return "\n".join(["```{toctree}", *options, "", *pages, "```", ""])
