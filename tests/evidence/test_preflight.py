#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""What --validate says before a run is what mechanics says, and what the run then does: the moment
of the first touch by the laws of free fall, the duration of contact by Hertz or by waves, the
memory within a fifth of what the system counts.
"""

import json
import math
import subprocess
import unittest

import check_history

#: A disc above a floor. By default it falls from rest.
FALLING_DISC = """
set Dimension = 2
subsection Time
  set Step size         = 5e-3
  set End time          = 1.5
end
subsection Bodies
  set Names = disc
  subsection disc
    set Shape           = ball
    set Centre          = 0, 1.5
    set Refinements     = 4
    set Young's modulus = 5000
    set Poisson's ratio = 0.3
    set Body force      = 0; -2
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
end
"""


#: Without refinements, so that the levels of multigrid are algebraic.
CUBE = """
set Dimension = 3
subsection Bodies
  set Names = cube
  subsection cube
    set Shape            = box
    set Lower corner     = 0, 0, 0.001
    set Upper corner     = 1, 1, 1.001
    set Repetitions      = 24, 24, 24
    set Young's modulus  = 1e5
    set Poisson's ratio  = 0.25
    set Initial velocity = 0; 0; -1
  end
end
subsection Obstacles
  set Names = floor
  subsection floor
    set Normal = 0, 0, 1
  end
end
subsection Contact
  set Pairs = cube[4] : floor
end
subsection Solver
  set Preconditioner = multigrid
end
"""


def validate(scene, *overrides, form="--validate=json"):
    command = [check_history.settings["executable"], str(scene), form]
    for override in overrides:
        command += ["--set", override]
    return subprocess.run(
        command,
        capture_output=True,
        text=True,
        timeout=check_history.TIMEOUT,
        check=False,
        env=check_history.environment(),
    )


class Preflight(check_history.SceneTest):
    def written(self, name, text):
        folder = check_history.pathlib.Path(check_history.settings["folder"]) / name
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "scene.prm").write_text(text, encoding="utf-8")
        return folder / "scene.prm"

    def forecast(self, scene, *overrides):
        done = validate(scene, *overrides)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def test_free_fall_and_hertz(self):
        """The disc falls 0.5: for sqrt(2 * 0.5 / 2), and is in contact as the run has it."""
        scene = self.written("fall", FALLING_DISC)
        said = self.forecast(scene)
        (impact,) = said["impacts"]
        moment = math.sqrt(0.5)
        self.expect_close(impact["time"], moment, 1e-3, "time of the first touch")
        self.expect_close(impact["speed"], 2 * moment, 2e-3, "speed")
        self.assertEqual(impact["theory"], "Hertz")
        # Faces of a fine mesh are nearly flat, and the body is as round as before.
        pole = "Bodies/disc/Refine where=0.1 - sqrt(x^2 + (y - 0.5)^2)"
        (fine,) = self.forecast(scene, "Bodies/disc/Local refinements=5", pole)["impacts"]
        self.assertEqual(fine["theory"], "Hertz")
        self.expect_close(fine["force"], impact["force"], 0.05, "force foretold on a fine mesh")
        run = check_history.Run(FALLING_DISC, "fallen")
        in_contact = [t for t, force in zip(run["time"], run["contact_force"]) if force > 0]
        self.assertLess(abs(in_contact[0] - moment), 2 * said["step_size"])
        self.expect_close(
            in_contact[-1] - in_contact[0], impact["duration"], 0.2, "duration of contact"
        )
        self.expect_close(max(run["contact_force"]), impact["force"], 0.2, "largest force")

    def test_forces_in_the_plane(self):
        """Forces of discs grow faster than their speed, by a logarithm. Foretold they are right
        to 8 % for two speeds (without it one of them would be wrong by 25 %), and the duration of
        contact to 5 %. Axes do not matter: the disc hits the floor of a scene that is turned."""
        tilted = ["Obstacles/floor/Normal=-1,1", "Obstacles/floor/Point=0,0"]
        for speed in (0.1, 2.0):
            c = math.sqrt(0.5)
            settings = [
                "Bodies/disc/Body force=0; 0",
                f"Bodies/disc/Centre={-1.01 * c!r}, {1.01 * c!r}",
                f"Bodies/disc/Initial velocity={speed * c!r}; {-speed * c!r}",
                "Bodies/disc/Radius=1",
                "Adaptivity/Indicator=residual",
                "Adaptivity/Goal=contact force",
                "Adaptivity/Target error=0.01",
                "Adaptivity/Maximum level=9",
            ] + tilted
            scene = self.written(f"plane-{speed}", FALLING_DISC)
            (impact,) = self.forecast(scene, *settings)["impacts"]
            settings += [
                f"Time/Step size={impact['duration'] / 100!r}",
                f"Time/End time={impact['time'] + 1.2 * impact['duration']!r}",
            ]
            run = check_history.Run(FALLING_DISC, f"in-the-plane-{speed}", settings)
            in_contact = [t for t, force in zip(run["time"], run["contact_force"]) if force > 0]
            self.expect_close(
                in_contact[-1] - in_contact[0], impact["duration"], 0.05, "duration of contact"
            )
            self.expect_close(max(run["contact_force"]), impact["force"], 0.08, "largest force")

    def test_true_way(self):
        """Thrown obliquely past the end of a short floor the disc meets nothing, and this is said;
        thrown to where the floor is, it does, though nothing is below it at the start."""
        short = ["Obstacles/floor/Extent=1", "Bodies/disc/Body force=0;0", "Contact/Motion=follow"]
        scene = self.written("way", FALLING_DISC)
        past = self.forecast(scene, *short, "Bodies/disc/Initial velocity=3;-0.5")
        self.assertEqual(past["impacts"], [])
        self.assertTrue(any("no pair meets" in warning for warning in past["warnings"]))
        onto = self.forecast(
            scene,
            *short,
            "Bodies/disc/Centre=-3,1.5",
            "Bodies/disc/Initial velocity=3;-0.5",
        )
        (impact,) = onto["impacts"]
        self.expect_close(impact["time"], 1.0, 1e-2, "time of the first touch")
        self.assertFalse(any("no pair meets" in warning for warning in onto["warnings"]))

    def test_an_obstacle_that_comes(self):
        """The floor rises with speed 2 to the disc, 0.5 above it, which rests."""
        scene = self.written("comes", FALLING_DISC)
        said = self.forecast(
            scene, "Bodies/disc/Body force=0;0", "Obstacles/floor/Motion=0; 2*t", "Time/End time=1"
        )
        (impact,) = said["impacts"]
        self.expect_close(impact["time"], 0.25, 1e-3, "time of the first touch")
        self.expect_close(impact["speed"], 2, 1e-6, "speed")
        self.assertEqual(impact["theory"], "Hertz")

    def test_waves(self):
        """The bar of length 10 with wave speed 30: a transit takes 1/3, contact two of them."""
        said = self.forecast(check_history.scene_file("bar_2d"))
        (body,) = said["bodies"]
        self.expect_close(body["pressure_wave_speed"], 30, 1e-12, "wave speed")
        self.expect_close(body["transit_time"], 1 / 3, 1e-12, "transit")
        self.expect_close(
            body["steps_per_transit"] * said["step_size"], 1 / 3, 1e-10, "steps in a transit"
        )
        (impact,) = said["impacts"]
        self.assertEqual(impact["theory"], "plane wave")
        self.expect_close(impact["duration"], 2 / 3, 1e-6, "duration")
        self.expect_close(
            impact["recommended_step_size"], impact["duration"] / 20, 1e-9, "recommended step"
        )

    def test_text_says_the_same(self):
        done = validate(check_history.scene_file("geometry_a"), form="--validate")
        self.assertEqual(done.returncode, 0, done.stderr)
        said = self.forecast(check_history.scene_file("geometry_a"))
        for part in (
            "memory",
            "Courant number",
            "first touch",
            "recommended",
            "transit",
            "skipped",
            f"{said['cells']} cells",
            said["law"],
        ):
            self.assertIn(part, done.stdout)

    def test_mistakes(self):
        """Friction with forces that alternate, and steps longer than the contact."""
        scene = self.written("mistakes", FALLING_DISC)
        friction = "Contact/disc : floor/Friction coefficient=0.3"
        for overrides, word in (
            ([friction, "Time/Scheme=contact-implicit"], "stick and slip by turns"),
            (["Time/Step size=0.1"], "reduce `Time/Step size`"),
            (["Bodies/disc/Body force=0;2"], "no pair meets"),
        ):
            with self.subTest(overrides=overrides):
                self.assertTrue(
                    any(word in text for text in self.forecast(scene, *overrides)["warnings"])
                )
        for warning in self.forecast(scene, friction)["warnings"]:
            self.assertNotIn("stick and slip", warning)
            self.assertNotIn("no pair meets", warning)
            self.assertNotIn("Step size", warning)

    def test_stiff_body_first(self):
        """Of long steps with the stiffer body first it is warned, and only of them; the remedy can
        be copied into the scene."""
        scene = check_history.scene_file("two_bars")
        stiff, long = "Bodies/left/Young's modulus=1e5", "Time/Step size=0.5"
        for overrides, expected in (([stiff, long], True), ([stiff], False), ([long], False)):
            warnings = self.forecast(scene, *overrides)["warnings"]
            remedy = "Write `Pairs = right[0] : left[1]`."
            self.assertEqual(any(remedy in warning for warning in warnings), expected)

    def test_unknown_form(self):
        done = validate(check_history.scene_file("bar_2d"), form="--validate=xml")
        self.assertEqual(done.returncode, 2)
        self.assertIn("--validate=json", done.stderr)
        self.assertEqual(done.stdout, "")

    def test_memory(self):
        """Runs that are large enough for the program itself not to count."""
        disc = self.written("memory", FALLING_DISC)
        adaptive = [
            "Adaptivity/Indicator=distance",
            "Adaptivity/Distance=10",
            "Adaptivity/Maximum level=7",
            "Adaptivity/Maximum cells=100000",
        ]
        for name, scene, overrides, key in (
            ("2d", disc, ["Bodies/disc/Refinements=7"], "memory"),
            ("without fields", disc, ["Bodies/disc/Refinements=7", "Output/VTU=false"], "memory"),
            ("adaptive", disc, adaptive, "memory"),
            ("algebraic levels", self.written("cube", CUBE), [], "memory"),
            (
                "3d",
                check_history.scene_file("quick_start"),
                ["Bodies/ball/Refinements=4"],
                "memory",
            ),
            (
                "two bodies",
                check_history.scene_file("two_balls_head_on"),
                ["Bodies/upper/Refinements=4", "Bodies/lower/Refinements=4"],
                "memory",
            ),
        ):
            with self.subTest(scene=name):
                overrides = overrides + ["Time/End time=0.015", "Time/Step size=5e-3"]
                said = self.forecast(scene, *overrides)
                self.expect_close(
                    said[key], self.memory_of_run(scene, name, overrides), 0.2, "memory"
                )

    def memory_of_run(self, scene, name, overrides):
        """Bytes, the most that the process has taken, as the system tells."""
        command = [check_history.settings["executable"], str(scene), "--quiet"]
        folder = check_history.pathlib.Path(check_history.settings["folder"]) / f"memory {name}"
        for override in [*overrides, f"Output directory={folder}"]:
            command += ["--set", override]
        # A process of its own, so that its only child is this run.
        program = (
            "import resource, subprocess, sys\n"
            "subprocess.run(sys.argv[1:], check=True, stderr=subprocess.DEVNULL)\n"
            "print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)"
        )
        done = subprocess.run(
            [check_history.sys.executable, "-c", program, *command],
            capture_output=True,
            text=True,
            timeout=check_history.TIMEOUT,
            check=True,
            env=check_history.environment(),
        )
        return 1024 * int(done.stdout)


if __name__ == "__main__":
    check_history.main()
