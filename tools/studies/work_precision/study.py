# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The study work-precision as the command line wants it."""

import pathlib

from .. import tables
from . import figures, page, peers
from .problem import Problem


def work_precision(arguments, root):
    """Runs all problems, or reads what was run; figures, tables and a page. Returns whether each
    problem has results: runs of poor schemes may fail, and the page tells which."""
    folder = pathlib.Path(arguments.folder or "output/work_precision").resolve()
    folder.mkdir(parents=True, exist_ok=True)
    good, text = True, ""
    for path in sorted((root / "parameters" / "studies" / "work_precision").glob("*.ini")):
        problem = Problem(arguments.executable, path, arguments.coarse, folder)
        done, exact = problem.run(arguments.executable, arguments.draw_only)
        if not any(done):
            good = False
            continue
        problem.read(done, exact)
        text += write(problem, folder, root / "parameters" / "studies" / "peers.csv")
        (folder / "tables.md").write_text(text, encoding="utf-8")
    print(f"\n{text}{folder / 'tables.md'}")
    return good


def write(problem, folder, others):
    """Figures and tables of a problem; its part of the page."""
    name, compared = problem.folder.name, None
    figures.draw(problem, folder / f"{name}.png")
    tables.write(page.runs(problem), folder / name)
    tables.write(page.best(problem), folder / f"{name}_best")
    if problem.study.peers:
        names, lines = peers.beside(problem, others)
        compared = peers.table(names, lines)
        tables.write(compared, folder / f"{name}_peers")
        figures.draw_peers(
            problem.study.title,
            [(code, cost, errors) for _, code, _, cost, errors in lines],
            names,
            folder / f"{name}_peers.png",
        )
    return page.part(problem, compared)
