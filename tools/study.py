#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Runs variations of a scene and compares them.

A study is a file with a section [study] (scene, relative to the file; observe, the columns of the
table, all if not given; processes) and at least one of these: [variations], keys of the scene and
their values, separated by semicolons, of which all combinations are run; [together], keys that
change together, value by value; sections [variant NAME], each with the keys of one line of the
table, or `variants = FILE` in [study], a file with such sections. [scene] has keys for all runs,
[coarse] those for --coarse. Results of each run go to FOLDER/<number or name>, the table to
FOLDER/table.csv and FOLDER/table.md. With [together] the table shows, behind each error, the rate
log2(error before / error).

`exact force = ...` in [study], an expression in t with sin, cos, sqrt, abs, max, min and pi, gives
force_error. A section [reference] has the keys of a run to compare with, for example
`Time/Scheme = reference`: all runs that differ only in scheme and step size share one, with the
smallest of their step sizes if it does not give its own, of which theirs must be whole multiples.
It gives force_distance, displacement_distance and velocity_distance, the latter two of all probes;
a reference step size a few times smaller than the runs' keeps differences of its displacements out
of them. All are relative, L2 in time, and each force is compared at the instant to which it belongs
(signorini --print-schemes).

A section [quantities] derives numbers from the columns of history.csv, supports.csv, pairs.csv and
bodies.csv, and those of probes, PROBE.COLUMN, by names that `observe` and later quantities can use:
`name = expression` with first(COLUMN), last(COLUMN), largest(COLUMN), smallest(COLUMN),
total(COLUMN), its sum over the steps, integral(COLUMN), that of its products with the step size,
zero(COLUMN), the first time at which it passes through zero, begin(COLUMN) and end(COLUMN), the
times at which its first step that is not zero starts and its last one ends, and duration(COLUMN),
the length of all such steps: duration(contact_force) is the time in contact,
end(pair_0_normal_force) the end of the contact of the first pair.
`curve = FILE` in [study], two columns separated by commas below a line with their names, gives the
function curve(...). `figure = NAME over NAME` draws one observation over another to
FOLDER/figure.png beside the curve, with one kind of points for each variant, or for all variants
with the same `group = NAME`.

Five studies have a name instead of a file: krause-walloth compares all schemes on the examples of
Krause and Walloth (2012), with figures and a page; bar-table compares them on the bar with an
independent computation; adaptive compares uniform and adaptive meshes and steps; work-precision
finds the cheapest way to an error of 10, 1 and 0.1 % (doc/work_precision.md tells what its study
files have besides: [schemes], [curves], [exact] and peers); benchmark judges a collection of
impacts against known values (doc/benchmarks.md; [expected], [certify] and `certify with`).
"""

import argparse
import pathlib
import sys

from studies import instants, references, runs, tables
from studies.definition import Mistake, Study

ROOT = pathlib.Path(__file__).resolve().parents[1]
NAMES = ("krause-walloth", "bar-table", "adaptive", "work-precision", "benchmark")


def parse():
    """The command line."""
    parser = argparse.ArgumentParser(
        prog="study.py", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("executable", metavar="EXECUTABLE")
    parser.add_argument("study", metavar="STUDY", help=f"a file, or one of {', '.join(NAMES)}")
    parser.add_argument(
        "folder",
        metavar="FOLDER",
        nargs="?",
        help="where results go (default: output/<name of the study>)",
    )
    parser.add_argument(
        "--coarse", action="store_true", help="the cheap version, with the keys of [coarse]"
    )
    parser.add_argument(
        "--jobs", type=int, metavar="N", help="runs at a time (default: 1, of a named study 2)"
    )
    parser.add_argument(
        "--draw-only",
        action="store_true",
        help="no runs: tables, figures and page from the results in FOLDER",
    )
    parser.add_argument(
        "--page",
        metavar="FILE.md",
        type=pathlib.Path,
        help=(
            "krause-walloth: a copy of the page, with its figures in the folder pictures next to"
            " it; benchmark: the page whose tables are made anew; the results are kept, too"
        ),
    )
    parser.add_argument(
        "--certify",
        action="store_true",
        help="benchmark: reference values with error bars, from runs on finer and finer meshes",
    )
    arguments = parser.parse_args()
    if arguments.jobs is not None and arguments.jobs < 1:
        parser.error("--jobs: give a number of 1 or more")
    if arguments.page and arguments.study not in ("krause-walloth", "benchmark"):
        parser.error("--page: only the studies krause-walloth and benchmark write a page")
    if arguments.certify and arguments.study != "benchmark":
        parser.error("--certify: only the study benchmark has reference values")
    return arguments


def study_of_a_file(arguments):
    """Runs a study file and writes its table. Returns whether all went well."""
    study = Study(pathlib.Path(arguments.study), arguments.coarse)
    folder = pathlib.Path(arguments.folder or f"output/{study.name}").resolve()
    folder.mkdir(parents=True, exist_ok=True)
    tasks = runs.tasks(study, folder)
    reference_tasks, belongs = references.plan(study, tasks, folder)
    everything = reference_tasks + tasks
    done = (
        runs.read_all(everything)
        if arguments.draw_only
        else runs.run_all(arguments.executable, everything, arguments.jobs or 1)
    )
    results = done[len(reference_tasks) :]
    for number, result in enumerate(results):
        result.exact_force = study.exact_force
        result.reference = done[belongs[number]] if belongs else None
    rows = tables.observed(study, results)
    tables.write(rows, folder / "table")
    if study.figure:
        from studies import scatter  # needs matplotlib, a table does not

        scatter.draw(study, results, folder / "figure.png")
    print(f"\n{tables.markdown(rows)}\n\n{folder / 'table.md'}")
    return all(done)


def main():
    arguments = parse()
    try:
        instants.use(arguments.executable)
        if arguments.study == "krause-walloth":
            from studies import comparison  # needs matplotlib, a study of a file does not

            good = comparison.krause_walloth(arguments, ROOT)
        elif arguments.study == "bar-table":
            from studies import bar_table

            good = bar_table.bar_table(arguments, ROOT)
        elif arguments.study == "adaptive":
            from studies import adaptive

            good = adaptive.adaptive(arguments, ROOT)
        elif arguments.study == "work-precision":
            from studies.work_precision import study

            good = study.work_precision(arguments, ROOT)
        elif arguments.study == "benchmark":
            from studies.benchmark import study

            good = study.benchmark(arguments, ROOT)
        else:
            good = study_of_a_file(arguments)
    except Mistake as mistake:
        print(f"study.py: {mistake}", file=sys.stderr)
        sys.exit(2)
    except OSError as error:
        sys.exit(
            f"study.py: {error.filename}: {error.strerror}. Name a folder that can be written."
        )
    except ImportError as error:
        sys.exit(
            f"study.py: {error}. On Debian: apt-get install python3-matplotlib python3-meshio, and"
            " run it with /usr/bin/python3 (./dev study does both)."
        )
    sys.exit(0 if good else 1)


if __name__ == "__main__":
    main()
