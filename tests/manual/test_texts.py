# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""What the manual says is what the program does: scenes in the text are accepted by --validate, and
so are shipped scenes with the options of the commands that are shown; messages that are explained
stand in the sources; options in the changelog exist; results in the gallery belong to the scenes as
they are; the summary of the quick start in README.md, in the manual and in the gallery is that of a
run.

test_texts.py EXECUTABLE FOLDER
"""

import configparser
import json
import re
import shlex
import shutil
import subprocess
import unittest

import common

import gallery
import messages
import program
import scenes

PAGES = sorted(common.MANUAL.rglob("*.md"))
NUMBER = re.compile(r"[-+]?\d+\.?\d*(?:e[-+]?\d+)?")


def blocks(text, language):
    """(text before, block) of each fenced block of a language."""
    for match in re.finditer(rf"^```{language}\n(.*?)^```", text, re.MULTILINE | re.DOTALL):
        yield text[: match.start()], match[1]


def alike(line, other):
    """Whether lines have the same words, and numbers that agree up to round-off and rounding."""
    if NUMBER.sub("#", line).split() != NUMBER.sub("#", other).split():
        return False
    pairs = zip(map(float, NUMBER.findall(line)), map(float, NUMBER.findall(other)))
    return all(abs(a - b) <= max(2e-3 * abs(a), 1e-8) for a, b in pairs)


def shown_summary(text):
    """The lines of the block after the mark for the summary of the quick start."""
    block = text.split("<!-- summary: quick_start -->\n", 1)[1].lstrip("\n")
    if block.startswith("```"):
        lines = block.split("\n", 1)[1].split("```")[0].splitlines()
    else:
        lines = [line[4:] for line in block.split("\n\n", 1)[0].splitlines()]
    return [line for line in lines if line.strip()]


class Texts(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = common.settings["folder"]
        shutil.rmtree(cls.folder)
        cls.folder.mkdir()
        (cls.folder / "parameters").symlink_to(scenes.PARAMETERS)
        for mesh in common.MANUAL.rglob("*.msh"):
            shutil.copy(mesh, cls.folder)
        for page in PAGES:
            text = page.read_text(encoding="utf-8")
            for language in ("prm", "ini"):
                for before, block in blocks(text, language):
                    names = re.findall(rf"`(\w+\.{language})`", before)
                    name = names[-1] if names else f"{page.stem}.{language}"
                    (cls.folder / name).write_text(block, encoding="utf-8")

    def validate(self, *arguments):
        """What --validate says; it must find no mistake."""
        command = [common.settings["executable"], *arguments, "--validate"]
        result = subprocess.run(
            command, cwd=self.folder, capture_output=True, text=True, check=False
        )
        self.assertEqual(result.returncode, 0, f"{arguments}: {result.stderr}")
        return result.stdout

    def test_scenes_in_the_text(self):
        names = sorted(path.name for path in self.folder.glob("*.prm"))
        self.assertGreaterEqual(len(names), 5)
        for name in names:
            with self.subTest(name):
                self.validate(name)

    def commands(self):
        """Arguments of all runs of the program that the pages show."""
        for page in PAGES:
            text = page.read_text(encoding="utf-8")
            for _, block in blocks(text, "sh"):
                for line in block.replace("\\\n", " ").splitlines():
                    words = shlex.split(line.replace("$level", "1"), comments=True)
                    if words and words[0].endswith("signorini"):
                        yield words[1:]

    def test_commands_with_scenes(self):
        commands = list(self.commands())
        self.assertGreaterEqual(len(commands), 10)
        for arguments in {tuple(command): None for command in commands}:
            with self.subTest(arguments=arguments):
                self.validate(
                    *(word for word in arguments if word not in ("--validate", "--resume"))
                )

    def test_studies_in_the_text(self):
        for path in self.folder.glob("*.ini"):
            study = configparser.ConfigParser(delimiters="=")
            study.optionxform = str
            study.read(path, encoding="utf-8")
            for key, values in study["variations"].items():
                self.validate(study["study"]["scene"], "--set", f"{key}={values.split(';')[0]}")

    def test_messages_that_are_explained(self):
        everything = " ".join(" ".join(texts) for texts in messages.all_texts().values())
        page = (common.MANUAL / "troubleshooting.md").read_text(encoding="utf-8")
        lines = [line for _, block in blocks(page, "text") for line in block.splitlines()]
        self.assertGreater(len(lines), 30)
        for line in lines:
            for part in filter(None, map(str.strip, line.split("…"))):
                self.assertTrue(part in everything, f"no source has the message {line!r} any more")

    def test_changelog_and_citation_know_the_program(self):
        version = re.search(
            r"project\(signorini VERSION (\S+)",
            (common.SOURCE / "CMakeLists.txt").read_text(encoding="utf-8"),
        )[1]
        citation = (common.SOURCE / "CITATION.cff").read_text(encoding="utf-8")
        self.assertIn(f"\nversion: {version}\n", citation)
        changelog = (common.SOURCE / "CHANGELOG.md").read_text(encoding="utf-8")
        known = program.call(common.settings["executable"], "--help")
        known += (common.SOURCE / "dev").read_text(encoding="utf-8")
        options = set(re.findall(r"`[^`]*?(--[a-z-]+)", changelog)) - {"--install"}  # of cmake
        self.assertGreater(len(options), 5)
        for option in options:
            self.assertTrue(option in known, f"CHANGELOG.md: there is no {option}")

    def test_results_of_the_gallery_belong_to_the_scenes(self):
        results = gallery.read_results()
        for scene in scenes.shipped():
            with self.subTest(scene.name):
                remedy = "run ./dev doc --gallery"
                self.assertTrue(scene.name in results, remedy)
                self.assertEqual(results[scene.name]["checksum"], scene.checksum, remedy)
                picture = gallery.PICTURES / f"{scene.name}.png"
                self.assertTrue(picture.is_file(), remedy)
                self.assertLessEqual(picture.stat().st_size, gallery.LARGEST_PICTURE)

    def test_summary_of_the_quick_start(self):
        scene = scenes.Scene(scenes.PARAMETERS / "quick_start.prm")
        summary, _ = gallery.run(
            common.settings["executable"], scene, self.folder / "quick_start", limit=300
        )
        summary = [line for line in summary if not line.startswith("products")]
        self.assertGreater(len(summary), 4)
        kept = json.loads(gallery.RESULTS.read_text(encoding="utf-8"))["quick_start"]["summary"]
        shown = {"gallery": [line for line in kept if not line.startswith("products")]}
        for page in (common.SOURCE / "README.md", common.MANUAL / "quick_start.md"):
            shown[page.name] = shown_summary(page.read_text(encoding="utf-8"))
        for place, lines in shown.items():
            self.assertGreater(len(lines), 4, place)
            for line, run in zip(lines, summary):
                if line.endswith("; ..."):
                    line, run = line[:-5], run.partition(";")[0]
                self.assertTrue(alike(line, run), f"{place}: {line!r}, but a run says {run!r}")


if __name__ == "__main__":
    common.main()
