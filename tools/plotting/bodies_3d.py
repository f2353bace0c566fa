# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Views of three-dimensional bodies."""

import numpy

from . import obstacles, solids
from .moments import (
    BODY,
    PRESSURE_MAP,
    STRESS_MAP,
    colour_scale,
    same_view,
    surroundings,
    von_mises,
)


def draw_stress(panels, moments, walls):
    """The far half of each body, so that the stress inside can be seen."""
    camera = solids.Camera((0.25, -1.0, 0.28))
    stresses = [von_mises(moment) for moment in moments]
    scale = colour_scale(panels, stresses, STRESS_MAP, "von Mises stress (cut open)")
    middle, size = surroundings(moments)
    for panel, moment, stress in zip(panels, moments, stresses):
        for wall in walls:
            faces = obstacles.faces_3d(wall, middle, 1.5 * size)
            if faces:
                camera.draw(panel, faces, solids.one_colour(faces, obstacles.COLOUR), edges=0.06)
        if moment.moving_walls:
            faces = obstacles.moving_faces_3d(moment.moving_walls)
            camera.draw(panel, faces, solids.one_colour(faces, obstacles.COLOUR), edges=0.06)
        faces = solids.boundary_faces(moment.volume, moment.positions, far_half(moment.volume))
        camera.draw(panel, faces, scale.to_rgba(stress[faces.cell]))
    same_view(panels, [camera.project(moment.positions) for moment in moments])


def far_half(fields):
    """Cells behind the vertical plane through the middle of a body; all if it is one cell thick."""
    centres = fields.points[fields.cells].mean(axis=1)[:, 1]
    body = fields.at_cells("body")
    body = numpy.zeros(len(centres)) if body is None else numpy.round(body)
    keep = numpy.zeros(len(centres), dtype=bool)
    for number in numpy.unique(body):
        own = body == number
        depth = fields.points[fields.cells[own], 1]
        low, high = depth.min(), depth.max()
        keep |= own & (centres >= 0.5 * (low + high) - 1e-6 * (high - low))
    return keep


def draw_pressure(panels, moments, _walls):
    """The bodies as the obstacle sees them."""
    skins = [solids.boundary_faces(moment.volume, moment.positions) for moment in moments]
    matches = [surface_face_of(skin, moment) for skin, moment in zip(skins, moments)]
    pressures = [moment.surface.at_points("CPRESS")[moment.surface.cells] for moment in moments]
    camera = solids.Camera(pressed_direction(skins, matches, pressures))
    scale = colour_scale(
        panels, pressures, PRESSURE_MAP, "contact pressure\n(seen from the obstacle)"
    )
    for panel, moment, skin, match, pressure in zip(panels, moments, skins, matches, pressures):
        pressed = (match >= 0) & (pressure[match].max(axis=1) > 1e-3 * scale.norm.vmax)
        plain = solids.Faces(skin.corners[~pressed], skin.normals[~pressed], skin.cell[~pressed])
        corners = moment.surface_positions[moment.surface.cells[match[pressed]]]
        fine, values = solids.subdivide(corners, skin.normals[pressed], pressure[match[pressed]])
        camera.draw(
            panel,
            solids.together(plain, fine),
            numpy.concatenate([solids.one_colour(plain, BODY), scale.to_rgba(values)[:, :3]]),
            edges=numpy.repeat([0.3, 0.0], [len(plain.cell), len(fine.cell)]),
        )
    same_view(panels, [camera.project(moment.positions) for moment in moments])


def surface_face_of(skin, moment):
    """For each face of the skin the same face of the contact surface, -1 outside of it."""
    middles = moment.surface_positions[moment.surface.cells].mean(axis=1)
    quantum = 1e-4 * (numpy.ptp(moment.positions, axis=0).max() or 1.0)
    match = numpy.full(len(skin.cell), -1)
    # Equal places may round differently with one shift of the grid, but not with both.
    for shift in (0.2, 0.7):
        known = {tuple(key): n for n, key in enumerate(numpy.floor(middles / quantum + shift))}
        for n, key in enumerate(numpy.floor(skin.corners.mean(axis=1) / quantum + shift)):
            match[n] = known.get(tuple(key), match[n])
    return match


def pressed_direction(skins, matches, pressures):
    """From where the pressed faces are seen best, tilted so that the bodies still look solid."""
    normal = sum(
        pressure.mean(axis=1)[match[match >= 0]] @ skin.normals[match >= 0]
        for skin, match, pressure in zip(skins, matches, pressures)
    )
    if numpy.linalg.norm(normal) < 1e-12:
        normal = numpy.array([0.0, 0.0, -1.0])
    return normal / numpy.linalg.norm(normal) + numpy.array([0.25, -0.55, 0.0])
