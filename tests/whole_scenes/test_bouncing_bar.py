#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The bar that bounces under gravity, 400 elements: after two, four and six impacts the energy is
what an independent one-dimensional computation gives for each scheme, in per cent of the energy of
an impact. The periodic motion itself has impacts of pressure 300 to 500 and back.
"""

import check_history

#: Changes after 2, 4, 6 impacts. The schemes of Laursen lose nothing.
CHANGES = {
    "contact-implicit": (["Time/Scheme=contact-implicit"], (-0.16, -0.31, -0.39)),
    "contact-stabilized": (["Time/Scheme=contact-stabilized"], (-0.20, -0.38, -0.54)),
    "contact-stabilized-projected": (
        ["Time/Scheme=contact-stabilized-projected"],
        (-0.18, -0.29, -0.38),
    ),
    "khenous-laborde-renard 1-4": (
        ["Time/Scheme=khenous-laborde-renard", "Time/Newmark beta=0.25"],
        (-0.06, -0.10, -0.14),
    ),
    "laursen-chawla": (["Time/Scheme=laursen-chawla"], (0.0, 0.0, 0.0)),
}
#: At rest between impacts, just before the bar would be at its highest point.
TIMES = (5.0, 5.0 + 16 / 3, 5.0 + 32 / 3)
WIDTH = 0.025
ENERGY_OF_IMPACT = 0.5 * 10 * WIDTH * 10**2


class BouncingBar(check_history.SceneTest):
    def check(self, name):
        overrides, expected = CHANGES[name]
        run = check_history.Run(
            check_history.PARAMETERS / "bouncing_bar.prm",
            f"bouncing-{name}",
            [
                *overrides,
                "Time/End time=15.7",
                "Bodies/bar/Repetitions=1, 400",
                f"Bodies/bar/Upper corner={WIDTH}, 10",
                "Time/Step size=7.5e-4",
            ],
        )
        energy = run["total_energy_modified"]
        for time, change in zip(TIMES, expected):
            row = next(row for row, t in enumerate(run["time"]) if t >= time)
            found = 100 * (energy[row] - energy[0]) / ENERGY_OF_IMPACT
            self.assertLessEqual(
                abs(found - change),
                max(0.05 * abs(change), 0.006),
                f"at {time}: {found}, expected {change}",
            )
        if name == "contact-stabilized-projected":
            for time, pressure in (
                (1.1, 330.0),
                (5 / 3 - 0.1, 470.0),
                (11 / 3 + 0.1, 470.0),
                (13 / 3 - 0.1, 330.0),
            ):
                row = next(row for row, t in enumerate(run["time"]) if t >= time)
                self.expect_close(
                    run["contact_force"][row] / WIDTH, pressure, 0.04, f"pressure at {time}"
                )


for variant in CHANGES:
    setattr(
        BouncingBar,
        f"test_{variant.replace(' ', '_').replace('-', '_')}",
        lambda self, name=variant: self.check(name),
    )


if __name__ == "__main__":
    check_history.main()
