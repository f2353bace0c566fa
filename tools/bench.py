#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""What a step costs: bench.py EXECUTABLE [REFINEMENT ...]

Runs Geometry A (one body) and Geometry B (two bodies, curved face; both in parameters/) at each
refinement (default: 3 and 4) on one and on two processes, 100 steps without fields, and prints,
from columns of history.csv: the time of a step with contact and of a step after release (the bodies
vibrate, no contact) in the same run, their ratio, iterations, and matrix-vector products per step
by matrix; then the part that the set-up of contact (search, segments, coupling) and of the
preconditioner has in the run. Then what friction costs: the same bodies thrown obliquely, a step
with contact with the coefficient 0.3 against one without friction. Then the first steps of Geometry
A with each preconditioner, and with truncated Newton multigrid, in steps of five sizes. Then what
an iteration of the sweeps takes on a large mesh, against what it takes this machine to stream as
many bytes (the triad of STREAM, compiled for it). Last, the products of a step in undeformed
flight. Times are those of this machine at this moment; ratios and counts travel.
"""

import pathlib
import re
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "python"))

import signorini  # noqa: E402  pylint: disable=wrong-import-position
from signorini.tables import GrowingTable  # noqa: E402  pylint: disable=wrong-import-position

#: Scene: its bodies and its 100 steps.
SCENES = {
    "geometry_a": (["ball"], []),
    "geometry_b_curved": (["upper", "lower"], ["Time/End time=0.05"]),
}
#: Oblique throws with friction: the pair, and the keys of the throw.
OBLIQUE = {
    "geometry_a": ("ball : plane", ["Bodies/ball/Initial velocity=1; 0; -2"]),
    "geometry_b_curved": ("upper[4] : lower[5]", ["Bodies/upper/Initial velocity=1; 0.4; -2"]),
}
#: Sections of the timer table that are done once per mesh because of contact.
SET_UP = ("mesh: contact surface", "step: preconditioner set-up")
#: Preconditioner and method of a step; at refinement 4 the steps have Courant numbers 5 to 2500.
SOLVERS = (
    ("symmetric-gauss-seidel", "active-set"),
    ("incomplete-cholesky", "active-set"),
    ("ml", "active-set"),
    ("multigrid", "active-set"),
    ("multigrid", "truncated-newton-multigrid"),
)
STEP_SIZES, FIRST_STEPS = (5e-3, 1e-2, 4e-2, 0.32, 2.6), 8
#: Of an iteration of the sweeps, per degree of freedom in 3d: half the matrix in single precision
#: with its columns, back and forth (27/2 blocks per node), and five vectors of four numbers per
#: node that are read or written 14 times.
BYTES_OF_AN_ITERATION = (2 * 13 * (9 * 4 + 4) + 14 * 16) / 3
#: a = b + s c on arrays of the given number of doubles: prints bytes per second, the best of ten.
TRIAD = """
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <vector>
int main(int, char **argv)
{
  const long n = std::atol(argv[1]);
  std::vector<double> a(n, 0.), b(n, 1.), c(n, 2.);
  double best = 1e300;
  for (int k = 0; k < 10; ++k)
    {
      const auto start = std::chrono::steady_clock::now();
      for (long i = 0; i < n; ++i)
        a[i] = b[i] + (k + 1) * c[i];
      const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
      best = taken.count() < best ? taken.count() : best;
    }
  std::printf("%g %g", 24. * n / best, a[n / 2]);
}
"""
MATRICES = (("products_combined", "M + s A"), ("products_stiffness", "A"), ("products_mass", "M"))


def run(executable, scene, processes, *settings, sections=SET_UP):
    """The rows of history.csv of one run as numbers, and the seconds of sections of the timer."""
    changes = {"Output/VTU": False, **dict(text.split("=", 1) for text in settings)}
    file = ROOT / "parameters" / f"{scene}.prm"
    with tempfile.TemporaryDirectory() as folder:
        going_on = signorini.start(
            file, folder, changes, processes=processes, executable=executable
        )
        log = going_on.wait().log
        return GrowingTable(going_on.history).new_rows(), sum(
            float(
                re.search(
                    re.escape(name) + r"\s*\|\s*\d+\s*\|.*?([\d.e-]+)s\s+\d+\s*\|\s*$",
                    log,
                    re.MULTILINE,
                )[1]
            )
            for name in sections
        )


def phases(history):
    """Steps with contact, and steps after the last contact; without the first one, the set-up."""
    touching = [row for row in history if row["active_nodes"] > 0]
    last = touching[-1]["step"] if touching else 0
    return touching, [row for row in history if row["step"] > last + 1]


def mean(rows, column):
    return statistics.fmean(row[column] for row in rows)


def milliseconds(history, rows, average=statistics.median):
    """Time of the given steps; a single slow step of the machine does not count in the median."""
    time = {row["step"]: row["wall_time"] for row in history}
    return 1e3 * average(
        time[row["step"]] - time[row["step"] - 1] for row in rows if row["step"] > 1
    )


def report(label, history, rows):
    products = ", ".join(f"{mean(rows, column):5.1f} {name}" for column, name in MATRICES)
    total = sum(mean(rows, column) for column, _ in MATRICES)
    print(
        f"  {label:14}{milliseconds(history, rows):8.1f} ms  {mean(rows, 'linear_iterations'):5.1f}"
        f" iterations in {mean(rows, 'active_set_iterations'):.1f} active sets,"
        f" {mean(rows, 'predictor_iterations'):4.1f} in the predictor;  products: {products};"
        f" {total:.1f} in all"
    )


def report_friction(executable, refinement):
    for scene, (bodies, settings) in SCENES.items():
        pair, throw = OBLIQUE[scene]
        sizes = [f"Bodies/{body}/Refinements={refinement}" for body in bodies]
        print(f"{scene}, refinement {refinement}, thrown obliquely:")
        cost = {}
        for coefficient in (0, 0.3):
            history, _ = run(
                executable,
                scene,
                1,
                *settings,
                *sizes,
                *throw,
                f"Contact/{pair}/Friction coefficient={coefficient}",
            )
            contact, _ = phases(history)
            report(f"friction {coefficient}", history, contact)
            cost[coefficient] = (
                milliseconds(history, contact, statistics.fmean),
                sum(mean(contact, column) for column, _ in MATRICES),
            )
        print(
            f"  friction / none: {cost[0.3][0] / cost[0][0]:.2f} in mean time,"
            f" {cost[0.3][1] / cost[0][1]:.2f} in products\n"
        )


def report_solvers(executable, refinement):
    """Iterations, and seconds of the inequalities, of the first steps."""
    print(f"geometry_a, refinement {refinement}, first {FIRST_STEPS} steps of each size:")
    for step_size in STEP_SIZES:
        print(f"  step size {step_size}:")
        for preconditioner, method in SOLVERS:
            history, seconds = run(
                executable,
                "geometry_a",
                1,
                f"Bodies/ball/Refinements={refinement}",
                f"Time/Step size={step_size}",
                f"Time/End time={FIRST_STEPS * step_size}",
                f"Solver/Preconditioner={preconditioner}",
                f"Solver/Inequality={method}",
                sections=("step: inequality",),
            )
            print(
                f"    {preconditioner + ', ' + method:42}"
                f"{sum(row['linear_iterations'] for row in history):6.0f} iterations in"
                f" {sum(row['active_set_iterations'] for row in history):3.0f} active sets,"
                f" {seconds:6.2f} s"
            )
    print()


def bytes_per_second():
    """Of the triad, on arrays as large as the matrix of a large mesh."""
    with tempfile.TemporaryDirectory() as folder:
        source, program = pathlib.Path(folder) / "triad.cc", pathlib.Path(folder) / "triad"
        source.write_text(TRIAD, encoding="utf-8")
        subprocess.run(["c++", "-O3", "-march=native", source, "-o", program], check=True)
        result = subprocess.run([program, "20000000"], check=True, capture_output=True, text=True)
        return float(result.stdout.split()[0])


def report_iteration(executable):
    """Of the sweeps, at refinement 5."""
    history, seconds = run(
        executable,
        "geometry_a",
        1,
        "Bodies/ball/Refinements=5",
        "Time/Step size=2.5e-3",
        "Time/End time=0.0125",
        "Solver/Preconditioner=symmetric-gauss-seidel",
        sections=("step: inequality",),
    )
    iterations = sum(row["linear_iterations"] for row in history)
    streamed = BYTES_OF_AN_ITERATION * history[0]["dofs"] / bytes_per_second()
    print(
        f"An iteration of the sweeps, {history[0]['dofs']:.0f} dofs, refinement in double precision"
        f" and active sets included: {1e3 * seconds / iterations:.1f} ms;"
        f" to stream its {BYTES_OF_AN_ITERATION:.0f} bytes per dof takes {1e3 * streamed:.1f} ms:"
        f" {seconds / iterations / streamed:.2f} times\n"
    )


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    executable = sys.argv[1]
    for scene, (bodies, settings) in SCENES.items():
        for refinement in [int(argument) for argument in sys.argv[2:]] or [3, 4]:
            elapsed = {}
            for processes in (1, 2):
                history, set_up = run(
                    executable,
                    scene,
                    processes,
                    *settings,
                    *(f"Bodies/{body}/Refinements={refinement}" for body in bodies),
                )
                contact, released = phases(history)
                elapsed[processes] = history[-1]["wall_time"]
                print(
                    f"{scene}, refinement {refinement}, {history[0]['dofs']:.0f} dofs, {processes}"
                    f" process(es): {history[-1]['step']:.0f} steps in {elapsed[processes]:.2f} s"
                )
                report("contact", history, contact)
                report("after release", history, released)
                print(
                    "  contact / after release:"
                    f" {milliseconds(history, contact) / milliseconds(history, released):.2f}; "
                    " set-up of contact and preconditioner:"
                    f" {100 * set_up / elapsed[processes]:.1f} % of the steps"
                )
            print(f"  two processes are {elapsed[1] / elapsed[2]:.2f} times as fast as one\n")
    for refinement in [int(argument) for argument in sys.argv[2:]] or [3, 4]:
        report_friction(executable, refinement)
    for refinement in [int(argument) for argument in sys.argv[2:]] or [3, 4]:
        report_solvers(executable, refinement)
    report_iteration(executable)
    flight, _ = run(
        executable,
        "geometry_a",
        1,
        "Bodies/ball/Refinements=3",
        "Bodies/ball/Centre=0, 0, 5",
        "Time/End time=0.1",
    )
    print("Undeformed flight, refinement 3:")
    report("flight", flight, flight[2:])


if __name__ == "__main__":
    main()
