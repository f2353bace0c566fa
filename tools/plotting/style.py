# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Look of all figures."""

import matplotlib

matplotlib.use("Agg")

from matplotlib import pyplot  # noqa: E402  (the backend comes first)

# Okabe and Ito's palette: distinguishable with any kind of colour vision.
BLUE, ORANGE, GREEN, VERMILION, PURPLE, SKY = (
    "#0072B2",
    "#E69F00",
    "#009E73",
    "#D55E00",
    "#CC79A7",
    "#56B4E9",
)
BLACK, GREY = "#222222", "#8A8A8A"
CONTACT_SHADE = "#F1ECE2"


def use():
    """Set the defaults of matplotlib."""
    pyplot.rcParams.update(
        {
            "figure.dpi": 100,
            "savefig.dpi": 160,
            "figure.constrained_layout.use": True,
            "font.family": "sans-serif",
            "font.size": 12,
            "axes.titlesize": 13,
            "axes.labelsize": 12,
            "axes.titlelocation": "left",
            "axes.titlepad": 8,
            "axes.spines.top": False,
            "axes.spines.right": False,
            "axes.edgecolor": "#555555",
            "axes.axisbelow": True,
            "axes.grid": True,
            "grid.color": "#DDDDDD",
            "grid.linewidth": 0.7,
            "xtick.labelsize": 11,
            "ytick.labelsize": 11,
            "legend.fontsize": 11,
            "legend.frameon": False,
            "lines.linewidth": 1.9,
            "lines.solid_capstyle": "round",
        }
    )


def panels(n, heights=None, width=8.5, height=3.1):
    """n panels above each other that share the time axis."""
    figure, axes = pyplot.subplots(
        n,
        1,
        sharex=True,
        squeeze=False,
        figsize=(width, height * n + 0.3),
        gridspec_kw={"height_ratios": heights} if heights else None,
    )
    axes = axes[:, 0]
    axes[-1].set_xlabel("time")
    figure.align_ylabels(axes)
    return figure, axes


def line(axes, x, y, colour, label=None, **options):
    """A curve; a single point gets a marker, or it would not be seen."""
    marker = "o" if len(x) == 1 else None
    return axes.plot(x, y, color=colour, label=label, marker=marker, **options)


def legend_beside(axes):
    """A legend to the right of the panel, where it hides no curve."""
    axes.legend(loc="center left", bbox_to_anchor=(1.01, 0.5), borderaxespad=0)


def close(figure):
    pyplot.close(figure)
