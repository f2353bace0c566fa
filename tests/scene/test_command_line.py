#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The executable as a user meets it: exit status, one message per mistake, no hang on two
processes.

Usage: test_command_line.py EXECUTABLE
"""

import collections
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

EXECUTABLE = ""
PARAMETERS = pathlib.Path(__file__).resolve().parents[2] / "parameters"
QUICK_START = str(PARAMETERS / "quick_start.prm")
TIMEOUT = 300


def own_lines(text):
    """What the program itself says on stderr. Libraries may write there, as hwloc without /sys."""
    return [line for line in text.splitlines() if "signorini: " in line]


class CommandLine(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        loads_libraries = subprocess.run(
            [EXECUTABLE, "--print-schemes"],
            timeout=TIMEOUT,
            check=True,
            capture_output=True,
            text=True,
        )
        cls.libraries_are_silent = loads_libraries.stderr == ""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def call(self, *arguments, processes=1):
        mpirun = ["mpirun", "--oversubscribe", "-np", str(processes)] if processes > 1 else []
        return subprocess.run(
            mpirun + [EXECUTABLE, *arguments],
            cwd=self.folder,
            timeout=TIMEOUT,
            capture_output=True,
            text=True,
            check=False,
        )

    def expect_nothing_else(self, stderr, own):
        """Where libraries are silent, every line is the program's own."""
        if self.libraries_are_silent:
            self.assertEqual(stderr.splitlines(), own)

    def expect_mistake(self, arguments, *words, processes=1):
        with self.subTest(arguments=arguments, processes=processes):
            result = self.call(*arguments, processes=processes)
            self.assertEqual(result.returncode, 2, result.stderr)
            own = own_lines(result.stderr)
            self.assertEqual(result.stderr.count("signorini: "), 1, result.stderr)
            for word in words:
                self.assertIn(word, own[0])
            for noise in (
                "Stacktrace",
                "An error occurred in line",
                "Message:",
                "terminate called",
            ):
                self.assertNotIn(noise, result.stderr)
            if processes == 1:
                self.expect_nothing_else(result.stderr, own)
            self.assertEqual(os.listdir(self.folder), [])

    def test_information(self):
        for arguments, word in (
            ([], "signorini --new ball"),
            (["--help"], "--validate"),
            (["--version"], "deal.II"),
            (["--print-parameters"], "set Step size"),
        ):
            result = self.call(*arguments)
            self.assertEqual((result.returncode, own_lines(result.stderr)), (0, []), result.stderr)
            self.expect_nothing_else(result.stderr, [])
            self.assertIn(word, result.stdout)

    def test_what_needs_no_library_loads_none(self):
        """The linker needs a quarter of a second for all that deal.II brings."""
        loading = {**os.environ, "LD_DEBUG": "files"}
        for arguments, loads in (
            (["--version"], False),
            (["--help"], False),
            ([], False),
            (["--print-schemes"], True),
        ):
            result = subprocess.run(
                [EXECUTABLE, *arguments],
                env=loading,
                timeout=TIMEOUT,
                check=True,
                capture_output=True,
                text=True,
            )
            self.assertIn("libc.so", result.stderr)
            self.assertEqual("libsignorini.so" in result.stderr, loads, arguments)

    def test_mistakes_in_questions_do_not_hang(self):
        """The first process answers alone, and ends the others, which have nothing to do."""
        for arguments in (["--explain", "Time/No such key"], ["--new", "nothing"]):
            for processes in (1, 2):
                result = self.call(*arguments, processes=processes)
                self.assertEqual(result.returncode, 2, result.stderr)
                self.assertEqual(len(own_lines(result.stderr)), 1, result.stderr)

    def test_without_its_library(self):
        alone = self.folder / "signorini"
        shutil.copy(EXECUTABLE, alone)
        environment = {k: v for k, v in os.environ.items() if k != "LD_LIBRARY_PATH"}
        result = subprocess.run(
            [alone, QUICK_START],
            env=environment,
            timeout=TIMEOUT,
            check=False,
            capture_output=True,
            text=True,
        )
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stderr, "^signorini: its library is missing.*Install or build it")

    def test_explanations_of_keys(self):
        """Of every key that --print-parameters prints, with its default, and of all sections."""
        path, keys = [], {}
        for line in self.call("--print-parameters").stdout.splitlines():
            line = line.strip()
            if line.startswith("subsection "):
                path.append(line.removeprefix("subsection "))
            elif line == "end":
                path.pop()
            elif line.startswith("set "):
                name, _, value = line.removeprefix("set ").partition("=")
                keys["/".join([*path, name.strip()])] = value.strip()
        self.assertGreater(len(keys), 100)
        examples = ("Time/Step size", "Bodies/ball/Radius", "Contact/ball : floor/Friction law")
        for key in (*examples, "Mapping"):
            result = self.call("--explain", key)
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            self.assertEqual(result.stdout.splitlines()[0], key)
            self.assertIn("default:", result.stdout)
        self.assertIn("default: " + keys["Mapping"], result.stdout)
        self.assertIn("automatic, linear, curved", result.stdout)
        for key, values in (
            ("Adaptivity/Repetitions", "an integer"),
            ("Time/End time", "a number"),
        ):
            self.assertIn(f"values:  {values}\n", self.call("--explain", key).stdout)
        for section in {key.rpartition("/")[0] for key in keys} - {""}:
            listed = self.call("--explain", section).stdout
            for key in keys:
                if key.rpartition("/")[0] == section:
                    self.assertIn(f"  {key.rpartition('/')[2]} = ", listed)
        self.expect_mistake(["--explain", "Time/Schem"], "Did you mean `Scheme`?")
        self.expect_mistake(["--explain", "Time/Scheme/a"], "That is a key")
        self.expect_mistake(["--explain"], "--explain needs a key")

    def test_table_of_schemes(self):
        """As a table it is that of doc/schemes.md; as JSON, each scheme can be named in a scene."""
        page = (pathlib.Path(QUICK_START).parents[1] / "doc" / "schemes.md").read_text(
            encoding="utf-8"
        )
        self.assertIn(
            self.call("--print-schemes").stdout.strip(),
            page,
            "put the new table into doc/schemes.md",
        )
        self.expect_mistake(["--print-schemes", "json"], "Write --print-schemes=json")
        schemes = json.loads(self.call("--print-schemes=json").stdout)
        self.assertGreater(len(schemes), 10)
        for scheme in schemes:
            overrides = ["--set", f"Time/Scheme={scheme['name']}"]
            if not scheme["inertia"]:
                overrides += ["--set", "Bodies/ball/Initial velocity=0; 0; 0"]
            result = self.call(QUICK_START, "--validate", *overrides)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertIn(scheme["name"], result.stdout)

    def test_mistakes_of_the_command_line(self):
        self.expect_mistake(["--validat"], "--validat", "Did you mean `--validate`?")
        self.expect_mistake(["--validate"], "no scene", "quick_start.prm")
        self.expect_mistake(["--set"], "--set", "Section/Subsection/Key=value")
        self.expect_mistake([QUICK_START, "--set", "Time/Step size"], "Time/Step size", "value")
        self.expect_mistake([QUICK_START, "--set", "Output directory=a#1"], "a#1", "comment")
        self.expect_mistake([QUICK_START, "--resum"], "unknown option --resum", "--resume")
        self.expect_mistake([QUICK_START, "--resume"], "no checkpoint", "Run without --resume")
        self.expect_mistake([QUICK_START, "--resume", "--validate"], "one of them")
        self.expect_mistake([QUICK_START, QUICK_START], "two scenes")
        self.expect_mistake(["missing.prm"], "missing.prm", "no such file")
        self.expect_mistake([str(self.folder)], "directory")

    def test_mistakes_of_the_scene(self):
        for assignment, word in (
            ("Bodies/ball/Young's modulus=-1", "positive"),
            ("Bodies/ball/Poisson's ratio=0.5", "incompressible"),
            ("Bodies/ball/Initial velocity=0;0;foo(x)", "foo"),
            ("Time/Scheme=newmrk", "Did you mean `newmark`?"),
            ("Time/Step size=nan", "finite"),
            ("Contact/Pairs=ball : roof", "roof"),
            ("Nonsense/Key=1", "Nonsense"),
            ("Output directory=/dev/null/x", "/dev/null"),
        ):
            self.expect_mistake([QUICK_START, "--validate", "--set", assignment], word)
        adaptive = str(pathlib.Path(QUICK_START).parent / "adaptive_bar.prm")
        self.expect_mistake(
            [adaptive, "--validate", "--set", "Adaptivity/Maximum cells=3"],
            "Maximum cells = 3",
            "begins with",
        )

    def test_mistakes_of_a_mesh_file(self):
        anvil = (pathlib.Path(QUICK_START).parent / "meshes" / "anvil.msh").read_text(
            encoding="utf-8"
        )
        with tempfile.TemporaryDirectory() as folder:
            for name, text, word in (
                ("cut.msh", anvil[: len(anvil) // 2], "broken"),
                (
                    "reference.msh",
                    anvil.replace("$Nodes\n252\n1 ", "$Nodes\n252\n999 "),
                    "index 1",
                ),
                ("inverted.msh", anvil.replace("\n101 -0.3", "\n101 5.3"), "inverted"),
            ):
                self.assertNotEqual(text, anvil)
                file = pathlib.Path(folder) / name
                file.write_text(text, encoding="utf-8")
                arguments = [
                    QUICK_START,
                    "--set",
                    "Bodies/ball/Shape=file",
                    "--set",
                    f"Bodies/ball/File={file}",
                ]
                self.expect_mistake(arguments, word, name)
                self.expect_mistake(arguments, word, name, processes=2)

    def test_two_processes(self):
        self.expect_mistake(["missing.prm"], "missing.prm", processes=2)
        self.expect_mistake([QUICK_START, "--set", "Time/Step size=0"], "positive", processes=2)
        self.expect_mistake(
            [QUICK_START, "--set", "Output directory=/dev/null/x"], "/dev/null", processes=2
        )
        self.expect_mistake([QUICK_START, "--wrong"], "--wrong", processes=2)

    def test_a_lost_probe_is_found_before_anything_is_removed(self):
        """A point that is not in the body, and a probe of a scene without contact."""
        point = ["Probes/south_pole/Body=ball", "Probes/south_pole/Point=0, 0, -1"]
        for changes, word in ((point, "Probes/south_pole/Point"), (["Contact/Pairs="], "probe")):
            overrides = [part for change in changes for part in ("--set", change)]
            for processes in (1, 2):
                self.expect_mistake(
                    [QUICK_START, "--validate", *overrides], word, processes=processes
                )
            with tempfile.TemporaryDirectory() as folder:
                earlier = pathlib.Path(folder) / "history.csv"
                earlier.write_text("earlier", encoding="utf-8")
                self.expect_mistake(
                    [QUICK_START, *overrides, "--set", f"Output directory={folder}"], word
                )
                self.assertEqual(os.listdir(folder), ["history.csv"])

    def test_validate_leaves_the_setup_behind_or_nothing(self):
        for processes in (1, 2):
            for words in (["--validate=json"], ["--validate", "--set", "Output/VTU=false"]):
                result = self.call(QUICK_START, *words, processes=processes)
                self.assertEqual(result.returncode, 0, result.stderr)
                self.assertNotEqual(result.stdout, "")
                self.assertEqual(os.listdir(self.folder), [])
        result = self.call(QUICK_START, "--validate", processes=2)
        self.assertIn("setup.pvd", result.stdout)
        output = next(pathlib.Path(self.folder).rglob("setup.pvd")).parent
        self.assertEqual(
            sorted(path.relative_to(output).as_posix() for path in output.rglob("*.*")),
            [
                "fields/setup_000000.0.vtu",
                "fields/setup_000000.1.vtu",
                "fields/setup_000000.pvtu",
                "setup.pvd",
                "setup.svg",
                "setup_obstacles.vtu",
            ],
        )
        pieces = [path.read_bytes() for path in output.rglob("setup_000000.*.vtu")]
        faces = [int(re.search(rb'NumberOfCells="(\d+)"', piece)[1]) for piece in pieces]
        self.assertEqual(sum(faces), 24 * 16)

    def picture(self, scene, processes=1):
        """@return the kinds of lines of its picture, and all lines, in a fixed order"""
        result = self.call(str(scene), "--validate", processes=processes)
        self.assertEqual(result.returncode, 0, result.stderr)
        file = next(pathlib.Path(self.folder).rglob("setup.svg"))
        text = file.read_text()
        file.unlink()
        kinds = collections.Counter(
            element.tag.rsplit("}")[-1] for element in xml.etree.ElementTree.fromstring(text).iter()
        )
        return kinds, sorted(text.splitlines())

    def test_picture_of_the_setup(self):
        """A ball shows half of its 24 x 16 faces and the floor; a strip its cells and its edges;
        both the same on one and two processes."""
        kinds, ball = self.picture(QUICK_START)
        self.assertEqual(sum("stroke=" in line for line in ball if "<polygon" in line), 192)
        self.assertEqual(kinds["title"], 1)
        for word in ("ball", "floor", "contact: slave", "z from 0 to 2"):
            self.assertTrue(any(f">{word}</text>" in line for line in ball), word)
        self.assertEqual(self.picture(QUICK_START, 2)[1], ball)
        base = PARAMETERS / "moving_base.prm"
        lines = self.picture(base)[1]
        self.assertTrue(any("prescribed displacement" in line for line in lines))
        self.assertEqual(self.picture(base, 2)[1], lines)

    def test_output_that_is_lost(self):
        """A full disk behind the standard output is no success; what a run computes stays."""
        if not pathlib.Path("/dev/full").exists():
            self.skipTest("no device that is always full")
        scene = [QUICK_START, "--set", "Time/End time=0.005", "--set", "Output directory=out"]
        for arguments in (["--help"], ["--version"], ["--print-schemes"], scene):
            with self.subTest(arguments=arguments), open("/dev/full", "wb") as full:
                result = subprocess.run(
                    [EXECUTABLE, *arguments],
                    cwd=self.folder,
                    timeout=TIMEOUT,
                    stdout=full,
                    stderr=subprocess.PIPE,
                    text=True,
                    check=False,
                )
                self.assertEqual(result.returncode, 1)
                self.assertIn("the standard output cannot be written", result.stderr)
        self.assertTrue((self.folder / "out" / "history.csv").stat().st_size > 0)


if __name__ == "__main__":
    EXECUTABLE = str(pathlib.Path(sys.argv.pop(1)).resolve())
    unittest.main()
