# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Runs scenes with the real executable and checks what theory promises of every row of history.csv.

Only the standard library. A test calls main(), which takes EXECUTABLE and FOLDER (for results) from
the command line.
"""

import csv
import itertools
import os
import pathlib
import shutil
import subprocess
import sys
import unittest

SOURCE = pathlib.Path(__file__).resolve().parents[2]
PARAMETERS = SOURCE / "parameters"
SCHEMES = ("newmark", "contact-implicit", "contact-stabilized")
#: Beyond the ones above; some penetrate by design.
FURTHER_SCHEMES = (
    "laursen-chawla",
    "laursen-love",
    "contact-stabilized-projected",
    "hht-alpha",
    "generalized-alpha",
    "moreau-jean",
    "nonsmooth-generalized-alpha",
    "backward-euler",
)
#: With contact nodes that have no mass.
MASSLESS_SCHEMES = ("khenous-laborde-renard", "hager-hueeber-wohlmuth")
ALL_SCHEMES = SCHEMES + FURTHER_SCHEMES + MASSLESS_SCHEMES
#: Energy never grows with these.
DISSIPATIVE = ("contact-implicit", "contact-stabilized")
#: What the solver promises, relative to the energy of the motion.
ACCURACY = 1e-10
TIMEOUT = 900

settings = {"executable": "", "folder": ""}


def scene_file(name):
    """A scene of parameters/ or of a folder in it."""
    return next(PARAMETERS.rglob(f"{name}.prm"))


def on_floor(*surfaces, more=""):
    """The sections of a floor at height 0, in 2d, and of what may touch it; `more` pairs follow."""
    pairs = ", ".join(f"{surface} : floor" for surface in surfaces)
    return f"""subsection Obstacles
  set Names = floor
  subsection floor
    set Normal = 0, 1
  end
end
subsection Contact
  set Pairs = {pairs}{more}
end
"""


def box_on_floor(coefficient, time, box):
    """The text of a scene in 3d: a box with friction above a floor at height 0. time, box: lines
    "Key = value" of their sections."""

    def lines(values, blanks):
        return "".join(f"{blanks}set {value}\n" for value in values)

    return f"""set Dimension = 3
subsection Time
{lines(time, "  ")}end
subsection Bodies
  set Names = box
  subsection box
    set Shape = box
{lines(box, "    ")}  end
end
subsection Obstacles
  set Names = floor
  subsection floor
    set Normal = 0, 0, 1
  end
end
subsection Contact
  set Pairs = box : floor
  subsection box : floor
    set Friction coefficient = {coefficient}
  end
end
"""


def bar(name, *entries):
    """The section of a body in 2d that moves as a bar of length 10 with wave speed 30: without
    Poisson's ratio, one cell thick. Further entries: "key=value"."""
    entries = "".join(f"    set {entry}\n" for entry in entries)
    return f"""  subsection {name}
    set Shape           = box
    set Lower corner    = 0, 0
    set Upper corner    = 10, 0.1
    set Repetitions     = 100, 1
    set Young's modulus = 900
    set Poisson's ratio = 0
    set Density         = 1
{entries}  end
"""


def environment():
    """In which a scene runs, also by root and beside other runs."""
    return dict(
        os.environ,
        OMPI_ALLOW_RUN_AS_ROOT="1",
        OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
        OMP_NUM_THREADS="1",
    )


def command(scene, overrides=(), processes=1, options=()):
    """How a scene is run, without talk."""
    words = [settings["executable"], str(scene), "--quiet", *options]
    for override in overrides:
        words += ["--set", override]
    return (["mpirun", "--oversubscribe", "-np", str(processes)] if processes > 1 else []) + words


def last_process(pid):
    """Of a program that was started by mpirun: its last child."""
    children = pathlib.Path(f"/proc/{pid}/task/{pid}/children").read_text(encoding="utf-8").split()
    return int(children[-1])


def read_table(path):
    """The columns of a table by name."""
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    return {name: [float(row[name]) for row in rows] for name in rows[0]}


class Run:
    """A finished run: its history, its probes, and how it was called."""

    def __init__(self, scene, name, overrides=(), processes=1):
        """scene: a file, or the text of one."""
        self.folder = pathlib.Path(settings["folder"]) / name
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)
        if isinstance(scene, str):
            (self.folder / "written.prm").write_text(scene, encoding="utf-8")
            scene = self.folder / "written.prm"
        output = f"Output directory={self.folder / 'output'}"
        result = subprocess.run(
            command(scene, (output, "Output/VTU=false", *overrides), processes),
            env=environment(),
            capture_output=True,
            text=True,
            timeout=TIMEOUT,
            check=False,
        )
        if result.returncode != 0:
            raise AssertionError(
                f"{name}: exit status {result.returncode}\n{result.stdout}\n{result.stderr}"
            )
        self.log = (self.folder / "output" / "log.txt").read_text(encoding="utf-8")
        self.history = self.table("history")
        self.probes = {
            path.stem[len("probe_") :]: read_table(path)
            for path in sorted((self.folder / "output").glob("probe_*.csv"))
        }

    def __getitem__(self, column):
        return self.history[column]

    def __len__(self):
        return len(self.history["step"])

    def table(self, name):
        """The columns of a table beside the history."""
        return read_table(self.folder / "output" / f"{name}.csv")

    def vector(self, quantity, row):
        """The components x, y, z of a quantity in a row."""
        return [self.history[f"{quantity}_{axis}"][row] for axis in "xyz"]

    def energy_scales(self, driven):
        """The scale of errors of energy in each row: the initial energy, or if the motion is
        driven, the largest one so far."""
        motion = [k + e for k, e in zip(self["kinetic_energy"], self["elastic_energy"])]
        return list(itertools.accumulate(motion, max)) if driven else [motion[0]] * len(self)

    def energy_change(self):
        """Of the total energy between start and end, relative to the start."""
        return self["total_energy"][-1] / self["total_energy"][0] - 1

    def impulse(self):
        """Of the contact forces, sum of force times step."""
        return sum(force * step for force, step in zip(self["contact_force"], self["step_size"]))


class SceneTest(unittest.TestCase):
    """Checks that hold for each scene. Failures name row and value."""

    def expect_valid(self, task):
        """The scene of a study with the keys of one of its runs."""
        sets = [
            part for key, value in task.settings.items() for part in ("--set", f"{key}={value}")
        ]
        done = subprocess.run(
            [settings["executable"], str(task.study.scene), "--validate", *sets],
            capture_output=True,
            text=True,
            timeout=TIMEOUT,
            check=False,
        )
        self.assertEqual(done.returncode, 0, f"{task.study.path}, {task.name}: {done.stderr}")

    def expect_close(self, value, expected, relative, what):
        self.assertLessEqual(
            abs(value - expected), relative * abs(expected), f"{what}: {value}, expected {expected}"
        )

    def expect_ledger_closes(self, run, driven=False, accuracy=ACCURACY):
        """Energy identity of the scheme: the works of a step explain its change of energy."""
        scales = run.energy_scales(driven)
        for row, residual in enumerate(run["energy_residual"]):
            self.assertLessEqual(
                abs(residual), accuracy * scales[row], f"energy residual in row {row}"
            )

    def expect_no_gain_of_energy(self, run, driven=False):
        """What the outside world does not bring never adds to the energy, and both dissipative
        terms have their sign."""
        scales = run.energy_scales(driven)
        for row in range(1, len(run)):
            tolerance = ACCURACY * scales[row]
            change = (
                run["total_energy"][row] - run["total_energy"][row - 1] - run["work_external"][row]
            )
            self.assertLessEqual(
                run["work_contact"][row], tolerance, f"work of contact in row {row}"
            )
            self.assertLessEqual(
                run["work_predictor"][row], tolerance, f"work of predictor in row {row}"
            )
            self.assertLessEqual(change, tolerance, f"gain of energy in row {row}")

    def expect_losses(self, run, accuracy=ACCURACY):
        """Of energies, relative to the largest one of the whole run, as it may begin at rest: the
        ledger closes; contact, predictor, friction and changes of the mesh give none."""
        tolerance = accuracy * max(run["kinetic_energy"] + run["elastic_energy"])
        self.assertLess(max(map(abs, run["energy_residual"])), tolerance, "energy residual")
        for column in ("work_contact", "work_predictor", "work_friction", "energy_transfer"):
            self.assertLess(max(run[column]), tolerance, column)

    def expect_no_penetration(self, run, size):
        for row, depth in enumerate(run["max_penetration"]):
            self.assertLessEqual(depth, 1e-10 * size, f"penetration in row {row}")

    def expect_pressure(self, run, direction=None):
        """Contact only presses: probes feel no tension, and on a plane the forces add up to the
        resultant along `direction`."""
        largest = max(run["contact_force"])
        for name, probe in run.probes.items():
            self.assertGreaterEqual(min(probe["pressure"]), 0.0, f"tension at the probe {name}")
        if direction is None:
            return
        for row, force in enumerate(run["contact_force"]):
            for resultant, component in zip(run.vector("contact_force", row), direction):
                self.assertLessEqual(
                    abs(resultant - component * force), 1e-12 * largest, f"resultant in row {row}"
                )

    def expect_balance_of_momentum(self, run, scheme, load):
        """p_new - p = tau (contact force + load); the classical scheme takes the mean of old and
        new contact force.

        load(start, end): mean load of a step.
        """
        scale = max(
            abs(component) for row in range(len(run)) for component in run.vector("momentum", row)
        )
        for row in range(1, len(run)):
            old, new = run.vector("momentum", row - 1), run.vector("momentum", row)
            external = load(run["time"][row - 1], run["time"][row])
            force, old_force = run.vector("contact_force", row), run.vector(
                "contact_force", row - 1
            )
            for c in range(3):
                contact = 0.5 * (force[c] + old_force[c]) if scheme == "newmark" else force[c]
                error = new[c] - old[c] - run["step_size"][row] * (contact + external[c])
                self.assertLessEqual(
                    abs(error), ACCURACY * scale, f"momentum {'xyz'[c]} in row {row}"
                )

    def expect_contact(self, run):
        """A scene without contact would pass all of these for nothing."""
        self.assertGreater(max(run["active_nodes"]), 0)
        self.assertGreater(max(run["contact_force"]), 0.0)

    def expect_same_history(self, run, other, tolerance):
        """Agreement relative to the largest value of each kind of quantity; counts and times of the
        clock are left out."""
        kinds = {
            "energy": (
                "kinetic_energy",
                "elastic_energy",
                "external_energy",
                "total_energy",
                "work_contact",
                "work_predictor",
                "work_external",
            ),
            "momentum": ("momentum_x", "momentum_y", "momentum_z"),
            "angular momentum": (
                "angular_momentum_x",
                "angular_momentum_y",
                "angular_momentum_z",
                "angular_momentum_drift",
            ),
            "force": ("contact_force", "contact_force_x", "contact_force_y", "contact_force_z"),
        }
        self.assertEqual(len(run), len(other))
        self.assertEqual(run["active_nodes"], other["active_nodes"])
        for kind, columns in kinds.items():
            scale = max(abs(value) for column in columns for value in run[column])
            if (
                "momentum" in kind
            ):  # zero by symmetry in many scenes: what contact exchanges gives the scale
                scale = max(
                    [scale, run.impulse()]
                    + [abs(value) for column in kinds["momentum"] for value in run[column]]
                )
            for column in columns:
                for row, (a, b) in enumerate(zip(run[column], other[column])):
                    self.assertLessEqual(
                        abs(a - b), tolerance * scale, f"{column} in row {row}: {a} and {b}"
                    )
        for name, probe in run.probes.items():
            for column, values in probe.items():
                scale = max(abs(value) for value in values)
                if column == "normal_velocity":  # may be round-off only, while a node is held
                    scale = max(
                        scale,
                        max(abs(value) for value in probe["normal_displacement"])
                        / run["step_size"][-1],
                    )
                for row, (a, b) in enumerate(zip(values, other.probes[name][column])):
                    self.assertLessEqual(
                        abs(a - b), tolerance * scale, f"probe {name}, {column} in row {row}"
                    )


def main():
    """python3 test.py EXECUTABLE FOLDER [unittest arguments]"""
    settings["executable"], settings["folder"] = sys.argv[1:3]
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
