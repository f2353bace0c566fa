# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The messages of the program, read from its sources: sentences with a reason or a remedy.

An ellipsis stands for what is put in at run time. Texts that are put together in several places are
several entries.
"""

import collections
import re

from scenes import ROOT

LITERAL = re.compile(r'"((?:[^"\\\n]|\\.)*)"')
#: Text, an expression that is put in, text: one message.
JOINT = re.compile(r"\s*|\s*(?:<<|\+|,)[^;{}\"]*?(?:<<|\+|,)\s*|\s*(?:<<|\+)\s*")
TITLES = {
    "base": "Command line and expressions",
    "prm": "Text of a scene",
    "scene": "Values of a scene",
    "mesh_files": "Mesh files",
    "obstacles": "Obstacles",
    "discretization": "Bodies and their meshes",
    "contact": "Contact",
    "mass": "Masses",
    "schemes": "Schemes",
    "system": "Steps and equilibria",
    "diagnostics": "What a run watches",
    "simulation": "Runs, meshes that change, checkpoints",
    "output": "Files of a run",
    "fclib": "Problems of steps for FCLIB",
    "checkpoint": "Checkpoints",
}
HEAD = """# All messages

Messages with a remedy, as they stand in the sources of the program. An ellipsis stands for the
names, values and places that a message names. [Troubleshooting](troubleshooting.md) explains those
that are met most often.

"""


def plain(literal):
    """A literal of C++ as text."""
    return literal.replace(r"\"", '"').replace(r"\n", " ").replace("\\\\", "\\")


def texts(source):
    """All texts of a source file, those that follow each other joined."""
    source = re.sub(r"^\s*(#|//|/?\*).*$", "", source, flags=re.MULTILINE)
    source = re.sub(r"ExcMessage\([^;]*;", "", source)  # for developers
    result, end = [], None
    for match in LITERAL.finditer(source):
        between = source[end : match.start()] if end is not None else None
        if between is not None and JOINT.fullmatch(between):
            gap = "" if re.fullmatch(r"\s*(<<|\+)?\s*", between) else "…"
            result[-1] += gap + plain(match[1])
        else:
            result.append(plain(match[1]))
        end = match.end()
    return [" ".join(text.split()) for text in result]


def is_message(text):
    """A sentence that ends, after another one or a colon."""
    words = len(text.split())
    return words >= 7 and text.endswith((".", ".…")) and bool(re.search(r"[.:,] ", text[:-1]))


def all_texts():
    """{module: texts of its sources}."""
    result = collections.defaultdict(list)
    for path in sorted((ROOT / "source").rglob("*.cc")):
        result[path.parent.name] += texts(path.read_text(encoding="utf-8"))
    return result


def is_known(text, elsewhere):
    """Whether a text is found elsewhere: the usage, or the description of a key."""
    return all(part.strip() in elsewhere for part in text.split("…") if len(part) > 20)


def page(elsewhere):
    """The page with all messages but those that are in the text `elsewhere`."""
    parts = [HEAD]
    elsewhere = " ".join(elsewhere.replace("\n", " ").replace("#", " ").split())
    found = all_texts()
    for module, title in TITLES.items():
        messages = [text for text in found[module] if is_message(text)]
        lines = [
            "* " + code_of(text)
            for text in dict.fromkeys(messages)
            if not is_known(text, elsewhere)
        ]
        if lines:
            parts.append(f"## {title}\n\n" + "\n".join(lines) + "\n\n")
    return "".join(parts)


def code_of(text):
    """A message as code; it may have backticks itself, and begin with what is put in."""
    text = text if re.match(r"[\w-]", text) else f"… {text}"
    return f"`` {text} ``" if "`" in text else f"`{text}`"
