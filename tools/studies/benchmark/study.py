# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The study benchmark as the command line wants it."""

import math
import pathlib

from ..mistake import Mistake
from ..tables import markdown, write
from . import page
from .certificate import combine, extrapolate, rounded
from .problem import Problem, read_certified
from .rows import FAILED, OUTSIDE, others, own
from .rows import write as write_results

#: Below the root of the sources.
STUDIES = pathlib.Path("parameters/studies/benchmark")
CERTIFIED = STUDIES / "certified.csv"
RESULTS = STUDIES / "results.csv"
PEERS = pathlib.Path("parameters/studies/peers.csv")


def benchmark(arguments, root):
    """Runs all cases, or reads what was run; results.csv, tables.md, and the page if one is given,
    with the results kept in the sources. With --certify the reference values instead. Returns
    whether all is as it should be."""
    folder = pathlib.Path(arguments.folder or "output/benchmark").resolve()
    folder.mkdir(parents=True, exist_ok=True)
    if arguments.certify:
        return certify(arguments, root, folder)
    rows, certified = [], read_certified(root / CERTIFIED)
    for path in sorted((root / STUDIES).glob("*.ini")):
        problem = Problem(path, arguments.coarse, folder, certified)
        missing = set(problem.study.observe) - set(problem.references)
        if missing:
            raise Mistake(
                f"{path}: nothing is known of {', '.join(sorted(missing))}. Give [exact], or run"
                " ./dev study benchmark --certify."
            )
        rows += own(problem, arguments.executable, arguments.draw_only)
        rows += others(problem, root / PEERS)
        write_results(rows, folder / "results.csv")
    text = "".join(f"## {name}\n\n{part}\n\n" for name, part in page.parts(rows).items())
    (folder / "tables.md").write_text(text, encoding="utf-8")
    if arguments.page:
        old = arguments.page.read_text(encoding="utf-8")
        arguments.page.write_text(page.renew(old, rows), encoding="utf-8")
        write_results(rows, root / RESULTS)
    wrong = [row for row in rows if row["verdict"] in (OUTSIDE, FAILED)]
    for row in wrong:
        print(
            f"{row['verdict']}: {row['case']}, {row['settings']}: {row['quantity']} ="
            f" {row['value']}, not {row['reference']} to {row['tolerance']}"
        )
    print(f"\n{text}{folder / 'results.csv'}")
    return not wrong


def certify(arguments, root, folder):
    """Reference values with error bars, into certified.csv, and the series that they come from,
    into series.csv. Returns whether they agree with those of the sources."""
    stored = {(row["case"], row["quantity"]): row for row in read_certified(root / CERTIFIED)}
    table = [["case", "quantity", "value", "uncertainty", "order", "scheme"]]
    series, good = [["case", "quantity", "scheme", "values", "extrapolated", "uncertainty"]], True
    for path in sorted((root / STUDIES).glob("*.ini")):
        problem = Problem(path, False, folder, [])
        if not problem.to_certify:
            continue
        print(problem.study.title, flush=True)
        results = problem.series(arguments.executable, arguments.draw_only)
        for name in problem.to_certify:
            values = {
                scheme: [problem.value(name, result) for result in runs]
                for scheme, runs in results.items()
            }
            found = {
                scheme: extrapolate(numbers, problem.resolution(name, results[scheme][-1]))
                for scheme, numbers in values.items()
                if not any(map(math.isnan, numbers))
            }
            if not found:
                print(f"  no series of {name} came to its end")
                good = False
                continue
            for scheme, one in found.items():
                numbers = " ".join(f"{value:.7g}" for value in values[scheme])
                series.append([problem.name, name, scheme, numbers, *rounded(one)])
            whole = combine(list(found.values()))
            scheme = next(key for key, one in found.items() if one.value == whole.value)
            order = "" if math.isnan(whole.order) else f"{whole.order:.1f}"
            table.append([problem.name, name, *rounded(whole), order, scheme])
            good &= agrees(whole, stored.get((problem.name, name)), problem.name, name)
    write(table, folder / "certified")
    write(series, folder / "series")
    print(f"\n{markdown(series)}\n\n{markdown(table)}\n\n{folder / 'certified.csv'}")
    return good


def agrees(found, row, case, name):
    """Whether a value lies where the stored one is, within both error bars; says so if not."""
    if row is None:
        print(f"  {case}: {name} is not in {CERTIFIED} yet")
        return False
    distance = abs(found.value - float(row["value"]))
    if distance <= found.uncertainty + float(row["uncertainty"]):
        return True
    print(f"  {case}: {name} is {found.value:.7g}, and {row['value']} in {CERTIFIED}")
    return False
