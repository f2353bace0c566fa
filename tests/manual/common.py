# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""What the tests of the manual share: places, the tools that build it, and the command line."""

import pathlib
import sys
import unittest

SOURCE = pathlib.Path(__file__).resolve().parents[2]
MANUAL = SOURCE / "doc" / "manual"
sys.path.insert(0, str(SOURCE / "tools" / "manual"))

settings = {"executable": None, "folder": None}


def main():
    """Run the tests of a file: test_<name>.py EXECUTABLE FOLDER [ARGS of unittest]."""
    settings["executable"] = pathlib.Path(sys.argv.pop(1)).resolve()
    settings["folder"] = pathlib.Path(sys.argv.pop(1)).resolve()
    settings["folder"].mkdir(parents=True, exist_ok=True)
    unittest.main(module="__main__")
