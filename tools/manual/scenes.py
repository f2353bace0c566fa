# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The scenes that are shipped: their files, what their first comment says, their checksums."""

import dataclasses
import hashlib
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]
PARAMETERS = ROOT / "parameters"


@dataclasses.dataclass(frozen=True)
class Scene:
    """A scene file below parameters/."""

    path: pathlib.Path

    @property
    def name(self):
        """Its place below parameters/, without the ending: `verification/steel_ball`."""
        return self.path.relative_to(PARAMETERS).with_suffix("").as_posix()

    @property
    def text(self):
        return self.path.read_text(encoding="utf-8")

    @property
    def comment(self):
        """The lines of the comment at the top, without the `#`."""
        lines = []
        for line in self.text.splitlines():
            if not line.startswith("#"):
                break
            lines.append(line[1:].removeprefix(" ").rstrip())
        return lines

    @property
    def checksum(self):
        """Changes when a key of the scene or a mesh file that it names does; comments are free."""
        digest = hashlib.sha256()
        for line in self.text.splitlines():
            statement = line.partition("#")[0].strip()
            if statement:
                digest.update(" ".join(statement.split()).encode() + b"\n")
        for mesh in re.findall(r"set File\s*=\s*([^#\n]+)", self.text):
            digest.update((self.path.parent / mesh.strip()).read_bytes())
        return digest.hexdigest()[:16]


def shipped():
    """All scenes below parameters/, by name."""
    return [Scene(path) for path in sorted(PARAMETERS.rglob("*.prm"))]
