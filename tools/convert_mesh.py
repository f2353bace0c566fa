#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Writes a mesh of any format that meshio knows in Gmsh's version 2.2: convert_mesh.py FROM TO.

Groups of cells and faces keep their names and numbers; Exodus files are read without meshio, which
passes over their side sets. The program has this script inside and runs it for formats that it
cannot read itself. If there is nothing to write, TO has a sentence that says why, and the exit
status is 1.
"""

import pathlib
import sys

#: Names of meshio: number in Gmsh, dimension, nodes; and where Gmsh has other places for the nodes.
KINDS = {
    "line": (1, 1, 2),
    "triangle": (2, 2, 3),
    "quad": (3, 2, 4),
    "tetra": (4, 3, 4),
    "hexahedron": (5, 3, 8),
    "wedge": (6, 3, 6),
    "pyramid": (7, 3, 5),
    "line3": (8, 1, 3),
    "triangle6": (9, 2, 6),
    "quad9": (10, 2, 9),
    "tetra10": (11, 3, 10),
    "quad8": (16, 2, 8),
    "hexahedron20": (17, 3, 20),
    "wedge15": (18, 3, 15),
}
HEXAHEDRON = (0, 1, 2, 3, 4, 5, 6, 7, 8, 11, 16, 9, 17, 10, 18, 19, 12, 15, 13, 14)
ORDER = {
    "tetra10": (0, 1, 2, 3, 4, 5, 6, 7, 9, 8),
    "hexahedron20": HEXAHEDRON,
    "wedge15": (0, 1, 2, 3, 4, 5, 6, 8, 12, 7, 13, 14, 9, 11, 10),
}
#: Kinds of which only the first nodes count.
SHORTER = {"hexahedron27": "hexahedron20", "wedge18": "wedge15", "triangle7": "triangle6"}
#: Where formats keep the numbers of groups.
TAGS = ("gmsh:physical", "medit:ref", "nastran:ref", "MaterialID", "physical")
PACKAGES = {"meshio": "python3-meshio", "netCDF4": "python3-netcdf4", "h5py": "python3-h5py"}

#: Exodus: types by the beginning of their names and the number of nodes, and the nodes of sides.
EXODUS = {
    ("BAR", 2): "line",
    ("TRI", 3): "triangle",
    ("TRI", 6): "triangle6",
    ("QUA", 4): "quad",
    ("QUA", 8): "quad8",
    ("QUA", 9): "quad9",
    ("SHE", 4): "quad",
    ("TET", 4): "tetra",
    ("TET", 10): "tetra10",
    ("HEX", 8): "hexahedron",
    ("HEX", 20): "hexahedron20",
    ("HEX", 27): "hexahedron27",
    ("WED", 6): "wedge",
    ("WED", 15): "wedge15",
}
SIDES = {
    "tri": ((0, 1), (1, 2), (2, 0)),
    "qua": ((0, 1), (1, 2), (2, 3), (3, 0)),
    "tet": ((0, 1, 3), (1, 2, 3), (0, 3, 2), (0, 2, 1)),
    "wed": ((0, 1, 4, 3), (1, 2, 5, 4), (0, 3, 5, 2), (0, 2, 1), (3, 4, 5)),
    "hex": (
        (0, 1, 5, 4),
        (1, 2, 6, 5),
        (2, 3, 7, 6),
        (0, 4, 7, 3),
        (0, 3, 2, 1),
        (4, 5, 6, 7),
    ),
}
FACES = {2: "line", 3: "triangle", 4: "quad"}


class NoMesh(Exception):
    """Why there is nothing to write."""


class Content:
    """Points, elements with their groups, and the groups."""

    def __init__(self, points):
        self.points = [[float(x) for x in [*point, 0, 0][:3]] for point in points]
        self.elements = []  # (number of the kind, nodes, numbers of groups)
        self.numbers = {}  # of groups, by dimension and name

    def name(self, dim, name, number=None):
        """Remember a group. @return its number, the given one or one that is free"""
        taken = {n for (d, _), n in self.numbers.items() if d == dim}
        if number is None:
            number = max(taken, default=0) + 1
        return self.numbers.setdefault((dim, name), number)

    def add(self, kind, nodes, groups):
        """An element; groups are numbers."""
        kind = SHORTER.get(kind, kind)
        if kind not in KINDS:
            if kind == "vertex":
                return
            raise NoMesh(f"it has elements of the kind `{kind}`, which cannot be used")
        number, _, n_nodes = KINDS[kind]
        nodes = [int(node) for node in nodes[:n_nodes]]
        if not all(0 <= node < len(self.points) for node in nodes):
            raise NoMesh("it has an element with a node that does not exist")
        order = ORDER.get(kind, range(n_nodes))
        self.elements.append((number, [nodes[k] for k in order], [g for g in groups if g > 0]))

    def write(self, path):
        """An element in several groups is written for each of them, as Gmsh does."""
        with path.open("w", encoding="utf-8") as out:
            out.write("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n")
            out.write(f"$PhysicalNames\n{len(self.numbers)}\n")
            for (dim, name), number in self.numbers.items():
                out.write(f'{dim} {number} "{name}"\n')
            out.write(f"$EndPhysicalNames\n$Nodes\n{len(self.points)}\n")
            for n, (x, y, z) in enumerate(self.points):
                out.write(f"{n + 1} {x!r} {y!r} {z!r}\n")
            rows = [
                f"{kind} 2 {group} {group} " + " ".join(str(node + 1) for node in nodes)
                for kind, nodes, groups in self.elements
                for group in groups or [0]
            ]
            out.write(f"$EndNodes\n$Elements\n{len(rows)}\n")
            out.writelines(f"{n + 1} {row}\n" for n, row in enumerate(rows))
            out.write("$EndElements\n")


def clean(name):
    """A name without what would break the lines of the file."""
    return " ".join(str(name).replace('"', "'").split())


def of_meshio(path):
    """The content of what meshio reads."""
    import meshio

    try:
        mesh = meshio.read(path)
    except SystemExit as error:
        raise NoMesh("meshio cannot read it") from error
    content = Content(mesh.points)
    for name, data in mesh.field_data.items():
        if len(data) == 2:
            content.name(int(data[1]), clean(name), int(data[0]))
    tags = next((mesh.cell_data[key] for key in TAGS if key in mesh.cell_data), None)
    families = mesh.cell_data.get("cell_tags")  # MED: each has names of groups
    names_of_family = getattr(mesh, "cell_tags", {})
    for b, block in enumerate(mesh.cells):
        dim = KINDS.get(SHORTER.get(block.type, block.type), (0, 0, 0))[1]
        groups = [[] for _ in block.data]
        for name, members in mesh.cell_sets.items():
            if not name.startswith("gmsh:") and members[b] is not None and len(members[b]) > 0:
                for cell in members[b]:
                    groups[int(cell)].append(content.name(dim, clean(name)))
        for cell, nodes in enumerate(block.data):
            if tags is not None and not groups[cell]:
                groups[cell] = [abs(int(tags[b][cell]))]
            elif families is not None:
                names = names_of_family.get(int(families[b][cell]), [])
                groups[cell] = [content.name(dim, clean(name)) for name in names]
            content.add(block.type, nodes, groups[cell])
    return content


def words_of(data, key):
    """Names in a table of letters."""
    if key not in data.variables:
        return []
    table = data.variables[key]
    table.set_auto_mask(False)
    return [b"".join(row).split(b"\0")[0].decode("utf-8", "replace").strip() for row in table[:]]


def coordinates(data):
    """Of all points of an Exodus file."""
    if "coord" in data.variables:
        return data.variables["coord"][:].T
    names = [f"coord{axis}" for axis in "xyz"]
    return list(zip(*(data.variables[name][:] for name in names if name in data.variables)))


def of_exodus(path):
    """Blocks, and side sets with names and numbers."""
    import netCDF4

    data = netCDF4.Dataset(path)
    content = Content(coordinates(data))
    cells = []
    for prefix, names in (("eb", words_of(data, "eb_names")), ("ss", words_of(data, "ss_names"))):
        if f"{prefix}_prop1" not in data.variables:
            continue
        for k, number in enumerate(data.variables[f"{prefix}_prop1"][:]):
            name = clean(names[k]) if k < len(names) and names[k] else f"{prefix}{number}"
            if prefix == "eb":
                block = data.variables[f"connect{k + 1}"]
                start, nodes = block.elem_type.upper()[:3], block[:] - 1
                kind = EXODUS.get((start, nodes.shape[1]), block.elem_type)
                dim = KINDS.get(SHORTER.get(kind, kind), (0, 0, 0))[1]
                group = content.name(dim, name, int(number))
                cells += [(kind, row) for row in nodes]
                for row in nodes:
                    content.add(kind, row, [group])
            elif f"elem_ss{k + 1}" in data.variables:
                members = data.variables[f"elem_ss{k + 1}"][:], data.variables[f"side_ss{k + 1}"][:]
                for element, side in zip(*members):
                    kind, row = cells[int(element) - 1]
                    corners = [row[v] for v in SIDES[kind[:3]][int(side) - 1]]
                    face = FACES[len(corners)]
                    content.add(face, corners, [content.name(KINDS[face][1], name, int(number))])
    return content


def main(source, target):
    """@return the exit status"""
    target = pathlib.Path(target)
    try:
        exodus = pathlib.Path(source).suffix.lower() in (".e", ".ex2", ".exo")
        (of_exodus if exodus else of_meshio)(source).write(target)
        return 0
    except ModuleNotFoundError as error:
        package = PACKAGES.get(error.name, error.name)
        reason = (
            f"Python's module {error.name} is missing. Install it (Debian: `apt-get install "
            f"{package}`), or write the mesh as .msh."
        )
    except NoMesh as error:
        reason = f"{error}. Write the mesh as .msh."
    except Exception as error:  # whatever a library meets in a broken file
        words = " ".join(str(error).split()).rstrip(".")[:150]
        reason = f"it cannot be read ({words or type(error).__name__}). Write the mesh as .msh."
    target.write_text(reason, encoding="utf-8")
    return 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
