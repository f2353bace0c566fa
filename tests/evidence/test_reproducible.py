#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The same scene on the same number of processes gives the same bits, because no sum depends on
which message comes first, and nothing on the clock or on addresses; and what a run leaves in its
folder is enough to get them again, elsewhere and later.
"""

import csv
import hashlib
import subprocess
import unittest

import check_history

#: A disc is thrown obliquely on a floor: it sticks and slips; mesh and steps follow.
ADAPTIVE = """
set Dimension = 2
subsection Time
  set Step size         = 4e-3
  set End time          = 0.06
  set Step size control = force
  set Step tolerance    = 0.1
end
subsection Bodies
  set Names = disc
  subsection disc
    set Shape            = ball
    set Centre           = 0, 1.02
    set Refinements      = 2
    set Young's modulus  = 500
    set Poisson's ratio  = 0.3
    set Initial velocity = 1; -2
  end
end
subsection Obstacles
  set Names = floor
  subsection floor
    set Normal = 0, 1
  end
end
subsection Contact
  set Pairs = disc : floor
  subsection disc : floor
    set Friction coefficient = 0.3
  end
end
subsection Adaptivity
  set Indicator     = residual
  set Maximum level = 5
end
"""


def tables(run):
    """The text of all tables of a run, without what the clock says."""
    result = {}
    for path in sorted((run.folder / "output").glob("*.csv")):
        with open(path, newline="", encoding="utf-8") as file:
            rows = list(csv.reader(file))
        kept = [i for i, name in enumerate(rows[0]) if name != "wall_time"]
        result[path.name] = [[row[i] for i in kept] for row in rows]
    return result


class Reproducible(check_history.SceneTest):
    def test_same_bits_twice(self):
        for processes in (1, 2):
            one, two = (
                check_history.Run(ADAPTIVE, f"twice-{processes}-{n}", processes=processes)
                for n in (1, 2)
            )
            self.expect_contact(one)
            self.assertGreater(max(one["slip_nodes"]), 0)
            self.assertGreater(len(set(one["cells"])), 2, "the mesh did not follow")
            self.assertGreater(len(set(one["step_size"])), 2, "the steps did not follow")
            self.assertEqual(tables(one), tables(two))

    def test_a_run_is_repeated_from_its_folder(self):
        first = check_history.Run(
            check_history.scene_file("hammer_and_anvil"), "first", ["Time/End time=0.05"]
        )
        self.expect_contact(first)
        for copy in ("scene", "parameters"):
            again = check_history.Run(first.folder / "output" / f"{copy}.prm", f"again-{copy}")
            self.assertEqual(tables(first), tables(again))

    def test_log_tells_where_a_run_comes_from(self):
        scene = check_history.scene_file("hammer_and_anvil")
        run = check_history.Run(scene, "told", ["Time/End time=0.01"], processes=2)
        version = subprocess.run(
            [check_history.settings["executable"], "--version"],
            capture_output=True,
            text=True,
            timeout=check_history.TIMEOUT,
            check=True,
        ).stdout.strip()
        self.assertRegex(version, r"commit ([0-9a-f]{12}(-modified)?|unknown) \(deal\.II")
        self.assertTrue(run.log.startswith(version), run.log)
        meshes = sorted((scene.parent / "meshes").glob("*"))
        self.assertTrue(meshes)
        for part in (
            str(scene),
            '--set "Time/End time=0.01"',
            "p4est",
            "Trilinos",
            "SUNDIALS",
            "MPI v",
            "2 processes",
        ):
            self.assertIn(part, run.log)
        for line in run.log.splitlines():
            if line.startswith("  mesh  "):
                named = line.split(maxsplit=1)[1]
                with open(named, "rb") as file:
                    self.assertIn(hashlib.sha256(file.read()).hexdigest(), run.log)
        self.assertEqual(run.log.count("SHA-256"), 2)


if __name__ == "__main__":
    check_history.main()
