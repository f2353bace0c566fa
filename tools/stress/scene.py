# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""A scene as its keys, by which a sweep can change any of them."""

import dataclasses

import signorini


def vector(*components, separator="; "):
    """Components of an expression, or with commas those of a point."""
    return separator.join(f"{component!r}" for component in components)


def point(*components):
    """Coordinates."""
    return vector(*components, separator=", ")


@dataclasses.dataclass
class Scene:
    """Values by keys such as Bodies/upper/Density, and what they mean to the laws."""

    settings: dict
    size: float = 1.0  # of the smallest body, by which depths are measured

    def text(self):
        """The file of the scene."""
        return signorini.Scene(self.settings).text()

    def number(self, key, default=0.0):
        """A number, or its default."""
        return float(self.settings.get(key, default))

    def acceleration(self, body):
        """The constant force per mass, by axis."""
        force = self.settings.get(f"Bodies/{body}/Body force", "0; 0; 0")
        return [float(component) for component in force.split(";")] + [0.0]

    def pairs(self):
        """(name, slave, master) of each pair; a master that is an obstacle is no body."""
        found = []
        for pair in self.settings["Contact/Pairs"].split(","):
            slave, master = (side.split("[")[0].strip() for side in pair.split(" : "))
            found.append((pair.strip(), slave, master))
        return found

    def bodies(self):
        """Names."""
        return [name.strip() for name in self.settings["Bodies/Names"].split(",")]
