#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""What runs of bodies that meet say about themselves is right for the scene: remedies that it can
take, percentages of what there was to lose, counts that do not depend on the number of processes,
and impacts that can come."""

import itertools
import pathlib
import subprocess

import check_history
from following_scenes import box, disc, entries, friction, obstacles, scene

WEIGHT = "set Body force = 0; -1"
FLOOR = obstacles({"floor": entries(Normal="0, 1")})


def ring(level, end=0.5):
    """Three discs on a floor and on each other, each of which meets both others."""
    discs = [
        disc("a", "-1.04, 1", WEIGHT, level=level),
        disc("b", "1.04, 1", WEIGHT, level=level),
        disc("c", "0.04, 2.9", WEIGHT, "set Initial velocity = 0; -0.4", level=level),
    ]
    pairs = ["a : b", "b : c", "c : a", "a : floor", "b : floor"]
    return scene(discs, pairs, end, "contact-stabilized-projected", obstacles=FLOOR)


#: A block falls on two others that lie on each other.
PILE = scene(
    [
        box("one", "-0.3, 1.35", "0.3, 1.8", "5, 4", "set Initial velocity = 0.2; -1"),
        box("two", "-0.5, 0.8", "0.5, 1.3", "8, 4"),
        box("three", "-1, 0", "1, 0.75", "8, 3"),
    ],
    ["one : two", "two : three", "three : floor"],
    0.25,
    "contact-stabilized-projected",
    step=2e-3,
    obstacles=FLOOR,
    laws=friction("one : two", 0.3) + friction("two : three", 0.3),
)

#: An arm whose upper side is moved down to and along a floor, against friction.
ARM = scene(
    [
        box(
            "arm",
            "0, 0.05",
            "1, 0.45",
            "10, 4",
            "set Dirichlet = 3: 0.2*t + 0.4*t^2; -0.06*sin(pi/2*min(t, 1))",
        )
    ],
    ["arm : floor"],
    2,
    "contact-stabilized-projected",
    obstacles=FLOOR,
    laws=friction("arm : floor", 0.3),
)

#: Discs in a row, of which the first one flies at the others, which rest.
ROW = scene(
    [
        disc("a", "-0.2, 1.5", "set Initial velocity = 1; 0"),
        disc("b", "2, 1.5"),
        disc("c", "4.2, 1.5"),
    ],
    ["c : a", "a : b", "b : c"],
    6,
)


class Advice(check_history.SceneTest):
    def words_of(self, text, *overrides):
        """All that `--validate` says of a scene."""
        path = pathlib.Path(check_history.settings["folder"]) / "words.prm"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        command = [check_history.settings["executable"], str(path), "--validate"]
        for override in overrides:
            command += ["--set", override]
        result = subprocess.run(
            command,
            env=check_history.environment(),
            capture_output=True,
            text=True,
            timeout=300,
            check=False,
        )
        return result.stdout + result.stderr

    def test_remedies_of_linearised_contact(self):
        """Bodies that share nodes, and bodies that do not look at each other: where the scheme
        follows, the key helps; where it does not, only another scheme."""
        boxes = [box("a", "0, 3", "1, 4", "2, 2"), box("b", "3, 3", "4, 4", "2, 2")]
        apart = scene(boxes, ["a[2] : b"], 1)
        for text, reason in ((ring(2), "share the node"), (apart, "no face of the slave looks")):
            words = self.words_of(text, "Contact/Motion=linearised")
            self.assertIn(reason, words)
            self.assertIn("set `Contact/Motion = follow`", words)
            for motion in ("linearised", "automatic"):
                words = self.words_of(
                    text, "Time/Scheme=moreau-jean", f"Contact/Motion={motion}"
                )
                self.assertIn(reason, words)
                self.assertNotIn("set `Contact/Motion = follow`", words)
                self.assertIn("one of the schemes contact-stabilized-projected", words)

    def test_gaps_that_are_missed(self):
        """Coarse discs are warned of; finer ones are not, and steps of half the size change
        nothing, as what is told is that of a step."""
        parts = []
        for level, step in ((2, 0.01), (2, 0.005), (5, 0.01)):
            run = check_history.Run(ring(level), "ring", [f"Time/Step size={step}"])
            self.expect_contact(run)
            energy = max(k + e for k, e in zip(run["kinetic_energy"], run["elastic_energy"]))
            parts.append(max(map(abs, run["work_geometry"])) / energy)
            self.assertEqual("misses their true gaps" in run.log, parts[-1] > 0.01, run.log)
            self.assertEqual("missed gaps  " in run.log, parts[-1] > 1e-4, run.log)
        self.assertGreater(parts[0], 0.01)
        self.expect_close(parts[1], parts[0], 0.5, "half the steps")
        self.assertLess(parts[2], 0.01)

    def test_percentages_of_a_driven_arm(self):
        """It starts slowly, and friction takes several times the energy that it has at once.
        Percentages are those of what the drive has brought at most."""
        run = check_history.Run(ARM, "arm")
        brought = max(map(abs, itertools.accumulate(run["work_external"])))
        energy = max(k + e for k, e in zip(run["kinetic_energy"], run["elastic_energy"]))
        self.assertGreater(brought, 2 * energy)
        taken = -sum(run["work_contact"]) - sum(run["work_predictor"])
        self.assertLess(taken, 0.1 * brought)
        self.assertGreater(taken, 0.1 * run["total_energy"][0])
        self.assertNotIn("contact took", run.log)
        change = run["total_energy"][-1] - run["total_energy"][0]
        said = float(run.log.split("energy            changed by ")[1].split()[0])
        self.expect_close(said, 100 * change / brought, 1e-3, "per cent of the work of the drive")

    def test_counts_of_nodes_on_two_processes(self):
        """Forces agree to a part of 1e-9 of the largest one, and so do the numbers of nodes that
        have one, in pairs, too."""
        one, two = (check_history.Run(PILE, f"pile_{n}", processes=n) for n in (1, 2))
        self.expect_contact(one)
        largest = max(one["contact_force"])
        for a, b in zip(one["contact_force"], two["contact_force"]):
            self.assertLess(abs(a - b), 1e-8 * largest)
        for column in ("active_nodes", "stick_nodes", "slip_nodes"):
            self.assertEqual(one[column], two[column], column)

    def test_who_is_hit_first(self):
        """In a row of three the first one meets the second one, and not the third behind it; in
        its absence it does."""
        words = self.words_of(ROW)
        self.assertIn("first impact of 'a : b', at time 0.2", words)
        self.assertNotIn("'c : a'", words)
        words = self.words_of(ROW, "Bodies/b/Centre=2, 5")
        self.assertIn("first impact of 'c : a', at time 2.4", words)
        self.assertNotIn("first impact of 'a : b'", words)


if __name__ == "__main__":
    check_history.main()
