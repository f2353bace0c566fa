# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""From cells to what can be seen of them: boundary faces, projection, light."""

import dataclasses

import numpy
from matplotlib.collections import PolyCollection
from matplotlib.colors import to_rgb

# Faces of a VTK hexahedron.
HEXAHEDRON_FACES = numpy.array(
    [[0, 1, 2, 3], [4, 5, 6, 7], [0, 1, 5, 4], [3, 2, 6, 7], [0, 3, 7, 4], [1, 2, 6, 5]]
)


@dataclasses.dataclass
class Faces:
    """Quadrilaterals in space with the cell that each belongs to."""

    corners: numpy.ndarray  # (faces, 4, 3)
    normals: numpy.ndarray  # (faces, 3), out of the body
    cell: numpy.ndarray  # (faces,)


def boundary_faces(fields, positions, keep=None):
    """Faces that belong to one of the kept cells only; different bodies never share a face."""
    faces, owner = outer_faces(fields, point_numbers(fields), keep)
    corners = positions[faces]
    centres = positions[fields.cells[owner]].mean(axis=1)
    return Faces(corners, outward(corners, centres), owner)


def point_numbers(fields):
    """Points are repeated per cell: equal points of a body get the same number."""
    extent = numpy.ptp(fields.points, axis=0).max() or 1.0
    body = fields.at_cells("body")
    key = numpy.zeros((len(fields.points), 4), dtype=numpy.int64)
    key[:, :3] = numpy.floor((fields.points - fields.points.min(axis=0)) / extent * 1e5 + 0.382)
    if body is not None:
        key[fields.cells, 3] = numpy.round(body)[:, None]
    return numpy.unique(key, axis=0, return_inverse=True)[1].ravel()


def outer_faces(fields, number, keep=None):
    """(points of each face, its cell) of the faces that belong to one of the kept cells only."""
    kept = numpy.arange(len(fields.cells)) if keep is None else numpy.flatnonzero(keep)
    faces = fields.cells[kept][:, HEXAHEDRON_FACES].reshape(-1, 4)
    owner = numpy.repeat(kept, len(HEXAHEDRON_FACES))
    _, first, count = numpy.unique(
        numpy.sort(number[faces], axis=1), axis=0, return_index=True, return_counts=True
    )
    outer = first[count == 1]
    return faces[outer], owner[outer]


def together(*parts):
    """One list of faces out of several."""
    return Faces(
        *(
            numpy.concatenate([getattr(part, field.name) for part in parts])
            for field in dataclasses.fields(Faces)
        )
    )


def subdivide(corners, normals, values, pieces=4):
    """Small faces with one value each: the bilinear field with these values at the corners."""
    s = numpy.linspace(0.0, 1.0, pieces + 1)
    low_s, low_t = numpy.repeat(s[:-1], pieces), numpy.tile(s[:-1], pieces)
    step = 1.0 / pieces

    def at(s, t, field):
        weights = numpy.stack([(1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t], axis=1)
        return numpy.einsum("pk,fk...->fp...", weights, field)

    fine = numpy.stack(
        [
            at(low_s + i * step, low_t + j * step, corners)
            for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))
        ],
        axis=2,
    )
    means = at(low_s + 0.5 * step, low_t + 0.5 * step, values)
    n = means.size
    return (
        Faces(fine.reshape(n, 4, 3), numpy.repeat(normals, pieces**2, axis=0), numpy.full(n, -1)),
        means.ravel(),
    )


def outward(corners, centres):
    """Unit normals of faces, pointing away from the given inner points."""
    normals = numpy.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    normals /= numpy.maximum(numpy.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
    side = numpy.einsum("ij,ij->i", normals, corners.mean(axis=1) - centres)
    return numpy.where(side[:, None] < 0, -normals, normals)


class Camera:
    """Parallel projection along a direction; `up` is as vertical in the picture as possible."""

    def __init__(self, towards_viewer, up=(0.0, 0.0, 1.0)):
        self.depth = numpy.asarray(towards_viewer, dtype=float)
        self.depth /= numpy.linalg.norm(self.depth)
        right = numpy.cross(up, self.depth)
        if numpy.linalg.norm(right) < 1e-6:
            right = numpy.cross((0.0, 1.0, 0.0), self.depth)
        self.right = right / numpy.linalg.norm(right)
        self.up = numpy.cross(self.depth, self.right)

    def project(self, points):
        """Coordinates in the picture."""
        return points @ numpy.stack([self.right, self.up], axis=1)

    def draw(self, axes, faces, colours, edges=0.3):
        """Paint the faces that look at the viewer, the farthest first, with light from the upper
        left.

        `edges` darkens the outlines, one number for all or one for each face.
        """
        visible = numpy.flatnonzero(faces.normals @ self.depth > 0)
        order = visible[numpy.argsort(faces.corners[visible].mean(axis=1) @ self.depth)]
        light = self.depth + 0.7 * self.up - 0.5 * self.right
        light /= numpy.linalg.norm(light)
        shade = 0.62 + 0.38 * numpy.clip(faces.normals[order] @ light, 0.0, 1.0)
        painted = numpy.asarray(colours)[order, :3] * shade[:, None]
        edges = numpy.broadcast_to(edges, len(faces.corners))[order, None]
        axes.add_collection(
            PolyCollection(
                self.project(faces.corners[order]),
                facecolors=painted,
                edgecolors=painted * (1.0 - edges),
                linewidths=0.35,
            )
        )


def one_colour(faces, colour):
    """The same colour for all faces."""
    return numpy.tile(to_rgb(colour), (len(faces.corners), 1))
