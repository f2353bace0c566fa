#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Steps that follow the motion against steps of equal size, at equal error of the contact force.

The error is the norm in L2 of time of the difference from the exact force of the bar, or from the
force of a run of the ball with tiny steps on the same mesh; a force is constant over the step
that has it. The bar after a long flight takes at least 2 times fewer steps, the ball, which is in
contact for most of the run, 1.5 times, for several sizes and tolerances. Computed steps, those
thrown away included, are compared, too: of the bar few are rejected, of the ball so many that
computing takes about as long as with equal steps.

The error of equal steps falls with a power of their number, on which the phase of the touch puts
a scatter of a tenth: for the bar this law is fitted to six runs. That of the ball falls from run
to run and is interpolated.

Steps for a goal keep the error of the force below twice the target, whatever the first size is, and
what a run says of its error by steps is right but for a factor of three.

Steps by the force do not know axes: a scene that is turned takes the same ones.

Round-off decides nothing: the bar touches after a whole number of steps, and with velocities that
differ by 1e-12 it takes the same steps to the same forces.
"""

import math
import re
import statistics

import check_history

#: The bar touches after half of the run.
FAR_BAR = ["Time/End time=3", "Obstacles/wall/Point=0, -15"]

#: A block that is held on top, and a floor that goes up and down.
PRESSED_BLOCK = """
set Dimension = 2
subsection Time
  set End time = 1
end
subsection Bodies
  set Names = block
  subsection block
    set Shape           = box
    set Lower corner    = 0, 0
    set Upper corner    = 0.1, 0.1
    set Repetitions     = 8, 8
    set Young's modulus = 1e5
    set Poisson's ratio = 0.3
    set Density         = 1000
    set Dirichlet       = 3: 0; 0
  end
end
subsection Obstacles
  set Names = floor
  subsection floor
    set Point  = 0, -0.001
    set Normal = 0, 1
    set Motion = 0; 0.002*(1-cos(2*pi*t))
  end
end
subsection Contact
  set Pairs = block[2] : floor
end
subsection Output
  set VTU = false
end
"""

#: A box that falls askew onto a floor with friction; box and floor are turned by an angle.
TURNED_BOX = """
set Dimension = 2
subsection Time
  set End time          = 0.6
  set Step size         = 4e-3
  set Step size control = force
  set Step tolerance    = 0.3
end
subsection Bodies
  set Names = box
  subsection box
    set Shape            = box
    set Upper corner     = 1, 0.5
    set Repetitions      = 8, 4
    set Rotation         = %(turn)r
    set Rotation centre  = 0, 0
    set Young's modulus  = 500
    set Poisson's ratio  = 0.3
    set Density          = 1
    set Initial velocity = %(velocity)s
  end
end
subsection Obstacles
  set Names = floor
  subsection floor
    set Shape  = plane
    set Normal = %(normal)s
  end
end
subsection Contact
  set Pairs = box : floor
  subsection box : floor
    set Friction coefficient = 0.3
  end
end
subsection Output
  set VTU = false
end
"""


def turned(degrees, slope=20.0):
    """TURNED_BOX, with the box a little further than the floor, so that it hits with a corner."""
    angle = math.radians(degrees)
    c, s = math.cos(angle), math.sin(angle)
    return TURNED_BOX % {
        "turn": degrees + slope,
        "velocity": f"{0.6 * c + s!r}; {0.6 * s - c!r}",
        "normal": f"{-s!r}, {c!r}",
    }


def controlled(control, step_size, tolerance):
    """Settings of steps that follow the motion."""
    key = "Adaptivity/Target error" if control == "goal" else "Time/Step tolerance"
    return [
        f"Time/Step size={step_size}",
        f"Time/Step size control={control}",
        f"{key}={tolerance}",
    ]


def pieces(run):
    """(start, end, force) of each step."""
    return list(zip(run["time"], run["time"][1:], run["contact_force"][1:]))


def distance(first, second):
    """L2 in time of the difference of two forces that are constant in pieces."""
    total, i, k, time = 0.0, 0, 0, 0.0
    while i < len(first) and k < len(second):
        end = min(first[i][1], second[k][1])
        total += max(0.0, end - time) * (first[i][2] - second[k][2]) ** 2
        time = end
        i, k = i + (first[i][1] <= end + 1e-12), k + (second[k][1] <= end + 1e-12)
    return math.sqrt(total)


def at_instants(run):
    """The force as pieces of a line through the instants, the middles of the steps."""
    middles = [(start + end) / 2.0 for start, end, _ in pieces(run)]
    forces = run["contact_force"][1:]
    result, parts = [], 50
    for (start, end), (first, last) in zip(zip(middles, middles[1:]), zip(forces, forces[1:])):
        for k in range(parts):
            ends = [start + (end - start) * i / parts for i in (k, k + 1)]
            result.append((*ends, first + (last - first) * (k + 0.5) / parts))
    return result


def computed(run):
    """Number of steps that were computed for the accepted ones."""
    return int(re.search(r"(\d+) steps computed", run.log).group(1))


def steps_needed(curve, error):
    """Equal steps for an error, interpolated in logarithms; curve: (steps, falling error)."""
    for (few, large), (many, small) in zip(curve, curve[1:]):
        if small <= error <= large:
            return few * (many / few) ** (math.log(large / error) / math.log(large / small))
    raise AssertionError(f"error {error} is not among those of equal steps: {curve}")


def steps_needed_by_law(curve, error):
    """The same by the line of least squares through the logarithms. No run may be far from it."""
    numbers, errors = ([math.log(point[i]) for point in curve] for i in (0, 1))
    number, mean = statistics.fmean(numbers), statistics.fmean(errors)
    slope = sum((n - number) * (e - mean) for n, e in zip(numbers, errors)) / sum(
        (n - number) ** 2 for n in numbers
    )
    for n, e in zip(numbers, errors):
        if abs(e - mean - slope * (n - number)) > 0.2:
            raise AssertionError(f"errors of equal steps follow no power of their number: {curve}")
    return math.exp(number + (math.log(error) - mean) / slope)


class StepSize(check_history.SceneTest):
    def compare(self, scene, name, common, step_sizes, exact, law, controls):
        """law: steps_needed or steps_needed_by_law;
        controls: (settings, factor for steps, factor for computed steps)."""
        curve = []
        for size in step_sizes:
            run = check_history.Run(
                check_history.PARAMETERS / scene,
                f"{name}-{size:g}",
                common + [f"Time/Step size={size}"],
            )
            curve.append((len(run) - 1, distance(pieces(run), exact)))
            print(f"{name}: fixed {size:g}: {curve[-1][0]} steps, error {curve[-1][1]:.5g}")
        for number, (settings, factor, factor_computed) in enumerate(controls):
            run = check_history.Run(
                check_history.PARAMETERS / scene, f"{name}-{number}", common + settings
            )
            error, steps = distance(pieces(run), exact), len(run) - 1
            needed = law(curve, error)
            print(
                f"{name}: {settings}: {steps} steps, {computed(run)} computed, error {error:.5g}; "
                f"{needed / steps:.2f} and {needed / computed(run):.2f} times fewer"
            )
            self.expect_ledger_closes(run)
            self.assertGreaterEqual(needed / steps, factor, f"{settings}: steps")
            self.assertGreaterEqual(
                needed / computed(run), factor_computed, f"{settings}: computed steps"
            )

    def test_bar_after_a_long_flight(self):
        # Touches at 1.5, leaves at 1.5 + 2/3.
        exact = [(0.0, 1.5, 0.0), (1.5, 1.5 + 2.0 / 3.0, 30.0), (1.5 + 2.0 / 3.0, 3.0, 0.0)]
        self.compare(
            "bar_2d.prm",
            "bar",
            FAR_BAR,
            (20e-3, 12e-3, 8e-3, 6e-3, 4e-3, 3e-3),
            exact,
            steps_needed_by_law,
            [
                (controlled("embedded", 6e-3, 0.3), 2.0, 2.0),
                (controlled("doubling", 6e-3, 0.4), 2.0, 2.0),
                (controlled("force", 6e-3, 0.3), 3.0, 3.0),
                (controlled("force", 6e-3, 0.1), 3.0, 3.0),
            ],
        )

    def test_round_off(self):
        scene = check_history.PARAMETERS / "bar_2d.prm"
        for control, tolerance in (
            ("embedded", 0.3),
            ("doubling", 0.4),
            ("force", 0.3),
            ("force", 0.1),
            ("goal", 0.01),
        ):
            settings = FAR_BAR + controlled(control, 6e-3, tolerance)
            first, *others = (
                check_history.Run(
                    scene,
                    f"bar-{control}-{factor}",
                    settings + [f"Bodies/bar/Initial velocity=0; -10*{factor}"],
                )
                for factor in ("1", "(1+1e-12)", "(1-1e-12)")
            )
            for run in others:
                self.assertEqual((len(run), computed(run)), (len(first), computed(first)), control)
                for column, tolerated in (("time", 1e-9), ("contact_force", 1e-4)):
                    for row, (a, b) in enumerate(zip(run[column], first[column])):
                        self.assertLessEqual(abs(a - b), tolerated, f"{control}: {column}, {row}")

    def test_ball(self):
        # A coarse one of curved cells. In contact for 0.315 of 0.5, so that nothing but a free
        # flight would save 37 % of the steps.
        common = ["Bodies/ball/Refinements=3", "Mapping=curved"]
        exact = pieces(
            check_history.Run(
                check_history.PARAMETERS / "geometry_a.prm",
                "ball-exact",
                common + ["Time/Step size=5e-4"],
            )
        )
        self.compare(
            "geometry_a.prm",
            "ball",
            common,
            (12.5e-3, 1e-2, 7.5e-3, 5e-3, 3.75e-3),
            exact,
            steps_needed,
            [
                (controlled("force", size, tolerance) + ["Time/Maximum step size=0.2"], 1.5, 0.9)
                for size, tolerance in ((5e-3, 0.3), (6e-3, 0.2), (8e-3, 0.2))
            ],
        )

    def test_goal(self):
        """A disc that touches slowly, on the same mesh, with first sizes that are too long or too
        short, and with equal steps, which tell their error."""
        scene = check_history.PARAMETERS / "disc_2d.prm"
        common = [
            "Mapping=curved",
            "Bodies/disc/Refinements=5",
            "Bodies/disc/Initial velocity=0; -0.06",
            "Time/Spectral radius=1",
            "Time/End time=0.6",
            "Time/Maximum step size=0.06",
        ]
        equal = common[:-1]
        exact = check_history.Run(scene, "disc-exact", [*equal, "Time/Step size=5e-4"])
        size = math.sqrt(sum(force * force for force in exact["contact_force"]) * 5e-4)

        def error(run):
            return distance(at_instants(run), at_instants(exact)) / size

        for target, step_size in ((0.02, 8e-3), (0.01, 8e-3), (0.01, 2e-3), (0.002, 4e-3)):
            with self.subTest(target=target, step_size=step_size):
                run = check_history.Run(
                    scene,
                    f"disc-{target}-{step_size}",
                    [*common, *controlled("goal", step_size, target)],
                )
                print(f"goal {target}, {step_size}: {len(run) - 1} steps, error {error(run):.3g}")
                self.assertLess(error(run), 2.0 * target)
                self.assertLess(len(run), 40 + 5.0 / math.sqrt(target))
                self.expect_ledger_closes(run)
        for step_size in (32e-3, 16e-3, 8e-3, 4e-3):
            with self.subTest(step_size=step_size):
                settings = [*equal, f"Time/Step size={step_size}", "Adaptivity/Target error=1e-4"]
                run = check_history.Run(scene, f"disc-{step_size}", settings)
                told = 0.01 * float(re.search(r"error by steps +about (\S+) %", run.log)[1])
                print(f"equal steps of {step_size}: error {error(run):.3g}, told {told:.3g}")
                self.assertLess(error(run) / 3.0, told)
                self.assertLess(told, 3.0 * error(run))
                self.assertIn("the target was 0.01 %: give a `Time/Step size`", run.log)

    def test_rest(self):
        """A body at rest that an obstacle presses and leaves again: what a rejected step leaves of
        the guesses is round-off, and no motion that breaks a law."""
        for control in ("force", "goal"):
            settings = controlled(control, 5e-3, 0.02)
            run = check_history.Run(PRESSED_BLOCK, f"press-{control}", settings)
            self.assertGreater(max(run["contact_force"]), 0.0)
            self.assertGreater(sum(run["rejected_steps"]), 0)
            self.assertLess(len(run), 1500)
            largest = max(run["kinetic_energy"]) + max(run["elastic_energy"])
            self.assertLess(max(map(abs, run["energy_residual"])), 1e-9 * largest)

    def test_frame(self):
        """Steps by the force are the same in any frame."""
        straight, *others = (
            check_history.Run(turned(degrees), f"frame-{degrees}", []) for degrees in (0, 30, 45)
        )
        self.assertGreater(max(straight["contact_force"]), 0.0)
        sizes = [end - start for start, end in zip(straight["time"], straight["time"][1:])]
        self.assertGreater(max(sizes), 2.0 * min(sizes))
        for other in others:
            self.assertEqual(len(straight), len(other))
            for column in ("time", "contact_force", "total_energy"):
                scale = max(map(abs, straight[column]))
                for row, (a, b) in enumerate(zip(straight[column], other[column])):
                    self.assertLessEqual(abs(a - b), 1e-6 * scale, f"{column} in row {row}")

    def test_two_bodies_with_friction(self):
        """The steps of one and two processes are the same; touch and release are met by shorter
        steps than flight."""
        scene = check_history.PARAMETERS / "oblique_impact_two_balls.prm"
        settings = [
            "Time/Step size control=force",
            "Time/Step tolerance=0.1",
            "Bodies/upper/Refinements=1",
            "Bodies/lower/Refinements=1",
        ]
        one, two = (check_history.Run(scene, f"two-balls-{n}", settings, n) for n in (1, 2))
        self.assertEqual(len(one), len(two))
        for column in ("time", "contact_force", "total_energy"):
            scale = max(map(abs, one[column]))
            for row, (a, b) in enumerate(zip(one[column], two[column])):
                self.assertLessEqual(abs(a - b), 1e-8 * scale, f"{column} in row {row}")
        self.expect_ledger_closes(one)
        sizes = [end - start for start, end in zip(one["time"], one["time"][1:])]
        flight = [size for size, force in zip(sizes, one["contact_force"][1:]) if force == 0.0]
        contact = [size for size, force in zip(sizes, one["contact_force"][1:]) if force != 0.0]
        self.assertGreater(max(flight), 2.0 * max(contact))


if __name__ == "__main__":
    check_history.main()
