# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""What a user can put right."""


class Mistake(Exception):
    """A study cannot be run; the message names file, section, key and remedy."""
