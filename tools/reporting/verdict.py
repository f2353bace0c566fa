# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""One line of the summary."""

import dataclasses

#: A law is kept, is broken; something is to be looked at; the tables cannot tell, or need not.
KEPT, BROKEN, LOOK, NOT_JUDGED = "kept", "broken", "look", "not judged"


@dataclasses.dataclass
class Verdict:
    """What was asked, the answer, and the sentence with its numbers."""

    name: str
    state: str
    text: str


def by_limit(name, value, limit, what):
    """Kept up to the limit, broken beyond, and by what is no number."""
    state = KEPT if value <= limit else BROKEN
    return Verdict(name, state, f"{what.format(f'{value:.2g}')} (limit {limit:.1g}).")
