# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The deformed bodies as a film: von Mises stress, and contact pressure, over all moments."""

import shutil

import numpy
from matplotlib import animation, pyplot

from . import fields as vtu
from . import obstacles, style
from .bodies import finish_panel, has_surface, views_of
from .moments import by_time, read_moment
from .problem import Problem

#: More moments than these are thinned: a film is to be seen, not to be waited for.
MOST_FRAMES = 120
#: How long it is to last, in seconds, as far as 4 to 25 pictures in a second can do that.
SECONDS = 8.0
WRITERS = {"mp4": animation.FFMpegWriter, "gif": animation.PillowWriter}


def moments_of(directory):
    """At most MOST_FRAMES moments, the first and the last among them."""
    series = vtu.read_series(directory / "volume.pvd")
    surface, walls = (by_time(directory / name) for name in ("surface.pvd", "obstacles.pvd"))
    count = min(len(series), MOST_FRAMES)
    rows = numpy.linspace(0, len(series) - 1, count).round().astype(int)
    return [
        read_moment(f"time {time:.4g}", path, surface.get(time), walls.get(time))
        for time, path in (series[row] for row in rows)
    ]


def require(kind):
    """Raises Problem if the program that makes such films is not there."""
    if kind == "mp4" and not shutil.which("ffmpeg"):
        raise Problem(
            "mp4 needs ffmpeg, which is not installed. On Debian: apt-get install ffmpeg; or take "
            "--animation gif"
        )


def animate(directory, kind):
    """Write directory/pictures/bodies.<kind>, kind being mp4 or gif. Returns the path.

    Raises Problem without fields.
    """
    style.use()
    moments = moments_of(directory)
    figure, frames = draw_frames(directory, moments)
    rate = min(25.0, max(4.0, len(moments) / SECONDS))
    path = directory / "pictures" / f"bodies.{kind}"
    writer = WRITERS[kind](fps=rate)
    try:
        path.parent.mkdir(exist_ok=True)
        with writer.saving(figure, str(path), dpi=100):
            for number in range(len(moments)):
                for other, panels in enumerate(frames):
                    for panel in panels:
                        panel.set_visible(other == number)
                writer.grab_frame()
    except OSError as error:
        raise Problem(f"cannot write {path}: {error.strerror or error}") from None
    finally:
        style.close(figure)
    return path


def draw_frames(directory, moments):
    """A figure, and the panels of each moment, which lie over each other.

    All moments are drawn before the film begins, so that they share scales of colour and view.
    """
    views, walls = views_of(moments), obstacles.read_obstacles(directory)
    rows = 1 + has_surface(moments)
    figure = pyplot.figure(figsize=(4.2 * rows + 1.6, 4.6))
    grid = figure.add_gridspec(1, rows)
    panels = [[figure.add_subplot(grid[0, row]) for _ in moments] for row in range(rows)]
    views.draw_stress(panels[0], moments, walls)
    if rows > 1:
        views.draw_pressure(panels[1], moments, walls)
    for row in panels:
        for panel, moment in zip(row, moments):
            panel.set_title(moment.title)
            finish_panel(panel)
    figure.canvas.draw()  # while all panels are there, so that they get the same place
    figure.set_layout_engine("none")
    return figure, list(zip(*panels))
