# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The tables of the study work-precision, and the text that reads them."""

from ..case import text
from ..tables import markdown
from .front import cheapest, pareto, points
from .problem import COSTS

#: Errors for which the cheapest run is looked for, in per cent.
LEVELS = (10, 1, 0.1)
ALL = "all of them"


def runs(problem):
    """A line for each run; the last column names the errors on whose Pareto front it is."""
    names = problem.quantities
    fronts = {name: pareto(points(problem.rows, [name])) for name in names}
    rows = [["run", "kind", *COSTS.values(), *(f"{name}, %" for name in names), "front"]]
    for number, (variant, numbers) in enumerate(problem.rows):
        rows.append(
            [
                variant.name,
                variant.group,
                *(text(numbers.get(name, float("nan"))) for name in (*COSTS, *names)),
                ", ".join(name for name in names if number in fronts[name]) or "-",
            ]
        )
    return rows


def best(problem):
    """The cheapest run for each level and each error, and for all errors at once."""
    targets = {**{name: [name] for name in problem.quantities}, ALL: problem.quantities}
    rows = [["error at most", *targets]]
    for level in LEVELS:
        row = [f"{level} %"]
        for names in targets.values():
            row.append(answer(problem, names, level))
        rows.append(row)
    return rows


def answer(problem, names, level):
    """The cheapest run with errors up to a level, or why there is none."""
    open_question = max(problem.floor.get(name, 0.0) for name in names)
    if level < open_question:
        return f"not known: the reference leaves {text(open_question)} % open"
    number = cheapest(points(problem.rows, names), level)
    if number is None:
        return "none of these"
    variant, numbers = problem.rows[number]
    return f"{variant.name} ({text(numbers['seconds'])} s, {text(numbers['products'])} products)"


def sentences(problem):
    """What the tables say, for a reader without the time to read them."""
    said = []
    for level in LEVELS:
        reached = [
            (name, cheapest(points(problem.rows, [name]), level))
            for name in problem.quantities
            if level >= problem.floor.get(name, 0.0)
        ]
        winners = {}
        for name, number in reached:
            winners.setdefault(number, []).append(name.replace("_", " "))
        parts = [
            f"`{problem.rows[number][0].name}` for {listing(names)}"
            f" ({text(problem.rows[number][1]['seconds'])} s)"
            for number, names in winners.items()
            if number is not None
        ]
        if None in winners:
            parts.append(f"none for {listing(winners[None])}")
        said.append(f"The cheapest run for {level} %: {'; '.join(parts) or 'not known'}.")
    crowd = [variant for variant, numbers in problem.rows if not numbers]
    if crowd:
        said.append("Failed: " + ", ".join(f"`{variant.name}`" for variant in crowd) + ".")
    for scheme, message in problem.refused.items():
        reason = message.split(". ")[0].rsplit(": ", 1)[-1]
        said.append(f"Not run along the path: `{scheme}` ({reason}).")
    return said


def listing(names):
    """a, b and c."""
    return " and ".join(filter(None, [", ".join(names[:-1]), names[-1]]))


def settings(problem):
    """The keys behind the numbers of the path."""
    rows = problem.study.path_of_schemes
    lines = [["number", *(key for key in rows[0])]] if rows else []
    return lines + [[str(number), *row.values()] for number, row in enumerate(rows, 1)]


def part(problem, peers):
    """The part of the page about a problem. peers: the table with other programs, or None."""
    name = problem.folder.name
    pieces = [
        f"## {problem.study.title}",
        f"![Errors over processor time]({name}.png)",
        "".join(f"* {sentence}\n" for sentence in sentences(problem)).rstrip(),
        markdown(best(problem)),
        "All schemes, by their number:",
        markdown(settings(problem)),
        markdown(runs(problem)),
    ]
    if peers:
        pieces += [
            "Beside other programs:",
            f"![Other programs]({name}_peers.png)",
            markdown(peers),
        ]
    return "\n\n".join(pieces) + "\n\n"
