# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The moments of a run for viewer.js, thinned until they fit into a page."""

import base64

import numpy
from plotting import fields as vtu
from plotting.moments import PRESSURE_MAP, STRESS_MAP
from plotting.problem import Problem

from . import skin as skins

#: Below these nothing is thinned.
FEW_MOMENTS, FEW_FACES = 12, 2000
#: Of base64, over the bytes that it carries.
ENCODED = 4.0 / 3.0
COLOURS = 12


def encode(array, kind="<f4"):
    """Numbers as viewer.js reads them."""
    return base64.b64encode(numpy.ascontiguousarray(array, dtype=kind).tobytes()).decode("ascii")


def read_obstacles(path):
    """Points and lines or triangles of a file of obstacles."""
    obstacle = vtu.read_fields(path)
    points, nodes = numpy.unique(obstacle.points, axis=0, return_inverse=True)
    cells = nodes.ravel()[obstacle.cells]
    return {
        "corners": cells.shape[1],
        "points": encode(points),
        "cells": encode(cells, "<u4"),
    }


def series_or_nothing(path):
    """(time, file) of a series, nothing if there is none."""
    try:
        return vtu.read_series(path)
    except Problem:
        return []


class View:
    """What of a run is in the page."""

    def __init__(self, run, most_bytes):
        self.folder, self.most_bytes, self.notes = run.folder, most_bytes, []
        self.dimension = run.dimension
        self.problems = []
        series = vtu.read_series(run.folder / "volume.pvd")
        self.surface = dict(series_or_nothing(run.folder / "surface.pvd"))
        self.meshes, self.moments, self.obstacles = [], [], []
        self._skin = self._sizes = None
        self.most_faces = None
        chosen = self._choose(series, peak_time(run.history))
        for time, path in chosen:
            try:
                self._add(time, path)
            except Problem as problem:
                self.problems.append(str(problem))
        if not self.moments:
            raise Problem(self.problems[0] if self.problems else "no moment could be read")
        self._add_obstacles()

    def _choose(self, series, peak):
        """As many moments as fit; the first, the last and that of the largest force among them."""
        sample = skins.make_skin(first_readable(reversed(series)))
        size = bytes_of(sample)
        fit = int(self.most_bytes / size)
        if fit < min(FEW_MOMENTS, len(series)):
            wanted = self.most_bytes / min(FEW_MOMENTS, len(series))
            self.most_faces = max(FEW_FACES, int(len(sample.faces) * wanted / size))
            sample = skins.coarsened(sample, self.most_faces)
            fit = max(2, int(self.most_bytes / bytes_of(sample)))
            self.notes.append(
                f"The surface is shown with {len(sample.faces)} faces, not with all of its own."
            )
        if fit >= len(series):
            return series
        times = numpy.array([time for time, _ in series])
        rows = set(numpy.linspace(0, len(series) - 1, max(2, fit - 1)).round().astype(int))
        if peak is not None:
            rows.add(int(numpy.argmin(abs(times - peak))))
        self.notes.append(f"{len(rows)} of the {len(series)} moments in volume.pvd are shown.")
        return [series[row] for row in sorted(rows)]

    def _add(self, time, path):
        fields = vtu.read_fields(path)
        if self._skin is None or not self._skin.fits(fields):
            self._skin = skins.make_skin(fields)
            if self.most_faces and len(self._skin.faces) > self.most_faces:
                self._skin = skins.coarsened(self._skin, self.most_faces)
            self.meshes.append(
                {
                    "reference": encode(self._skin.reference),
                    "faces": encode(self._skin.faces, "<u4"),
                }
            )
        skin = self._skin
        surface = self._surface_at(time)
        velocity = fields.point_data.get("velocity", numpy.zeros((len(fields.points), 3)))
        shown = {
            "displacement": fields.displacement()[skin.points],
            "velocity": numpy.linalg.norm(velocity[skin.points], axis=1),
            "pressure": skins.pressures(skin, surface),
            "stress": skins.stresses(skin, fields),
        }
        moment = {"time": time, "mesh": len(self.meshes) - 1, "obstacle": None}
        self.moments.append(moment | {name: encode(value) for name, value in shown.items()})

    def _surface_at(self, time):
        """Fields of the contact surface, None without."""
        try:
            return vtu.read_fields(self.surface[time]) if time in self.surface else None
        except Problem as problem:
            self.problems.append(str(problem))
            return None

    def _add_obstacles(self):
        """Those that rest, and of those that move the surface that belongs to each moment."""
        at_rest = self.folder / "obstacles.vtu"
        files = [(None, at_rest)] if at_rest.exists() else []
        moving = dict(series_or_nothing(self.folder / "obstacles.pvd"))
        wanted = {moment["time"] for moment in self.moments}
        files += [(time, path) for time, path in moving.items() if time in wanted]
        for time, path in files:
            try:
                self.obstacles.append(read_obstacles(path))
            except Problem as problem:
                self.problems.append(str(problem))
                continue
            for moment in self.moments:
                if moment["time"] == time:
                    moment["obstacle"] = len(self.obstacles) - 1
        self.rests = bool(files and files[0][0] is None and self.obstacles)

    def data(self):
        """For viewer.js."""
        return {
            "dimension": self.dimension,
            "meshes": self.meshes,
            "moments": self.moments,
            "obstacles": self.obstacles,
            "rests": self.rests,
            "colours": {
                name: [colour_bytes(colour_map, n / (COLOURS - 1)) for n in range(COLOURS)]
                for name, colour_map in (("cold", STRESS_MAP), ("warm", PRESSURE_MAP))
            },
        }


def colour_bytes(colour_map, value):
    """Red, green and blue from 0 to 255."""
    return [int(round(255 * part)) for part in colour_map(value)[:3]]


def bytes_of(skin):
    """Of one moment in the page: displacement, velocity, pressure, and the stress of faces."""
    return ENCODED * 4.0 * (5 * len(skin.reference) + len(skin.faces))


def first_readable(series):
    """Fields of the first file that is whole."""
    reason = None
    for _, path in series:
        try:
            return vtu.read_fields(path)
        except Problem as problem:
            reason = reason or problem
    raise reason


def peak_time(history):
    """Of the largest contact force, None without."""
    force = history.get("contact_force")
    if force is None or not force.max() > 0.0:
        return None
    return history["time"][numpy.argmax(force)]
