#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Writes the meshes of parameters/meshes/: make_meshes.py [FOLDER].

anvil.msh   Gmsh 2.2: a block with sloping sides, its top in the plane z = 0.
            Physical groups, which become boundary ids: 1 bottom, 2 top, 3 sides.
hammer.inp  Abaqus: a round bar that lies along the x axis, with a conical nose whose slightly
            domed face touches the plane x = 0 in the origin. Surfaces, whose numbers become
            boundary ids: 1 face, 2 cone, 3 mantle, 4 back.
ring.inp    UCD, in 2d: a regular polygon with 48 corners at the distance 1 from the origin and a
            hole of the same form, 0.8; its sides at both ends of the x axis are upright. The
            outside has the boundary id 1.
"""

import itertools
import math
import pathlib
import sys

# Corners of a hexahedron in the order of both formats, as steps in the directions u, v, w
# (right-handed).
CORNERS = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))


class Mesh:
    """Vertices are numbered from 1 in the order in which cells ask for them."""

    def __init__(self):
        self.numbers, self.points, self.cells = {}, [], []

    def vertex(self, point):
        key = tuple(round(x, 9) + 0.0 for x in point)
        if key not in self.numbers:
            self.points.append(key)
            self.numbers[key] = len(self.points)
        return self.numbers[key]

    def add_cell(self, corner):
        """corner(u, v, w): a point for steps 0 or 1."""
        self.cells.append([self.vertex(corner(*step)) for step in CORNERS])
        return len(self.cells)


# --- anvil ---------------------------------------------------------------------------------------

ANVIL_CELLS = (6, 5, 5)
ANVIL_HEIGHT, ANVIL_BOTTOM, ANVIL_TOP = 1.0, (1.2, 0.9), (0.8, 0.6)  # half widths in x and y
ANVIL_GROUPS = {1: "bottom", 2: "top", 3: "sides"}


def anvil():
    """The mesh, and its boundary faces as (group, four vertices)."""
    mesh, faces = Mesh(), []

    def point(i, j, k):
        height = k / ANVIL_CELLS[2]
        wide = [low + height * (high - low) for low, high in zip(ANVIL_BOTTOM, ANVIL_TOP)]
        return (
            (2 * i / ANVIL_CELLS[0] - 1) * wide[0],
            (2 * j / ANVIL_CELLS[1] - 1) * wide[1],
            ANVIL_HEIGHT * (height - 1),
        )

    for k, j, i in itertools.product(*(range(n) for n in reversed(ANVIL_CELLS))):
        cell = mesh.cells[mesh.add_cell(lambda u, v, w: point(i + u, j + v, k + w)) - 1]
        for direction, index in enumerate((i, j, k)):
            for side in (0, 1):
                if index == side * (ANVIL_CELLS[direction] - 1):
                    group = 3 if direction < 2 else 1 + side
                    faces.append((group, face(cell, direction, side)))
    return mesh, faces


def face(cell, direction, side):
    """The vertices around a face of a cell."""
    first, second = ((1, 2), (2, 0), (0, 1))[direction]

    def vertex(a, b):
        step = [side] * 3
        step[first], step[second] = a, b
        return cell[CORNERS.index(tuple(step))]

    return [vertex(0, 0), vertex(1, 0), vertex(1, 1), vertex(0, 1)]


def gmsh(mesh, faces):
    lines = [
        "$MeshFormat",
        "2.2 0 8",
        "$EndMeshFormat",
        "$PhysicalNames",
        str(len(ANVIL_GROUPS) + 1),
    ]
    lines += [f'2 {number} "{name}"' for number, name in ANVIL_GROUPS.items()] + [
        '3 1 "anvil"',
        "$EndPhysicalNames",
    ]
    lines += ["$Nodes", str(len(mesh.points))]
    lines += [
        f"{number} {x:.9g} {y:.9g} {z:.9g}" for number, (x, y, z) in enumerate(mesh.points, 1)
    ]
    lines += ["$EndNodes", "$Elements", str(len(faces) + len(mesh.cells))]
    elements = [(3, group, corners) for group, corners in faces] + [
        (5, 1, cell) for cell in mesh.cells
    ]
    lines += [
        f"{number} {kind} 2 {group} {group} " + " ".join(map(str, corners))
        for number, (kind, group, corners) in enumerate(elements, 1)
    ]
    return "\n".join(lines + ["$EndElements", ""])


# --- hammer --------------------------------------------------------------------------------------

CORE_CELLS = 4  # in both directions of the square core; as many on each side of the ring
LENGTHS, RADII = (0.0, 0.25, 0.5, 0.75, 1.0, 1.25, 1.5), (0.3, 0.45, 0.6, 0.6, 0.6, 0.6, 0.6)
CORE_PART = 0.5  # half width of the core by the radius of the bar
DOME_RADIUS = 1.0
HAMMER_SURFACES = ("FACE-1", "CONE-2", "MANTLE-3", "BACK-4")


def core_point(i, j):
    """A vertex of the core of a bar of radius 1."""
    return tuple(CORE_PART * (2 * n / CORE_CELLS - 1) for n in (i, j))


def rim(n):
    """Indices (i, j) of vertex n of the outline of the core, counter-clockwise from (0, 0)."""
    side, step = divmod(n % (4 * CORE_CELLS), CORE_CELLS)
    end, back = CORE_CELLS, CORE_CELLS - step
    return ((step, 0), (end, step), (back, end), (0, back))[side]


def ring_point(n, outside):
    if not outside:
        return core_point(*rim(n))
    angle = 2 * math.pi * n / (4 * CORE_CELLS) - 0.75 * math.pi
    return math.cos(angle), math.sin(angle)


def along_the_bar(layer, section):
    """A point of the cross-section of radius 1 in its place. The dome recedes from the plane
    x = 0."""
    y, z = (RADII[layer] * c for c in section)
    recession = DOME_RADIUS - math.sqrt(DOME_RADIUS**2 - y * y - z * z) if layer == 0 else 0.0
    return LENGTHS[layer] + recession, y, z


def hammer():
    """The mesh, and for each surface its faces as (element, face of the element)."""
    mesh, surfaces = Mesh(), {name: [] for name in HAMMER_SURFACES}
    last = len(LENGTHS) - 2
    for layer in range(last + 1):
        elements = []
        for i, j in itertools.product(range(CORE_CELLS), repeat=2):
            elements.append(
                mesh.add_cell(lambda u, v, w: along_the_bar(layer + w, core_point(i + u, j + v)))
            )
        for n in range(4 * CORE_CELLS):
            elements.append(
                mesh.add_cell(lambda u, v, w: along_the_bar(layer + w, ring_point(n + v, u == 1)))
            )
            surfaces["CONE-2" if LENGTHS[layer] < 0.5 else "MANTLE-3"].append((elements[-1], 4))
        if layer == 0:
            surfaces["FACE-1"] += [(element, 1) for element in elements]
        if layer == last:
            surfaces["BACK-4"] += [(element, 2) for element in elements]
    return mesh, surfaces


def abaqus(mesh, surfaces):
    lines = ["*HEADING", "hammer", "** Written by tools/make_meshes.py", "*NODE, NSET=ALL"]
    lines += [
        f"{number}, {x:.9g}, {y:.9g}, {z:.9g}" for number, (x, y, z) in enumerate(mesh.points, 1)
    ]
    lines += ["*ELEMENT, TYPE=C3D8, ELSET=HAMMER"]
    lines += [
        f"{number}, " + ", ".join(map(str, cell)) for number, cell in enumerate(mesh.cells, 1)
    ]
    for name, faces in surfaces.items():
        numbers, kind = [str(element) for element, _ in faces], faces[0][1]
        lines += [f"*ELSET, ELSET={name}_S{kind}"]
        lines += [", ".join(numbers[start : start + 16]) for start in range(0, len(numbers), 16)]
        lines += [f"*SURFACE, TYPE=ELEMENT, NAME={name}", f"{name}_S{kind}, S{kind}"]
    return "\n".join(lines + [""])


# --- ring ----------------------------------------------------------------------------------------

RING_CORNERS, RING_RADII = 48, (0.8, 0.9, 1.0)


def ring():
    """The text of the file."""
    across = len(RING_RADII)
    angles = [2 * math.pi * (n + 0.5) / RING_CORNERS for n in range(RING_CORNERS)]
    points = [(r * math.cos(a), r * math.sin(a)) for a in angles for r in RING_RADII]

    def vertex(n, layer):
        return n % RING_CORNERS * across + layer + 1

    cells = [
        (vertex(n, k), vertex(n, k + 1), vertex(n + 1, k + 1), vertex(n + 1, k))
        for n, k in itertools.product(range(RING_CORNERS), range(across - 1))
    ]
    lines = [f"{len(points)} {len(cells) + RING_CORNERS} 0 0 0"]
    lines += [f"{number} {x:.10g} {y:.10g} 0" for number, (x, y) in enumerate(points, 1)]
    lines += [f"{n} 0 quad {' '.join(map(str, cell))}" for n, cell in enumerate(cells, 1)]
    lines += [
        f"{len(cells) + n + 1} 1 line {vertex(n, across - 1)} {vertex(n + 1, across - 1)}"
        for n in range(RING_CORNERS)
    ]
    return "\n".join(lines + [""])


def main():
    default = pathlib.Path(__file__).resolve().parent.parent / "parameters" / "meshes"
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else default
    (folder / "anvil.msh").write_text(gmsh(*anvil()), encoding="utf-8")
    (folder / "hammer.inp").write_text(abaqus(*hammer()), encoding="utf-8")
    (folder / "ring.inp").write_text(ring(), encoding="utf-8")


if __name__ == "__main__":
    main()
