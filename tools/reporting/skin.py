# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""What can be seen of the bodies at one moment: their surfaces in 3d, all cells in 2d."""

import dataclasses

import numpy
from plotting import fields as vtu
from plotting import solids

HEXAHEDRON = 8


@dataclasses.dataclass
class Skin:
    """Faces between nodes, on a mesh that may serve several moments."""

    reference: numpy.ndarray  # (nodes, 3), undeformed
    faces: numpy.ndarray  # (faces, 4), nodes in turn
    points: numpy.ndarray  # (nodes,) a point of the fields for each node
    cells: numpy.ndarray  # (faces,) the cell behind each face
    source: vtu.Fields  # what it was made of

    def fits(self, fields):
        """Whether fields have the mesh of this skin."""
        return numpy.array_equal(self.source.cells, fields.cells) and numpy.array_equal(
            self.source.points, fields.points
        )


def make_skin(fields):
    """The skin of a mesh."""
    number = solids.point_numbers(fields)
    if fields.cells.shape[1] == HEXAHEDRON:
        faces, owner = solids.outer_faces(fields, number)
    else:
        faces, owner = fields.cells, numpy.arange(len(fields.cells))
    _, points, nodes = numpy.unique(number[faces], return_index=True, return_inverse=True)
    points = faces.ravel()[points]
    return Skin(fields.points[points], nodes.reshape(faces.shape), points, owner, fields)


def coarsened(skin, most_faces):
    """The same shape with fewer faces: nodes that are near each other become one of them."""
    along = int(numpy.sqrt(most_faces / 6)) + 1
    while along > 1:
        low, extent = skin.reference.min(axis=0), numpy.ptp(skin.reference, axis=0).max() or 1.0
        body = skin.source.at_points("body")[skin.points][:, None]
        key = numpy.floor((skin.reference - low) / extent * along * (1 - 1e-9))
        _, kept, cluster = numpy.unique(
            numpy.hstack([key, numpy.round(body)]), axis=0, return_index=True, return_inverse=True
        )
        faces = cluster.ravel()[skin.faces]
        corners = numpy.sort(faces, axis=1)
        solid = (numpy.diff(corners, axis=1) > 0).sum(axis=1) >= 2
        _, first = numpy.unique(corners[solid], axis=0, return_index=True)
        chosen = numpy.flatnonzero(solid)[first]
        if len(chosen) <= most_faces:
            break
        along = along * 3 // 4
    return Skin(
        skin.reference[kept], faces[chosen], skin.points[kept], skin.cells[chosen], skin.source
    )


def pressures(skin, surface):
    """The contact pressure at the nodes: that of the contact surface at the same places."""
    values = numpy.zeros(len(skin.reference))
    if surface is None or "CPRESS" not in surface.point_data:
        return values
    places = numpy.concatenate([skin.reference, surface.points])
    extent = numpy.ptp(skin.reference, axis=0).max() or 1.0
    key = numpy.floor((places - skin.reference.min(axis=0)) / extent * 1e5 + 0.382)
    number = numpy.unique(key, axis=0, return_inverse=True)[1].ravel()
    known = numpy.zeros(number.max() + 1)
    numpy.maximum.at(known, number[len(values) :], surface.point_data["CPRESS"])
    return known[number[: len(values)]]


def stresses(skin, fields):
    """One value for each face: that of the cell behind it."""
    values = fields.at_cells("von_mises")
    return numpy.zeros(len(skin.cells)) if values is None else values[skin.cells]
