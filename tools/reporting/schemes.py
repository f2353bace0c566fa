# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""What the schemes promise, as signorini --print-schemes=json says it; a test compares both.

A folder of results does not say this, and is often read where there is no program.
"""

import dataclasses


@dataclasses.dataclass(frozen=True)
class Scheme:
    """Promises of a scheme, and the entries of doc/references.bib that describe it."""

    energy: str = "none"  # what contact does to it: dissipates | conserves | none
    penetrates: bool = False
    predictor: bool = False  # a predictor with a contact condition of its own
    inertia: bool = True
    own_tolerance: bool = False  # integrates by error control, not to the accuracy of the solver
    moving_contact: bool = True  # contact may follow the motion
    one_force: bool = False  # P_1 - P_0 = tau Q_1: the first row of the table in doc/output.md
    sources: tuple = ()


SCHEMES = {
    "contact-stabilized-projected": Scheme(
        "dissipates", predictor=True, one_force=True, sources=("deuflhard_krause_ertel_2008",)
    ),
    "contact-stabilized": Scheme(
        "dissipates", predictor=True, one_force=True, sources=("deuflhard_krause_ertel_2008",)
    ),
    "contact-implicit": Scheme(
        "dissipates", one_force=True, sources=("kane_repetto_ortiz_marsden_1999",)
    ),
    "laursen-chawla": Scheme(
        "conserves", penetrates=True, one_force=True, sources=("laursen_chawla_1997",)
    ),
    "laursen-love": Scheme("conserves", one_force=True, sources=("laursen_love_2002",)),
    "khenous-laborde-renard": Scheme(
        moving_contact=False, sources=("khenous_laborde_renard_2008",)
    ),
    "hager-hueeber-wohlmuth": Scheme(
        "conserves", penetrates=True, one_force=True, sources=("hager_hueeber_wohlmuth_2008",)
    ),
    "newmark": Scheme(moving_contact=False),
    "hht-alpha": Scheme(moving_contact=False, sources=("hilber_hughes_taylor_1977",)),
    "generalized-alpha": Scheme(moving_contact=False, sources=("chung_hulbert_1993",)),
    "nonsmooth-generalized-alpha": Scheme(
        moving_contact=False, penetrates=True, sources=("chen_acary_virlez_bruels_2013",)
    ),
    "backward-euler": Scheme("dissipates", one_force=True),
    "moreau-jean": Scheme(
        moving_contact=False, penetrates=True, one_force=True, sources=("jean_1999",)
    ),
    "reference": Scheme(
        moving_contact=False, own_tolerance=True, sources=("khenous_laborde_renard_2008",)
    ),
    "static": Scheme(inertia=False),
}
#: The comparison that the program is built around.
COMPARISON = "krause_walloth_2012"
