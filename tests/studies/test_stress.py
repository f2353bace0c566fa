#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The judge of extreme scenes finds what it is for. A run that keeps all laws, made by hand, is
broken in one place at a time, and only the law of this place complains; ends of all kinds get their
verdicts; and real runs are judged by promises that they cannot keep.
"""

import copy
import csv
import math
import pathlib
import sys
import types
import unittest

import check_history

sys.path.insert(0, str(check_history.SOURCE / "tools"))
from stress import families, laws, running, scenes, table, verdict  # noqa: E402
from studies import tables  # noqa: E402

CONSERVES = {"energy": "conserves", "penetrates": False, "predictor": False}
#: A point of mass 2 comes down with speed 3, is stopped for a step, and goes up with speed 3; it
#: slides with friction while it is stopped.
SLIDING = scenes.impact(friction=0.5)
MASS, STEP, SPEED, FRICTION = 2.0, 0.1, 3.0, 4.0
MOMENTA = [-MASS * SPEED, 0.0, MASS * SPEED]
FORCES = [0.0, MASS * SPEED / STEP, MASS * SPEED / STEP]
KINETIC = [9.0, 0.0, 9.0 - FRICTION]


def no_motion(*names):
    """Columns of zeros."""
    return {name: [0.0] * 3 for name in names}


def bounce():
    """The run, with all its tables."""
    columns = no_motion(
        *("work_external", "work_damping", "energy_transfer", "energy_residual", "max_penetration"),
        *("body_upper_momentum_x", "body_upper_velocity_x", "body_upper_velocity_z"),
        *("body_upper_momentum_z", "pair_0_force_x", "fallbacks", "rejected_steps"),
    )
    columns |= {
        "step": [0.0, 1.0, 2.0],
        "step_size": [0.0, STEP, STEP],
        "kinetic_energy_modified": KINETIC,
        "elastic_energy": [0.0, KINETIC[0] - FRICTION / 2, 0.0],
        "work_friction": [0.0, -FRICTION / 2, -FRICTION / 2],
        "body_upper_momentum_y": MOMENTA,
        "body_upper_velocity_y": [momentum / MASS for momentum in MOMENTA],
        "pair_0_force_y": FORCES,
        "contact_force": FORCES,
        "active_nodes": [0.0, 1.0, 1.0],
        "active_set_iterations": [0.0, 2.0, 4.0],
        "linear_iterations": [0.0, 5.0, 6.0],
    }
    columns["total_energy_modified"] = [
        k + e for k, e in zip(columns["kinetic_energy_modified"], columns["elastic_energy"])
    ]
    probe = no_motion("gap", "tangential_force_y", "tangential_force_z")
    probe |= {"normal_force": FORCES, "tangential_force_x": [0.5 * force for force in FORCES]}
    return types.SimpleNamespace(
        scene=SLIDING,
        scheme=dict(CONSERVES),
        accuracy=laws.ACCURACY,
        columns=copy.deepcopy(columns),
        probes={"p0": copy.deepcopy(probe)},
    )


class Laws(unittest.TestCase):
    def setUp(self):
        self.run_by_hand = bounce()

    def expect(self, *names):
        self.assertEqual(set(laws.broken(self.run_by_hand)), set(names))

    def set(self, column, row, value):
        """Another value in a table, or in that of the probe."""
        probe = self.run_by_hand.probes["p0"]
        (probe if column in probe else self.run_by_hand.columns)[column][row] = value

    def test_a_right_run_breaks_none(self):
        self.expect()

    def test_each_law_finds_its_own(self):
        big = 1e-7
        for law, column, row, value in (
            ("ledger", "energy_residual", 1, 9 * big),
            ("energy", "total_energy_modified", 2, KINETIC[2] + 9 * big),
            ("energy", "total_energy_modified", 2, KINETIC[2] - 9 * big),
            ("momentum", "body_upper_momentum_y", 2, MOMENTA[2] * (1 + big)),
            ("momentum", "pair_0_force_x", 1, big * FORCES[1]),
            ("depth", "max_penetration", 2, 1e-8),
            ("gap", "gap", 1, 1e-8),
            ("adhesion", "normal_force", 0, -1e-4),
            ("coulomb", "tangential_force_x", 1, 0.500001 * FORCES[1]),
            ("coulomb", "tangential_force_z", 0, 1e-4),
            ("finite", "elastic_energy", 1, math.nan),
            ("finite", "gap", 1, math.inf),
        ):
            with self.subTest(law=law, column=column):
                self.setUp()
                self.set(column, row, value)
                self.expect(*({law, "coulomb"} if law == "adhesion" else {law}))

    def test_friction_that_pushes(self):
        """The energy that it brings is in the ledger, and still against the law."""
        columns = self.run_by_hand.columns
        columns["work_friction"][2] = 1.0
        columns["total_energy_modified"][2] += 1.0 + FRICTION / 2
        self.expect("friction")

    def test_what_is_not_promised_is_not_asked(self):
        self.set("total_energy_modified", 2, 100.0)
        self.set("max_penetration", 2, 0.1)
        self.set("gap", 1, 0.1)
        self.run_by_hand.scheme = {"energy": "none", "penetrates": True, "predictor": False}
        self.expect()

    def test_a_scheme_that_dissipates_may_lose(self):
        self.run_by_hand.scheme["energy"] = "dissipates"
        self.set("total_energy_modified", 2, 1.0)
        self.expect()

    def test_weight_and_supports_are_forces(self):
        weight = {"Bodies/upper/Body force": "0.0; -10.0"}
        self.run_by_hand.scene = scenes.changed(SLIDING, weight)
        self.expect("momentum")
        self.run_by_hand.columns["support_upper_3_y"] = [10.0 * MASS] * 3
        self.expect()


class Verdicts(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(check_history.settings["folder"]) / "verdicts"
        (self.folder / "output").mkdir(parents=True, exist_ok=True)
        self.write(bounce().columns)

    def write(self, columns):
        with open(self.folder / "output" / "history.csv", "w", newline="", encoding="utf-8") as f:
            csv.writer(f).writerows([list(columns), *zip(*columns.values())])

    def judge(self, status, messages=""):
        ending = running.Ending(status, messages, 1.0)
        return verdict.judge(ending, self.folder / "output", SLIDING, CONSERVES)

    def expect(self, outcome, status, messages="", why=""):
        found = self.judge(status, messages)
        self.assertEqual(found.outcome, outcome, found)
        self.assertIn(why, found.why)

    def test_ends(self):
        self.expect(verdict.FINISHED, 0)
        strained = "signorini: warning: the body 'a' is 7 % strained at one place. Strains are"
        self.expect(verdict.WARNED, 0, strained, "strained")
        self.expect(verdict.REFUSED, 1, "a library\nsignorini: the run failed: too far", "too far")
        self.expect(verdict.REFUSED, 2, "signorini: mistake", "mistake")
        self.expect(verdict.WRONG, 1, "no message of its own", "exit status 1")
        self.expect(verdict.WRONG, 1, strained, "exit status 1")
        self.expect(verdict.WRONG, 134, "signorini: aborted", "134")
        self.expect(verdict.WRONG, -11, "", "signal 11")
        self.expect(verdict.WRONG, None, "no end after 3 s", "no end")

    def test_without_a_table(self):
        (self.folder / "output" / "history.csv").unlink()
        self.expect(verdict.REFUSED, 2, "signorini: mistake")
        self.expect(verdict.WRONG, 0, "", "no table")

    def test_a_law_broken_in_silence_is_wrong(self):
        columns = bounce().columns
        columns["total_energy_modified"][2] += 1e-3
        self.write(columns)
        self.expect(verdict.WRONG, 0, "", "gains")
        self.expect(verdict.WRONG, 1, "signorini: the run failed", "gains")
        self.expect(verdict.WRONG, 0, "warning: the body 'a' is 7 % strained", "gains")
        said = "warning: contact brought 3 % of the energy in one step"
        self.expect(verdict.WARNED, 0, said, "contact brings energy")
        self.assertIn("energy", self.judge(0, said).laws)

    def test_the_table_shows_the_worst(self):
        family = families.FAMILIES[0]
        lines = [
            table.row(family, 1.0, {"name": name}, self.judge(*end), 1.0)
            for name, end in (("a", (0,)), ("b", (-11,)), ("c", (2, "signorini: why not")))
        ]
        self.assertEqual(
            table.condensed(lines),
            ["1", "fXR", "0e+00", "all", "3.0, 4", "signal 11: no message"],
        )
        self.assertIn(f"**{family.name}**", table.markdown(lines, families.FAMILIES))
        table.write(lines, self.folder / "table.csv")
        self.assertEqual(tables.read_rows(self.folder / "table.csv"), lines)


class RealRuns(unittest.TestCase):
    def judge(self, name, scene, scheme, **promise):
        """The verdict about a scheme, with other promises than its own or a scene of other keys."""
        known = {entry["name"]: entry for entry in running.schemes(self.executable)}
        folder = pathlib.Path(check_history.settings["folder"]) / name
        real = scenes.changed(scene, scenes.keys_of(known[scheme]))
        ending = running.run(self.executable, real.text(), folder, 100.0)
        told = scenes.changed(scene, promise.pop("settings", {}))
        return verdict.judge(ending, folder / "output", told, known[scheme] | promise)

    @property
    def executable(self):
        return check_history.settings["executable"]

    def test_energy_and_depth(self):
        scene = scenes.impact(courant=5.0)
        self.assertEqual(self.judge("newmark", scene, "newmark").laws, {})
        self.assertIn("energy", self.judge("gain", scene, "newmark", energy="dissipates").laws)
        loss = self.judge("loss", scene, "contact-stabilized", energy="conserves")
        self.assertEqual(loss.outcome, verdict.WRONG)
        self.assertIn("loses", loss.why)
        depth = self.judge("depth", scene, "laursen-chawla", penetrates=False)
        self.assertIn("depth", depth.laws)

    def test_momentum_and_friction(self):
        """The judge is told of a weight and of less friction than there are."""
        scene = scenes.impact(sideways=0.02, friction=0.5, master=(4, 3))
        known = self.judge("right", scene, "contact-stabilized")
        self.assertEqual(known.laws, {})
        self.assertGreater(known.numbers["contacts"], 0)
        for law, key, value in (
            ("momentum", "Bodies/lower/Body force", "0.0; -1e-6"),
            ("coulomb", "Contact/upper : lower/Friction coefficient", 0.45),
        ):
            found = self.judge(law, scene, "contact-stabilized", settings={key: value})
            self.assertEqual(set(found.laws), {law})

    def test_a_refusal_has_a_reason(self):
        scene = scenes.changed(scenes.impact(), {"Bodies/upper/Density": -1})
        refused = self.judge("refused", scene, "contact-stabilized")
        self.assertEqual(refused.outcome, verdict.REFUSED)
        self.assertIn("Density", refused.why)


if __name__ == "__main__":
    check_history.main()
