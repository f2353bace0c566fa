# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The page of a comparison. What it says about schemes is computed from their numbers."""

import math
import re
import textwrap

from . import judge, statements, tables

#: What a figure shows.
CAPTIONS = {
    "force": (
        "Contact force",
        "The sum of all normal forces over time, as in the paper's figure 2.",
    ),
    "energy": (
        "Energy",
        (
            "The total energy relative to the initial one, as in figure 3. A scheme with a"
            " redistributed mass has two energies: with the standard mass, which is that of the"
            " body, and with its own one, which ignores the velocity of the contact surface."
        ),
    ),
    "displacement": (
        "Displacement of a node",
        (
            "The relative normal displacement of one node that comes into contact, as in figure 4."
            " Dashed: its gap. The lower row magnifies what is beyond the gap."
        ),
    ),
    "velocity": (
        "Velocity of a node",
        (
            "The relative normal velocity of the same node, as in figure 5, positive when it moves"
            " away; its time in contact is tinted. A velocity in contact should be zero. What"
            " leaves a panel is in the table of all observations."
        ),
    ),
    "pressure": (
        "Contact pressure",
        (
            "The pressure at the contact nodes in one step over the distance from the middle."
            " Without disturbance the dots lie on one arc."
        ),
    ),
    "pressure_from_above": ("", "The same from above, as in figure 6."),
}

MEASURES = f"""\
* **Roughness of the force:** mean absolute second difference during contact over the mean.
  **Zigzag of the force:** the part of all its changes that the very next step takes back, 0 for
  humps that many steps resolve and 1 for a pure zigzag; below {judge.SMOOTH:g} the force is called
  smooth.
* **Energy drift:** the largest deviation from the initial energy. Without a further word, energy is
  that with the standard mass; *own* energy is that with the mass of the scheme. Gains up to
  {judge.NONE:g} % are round-off.
* **Penetration, steps:** in units of what the observed node moves in one step on approach.
* **Velocities** are those of the observed node relative to the other side, along the normal,
  positive when it moves away; the zigzag of the velocity is its mean amplitude in contact, over the
  speed of approach.
* **Scatter of the pressure:** r.m.s. deviation from the best a + b r^2 + c r^4, without the rim of
  the contact zone, over the mean pressure; below {judge.SMOOTH_PRESSURE:g} the pressure is called
  smooth.
* **agrees:** the same word, or a number within {100 * judge.CLOSE:g} % (of a range, its ends within
  that part of its width). Otherwise the ratio of the number here, or of the width of the range, to
  that of the paper."""

#: Columns of the page, but for tables.
WIDTH = 100


def wrapped(text):
    """Paragraphs and items in lines of at most WIDTH columns; tables, headings, pictures stay."""
    joined = re.sub(r"(?<=\S)\n(?!\n|\* |[|#!]) *", " ", text.rstrip("\n"))
    return "".join(
        (
            line
            if line.startswith(("|", "#", "!"))
            else textwrap.fill(
                line,
                WIDTH,
                subsequent_indent="  " if line.startswith("* ") else "",
                break_long_words=False,
                break_on_hyphens=False,
            )
        )
        + "\n"
        for line in joined.split("\n")
    )


def failed(scenes):
    """What is missing, and why."""
    missing = [
        (scene, variant, message) for scene in scenes for variant, message in scene.failures()
    ]
    if not missing:
        return ""
    lines = [
        f"* {scene.study.title}, {variant.name}:"
        f" `{message.replace(str(scene.study.scene), scene.study.scene.name)}`"
        for scene, variant, message in missing
    ]
    return "**Some runs failed and are missing below:**\n\n" + "\n".join(lines) + "\n\n"


def schemes(scenes):
    """Names and the keys behind them."""
    rows = [["name here", "in the paper", "keys of the scene"]]
    for variant in scenes[0].variants:
        rows.append(
            [
                variant.name,
                variant.paper or "-",
                ", ".join(f"`{key} = {value}`" for key, value in variant.settings.items()),
            ]
        )
    return rows


def rank(values):
    """1 for the smallest; differences below two per cent do not count."""
    return [1 + sum(other < 0.98 * value for other in values) for value in values]


def ranking(scene):
    """Schemes in the order of the sum of their ranks."""
    criteria = ("force_roughness", "energy_drift", "penetration_in_steps")
    known = [
        (variant, numbers)
        for variant, numbers in zip(scene.variants, scene.numbers)
        if not any(math.isnan(numbers[name]) for name in criteria)
    ]
    ranks = list(zip(*(rank([numbers[name] for _, numbers in known]) for name in criteria)))
    rows = [
        [
            "scheme",
            "roughness of the force",
            "rank",
            "energy drift, %",
            "rank",
            "penetration, steps",
            "rank",
            "own energy drift, %",
        ]
    ]
    for own, (variant, numbers) in sorted(zip(ranks, known), key=lambda pair: sum(pair[0])):
        texts = [
            text
            for name, place in zip(criteria, own)
            for text in (tables.number(numbers[name]), str(place))
        ]
        rows.append([variant.name, *texts, tables.number(numbers["own_energy_drift"])])
    return rows


def scene_part(scene, pictures):
    """Figures of a scene and what they show."""
    text = f"## {scene.study.title}\n\n`parameters/{scene.study.scene.name}`\n\n"
    said = statements.by_figure(scene)
    for name, picture in pictures.items():
        heading, caption = CAPTIONS[name]
        text += (
            f"### {heading}\n\n" if heading else ""
        ) + f"{caption}\n\n![{heading or caption}]({picture})\n\n"
        text += "".join(f"* {sentence}\n" for sentence in said.get(name, ())) + (
            "\n" if said.get(name) else ""
        )
    return text


def page(scenes, pictures, beside, command):
    """The whole page."""
    text = "# All schemes on the examples of Krause and Walloth\n\n"
    text += (
        "R. Krause and M. Walloth, *Presentation and comparison of selected algorithms for dynamic"
        " contact based on the Newmark scheme*, Applied Numerical Mathematics 62 (2012), compare"
        " time discretisations on two examples: a ball on a plane (Geometry A) and two cubes"
        " (Geometry B, whose position they do not tell; see `doc/geometry_b.md`). Their figures 2"
        " to 5 are about the cubes, figure 6 about the ball. This page repeats the comparison,"
        f" with more schemes.\n\nIt is made by `{command}`: every number, and every sentence that"
        " depends on one, comes from the runs.\n\n"
    )
    text += failed(scenes)
    text += "## The schemes\n\n" + tables.markdown(schemes(scenes)) + "\n\n"
    text += (
        "## What the runs say\n\n"
        + "".join(f"* {sentence}\n" for sentence in statements.summary(scenes))
        + "\n"
    )
    for geometry, rows in beside.items():
        text += (
            f"## Numbers and words of the paper: Geometry {geometry}\n\n{tables.markdown(rows)}\n\n"
        )
    for scene in scenes:
        text += scene_part(scene, pictures[scene.study.name])
    text += (
        "## Order of the schemes\n\nRanks by roughness of the force, energy drift and penetration,"
        " the smallest first; the table is sorted by the sum of the three ranks. What matters to"
        " you may be only one of them.\n\n"
    )
    for scene in scenes:
        text += f"### {scene.study.title}: ranks\n\n{tables.markdown(ranking(scene))}\n\n"
    for scene in scenes:
        text += f"## All observations: {scene.study.title}\n\n{tables.markdown(scene.table())}\n\n"
    return wrapped(text + "## How it was measured\n\n" + MEASURES)
