# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Random scenes, judged by the laws of mechanics.

Boxes and discs or balls hit a plane or each other: sizes from 1e-3 to 1e3, densities from 1e-3 to
1e4, wave speeds from 0.1 to 1e4, Courant numbers from 0.1 to 300, friction up to 10, every scheme
that takes steps, one and two bodies, a mesh that changes or not, one and two processes. Each must
end with status 0, explain its energy to 1e-9, gain none if its scheme promises so, and not
penetrate if its scheme promises so. The same seed and number give the same scene anywhere.

    ./dev stress [--count 1000] [--seed 1] [--only NUMBER]
"""

import argparse
import csv
import json
import math
import os
import pathlib
import random
import subprocess
import sys

#: Largest part of a step's energy without an explanation.
ACCURACY = 1e-9
N_STEPS = 25
TIMEOUT = 600


def decades(source, lowest, highest):
    """A number whose logarithm is uniform."""
    return 10 ** source.uniform(math.log10(lowest), math.log10(highest))


class RandomScene:
    """The text of a scene, and what it promises."""

    def __init__(self, number, seed, schemes):
        self.number = number
        self.source = source = random.Random(f"{seed}-{number}")
        self.scheme = source.choice(schemes)
        self.dimension = source.choice((2, 2, 3))
        self.size = decades(source, 1e-3, 1e3)
        self.courant = decades(source, 0.1, 300)
        self.n_cells = source.choice((4, 6, 8) if self.dimension == 2 else (2, 3))
        self.round = source.random() < 0.4
        self.two_bodies = source.random() < 0.4
        self.friction = 0.0
        if self.scheme["friction"] and source.random() < 0.5:
            self.friction = decades(source, 1e-2, 10)
        self.changing = self.scheme["changing_mesh"] and source.random() < 0.3
        self.processes = 2 if source.random() < 0.2 else 1
        self.density, self.wave_speed = decades(source, 1e-3, 1e4), decades(source, 0.1, 1e4)
        self.poisson = source.uniform(0, 0.45)
        self.step = self.courant * self.size / self.n_cells / self.wave_speed
        # A step moves a body by at most a fraction of itself, and a hit strains it a little.
        fastest = min(1e-2 * self.wave_speed, 2e-3 * self.size / self.step)
        self.speed = fastest * decades(source, 1e-3, 1)
        self.text = self.write()

    def vector(self, normal, tangential=0.0):
        """Components with the normal direction last."""
        return "; ".join([f"{tangential!r}"] + ["0"] * (self.dimension - 2) + [f"{normal!r}"])

    def body(self, name, offset, speed):
        """A body that rests on the height offset."""
        size, rest = self.size, self.dimension - 1
        modulus = (
            self.density
            * self.wave_speed**2
            * (1 + self.poisson)
            * (1 - 2 * self.poisson)
            / (1 - self.poisson)
        )
        if self.round:
            shape = f"""set Shape = ball
    set Centre = {", ".join(["0"] * rest + [repr(offset + size)])}
    set Radius = {size!r}
    set Refinements = {2 if self.dimension == 2 else 1}"""
        else:
            shape = f"""set Shape = box
    set Lower corner = {", ".join(["0"] * rest + [repr(offset)])}
    set Upper corner = {", ".join([repr(size)] * rest + [repr(offset + size)])}
    set Repetitions = {", ".join([str(self.n_cells)] * (rest + 1))}"""
        sideways = self.source.uniform(-0.5, 0.5) * speed if self.friction > 0 else 0.0
        return f"""  subsection {name}
    {shape}
    set Young's modulus = {modulus!r}
    set Poisson's ratio = {self.poisson!r}
    set Density = {self.density!r}
    set Initial velocity = {self.vector(speed, sideways)}
  end
"""

    def write(self):
        """All sections."""
        gap = self.source.uniform(0, 5) * self.speed * self.step
        height = 2 * self.size if self.round else self.size
        bodies = self.body("upper", gap, -self.speed)
        names, pair, obstacle = "upper", "upper : floor", ""
        if self.two_bodies:
            bodies += self.body("lower", -height, 0.0)
            names, pair = "upper, lower", "upper : lower"
        else:
            point = ", ".join(["0"] * self.dimension)
            normal = ", ".join(["0"] * (self.dimension - 1) + ["1"])
            obstacle = f"""subsection Obstacles
  set Names = floor
  subsection floor
    set Point = {point}
    set Normal = {normal}
  end
end
"""
        adaptivity = ""
        if self.changing:
            adaptivity = """subsection Adaptivity
  set Indicator = residual
  set Maximum level = 3
  set Maximum cells = 400
  set Steps between remeshings = 4
end
"""
        # Macro-elements, the usual construction of one of them, are not definite on every mesh.
        massless = ""
        if self.scheme["massless_nodes"] == "needed":
            massless = "\n  set Mass = redistributed\n  set Mass redistribution = extrapolation"
        friction = f"\n    set Friction coefficient = {self.friction!r}" if self.friction else ""
        return f"""set Dimension = {self.dimension}
subsection Time
  set Scheme = {self.scheme["name"]}{massless}
  set Step size = {self.step!r}
  set End time = {N_STEPS * self.step!r}
end
subsection Bodies
  set Names = {names}
{bodies}end
{obstacle}subsection Contact
  set Pairs = {pair}
  subsection {pair}{friction}
  end
end
{adaptivity}subsection Output
  set VTU = false
end
"""

    def title(self):
        """In words."""
        return (
            f"{self.number}: {self.scheme['name']}, {self.dimension}d"
            f"{', round' if self.round else ''}{', two bodies' if self.two_bodies else ''}"
            f"{f', friction {self.friction:.2g}' if self.friction else ''}"
            f"{', changing mesh' if self.changing else ''}, Courant number {self.courant:.2g},"
            f" size {self.size:.2g}, {self.processes} process(es)"
        )


def read(path):
    """The columns of a table."""
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    return {name: [float(row[name]) for row in rows] for name in rows[0]}


def run(executable, scene, folder):
    """(exit status, messages, history or None)"""
    folder.mkdir(parents=True, exist_ok=True)
    file = folder / "scene.prm"
    file.write_text(scene.text, encoding="utf-8")
    command = [executable, str(file), "--quiet", "--set", f"Output directory={folder / 'output'}"]
    if scene.processes > 1:
        command = ["mpirun", "--oversubscribe", "-np", str(scene.processes)] + command
    session = folder / "mpi"
    session.mkdir(exist_ok=True)
    environment = dict(
        os.environ,
        OMPI_ALLOW_RUN_AS_ROOT="1",
        OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
        OMP_NUM_THREADS="1",
        OMPI_MCA_orte_tmpdir_base=str(session),
    )
    try:
        result = subprocess.run(
            command, env=environment, capture_output=True, text=True, timeout=TIMEOUT, check=False
        )
    except subprocess.TimeoutExpired:
        return -1, f"no end after {TIMEOUT} s", None
    table = folder / "output" / "history.csv"
    history = read(table) if result.returncode == 0 else None
    return result.returncode, (result.stdout + result.stderr).strip(), history


def judge(scene, history, accuracy):
    """The laws that a run has broken, in words."""
    broken = []
    motion = [k + e for k, e in zip(history["kinetic_energy_modified"], history["elastic_energy"])]
    scale = max(motion)
    if not all(math.isfinite(value) for values in history.values() for value in values):
        return ["a value is not finite"]
    residual = max(map(abs, history["energy_residual"])) / scale
    if residual > accuracy:
        broken.append(f"{residual:.2g} of the energy has no explanation")
    gain = max(
        after - before
        for before, after in zip(
            history["total_energy_modified"], history["total_energy_modified"][1:]
        )
    )
    # A change of the mesh may have an energy of its own, which is a column.
    gain -= max(0.0, max(history["energy_transfer"]))
    if scene.scheme["energy"] == "dissipates" and gain > accuracy * scale:
        broken.append(f"a dissipative scheme gains {gain / scale:.2g} of the energy")
    depth = max(history["max_penetration"]) / scene.size
    if not scene.scheme["penetrates"] and depth > 1e-9:
        broken.append(f"penetration of {depth:.2g} of the size")
    return broken


def main():
    """Run and report. @return 0 if no law was broken"""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("executable")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--seed", default="1")
    parser.add_argument("--accuracy", type=float, default=ACCURACY, help="of the energy of a step")
    parser.add_argument("--only", type=int, help="one scene by its number")
    arguments = parser.parse_args()
    table = subprocess.run(
        [arguments.executable, "--print-schemes=json"], capture_output=True, text=True, check=True
    )
    # A scheme with a tolerance of its own keeps its energy up to that; without inertia, nothing can
    # be thrown.
    schemes = [
        entry for entry in json.loads(table.stdout) if entry["variable_step"] and entry["inertia"]
    ]
    numbers = range(arguments.count) if arguments.only is None else [arguments.only]
    n_broken = n_contact = 0
    for number in numbers:
        scene = RandomScene(number, arguments.seed, schemes)
        folder = arguments.folder / str(number)
        status, messages, history = run(arguments.executable, scene, folder)
        if history is None:
            broken = [f"exit status {status}: {messages}"]
        else:
            broken = judge(scene, history, arguments.accuracy)
            n_contact += max(history["contact_force"]) > 0
        if broken:
            n_broken += 1
            print(f"{scene.title()}\n  {folder}\n  " + "\n  ".join(broken), flush=True)
    print(f"{len(numbers)} scenes, {n_contact} with contact, {n_broken} that break a law")
    return 1 if n_broken or 2 * n_contact < len(numbers) else 0


if __name__ == "__main__":
    sys.exit(main())
