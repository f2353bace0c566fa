# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The tables of doc/benchmarks.md, from the rows of results.csv. In the page each stands between
two comments, <!-- benchmark: CASE --> and <!-- end of benchmark -->."""

import math
import re

from ..mistake import Mistake
from ..tables import markdown
from .rows import OWN

#: Whose error is smaller, if not that of this program.
OTHERS, EQUAL = "**the other**", "none"
#: Errors below this, relative, are round-off.
ROUND_OFF = 1e-8
#: A part of the page that is made, and the name of the part about all cases.
PART = r"<!-- benchmark: (\S+) -->\n.*?<!-- end of benchmark -->"
SUMMARY = "summary"


def relative(row):
    """The error of a row, in per cent of the reference; absolute where that is zero."""
    error, scale = float(row["error"] or "nan"), abs(float(row["reference"]))
    if math.isnan(error):
        return "-"
    value = 100 * error / scale if scale else error
    text = f"{value:+.2g}" if abs(error) > ROUND_OFF * (scale or 1) else "0"
    return f"{text} %" if scale else text


def by_run(rows):
    """The rows of each run."""
    runs = {}
    for row in rows:
        keys = ("code", "version", "scheme", "contact", "settings", "dofs", "processor_s")
        runs.setdefault(tuple(row[key] for key in keys), []).append(row)
    return list(runs.values())


def reference(row):
    """The reference of a quantity as a text."""
    bar = f" ± {row['uncertainty']}" if float(row["uncertainty"]) else ""
    return f"{row['reference']}{bar} ({row['kind']})"


def table(rows):
    """A line for each run: what it is, what it cost, the errors of its quantities."""
    names = list({row["quantity"]: row for row in rows}.values())
    lines = [
        ["run", "dofs", "steps", "processor s", *(row["quantity"] for row in names)],
        ["*reference*", "", "", "", *map(reference, names)],
    ]
    for run in by_run(rows):
        first, found = run[0], {row["quantity"]: row for row in run}
        what = f"{first['code']}: {first['scheme'] or 'failed'}"
        if first["code"] != OWN:
            what = f"{first['code']} {first['version']}: {first['scheme']}; {first['contact']}"
        errors = [
            relative(found[row["quantity"]]) if row["quantity"] in found else "-" for row in names
        ]
        cost = f"{float(first['processor_s']):.3g}" if first["processor_s"] else "-"
        lines.append([what, first["dofs"], first["steps"], cost, *errors])
    return markdown(lines)


def size(row):
    """The magnitude of an error, infinite if it is not known; below the uncertainty of the
    reference, and below round-off, nothing can be told."""
    floor = max(float(row["uncertainty"]), ROUND_OFF * abs(float(row["reference"])))
    return max(abs(float(row["error"])), floor) if row["error"] else math.inf


def beaten(rows):
    """Of each quantity that others have, too: the best of theirs, beside the best here on the same
    mesh, if there is one. On coarse meshes single numbers may be right by luck."""
    lines = [["quantity", "best of the others", "here, on the same mesh", "better"]]
    for name in dict.fromkeys(row["quantity"] for row in rows if row["code"] != OWN):
        found = [row for row in rows if row["quantity"] == name]
        theirs = min((row for row in found if row["code"] != OWN), key=size)
        mine = [row for row in found if row["code"] == OWN]
        best = min([row for row in mine if row["dofs"] == theirs["dofs"]] or mine, key=size)
        word = OTHERS if size(theirs) < size(best) else EQUAL if size(theirs) == size(best) else OWN
        lines.append([name, sentence(theirs), sentence(best), word])
    return markdown(lines) if len(lines) > 1 else ""


def sentence(row):
    """A run with the error of a quantity and its time."""
    time = f", {float(row['processor_s']):.3g} s" if row["processor_s"] else ""
    return f"{row['code']} ({row['scheme']}, {row['dofs']} dofs{time}): {relative(row)}"


def summary(rows):
    """A line for each case: size and cost of the runs, and the largest part of a tolerance that was
    used."""
    lines = [["case", "quantities", "runs", "dofs", "processor s", "within", "most of a tolerance"]]
    for case in dict.fromkeys(row["case"] for row in rows):
        mine = [row for row in rows if row["case"] == case and row["code"] == OWN]
        runs = by_run(mine)
        used = [abs(float(row["error"] or "inf")) / float(row["tolerance"]) for row in mine]
        lines.append(
            [
                f"[{case}](#{case})",
                str(len(runs[0])),
                str(len(runs)),
                " / ".join(run[0]["dofs"] for run in runs),
                f"{sum(float(run[0]['processor_s'] or 'nan') for run in runs):.1f}",
                f"{sum(row['verdict'] == 'within' for row in mine)} of {len(mine)}",
                f"{100 * max(used):.0f} %",
            ]
        )
    return markdown(lines)


def parts(rows):
    """The text of each part by its name."""
    found = {SUMMARY: summary(rows)}
    for case in dict.fromkeys(row["case"] for row in rows):
        mine = [row for row in rows if row["case"] == case]
        found[case] = "\n\n".join(filter(None, [table(mine), beaten(mine)]))
    return found


def renew(text, rows):
    """The page with its parts made anew."""
    made = parts(rows)
    missing = set(made) - set(re.findall(PART, text, re.DOTALL))
    if missing:
        raise Mistake(f"the page has no <!-- benchmark: ... --> for {', '.join(sorted(missing))}.")

    def replace(match):
        name = match[1]
        body = f"\n{made[name]}\n\n" if name in made else "\nNot run.\n\n"
        return f"<!-- benchmark: {name} -->\n{body}<!-- end of benchmark -->"

    return re.sub(PART, replace, text, flags=re.DOTALL)
