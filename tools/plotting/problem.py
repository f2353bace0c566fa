# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The one exception that plot.py reports instead of a traceback."""


class Problem(Exception):
    """A picture cannot be drawn; the message says why."""
