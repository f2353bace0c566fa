# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""What the program says of itself: its keys and its schemes."""

import dataclasses
import json
import re
import subprocess

#: Names that the example of --print-parameters gives, and what stands for all of them.
PLACEHOLDERS = {
    ("Bodies", "ball"): "<body>",
    ("Obstacles", "floor"): "<obstacle>",
    ("Contact", "ball : floor"): "<pair>",
    ("Probes", "south_pole"): "<probe>",
}
#: Where a description tells the unit.
UNITS = (
    r"\((?:[^()]*; )?(length(?: per time(?: squared)?)?|force per area|no unit|radians per time)\)",
    r"(?<=in units of )(time|length|the root of an energy)",
    r"(?<=in )(degrees)",
    r"^(Mass per volume)",
    r"(?<=after so many )(minutes)",
)


@dataclasses.dataclass
class Key:
    """A key of a scene."""

    section: tuple  # names of its sections, from outside
    name: str
    default: str
    description: str
    example: tuple  # the section with the names of the example
    values: str = ""

    @property
    def path(self):
        return "/".join([*self.section, self.name])

    @property
    def unit(self):
        """ "" where the description tells none, or several."""
        for pattern in UNITS:
            match = re.search(pattern, self.description)
            if match:
                return match[1].lower()
        return ""


def call(executable, *arguments):
    """The standard output of the program."""
    command = [str(executable), *arguments]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def schemes(executable):
    """What is known about each time scheme."""
    return json.loads(call(executable, "--print-schemes=json"))


def statement(line):
    """(name, default) of a line `set NAME = VALUE # default: DEFAULT`."""
    name, _, value = line.removeprefix("set ").partition("=")
    value, mark, default = value.partition("# default:")
    return name.strip(), (default if mark else value).strip()


def read_keys(text):
    """All keys of the output of --print-parameters, without their values."""
    result, section, comment = [], [], []
    for line in map(str.strip, text.splitlines()):
        if line.startswith("#"):
            comment.append(line.removeprefix("#").strip())
        elif line.startswith("subsection "):
            section.append(line.removeprefix("subsection "))
        elif line == "end":
            section.pop()
        elif line.startswith("set "):
            name, default = statement(line)
            example = tuple(section)
            shown = tuple(
                PLACEHOLDERS.get((section[0], part), part) if level else part
                for level, part in enumerate(section)
            )
            result.append(Key(shown, name, default, " ".join(comment), example))
        if not line.startswith("#"):
            comment = []
    # The first comment begins with that of the whole listing.
    result[0].description = result[0].description.rpartition("- ")[2]
    return result


def values_of(executable, key):
    """The words that a key can have, from --explain; "" if it takes a number or a text."""
    if key.default in ("true", "false"):
        return "true, false"
    if not re.fullmatch(r"[a-z][a-z -]*", key.default):
        return ""
    explanation = call(executable, "--explain", "/".join([*key.example, key.name]))
    match = re.search(r"^values:\s+(.*)$", explanation, re.MULTILINE)
    return match[1] if match and "..." not in match[1] else ""


def keys(executable):
    """All keys of a scene, in the order of --print-parameters."""
    result = read_keys(call(executable, "--print-parameters"))
    for key in result:
        key.values = values_of(executable, key)
    return result
