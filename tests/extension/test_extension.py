#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The program works where `cmake --install` puts it, and find_package(signorini) is enough to add a
scheme, an obstacle, a shape and a material: as a plug-in, and as a program of one's own, which give
the same bits. What is added keeps the laws like all else. Libraries that are no plug-ins, belong to
another version or add a name twice are refused with one message. What else a user finds on the
command line works there, too: scenes to start from, and completion.
"""

import math
import pathlib
import shutil
import subprocess
import sys

import check_history

BUILD = sys.argv.pop(3)  # the folder of the build
KEY = "Additional shared libraries"


class Extension(check_history.SceneTest):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(check_history.settings["folder"])
        shutil.rmtree(cls.folder, ignore_errors=True)
        cls.folder.mkdir(parents=True)
        installed, build = cls.folder / "installed", cls.folder / "extension"
        ninja = ("-G", "Ninja")  # `make` does not come with deal.II everywhere
        sources = installed / "share/signorini/examples/extension"
        for command in (
            ("cmake", "--install", BUILD, "--prefix", installed),
            ("cmake", "-S", sources, "-B", build, *ninja, f"-DCMAKE_PREFIX_PATH={installed}"),
            ("cmake", "--build", build),
        ):
            subprocess.run(command, check=True, capture_output=True)
        cls.program = installed / "bin/signorini"
        cls.scene, cls.ring = sources / "washboard.prm", sources / "ring.prm"
        cls.plugin, cls.drop_test = build / "libextension.so", build / "drop_test"

    def run_program(self, program, *arguments, status=0):
        """Standard output; what went wrong is in the message of a failure."""
        done = subprocess.run(
            [program, *arguments],
            cwd=self.folder,
            env=check_history.environment(),
            capture_output=True,
            text=True,
            check=False,
        )
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        return done.stdout + done.stderr

    def history(self, name):
        with open(self.folder / name / "history.csv", encoding="utf-8") as table:
            rows = [row.split(",") for row in table.read().splitlines()]
        wall_time = rows[0].index("wall_time")
        return [row[:wall_time] + row[wall_time + 1 :] for row in rows]

    def test_plugin_and_program_are_the_same(self):
        plugin = ("--set", f"{KEY}={self.plugin}")
        self.run_program(self.program, self.scene, *plugin, "--set", "Output directory=plugin")
        self.run_program(self.drop_test, self.scene, "--set", "Output directory=program")
        self.assertEqual(self.history("plugin"), self.history("program"))
        # The folder of a run is enough to repeat it, from anywhere.
        copy = self.folder / "plugin/scene.prm"
        self.run_program(self.program, copy, "--set", "Output directory=again")
        self.assertEqual(self.history("plugin"), self.history("again"))
        log = (self.folder / "plugin/log.txt").read_text(encoding="utf-8")
        self.assertIn(str(self.plugin), log)
        self.assertIn("SHA-256", log)

    def test_laws(self):
        run = check_history.Run(self.scene, "laws", (f"{KEY}={self.plugin}",))
        self.expect_ledger_closes(run)
        self.expect_no_gain_of_energy(run)
        self.expect_no_penetration(run, size=0.02)
        self.assertGreater(max(run["contact_force_y"]), 1e5)
        # The disc comes down beside the top of a ridge, which pushes sideways, too.
        self.assertGreater(max(map(abs, run["contact_force_x"])), 1e3)

    def test_a_shape_of_its_own(self):
        """The mesh is that of the ring, and the run keeps the laws."""
        run = check_history.Run(self.ring, "ring", (f"{KEY}={self.plugin}",))
        self.expect_ledger_closes(run)
        self.expect_no_gain_of_energy(run)
        self.expect_no_penetration(run, size=0.02)
        # What falls is the ring between two regular polygons of 29 * 4 corners, of brass.
        corners = 29 * 4
        area = 0.5 * corners * math.sin(2 * math.pi / corners) * (0.01**2 - 0.008**2)
        self.assertAlmostEqual(run["kinetic_energy"][0] / (0.5 * 8500 * area * 0.5**2), 1, 9)
        # It is flattened before it jumps up.
        self.assertGreater(max(run["elastic_energy"]), 0.5 * run["kinetic_energy"][0])
        self.assertEqual(run["contact_force_y"][-1], 0)
        plugin = ("--set", f"{KEY}={self.plugin}", "--validate")
        for change, expected in (
            ("Hole radius=0.01", "smaller than `Radius`"),
            ("Hole radius=0.0099999999", "Bodies/ring/Shape gives more than 1000000 coarse cells"),
            ("Upper corner=2, 2", "is only for boxes"),
            ("Dirichlet=rim: 0; 0", "a ring has no boundary id `rim`. Valid: 0 (inner), 1 (outer)"),
        ):
            message = self.run_program(
                self.program, self.ring, *plugin, "--set", f"Bodies/ring/{change}", status=2
            )
            self.assertIn(expected, " ".join(message.split()))
        message = self.run_program(
            self.program, self.scene, *plugin, "--set", "Bodies/disc/Hole radius=0.1", status=2
        )
        self.assertIn("is only for rings", " ".join(message.split()))

    def test_what_is_added_is_known(self):
        plugin = ("--set", f"{KEY}={self.plugin}")
        for what, expected in (
            (("--print-schemes",), "contact-implicit-damped"),
            (("--explain", "Bodies/disc/Alloy"), "aluminium"),
            (("--explain", "Bodies/disc/Shape"), "or ring"),
            (("--explain", "Obstacles/floor/Ridge radius"), "radius of its ridges"),
        ):
            self.assertIn(expected, self.run_program(self.program, *what, *plugin))
        self.assertNotIn("damped", self.run_program(self.program, "--print-schemes"))
        message = self.run_program(
            self.program,
            self.scene,
            *plugin,
            *("--set", "Bodies/disc/Young's modulus=1e9"),
            status=2,
        )
        self.assertIn("Young's modulus", message)
        self.assertIn("hooke", message)

    def test_pictures_and_report(self):
        """The commands of the installation draw a run, without a checkout."""
        scene = self.program.parents[1] / "share/signorini/parameters/incline.prm"
        self.run_program(self.program, scene, "--quiet", "--set", "Output directory=drawn")
        for tool in ("signorini-plot", "signorini-report"):
            self.run_program(self.program.parent / tool, "drawn")
        self.assertTrue((self.folder / "drawn/pictures/energy.png").exists())
        page = (self.folder / "drawn/report.html").read_text(encoding="utf-8")
        self.assertIn("@article{krause", page.replace(" ", "").lower())

    def test_scenes_to_start_from(self):
        """Each is written once, says its own name, and is in order."""
        names = self.run_program(self.program, "--new").split("NAME.prm:")[1]
        names = names.split()
        self.assertEqual(names[0], "ball")
        self.assertGreater(len(names), 20)
        for name in names[:: len(names) // 5]:
            self.run_program(self.program, "--new", name)
            text = (self.folder / f"{name}.prm").read_text(encoding="utf-8")
            self.assertIn(f"output/{name}", text)
            self.assertNotIn("parameters/", text.split("#\n# What", maxsplit=1)[0])
            self.run_program(self.program, f"{name}.prm", "--validate")
            self.run_program(self.program, "--new", name, status=2)

    def test_completion(self):
        """The names that bash completes a word to."""
        script = """source installed/share/bash-completion/completions/signorini
            compopt() { :; }
            COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1))
            _signorini "$1"; printf '%s\\n' "${COMPREPLY[@]}" """
        for words, expected in (
            (("--pr",), "--print-parameters"),
            (("--new", "ba"), "ball"),
            (("--explain", "Time/Sch"), "Time/Scheme"),
            (("--set", "Bodies/ball/You"), r"Bodies/ball/Young's\ modulus"),
        ):
            found = self.run_program("bash", "-c", script, "bash", self.program, *words)
            self.assertIn(expected, found.splitlines())

    def test_what_is_no_plugin_of_this_program(self):
        other = self.folder / "other.cc"
        other.write_text(
            'extern "C" const char *signorini_plugin_interface() { return "signorini 7"; }\n'
            'extern "C" void signorini_plugin_begin() {}\n',
            encoding="utf-8",
        )
        message = self.run_program(
            self.program, "--print-schemes", "--set", f"{KEY}=/nowhere/a.so", status=2
        )
        self.assertIn("/nowhere/a.so", message)
        old = self.folder / "libother.so"
        subprocess.run(["c++", "-shared", "-fPIC", "-o", old, other], check=True)
        twice = shutil.copy(self.plugin, self.folder / "libtwice.so")
        core = next((self.folder / "installed").rglob("libsignorini.so"))
        for libraries, expected in (
            ("missing.so", "cannot load the library"),
            (core, "is no plug-in"),
            (old, "was compiled for `signorini 7`"),
            (f"{self.plugin}, {twice}", "already"),
            (other, "cannot load the library"),
        ):
            message = self.run_program(
                self.program, self.scene, "--set", f"{KEY}={libraries}", "--validate", status=2
            )
            self.assertIn(expected, message)
            self.assertIn(KEY, message)


if __name__ == "__main__":
    check_history.main()
