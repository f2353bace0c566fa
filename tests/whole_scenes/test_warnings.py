# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Results outside what the method can do are warned about while the run goes on, with the time, the
body and the remedy, also by a quiet run; and the summary judges what mesh and step can carry."""

import math
import pathlib
import subprocess

import check_history

#: A disc that spins at 2 rad/s above a floor, beside another one that rests.
SPINNING = """
set Dimension = 2
subsection Time
  set Step size = 5e-3
  set End time  = 0.2
end
subsection Bodies
  set Names = spinner, other
  subsection spinner
    set Shape            = ball
    set Centre           = 0, 3
    set Radius           = 1
    set Refinements      = 2
    set Young's modulus  = 5e4
    set Poisson's ratio  = 0.3
    set Density          = 1
    set Initial velocity = -2*(y - 3); 2*x
  end
  subsection other
    set Shape            = ball
    set Centre           = 5, 3
    set Radius           = 1
    set Refinements      = 1
    set Young's modulus  = 5e4
    set Poisson's ratio  = 0.3
    set Density          = 1
  end
end
""" + check_history.on_floor("spinner", "other")

#: A square that falls on a ball with its side turned away at first: it faces nothing.
BEHIND = """
set Dimension = 2
subsection Time
  set Step size = 1e-2
  set End time  = 0.4
end
subsection Bodies
  set Names = square
  subsection square
    set Shape            = box
    set Lower corner     = -0.1, 2
    set Upper corner     = 0.1, 2.2
    set Repetitions      = 2, 2
    set Young's modulus  = 500
    set Poisson's ratio  = 0.3
    set Density          = 1
    set Initial velocity = 0; -10
  end
end
subsection Obstacles
  set Names = ball
  subsection ball
    set Shape  = sphere
    set Centre = 0, 0
    set Radius = 1
  end
end
subsection Contact
  set Motion = linearised
  set Pairs = square[3] : ball
end
"""

#: A box below the height of a table moves into its side.
SIDEWAYS = """
set Dimension = 2
subsection Time
  set Step size = 5e-3
  set End time  = 1.6
end
subsection Bodies
  set Names = box
  subsection box
    set Shape            = box
    set Lower corner     = -3, -0.5
    set Upper corner     = -2, 0.5
    set Repetitions      = 4, 4
    set Young's modulus  = 1000
    set Poisson's ratio  = 0.3
    set Density          = 1
    set Initial velocity = 1; 0
  end
end
subsection Obstacles
  set Names = table
  subsection table
    set Normal = 0, 1
    set Extent = 2
  end
end
subsection Contact
  set Motion = linearised
  set Pairs = box[2] : table
end
"""

#: The first bending vibration of a cantilever, 78 steps long: E I = 1000/12, L = 20.
BENDING = """
set Dimension = 2
subsection Time
  set Step size = 1
  set End time  = 300
end
subsection Bodies
  set Names = beam
  subsection beam
    set Shape            = box
    set Lower corner     = 0, 0
    set Upper corner     = 20, 1
    set Repetitions      = 80, 4
    set Young's modulus  = 1000
    set Poisson's ratio  = 0
    set Density          = 1
    set Initial velocity = 0; 1e-4*x^2
    set Dirichlet        = 0: 0; 0
  end
end
"""


class Warnings(check_history.SceneTest):
    def run_quietly(self, name, scene, overrides=()):
        """(result, folder) of a quiet run."""
        folder = pathlib.Path(check_history.settings["folder"]) / name
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "scene_in.prm").write_text(scene, encoding="utf-8")
        command = [check_history.settings["executable"], str(folder / "scene_in.prm"), "--quiet"]
        for override in [f"Output directory={folder / 'output'}", *overrides]:
            command += ["--set", override]
        result = subprocess.run(command, capture_output=True, text=True, timeout=300, check=False)
        return result, folder / "output"

    def expect_warning(self, text, *parts):
        lines = [line for line in text.splitlines() if "warning: " in line]
        self.assertTrue(
            any(all(part in line for part in parts) for line in lines), f"{parts}\n{text}"
        )

    def test_a_body_that_turns(self):
        """3 degrees are reached after 0.0262 units of time, in the sixth step; the disc that rests
        is not blamed."""
        result, folder = self.run_quietly("turns", SPINNING)
        self.assertEqual((result.returncode, result.stdout), (0, ""), result.stderr)
        self.expect_warning(result.stderr, "at time 0.03 ", "'spinner'", "degrees turned")
        self.expect_warning(result.stderr, "since time 0.03 ", "the most of the run")
        self.assertNotIn("'other'", result.stderr)
        log = (folder / "log.txt").read_text(encoding="utf-8")
        self.expect_warning(log, "at time 0.03 ", "'spinner'")
        degrees = float(
            next(line for line in log.splitlines() if "the most of" in line)
            .split("'spinner' is ")[1]
            .split()[0]
        )
        self.expect_close(degrees, math.degrees(2 * 0.2), 0.01, "2 rad/s for 0.2")

    def test_condensation_that_is_asked_for_in_vain(self):
        sliding = check_history.scene_file("sliding_block")
        pressed = check_history.scene_file("static_hertz")
        note = "`Solver/Condensation = always` has no effect"
        short = ["Time/End time=0.02"]
        for name, scene, overrides, processes, reason in (
            ("here", sliding, short, 1, None),
            ("processes", sliding, short, 2, "on several processes"),
            ("static", pressed, [], 1, "Scheme = static"),
        ):
            with self.subTest(name=name):
                overrides = [*overrides, "Solver/Condensation=always"]
                run = check_history.Run(scene, f"condensed_{name}", overrides, processes)
                self.assertEqual(note in run.log, reason is not None)
                self.assertEqual("steps were solved for contact nodes" in run.log, reason is None)
                if reason is not None:
                    self.assertIn(reason, next(x for x in run.log.splitlines() if note in x))

    def test_more_processes_than_a_plane_scene_wants(self):
        """A factor is for one process. It has to pay: not for two steps."""
        note = "on one process the steps of this scene would be solved for the contact nodes alone"
        scene = check_history.scene_file("sliding_block")
        for end, processes, expected in ((1, 2, True), (1, 1, False), (0.002, 2, False)):
            with self.subTest(end=end, processes=processes):
                folder, step = f"alone_{end}_{processes}", "Time/Step size=1e-3"
                overrides = [f"Time/End time={end}", step, "Output/VTU=false"]
                run = check_history.Run(scene, folder, overrides, processes)
                self.assertEqual(note in run.log, expected)

    def test_a_run_may_stop_at_its_first_warning(self):
        """With the row of that step, the sixth, although only each fourth is due."""
        result, folder = self.run_quietly(
            "stops", SPINNING, ["Time/Stop on warning=true", "Output/History every=4"]
        )
        self.assertEqual(result.returncode, 1)
        self.assertIn("Stop on warning", result.stderr)
        history = check_history.read_table(folder / "history.csv")
        self.assertAlmostEqual(history["time"][-1], 0.03)
        self.assertEqual(len(list(folder.glob("*.pvd"))), 2)
        self.assertIn('timestep="0.03', (folder / "volume.pvd").read_text(encoding="utf-8"))

    def test_nodes_that_face_no_obstacle_are_watched(self):
        """The upper side has no contact node, and is a radius deep when the run ends."""
        result, _ = self.run_quietly("behind", BEHIND)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.expect_warning(result.stderr, "no node can come into contact")
        self.expect_warning(result.stderr, "'square'", "deep in an obstacle", "linearised")

    def test_a_body_that_meets_the_side_of_a_plane_gains_energy(self):
        """Its front nodes get a bound when they are above the table, and are inside it then."""
        result, folder = self.run_quietly("sideways", SIDEWAYS)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.expect_warning(result.stderr, "contact brought", "of the energy in one step")
        self.expect_warning(result.stderr, "'box'", "deep in an obstacle")
        energy = check_history.read_table(folder / "history.csv")["total_energy"]
        gain = max(new - old for old, new in zip(energy, energy[1:]))
        self.assertGreater(gain, 0.1 * energy[0])

    def test_damping_of_a_vibration_that_steps_resolve(self):
        """The Courant number, 126, asks for `Spectral radius = 0.6`, a stiffness damping of
        b = 1/8, and the steps resolve the vibration: omega = 3.516 sqrt(EI/(rho A L^4)) = 0.0802,
        so that exp(-b omega^2 t) of its energy is left."""
        result, folder = self.run_quietly("bending", BENDING)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.expect_warning(result.stderr, "the damping of the scheme took", "Spectral radius")
        energy = check_history.read_table(folder / "history.csv")["total_energy"]
        self.expect_close(energy[-1] / energy[0], math.exp(-0.125 * 0.0802**2 * 300), 0.03, "left")
        result, _ = self.run_quietly("undamped", BENDING, ["Time/Spectral radius=1"])
        self.assertNotIn("damping of the scheme", result.stderr)

    def test_a_mesh_that_is_too_coarse_for_its_contact(self):
        """One node of a coarse ball carries the contact; a step that is too long leaves it a few
        steps."""
        result, folder = self.run_quietly(
            "coarse",
            check_history.scene_file("geometry_a").read_text(encoding="utf-8"),
            [
                "Bodies/ball/Refinements=1",
                "Time/Step size=0.05",
                "Time/End time=1.5",
                "Bodies/ball/Initial velocity=0;0;-0.3",
            ],
        )
        self.assertEqual(result.returncode, 0, result.stderr)
        self.expect_warning(result.stderr, "only 1 of ", "Local refinements")

    def expected_of(self, *overrides):
        """What --validate says of the steel ball."""
        command = [
            check_history.settings["executable"],
            str(check_history.scene_file("steel_ball")),
            "--validate",
        ]
        for override in overrides:
            command += ["--set", override]
        result = subprocess.run(command, capture_output=True, text=True, timeout=300, check=False)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stdout

    def test_what_is_to_be_expected_is_said_before_the_run(self):
        """Hertz's force is 2309 N in 52.3 microseconds, 65 steps; the curvature is that of the
        cells. Without local refinement a node or two would have to carry it, and steps of 10
        microseconds are too long. A fast ball is not one for linear strains."""
        text = self.expected_of()
        self.assertNotIn("warning", text)
        line = next(line for line in text.splitlines() if "'ball : plane'" in line)
        self.assertIn("at time 0 with speed 1e+03", line)
        words = line.replace(",", "").split()
        force = float(words[words.index("force") + 1])
        duration = float(words[words.index("for") + 1])
        self.expect_close(force, 2309, 0.1, "force")
        self.expect_close(duration, 52.3e-6, 0.1, "duration")
        for override, part in (
            ("Bodies/ball/Local refinements=0", "refine the mesh where the bodies touch"),
            ("Time/Step size=10e-6", "reduce `Time/Step size`"),
            ("Bodies/ball/Initial velocity=0;0;-2e4", "Strains are linear"),
        ):
            with self.subTest(override=override):
                self.expect_warning(self.expected_of(override), "'ball : plane'", part)


if __name__ == "__main__":
    check_history.main()
