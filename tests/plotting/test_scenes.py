# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""./dev plot draws a run of every shipped scene without leaving anything out: energy, momentum,
contact force, each probe, and the bodies near the largest force. The runs are short; those with
friction, off centre and on changing meshes reach their contact. The default output shows it.

test_scenes.py EXECUTABLE FOLDER
"""

import pathlib
import re
import shutil
import subprocess
import sys
import unittest

SOURCE = pathlib.Path(__file__).resolve().parents[2]
PARAMETERS = SOURCE / "parameters"
#: Scenes that are run as far as their contact, smaller than they are.
WITH_CONTACT = {
    "quick_start": ["Bodies/ball/Refinements=2"],
    "two_balls_off_centre": ["Bodies/upper/Refinements=2", "Bodies/lower/Refinements=2"],
    "oblique_impact": ["Bodies/ball/Refinements=2"],
    "sliding_block": [],
    "striking_bar": [],
}
N_STEPS = 12

settings = {"executable": "", "folder": ""}


def value_of(scene, key):
    """The number that a scene gives to a key."""
    return float(re.search(rf"set {key}\s*=\s*(\S+)", scene)[1])


class Scenes(unittest.TestCase):
    def call(self, command):
        result = subprocess.run(
            [str(part) for part in command],
            capture_output=True,
            text=True,
            timeout=600,
            check=False,
        )
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        return result

    def draw(self, path):
        folder = pathlib.Path(settings["folder"]) / path.stem
        shutil.rmtree(folder, ignore_errors=True)
        overrides = WITH_CONTACT.get(path.stem)
        if overrides is None:
            step = value_of(path.read_text(encoding="utf-8"), "Step size")
            overrides = [f"Time/End time={N_STEPS * step}"]
        command = [settings["executable"], path, "--quiet", "--set", f"Output directory={folder}"]
        for override in [*overrides, "Output/VTU=true"]:
            command += ["--set", override]
        self.call(command)
        result = self.call([sys.executable, "-B", SOURCE / "tools/plot.py", folder])
        self.assertEqual(result.stderr, "")
        pictures = {picture.stem for picture in (folder / "pictures").glob("*.png")}
        probes = {probe.stem for probe in folder.glob("probe_*.csv")}
        self.assertEqual(pictures, {"energy", "momentum", "contact_force", "bodies"} | probes)
        return folder

    def test_all_shipped_scenes(self):
        scenes = sorted(PARAMETERS.rglob("*.prm"))
        self.assertGreater(len(scenes), 20)
        for path in scenes:
            with self.subTest(scene=path.stem):
                self.draw(path)

    def test_the_default_output_shows_the_impact(self):
        """Of quick_start, contact lasts a third of the run: of 21 states some are in it."""
        folder = self.draw(PARAMETERS / "quick_start.prm")
        states = (folder / "surface.pvd").read_text(encoding="utf-8").count("<DataSet")
        self.assertEqual(states, 21)


if __name__ == "__main__":
    settings["executable"], settings["folder"] = sys.argv[1:3]
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
