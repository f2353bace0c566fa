#!/usr/bin/python3 -B
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""One page about one run: report.py DIR writes DIR/report.html, which needs no other file and no
network."""

import argparse
import json
import pathlib
import sys

try:
    from plotting import pictures
except ImportError as error:
    sys.exit(
        f"{pathlib.Path(sys.argv[0]).name}: {error}. On Debian: apt-get install python3-matplotlib "
        "python3-meshio libjs-dygraphs, which is for Debian's own /usr/bin/python3."
    )

from plotting.problem import Problem
from reporting import dygraphs
from reporting.page import make_page
from reporting.run import Run
from reporting.view import View

#: A page of this size opens in a second or two; curves and pictures take less than one of it.
MOST_MEGABYTES = 30.0
MEGABYTE = 1e6
#: To meet the size.
ATTEMPTS = 4


def read_arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument(
        "directory", type=pathlib.Path, metavar="DIR", help="output directory of a run"
    )
    parser.add_argument(
        "--megabytes",
        type=float,
        default=MOST_MEGABYTES,
        help="about how large the page may be; moments and faces are left out until it is "
        "(default: %(default)g)",
    )
    return parser.parse_args()


def make_view(run, most_bytes):
    """(view, "") or (None, the reason). The size of changing meshes is known when they are there:
    then the view is made again, with less."""
    aim = most_bytes
    try:
        for _ in range(ATTEMPTS):
            view = View(run, aim)
            size = len(json.dumps(view.data()))
            if size <= most_bytes:
                break
            aim *= 0.9 * most_bytes / size
        return view, ""
    except Problem as problem:
        return None, str(problem)


def write_report(directory, megabytes):
    """Write the page. Returns its path, its size in bytes, and what was left out."""
    run = Run(directory)
    if not run.tables and not run.log.program:
        raise Problem(
            f"{directory} has no table and no log.txt. Give the 'Output directory' of a run."
        )
    drawn, problems, _ = pictures.draw_pictures(directory)
    without_view = len(make_page(run, None, "", drawn).encode("utf-8"))
    view, reason = make_view(run, max(megabytes * MEGABYTE - without_view, 0.1 * MEGABYTE))
    page = make_page(run, view, reason, drawn).encode("utf-8")
    path = directory / "report.html"
    try:
        path.write_bytes(page)
    except OSError as error:
        raise Problem(f"cannot write {path}: {error.strerror}") from None
    return path, len(page), [*map(str, problems), *([] if view is None else view.problems)]


def main():
    arguments = read_arguments()
    directory = arguments.directory
    if not directory.is_dir():
        sys.exit(
            f"report.py: {directory} is not a directory. Give the 'Output directory' of a run."
        )
    if not arguments.megabytes > 0.0:
        sys.exit(f"report.py: --megabytes {arguments.megabytes:g} has to be positive")
    try:
        path, size, problems = write_report(directory, arguments.megabytes)
    except Problem as problem:
        sys.exit(f"report.py: {problem}")
    for problem in dict.fromkeys(problems):
        print(f"report.py: left out: {problem}", file=sys.stderr)
    if not dygraphs.embedded()[1]:
        print(f"report.py: {dygraphs.MISSING}", file=sys.stderr)
    print(f"{path} ({size / MEGABYTE:.2g} MB)")
    return 0


if __name__ == "__main__":
    sys.exit(main())
