# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Variations of scenes: what a study file says, runs, observations, tables, figures and pages."""
