# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Texts of scenes whose contact follows the motion: bodies of one material, what they meet, and how
long. Bodies and obstacles are lists of lines `set Key = value`.
"""

SCENE = """
set Dimension = {dimension}
subsection Time
  set Scheme    = {scheme}
  set Step size = {step}
  set End time  = {end}
end
subsection Bodies
  set Names = {names}
{bodies}end
{obstacles}subsection Contact
  set Motion = follow
  set Pairs  = {pairs}
{laws}end
"""

MATERIAL = ("set Young's modulus = 1000", "set Poisson's ratio = 0.3", "set Density = 1")


def section(name, lines):
    """A subsection of a section."""
    return f"  subsection {name}\n" + "".join(f"    {line}\n" for line in lines) + "  end\n"


def entries(**values):
    """Lines `set Key = value`; an underscore stands for a blank."""
    return [f"set {key.replace('_', ' ')} = {value}" for key, value in values.items()]


def body(name, *keys):
    return name, section(name, MATERIAL + keys)


def disc(name, centre, *keys, level=3):
    """Or a ball, by its centre; the radius is 1."""
    ball = entries(Shape="ball", Centre=centre, Radius=1, Refinements=level)
    return body(name, *ball, *keys)


def box(name, lower, upper, cells, *keys):
    shape = entries(Shape="box", Lower_corner=lower, Upper_corner=upper, Repetitions=cells)
    return body(name, *shape, *keys)


def block_on_rails(*keys):
    """Its bottom moves along itself only."""
    return box("block", "0, 0", "1, 1", "4, 4", "set Dirichlet = 2: -; 0", *keys)


def obstacles(lines):
    """The section of obstacles; lines by name."""
    sections = "".join(section(name, values) for name, values in lines.items())
    return f"subsection Obstacles\n  set Names = {', '.join(lines)}\n{sections}end\n"


def friction(pair, coefficient):
    """The law of a pair."""
    return section(pair, entries(Friction_coefficient=coefficient))


def scene(
    bodies, pairs, end, scheme="contact-implicit", step=0.01, *, obstacles="", laws="", dimension=2
):
    """The text of a scene."""
    return SCENE.format(
        dimension=dimension,
        scheme=scheme,
        step=step,
        end=end,
        names=", ".join(name for name, _ in bodies),
        bodies="".join(text for _, text in bodies),
        obstacles=obstacles,
        pairs=", ".join(pairs),
        laws=laws,
    )
