# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Small meshes of all formats that the program reads, as texts: bodies of two cells or of simplices
with names, and surfaces under them."""

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


def simplices(dim):
    """One cell cut into triangles or tetrahedra, and the faces below; vertices from 1."""
    vertices = [v for v in (SQUARES if dim == 2 else CUBES) if v[0] < 2]
    if dim == 2:
        return vertices, [(1, 2, 4), (1, 4, 3)], [(1, 2)]
    around = (2, 4, 3, 7, 5, 6, 2)  # from corner to corner, about the diagonal from 1 to 8
    return vertices, [(1, *around[k : k + 2], 8) for k in range(6)], [(1, 2, 4), (1, 4, 3)]


def kinds_of_simplices(dim, names):
    """The name of a cell and of its face, by their dimensions."""
    return names[dim], names[dim - 1]


def gmsh_names(dim):
    """Version 2.2 with names of the groups."""
    vertices, cells, faces = simplices(dim)
    kind, face_kind = kinds_of_simplices(dim, {1: 1, 2: 2, 3: 4})
    elements = [(face_kind, 2, 1, 1, *face) for face in faces]
    elements += [(kind, 2, 7, 7, *cell) for cell in cells]
    return (
        f'$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n{dim - 1} 1 "below"\n'
        f'{dim} 7 "block"\n$EndPhysicalNames\n$Nodes\n{len(vertices)}\n{rows(vertices, 1)}'
        f"$EndNodes\n$Elements\n{len(elements)}\n{rows(elements, 1)}$EndElements\n"
    )


def gmsh_4_names(dim):
    """Version 4.1 with names of the groups."""
    vertices, cells, faces = simplices(dim)
    n, kinds = len(vertices), kinds_of_simplices(dim, {1: 1, 2: 2, 3: 4})
    box, n_all = "0 0 0 1 1 1", len(cells) + len(faces)
    counts = "0 1 1 0" if dim == 2 else "0 0 1 1"
    return (
        f'$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n{dim - 1} 1 "below"\n'
        f'{dim} 7 "block"\n$EndPhysicalNames\n'
        f"$Entities\n{counts}\n1 {box} 1 1 0\n1 {box} 1 7 0\n$EndEntities\n"
        f"$Nodes\n1 {n} 1 {n}\n{dim} 1 0 {n}\n{rows([(v + 1,) for v in range(n)])}{rows(vertices)}"
        f"$EndNodes\n$Elements\n2 {n_all} 1 {n_all}\n{dim - 1} 1 {kinds[1]} {len(faces)}\n"
        f"{rows(faces, 1)}{dim} 1 {kinds[0]} {len(cells)}\n{rows(cells, 1 + len(faces))}"
        "$EndElements\n"
    )


def gmsh_curved(dim):
    """Version 2.2 with one cell of second order."""
    middle = lambda a, b: tuple((x + y) / 2 for x, y in zip(a, b))
    corners = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)][: dim + 1]
    pairs = [(0, 1), (1, 2), (2, 0), (3, 0), (3, 2), (3, 1)][: 3 if dim == 2 else 6]
    vertices = corners + [middle(corners[a], corners[b]) for a, b in pairs]
    face = (1, 2) if dim == 2 else (1, 2, 3)
    elements = [
        (dim - 1, 2, 1, 1, *face),
        (9 if dim == 2 else 11, 2, 7, 7, *range(1, len(vertices) + 1)),
    ]
    return (
        f"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{len(vertices)}\n{rows(vertices, 1)}"
        f"$EndNodes\n$Elements\n2\n{rows(elements, 1)}$EndElements\n"
    )


def ucd_simplices(dim):
    """With the number of a group."""
    vertices, cells, faces = simplices(dim)
    kind, face_kind = kinds_of_simplices(dim, {1: "line", 2: "tri", 3: "tet"})
    elements = [(7, kind, *cell) for cell in cells] + [(1, face_kind, *face) for face in faces]
    return f"{len(vertices)} {len(elements)} 0 0 0\n{rows(vertices, 1)}{rows(elements, 1)}"


def abaqus_simplices(dim):
    """Faces are elements, in the sets of a geometry and in one of the user."""
    vertices, cells, faces = simplices(dim)
    kind, face_kind = kinds_of_simplices(dim, {1: "T2D2", 2: "CPS3", 3: "C3D4"})
    comma = lambda items, first: rows(items, first).replace(" ", ", ")
    return (
        f"*HEADING\na mesh\n*NODE\n{comma(vertices, 1)}*ELEMENT, TYPE={face_kind}, ELSET=Surface2\n"
        f"{comma(faces, 1)}*ELEMENT, TYPE={kind}, ELSET=Volume1\n{comma(cells, 11)}"
        "*ELSET, ELSET=below\n1, 2\n*ELSET, ELSET=block, GENERATE\n11, 16\n"
    )


def vtk_simplices(dim):
    """With the numbers of groups as deal.II writes them."""
    vertices, cells, faces = simplices(dim)
    kind, face_kind = kinds_of_simplices(dim, {1: 3, 2: 5, 3: 10})
    elements = [tuple(v - 1 for v in element) for element in cells + faces]
    text = vtk(vertices, "CELLS", elements, [kind] * len(cells) + [face_kind] * len(faces))
    groups = rows([(7,)] * len(cells) + [(1,)] * len(faces))
    return (
        f"{text}CELL_DATA {len(elements)}\nSCALARS MaterialID int 1\nLOOKUP_TABLE default\n{groups}"
    )


#: (name, maker, dimensions); those with names have the groups `below` and `block`.
NAMED = [
    ("named.msh", gmsh_names, (2, 3)),
    ("named4.msh", gmsh_4_names, (2, 3)),
    ("named.inp", abaqus_simplices, (2, 3)),
]
BODIES = [
    ("curved.msh", gmsh_curved, (2, 3)),
    ("simplices.ucd", ucd_simplices, (2, 3)),
    ("simplices.vtk", vtk_simplices, (2, 3)),
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
