# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Small meshes of all formats that the program reads, as texts: bodies of two cells, and surfaces
under them."""

import itertools
import struct

#: Vertices of two unit cells side by side, x the fastest.
SQUARES = [(x, y, 0) for y in (0, 1) for x in (0, 1, 2)]
CUBES = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1, 2)]
#: The lower and the upper side of a cell, around.
QUADRILATERALS = [(k, k + 1, k + 4, k + 3) for k in (0, 1)]
HEXAHEDRA = [around + tuple(v + 6 for v in around) for around in QUADRILATERALS]
#: The bottom of both cells, with boundary id 1.
LINES = [(0, 1), (1, 2)]
#: A large square below, as two triangles.
FLOOR = [(-4, -4, 0), (6, -4, 0), (6, 6, 0), (-4, 6, 0)]
TRIANGLES = [(0, 1, 2), (0, 2, 3)]


def rows(items, first=None):
    """One line for each tuple, with a number in front."""
    numbers = itertools.count(first or 0)
    return "".join(
        " ".join(map(str, ([next(numbers)] if first is not None else []) + list(item))) + "\n"
        for item in items
    )


def parts(dim):
    """Vertices, cells and faces with a boundary id."""
    if dim == 2:
        return SQUARES, QUADRILATERALS, LINES
    return CUBES, HEXAHEDRA, QUADRILATERALS


def from_one(cells):
    """Vertices counted from 1."""
    return [tuple(v + 1 for v in cell) for cell in cells]


def gmsh(dim):
    """Version 2.2."""
    vertices, cells, faces = parts(dim)
    kind, face_kind = (3, 1) if dim == 2 else (5, 3)
    elements = [(face_kind, 2, 1, 1, *face) for face in from_one(faces)]
    elements += [(kind, 2, 7, 7, *cell) for cell in from_one(cells)]
    return (
        f"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{len(vertices)}\n{rows(vertices, 1)}"
        f"$EndNodes\n$Elements\n{len(elements)}\n{rows(elements, 1)}$EndElements\n"
    )


def gmsh_4(dim):
    """Version 4.1, with the entities that a boundary id needs."""
    vertices, cells, faces = parts(dim)
    n, kind, face_kind = len(vertices), *((3, 1) if dim == 2 else (5, 3))
    box = "0 0 0 2 1 1"
    counts = "0 1 1 0" if dim == 2 else "0 0 1 1"
    return (
        "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"
        f"$Entities\n{counts}\n1 {box} 1 1 0\n1 {box} 1 7 0\n$EndEntities\n"
        f"$Nodes\n1 {n} 1 {n}\n{dim} 1 0 {n}\n{rows([(v + 1,) for v in range(n)])}{rows(vertices)}"
        f"$EndNodes\n$Elements\n2 4 1 4\n{dim - 1} 1 {face_kind} 2\n{rows(from_one(faces), 1)}"
        f"{dim} 1 {kind} 2\n{rows(from_one(cells), 3)}$EndElements\n"
    )


def ucd(dim):
    """As AVS writes it."""
    vertices, cells, faces = parts(dim)
    kind, face_kind = ("quad", "line") if dim == 2 else ("hex", "quad")
    elements = [(7, kind, *cell) for cell in from_one(cells)]
    elements += [(1, face_kind, *face) for face in from_one(faces)]
    return (
        f"{len(vertices)} {len(elements)} 0 0 0\n{rows(vertices, 1)}{rows(elements, 1)}"
    )


def abaqus(dim):
    """With an element set and a surface."""
    vertices, cells, _ = parts(dim)
    kind, side = ("CPS4", "S1") if dim == 2 else ("C3D8", "S1")
    comma = lambda items: rows(items, 1).replace(" ", ", ")
    return (
        f"*HEADING\na mesh\n*NODE\n{comma(vertices)}*ELEMENT, TYPE={kind}, ELSET=EB1\n"
        f"{comma(from_one(cells))}*ELSET, ELSET=BELOW, GENERATE\n1, 2, 1\n"
        f"*SURFACE, NAME=SS1, TYPE=ELEMENT\nBELOW, {side}\n"
    )


def vtk(points, section, cells, kinds=()):
    """A legacy file."""
    kind = "UNSTRUCTURED_GRID" if kinds else "POLYDATA"
    types = f"CELL_TYPES {len(kinds)}\n" + rows((k,) for k in kinds) if kinds else ""
    return (
        f"# vtk DataFile Version 3.0\nmesh\nASCII\nDATASET {kind}\nPOINTS {len(points)} double\n"
        f"{rows(points)}{section} {len(cells)} {sum(len(cell) + 1 for cell in cells)}\n"
        f"{rows((len(cell), *cell) for cell in cells)}{types}"
    )


def vtk_cells(dim):
    """Quadrilaterals or hexahedra."""
    vertices, cells, _ = parts(dim)
    return vtk(vertices, "CELLS", cells, [9 if dim == 2 else 12] * len(cells))


def vtk_surface(dim):
    """Lines or triangles."""
    if dim == 2:
        return vtk([(6, 0, 0), (-4, 0, 0)], "LINES", [(0, 1)])
    return vtk(FLOOR, "POLYGONS", TRIANGLES)


def obj(dim):
    """A line, or a quadrilateral with slashes."""
    if dim == 2:
        return "v 6 0 0\nv -4 0 0\nl 1 2\n"
    return "".join(f"v {x} {y} {z}\n" for x, y, z in FLOOR) + "f 1//1 2//1 -2//1 -1//1\n"


def stl(_dim):
    """As text."""
    facets = "".join(
        "facet normal 0 0 1\nouter loop\n"
        + "".join(f"vertex {x} {y} {z}\n" for x, y, z in (FLOOR[v] for v in triangle))
        + "endloop\nendfacet\n"
        for triangle in TRIANGLES
    )
    return f"solid floor\n{facets}endsolid floor\n"


def binary_stl(_dim):
    """As bytes."""
    facets = b"".join(
        struct.pack("<12fH", 0, 0, 1, *(c for v in triangle for c in FLOOR[v]), 0)
        for triangle in TRIANGLES
    )
    return b"floor".ljust(80) + struct.pack("<I", len(TRIANGLES)) + facets


#: (name, maker, dimensions)
BODIES = [
    ("body.msh", gmsh, (2, 3)),
    ("body4.msh", gmsh_4, (2, 3)),
    ("body.inp", abaqus, (2, 3)),
    ("body.ucd", ucd, (2, 3)),
    ("body.vtk", vtk_cells, (2, 3)),
]
SURFACES = [
    ("floor.stl", stl, (3,)),
    ("floor_binary.stl", binary_stl, (3,)),
    ("floor.obj", obj, (2, 3)),
    ("floor.vtk", vtk_surface, (2, 3)),
]
