# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The Python package as a user has it: installed by pip, without a network, and its notebook.

The installed package is not that of the checkout, has the version of the program, and runs a scene.
Each cell of the notebook runs, and its table shows what its text says: the classical scheme gains
energy, the default one does not.
"""

import os
import re
import shutil
import subprocess
import sys
import unittest

import running
import signorini

try:
    import nbclient
    import nbformat
except ImportError:
    nbclient = None

NOTEBOOK = running.SOURCE / "python" / "examples" / "bouncing_disc.ipynb"
#: What a user does first.
FIRST = """
import signorini
result = signorini.run("disc.prm", "output")
print(signorini.__file__, len(result.history), sep="\\n")
"""


class Installed(unittest.TestCase):
    def test_pip_installs_it(self):
        # pip builds in the folder of the sources.
        sources = running.folder / "python"
        shutil.copytree(
            running.SOURCE / "python", sources, ignore=shutil.ignore_patterns("build", "*.egg-info")
        )
        venv, python = running.folder / "venv", running.folder / "venv/bin/python"
        words = [sys.executable, "-m", "venv", "--system-site-packages", "--without-pip", venv]
        subprocess.run(words, check=True)
        pip = [sys.executable, "-m", "pip", "--python", python, "--disable-pip-version-check"]
        done = subprocess.run(
            [
                *pip,
                "install",
                "--quiet",
                "--no-index",
                "--no-build-isolation",
                "--no-deps",
                sources,
            ],
            capture_output=True,
            text=True,
            check=False,
        )
        self.assertEqual(done.returncode, 0, done.stderr)
        running.disc().write(running.folder / "disc.prm")
        done = subprocess.run([python, "-c", FIRST], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        file, rows = done.stdout.split()
        self.assertTrue(file.startswith(str(venv)), file)
        self.assertEqual(rows, "41")

    def test_the_version_is_that_of_the_program(self):
        project = (running.SOURCE / "python" / "pyproject.toml").read_text(encoding="utf-8")
        version = re.search('^version = "(.*?)"', project, re.MULTILINE).group(1)
        self.assertTrue(signorini.ask("--version").startswith(f"signorini {version},"))

    @unittest.skipIf(nbclient is None, "python3-nbclient and python3-ipykernel are not installed")
    def test_the_notebook(self):
        notebook = nbformat.read(NOTEBOOK, as_version=4)
        self.assertFalse([cell for cell in notebook.cells if cell.get("outputs")], "keep it small")
        os.environ["PYTHONPATH"] = str(running.SOURCE / "python")
        nbclient.NotebookClient(
            notebook, timeout=300, resources={"metadata": {"path": str(running.folder)}}
        ).execute()
        outputs = [output for cell in notebook.cells for output in cell.get("outputs", [])]
        pictures = [output for output in outputs if "image/png" in output.get("data", {})]
        self.assertEqual(len(pictures), 2)
        table = next(
            output["data"]["text/plain"]
            for output in outputs
            if "energy_change" in output.get("data", {}).get("text/plain", "")
        )
        changes = [
            float(line.split()[-1]) for line in table.split("energy_change")[1].splitlines()[1:]
        ]
        self.assertEqual(len(changes), 6)
        self.assertLess(max(changes[:3]), 0)
        self.assertGreater(min(changes[3:]), 0)


if __name__ == "__main__":
    running.main()
