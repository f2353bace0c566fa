# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The scene reference of the manual, from what the program says of its keys and schemes."""

import re

from markdown import code, escape, table, toctree

HEAD = """# Scene reference

Every key of a scene, section by section, as the program describes it. The same text comes from
`signorini --print-parameters`, and for one key from `signorini --explain "Time/Step size"`.

Lists of numbers are separated by commas, the components of expressions by semicolons. Units are
yours, but they must be consistent. A name in angle brackets stands for a name that you give:
`<body>`, `<obstacle>`, `<pair>`, `<probe>`.

"""


def file_name(section):
    """`contact_pair` of ("Contact", "<pair>")."""
    return re.sub(r"\W+", "_", " ".join(section)).strip("_").lower() or "scene"


def used_by(key, schemes):
    """The schemes that look at a key, where its description limits them; else none."""
    names = [scheme["name"] for scheme in schemes]
    if key.section[:1] == ("Contact",) and key.name.startswith("Friction"):
        return [scheme["name"] for scheme in schemes if scheme["friction"]]
    if key.section == ("Adaptivity",):
        return [scheme["name"] for scheme in schemes if scheme["changing_mesh"]]
    named = [name for name in names if re.search(rf"(?<![\w-]){name}(?![\w-])", key.description)]
    limited = (
        re.match(rf"Of (?:{'|'.join(names)})[,:]", key.description)
        or "No other scheme uses it" in key.description
        or "Known to the schemes" in key.description
    )
    return [name for name in names if name in named] if limited else []


def entry(key, schemes):
    """The part of a page about one key."""
    facts = [("default", code(key.default) or "nothing")]
    if key.values:
        facts.append(("values", ", ".join(code(value) for value in key.values.split(", "))))
    if key.unit:
        facts.append(("unit", key.unit))
    names = used_by(key, schemes)
    if names:
        facts.append(("schemes", ", ".join(code(name) for name in names)))
    lines = [f"## {key.name}", "", escape(key.description), ""]
    return "\n".join(lines + [f"* {name}: {value}" for name, value in facts]) + "\n"


def page(section, keys, schemes):
    """The page of a section."""
    title = "/".join(section) or "Keys outside of all sections"
    rows = [
        (f"[{key.name}](#{anchor(key.name)})", code(key.default), key.unit, first_sentence(key))
        for key in keys
    ]
    overview = table(("key", "default", "unit", "meaning"), rows)
    entries = "\n".join(entry(key, schemes) for key in keys)
    return f"# {escape(title)}\n\n{overview}\n{entries}"


def anchor(title):
    """The address of a heading, as GitHub and MyST form it."""
    return re.sub(r"[^\w -]", "", title.lower()).replace(" ", "-")


def first_sentence(key):
    """The beginning of a description, for the table at the top."""
    text = re.sub(r"^(Of|Without|With friction,) [^:.]*: ", "", key.description)
    marks = r"[.:;](?=\s|$)"
    if len(re.split(marks, text)[0].split()) < 4:  # the name of a value, of which a list begins
        marks = r"[.;](?=\s|$)"
    end = next(
        (mark.start() for mark in re.finditer(marks, text) if not is_inside(text, mark.start())),
        len(text),
    )
    begin = text[:1] if text == key.description else text[:1].upper()
    return escape(begin + text[1:end])


def is_inside(text, position):
    """Whether a position is in parentheses or in code."""
    before = text[:position]
    return before.count("(") > before.count(")") or before.count("`") % 2 == 1


def scheme_page(schemes):
    """The table of the time schemes."""
    yes = {True: "yes", False: "no"}
    rows = [
        (
            code(scheme["name"]),
            escape(scheme["summary"]),
            scheme["energy"],
            yes[scheme["friction"]],
            yes[scheme["changing_mesh"]],
            yes[scheme["variable_step"]],
            yes[scheme["moving_contact"]],
            yes[scheme["penetrates"]],
        )
        for scheme in schemes
    ]
    head = ("scheme", "what it does", "energy", "friction", "mesh may change")
    head += ("steps may change", "contact follows the motion", "penetrates")
    return (
        "# Time schemes\n\nWhat `signorini --print-schemes` knows. Which one to take is told in"
        " [Which scheme](../../which_scheme.md).\n\n" + table(head, rows)
    )


def pages(keys, schemes):
    """{name of a file: its text}."""
    sections = list(dict.fromkeys(key.section for key in keys))
    result = {
        f"{file_name(section)}.md": page(
            section, [key for key in keys if key.section == section], schemes
        )
        for section in sections
    }
    result["schemes.md"] = scheme_page(schemes)
    names = [file_name(section) for section in sections] + ["schemes"]
    result["index.md"] = HEAD + toctree(names)
    return result
