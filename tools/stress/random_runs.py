# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Runs of random scenes, each judged by the laws. A scene has a scene, a scheme (its entry in the
table of schemes), processes, and a title()."""

import argparse
import math
import pathlib

from . import laws, running
from .verdict import Judged

TIMEOUT = 600


def decades(source, lowest, highest):
    """A number whose logarithm is uniform."""
    return 10 ** source.uniform(math.log10(lowest), math.log10(highest))


def material(density, wave_speed, poisson):
    """The keys of a body in which waves of compression have this speed."""
    modulus = density * wave_speed**2 * (1 + poisson) * (1 - 2 * poisson) / (1 - poisson)
    return {"Young's modulus": modulus, "Poisson's ratio": poisson, "Density": density}


def main(description, make_scene, suits):
    """Run and report. @return 0 if no law was broken, and half of the scenes had contact
    make_scene: of number, seed and schemes; suits: which schemes of the table may be among them"""
    parser = argparse.ArgumentParser(description=description.split("\n", maxsplit=1)[0])
    parser.add_argument("executable")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--seed", default="1")
    parser.add_argument(
        "--accuracy", type=float, default=laws.ACCURACY, help="of the energy of a step"
    )
    parser.add_argument("--only", type=int, help="one scene by its number")
    arguments = parser.parse_args()
    schemes = [entry for entry in running.schemes(arguments.executable) if suits(entry)]
    numbers = range(arguments.count) if arguments.only is None else [arguments.only]
    n_broken = n_contact = 0
    for number in numbers:
        scene = make_scene(number, arguments.seed, schemes)
        folder = arguments.folder / str(number)
        ending = running.run(
            arguments.executable, scene.scene.text(), folder, TIMEOUT, scene.processes
        )
        if ending.status != 0:
            broken = [f"exit status {ending.status}: {ending.messages}"]
        else:
            run = Judged(folder / "output", scene.scene, scene.scheme, arguments.accuracy)
            broken = [text for texts in laws.broken(run).values() for text in texts]
            n_contact += max(run["contact_force"]) > 0
        if broken:
            n_broken += 1
            print(f"{scene.title()}\n  {folder}\n  " + "\n  ".join(broken), flush=True)
    print(f"{len(numbers)} scenes, {n_contact} with contact, {n_broken} that break a law")
    return 1 if n_broken or 2 * n_contact < len(numbers) else 0
