# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The gallery of the manual: a page for each shipped scene, from its comment and from its run."""

import pathlib
import re

from markdown import code, table, toctree

HEAD = """# Gallery

Every scene in `parameters/`, with what its author expects of it, what a run printed, and how long
the run took. The results are kept with the sources. A test compares them with the scenes: if a
scene changes, its run must be repeated (`./dev doc --gallery`).

Times are seconds of processor time of one process, with the output of fields. They were measured on
a virtual machine with two shared cores; read them as orders of magnitude.

"""
LONGEST_TITLE = 120
NO_RUN = "There is no run of this scene in the gallery yet: `./dev doc --gallery` makes one.\n"


def file_name(scene):
    return scene.name.replace("/", "_") + ".md"


def title(scene):
    """The first sentence of the comment, without its end; of a long one what is before a comma."""
    text = " ".join(" ".join(scene.comment).split())
    sentence = re.split(r"(?<![A-Z])[.:](?=\s|$)", text)[0] if text else scene.name
    return sentence if len(sentence) <= LONGEST_TITLE else sentence.partition(",")[0]


def link(scene):
    """The scene file, from a page of the gallery."""
    return f"[parameters/{scene.name}.prm](../../../parameters/{scene.name}.prm)"


def facts(entry):
    """Size and time of a run as a table."""
    rows = [
        ("scheme", code(entry["scheme"])),
        ("dimension", str(entry["dimension"])),
        ("cells at the start", str(entry["cells"])),
        ("degrees of freedom at the start", str(entry["dofs"])),
        ("steps", str(entry["steps"] or "of variable size")),
        ("processor time", f"{entry['processor_seconds']:g} s"),
    ]
    return table(("run", ""), rows)


def page(scene, entry, picture):
    """The page of a scene. The picture is a path relative to it, or None."""
    comment = "\n".join(scene.comment).strip()
    parts = [f"# {scene.name}\n", f"Scene: {link(scene)}\n"]
    if picture:
        parts.append(f"![Bodies of {scene.name}]({picture})\n")
    parts.append(f"## What it is, and what to expect\n\n```text\n{comment}\n```\n")
    if entry:
        summary = "\n".join(entry["summary"])
        parts.append(f"## What a run says\n\n```text\n{summary}\n```\n\n{facts(entry)}")
    else:
        parts.append(NO_RUN)
    parts.append(f"## The scene\n\n```prm\n{body(scene)}\n```\n")
    return "\n".join(parts)


def body(scene):
    """The text of a scene without the comment at its top."""
    return "\n".join(scene.text.splitlines()[len(scene.comment) :]).strip("\n")


def index(shipped, results):
    """The list of all scenes."""
    rows = []
    for scene in shipped:
        entry = results.get(scene.name)
        time = f"{entry['processor_seconds']:g}" if entry else ""
        dimension = f"{entry['dimension']}d" if entry else ""
        rows.append((f"[{scene.name}]({file_name(scene)})", dimension, title(scene), time))
    pages = [pathlib.Path(file_name(scene)).stem for scene in shipped]
    contents = toctree(pages).replace(":maxdepth: 1", ":hidden:")
    return HEAD + table(("scene", "", "what happens", "time, s"), rows) + "\n" + contents


def pages(shipped, results, pictures):
    """{name of a file: its text}; pictures is the folder with the pictures of the gallery."""
    result = {"index.md": index(shipped, results)}
    for scene in shipped:
        picture = pictures / f"{scene.name}.png"
        shown = f"{scene.name}.png" if picture.is_file() else None
        result[file_name(scene)] = page(scene, results.get(scene.name), shown)
    return result
