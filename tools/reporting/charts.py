# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Which curves of which tables stand in one chart."""

import dataclasses
import re

import numpy
from plotting import curves

#: Rows of a chart; of more the smallest and the largest of each stretch are kept.
MOST_ROWS = 4000
#: Of each table: title of a chart, and a pattern with the owner and the label of a column.
RULES = {
    "history": (
        ("Energy", r"()(kinetic_energy|elastic_energy|external_energy|total_energy)"),
        ("Contact force", r"()(contact_force|friction_force|contact_force_[xyz])"),
        ("Nodes in contact", r"()(active_nodes|stick_nodes|slip_nodes)"),
        ("Momentum", r"()(momentum_[xyz])"),
        ("Angular momentum", r"()(angular_momentum_[xyz])"),
        ("Penetration", r"()(max_penetration|geometric_penetration)"),
        ("Size of the steps", r"()(step_size)"),
        ("Cells", r"()(cells)"),
        ("Work in a step", r"()(work_\w+|energy_transfer)"),
        ("Unexplained change of energy in a step", r"()(energy_residual)"),
        ("Iterations", r"()(\w+_iterations)"),
        ("Products with matrices", r"()(products_\w+)"),
        ("Rejected steps and fallbacks", r"()(rejected_steps|fallbacks)"),
    ),
    "probe": (
        ("Distance", r"()(gap|normal_displacement)"),
        ("Position", r"()(position_[xyz])"),
        ("Displacement", r"()(displacement_[xyz])"),
        ("Velocity", r"()(normal_velocity|velocity_[xyz])"),
        ("Pressure", r"()(pressure)"),
        ("Nodal force", r"()(normal_force|tangential_force_[xyz])"),
        ("Stress", r"()(stress_\w+|von_mises)"),
        ("Slip", r"()(slip\w*)"),
    ),
    "pairs": (
        ("Force", r"pair_(\d+)_(force_[xyz]|normal_force|friction_force)"),
        ("Moment", r"pair_(\d+)_(moment_[xyz])"),
        ("Nodes in contact", r"pair_(\d+)_(active_nodes)"),
        ("Gap", r"pair_(\d+)_(smallest_gap|max_penetration|depth)"),
    ),
    "supports": (("Force of the support", r"support_(.+)_([xyz])"),),
    "bodies": (
        ("Energy", r"body_(.+?)_(kinetic_energy|elastic_energy)"),
        ("Angular momentum", r"body_(.+?)_(angular_momentum_[xyz])"),
        ("Momentum", r"body_(.+?)_(momentum_[xyz])"),
        ("Centroid", r"body_(.+?)_(centroid_[xyz])"),
        ("Velocity", r"body_(.+?)_(velocity_[xyz])"),
    ),
    "forces": (
        *((f"Contact force {axis} by three routes", rf"force_(.+)_(\w+_{axis})") for axis in "xyz"),
        ("Distance of the routes", r"force_(.+)_(spread)"),
    ),
}
#: Curves below this part of the largest one beside them are zero.
ROUND_OFF = 1e-12
#: Charts of what belongs to steps as a whole.
STEPPED = {"Cells", "Size of the steps"}
NO_CURVES = {"time", "step", "dofs", "wall_time"}


@dataclasses.dataclass
class Chart:
    """Curves over time; those that are zero throughout are named only."""

    title: str
    time: numpy.ndarray
    curves: dict  # label: values
    zero: list = dataclasses.field(default_factory=list)

    def add(self, label, values):
        """One more curve."""
        if numpy.any(values):
            self.curves[label] = values
        else:
            self.zero.append(label)

    def data(self):
        """For curves.js: rows of numbers, null for what is none."""
        largest = max(numpy.nanmax(abs(values)) for values in self.curves.values())
        shown = {
            label: values
            for label, values in self.curves.items()
            if not numpy.nanmax(abs(values)) <= ROUND_OFF * largest
        }
        zero = [*self.zero, *(label for label in self.curves if label not in shown)]
        rows = thin(numpy.column_stack([self.time, *shown.values()]))
        return {
            "title": self.title,
            "labels": ["time", *shown],
            "rows": [[number(value) for value in row] for row in rows],
            "note": f"zero: {', '.join(zero)}" if zero else "",
            "stepped": "Nodes" in self.title or self.title in STEPPED,
        }


def number(value):
    """With the digits that can be seen, None for what is no number."""
    return float(f"{value:.8g}") if numpy.isfinite(value) else None


def thin(rows):
    """At most about MOST_ROWS rows: of each stretch those with an extreme value of a curve."""
    if len(rows) <= MOST_ROWS:
        return rows
    stretches = numpy.array_split(
        numpy.arange(len(rows)), max(1, MOST_ROWS // (2 * rows.shape[1] - 2))
    )
    keep = {0, len(rows) - 1}
    for stretch in stretches:
        values = numpy.nan_to_num(rows[stretch, 1:])
        keep.update(stretch[values.argmin(axis=0)], stretch[values.argmax(axis=0)])
    return rows[sorted(keep)]


def sections(run):
    """(title, charts) of each table, the history first."""
    found = []
    if "time" in run.history:
        charts = charts_of(run.history, RULES["history"], str)
        energy = energy_changes(run.history)
        found.append(("The whole scene", [*charts[:1], *energy, *charts[1:]]))
    for name, table in run.probes.items():
        found.append((f"Probe {name}", charts_of(table, RULES["probe"], str)))
    pairs = [f"{slave} : {master}" for slave, master, _ in run.pairs()]
    titles = {"pairs": "Pairs", "supports": "Supports", "bodies": "Bodies", "forces": "Forces"}
    for name, title in titles.items():
        if name in run.tables:

            def owner(text, is_pair=name == "pairs"):
                return pairs[int(text)] if is_pair and int(text) < len(pairs) else text

            found.append((title, charts_of(run.tables[name], RULES[name], owner)))
    return [(title, charts) for title, charts in found if charts]


def charts_of(table, rules, owner_name):
    """By the rules, in their order; a column that none of them knows gets a chart of its own."""
    if "time" not in table:
        return []
    charts = {}
    for column, values in table.items():
        if column in NO_CURVES or is_repeated(column, table):
            continue
        number, owner, label = place(column, rules)
        title = rules[number][0] if number < len(rules) else column
        if owner:
            title += f": {owner_name(owner)}"
        chart = charts.setdefault((owner, number, title), Chart(title, table["time"], {}))
        chart.add(label, values)
    order = sorted(charts, key=lambda key: (key[0], key[1]))
    return [charts[key] for key in order if charts[key].curves]


def is_repeated(column, table):
    """Whether energies of the mass of the scheme are those of the mass of the body."""
    standard = column.removesuffix("_modified")
    return standard != column and numpy.array_equal(table[column], table.get(standard))


def place(column, rules):
    """(number of the rule, owner, label) of a column."""
    for number, (_, pattern) in enumerate(rules):
        match = re.fullmatch(pattern, column)
        if match:
            return number, match[1], match[2]
    return len(rules), "", column


def energy_changes(history):
    """The change of the total energy and the causes that add up to it, in per cent."""
    try:
        kinetic, elastic, total = (
            history[f"{name}_energy"] for name in ("kinetic", "elastic", "total")
        )
    except KeyError:
        return []
    scale, name = curves.energy_scale(
        total, kinetic, elastic, history.get("external_energy", total)
    )
    chart = Chart(
        f"Change of the total energy and its causes, % of the {name}", history["time"], {}
    )
    chart.add("total", 100.0 * (total - total[0]) / scale)
    for column in [*filter(lambda name: name.startswith("work_"), history), "energy_transfer"]:
        if column in history and column != "work_geometry":
            chart.add(column, 100.0 * numpy.cumsum(history[column]) / scale)
    return [chart] if chart.curves else []
