# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Variations of scenes: what a study file says, runs, observations, tables, figures and pages."""

import pathlib
import sys

# The package of the checkout drives the program, whether it is installed or not.
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "python"))
