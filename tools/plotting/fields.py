# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Reading of the VTU series (volume.pvd, surface.pvd)."""

import dataclasses
import re
import xml.etree.ElementTree as ElementTree

import meshio
import numpy

from .problem import Problem


@dataclasses.dataclass
class Fields:
    """One moment of a series, all processes put together. Points are repeated for each cell."""

    points: numpy.ndarray  # (points, 3), reference configuration
    cells: numpy.ndarray  # (cells, vertices of a cell)
    point_data: dict
    cell_data: dict

    def at_points(self, name):
        """A point field, or zeros if the series does not have it."""
        return self.point_data.get(name, numpy.zeros(len(self.points)))

    def displacement(self):
        field = self.point_data.get("displacement", numpy.zeros((len(self.points), 3)))
        return numpy.pad(field, ((0, 0), (0, 3 - field.shape[1])))

    def at_cells(self, name):
        """A cell field, or the cell mean of a point field, or None."""
        if name in self.cell_data:
            return self.cell_data[name]
        if name in self.point_data:
            return self.point_data[name][self.cells].mean(axis=1)
        return None


def read_series(path):
    """(time, file) for each moment of a .pvd."""
    try:
        datasets = ElementTree.parse(path).iter("DataSet")
        series = [
            (float(entry.get("timestep")), path.parent / entry.get("file")) for entry in datasets
        ]
    except OSError as error:
        raise Problem(f"{path}: {error.strerror}") from None
    except (ElementTree.ParseError, TypeError, ValueError) as error:
        raise Problem(f"{path} is not a whole .pvd file ({error})") from None
    if not series:
        raise Problem(f"{path} names no file")
    return series


def read_fields(path):
    """A .pvtu with its pieces, or a single .vtu."""
    try:
        pieces = [path]
        if path.suffix == ".pvtu":
            pieces = [
                path.parent / piece.get("Source") for piece in ElementTree.parse(path).iter("Piece")
            ]
        return join([read_piece(piece) for piece in pieces if not is_empty(piece)], path)
    except OSError as error:
        raise Problem(f"{error.filename or path}: {error.strerror}") from None
    except ElementTree.ParseError as error:
        raise Problem(f"{path} is not a whole file ({error})") from None


def read_piece(path):
    """One .vtu. On broken files meshio.read() ends the program; what is below raises anything."""
    try:
        return meshio.vtu.read(path)
    except OSError:
        raise
    except Exception as error:
        raise Problem(
            f"{path} is not a whole .vtu file ({str(error) or type(error).__name__})"
        ) from None


def is_empty(piece):
    """Whether a process had nothing to write; meshio cannot read such a piece."""
    with open(piece, "rb") as file:
        return re.search(rb'NumberOfCells="0"', file.read(2000)) is not None


def join(meshes, path):
    """One mesh out of those of all processes."""
    if not meshes:
        raise Problem(f"{path} has no cells")
    kinds = {block.type for mesh in meshes for block in mesh.cells}
    if not kinds <= {"line", "triangle", "quad", "hexahedron"} or len(kinds) != 1:
        raise Problem(
            f"{path} has cells of the kinds {', '.join(sorted(kinds))}; "
            "only meshes of lines, triangles, quadrilaterals or hexahedra are drawn"
        )
    offsets = numpy.cumsum([0] + [len(mesh.points) for mesh in meshes])
    return Fields(
        points=numpy.concatenate([mesh.points for mesh in meshes]),
        cells=numpy.concatenate(
            [block.data + offset for mesh, offset in zip(meshes, offsets) for block in mesh.cells]
        ),
        point_data={
            name: numpy.concatenate([mesh.point_data[name] for mesh in meshes])
            for name in meshes[0].point_data
        },
        cell_data={
            name: numpy.concatenate([block for mesh in meshes for block in mesh.cell_data[name]])
            for name in meshes[0].cell_data
        },
    )
