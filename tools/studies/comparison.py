# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The study krause-walloth: all schemes on several scenes, in tables, figures and a page."""

import dataclasses
import io
import math
import pathlib

from PIL import Image
from plotting import style

from . import figures, judge, observe, page, runs, stress, tables
from .definition import Mistake, Study
from .observe import OBSERVATIONS

SCENES = ("krause_walloth_b", "krause_walloth_b_tilted", "krause_walloth_a")
PAPER = "krause_walloth_paper.csv"
#: Figures of a scene, drawn from curves.
CURVES = {
    "force": figures.force,
    "energy": figures.energy,
    "displacement": figures.displacement,
    "velocity": figures.velocity,
}
#: Figures of a scene, drawn from the pressure at one time.
PRESSURES = {
    "pressure": figures.pressure_over_radius,
    "pressure_from_above": figures.pressure_from_above,
}


@dataclasses.dataclass
class Scene:
    """A study with its results, in the order of its variants."""

    study: Study
    results: list

    def __post_init__(self):
        self.variants = self.study.variants
        time = self.study.pressure_time
        self.pressures = [
            stress.read_pressure(result.folder, time) if time and result else None
            for result in self.results
        ]
        self.numbers = [
            {name: observation(result) for name, observation in OBSERVATIONS.items()}
            for result in self.results
        ]
        for numbers, pressure in zip(self.numbers, self.pressures):
            if pressure is not None:
                numbers["pressure_scatter"] = pressure.scatter()

    def failures(self):
        """(variant, message) of the runs that failed."""
        return [
            (variant, result.failure)
            for variant, result in zip(self.variants, self.results)
            if not result
        ]

    def table(self):
        """All observations, with the scatter of the pressure where it is known."""
        rows = tables.observed(self.study, self.results)
        if self.study.pressure_time:
            rows[0].append("scatter of the pressure")
            for row, numbers in zip(rows[1:], self.numbers):
                row.append(tables.number(numbers.get("pressure_scatter", math.nan)))
        return rows

    def beside(self, row):
        """What was observed of a number of the paper, and how it compares."""
        names = [variant.name for variant in self.variants]
        if row["variant"] not in names:
            return ["-", "-"]
        at = names.index(row["variant"])
        text = judge.say(row["quantity"], self.numbers[at])
        verdict = judge.verdict(row["paper"], text)
        time = (
            observe.passes(self.results[at], float(row["paper"]))
            if row["quantity"] == "energy_most"
            else None
        )
        if time is not None and verdict != "agrees":
            verdict += f", passes the paper's at t = {time:.3g}"
        return [text, verdict]


def save(figure, path):
    """Write a figure with few colours, so that the file is small."""
    buffer = io.BytesIO()
    figure.savefig(buffer, format="png", dpi=100, bbox_inches="tight", pad_inches=0.1)
    style.close(figure)
    buffer.seek(0)
    Image.open(buffer).convert("RGB").quantize(256, dither=Image.Dither.NONE).save(
        path, optimize=True
    )


def draw(scene, folder):
    """The figures of a scene by name."""
    groups = figures.groups_of(zip(scene.variants, scene.results))
    drawn = {name: (function, groups) for name, function in CURVES.items() if groups}
    if scene.study.pressure_time:
        drawn.update(
            {
                name: (function, list(zip(scene.variants, scene.pressures)))
                for name, function in PRESSURES.items()
            }
        )
    written = {}
    for name, (function, data) in drawn.items():
        figure = function(data)
        if figure:
            written[name] = f"{scene.study.name}_{name}.png"
            save(figure, folder / written[name])
    return written


def check_paper(path, rows, variants):
    """Each line of the paper's numbers needs a known variant and a known quantity."""
    known = {
        "variant": [variant.name for variant in variants],
        "quantity": [*judge.WORDS, *judge.RANGES, *OBSERVATIONS],
    }
    for row in rows:
        for column, valid in known.items():
            if row.get(column) not in valid:
                raise Mistake(
                    f"{path}: {column} = {row.get(column)} is not known. Valid: {', '.join(valid)}."
                )


def against_paper(rows, scenes):
    """By geometry, tables that put numbers of the paper beside those of its scenes."""
    found = {}
    for geometry in dict.fromkeys(row["geometry"] for row in rows):
        here = [scene for scene in scenes if scene.study.geometry == geometry]
        if not here:
            continue
        found[geometry] = [
            ["section", "scheme", "observed", "paper"]
            + [text for scene in here for text in (f"here: {scene.study.title}", "")]
        ]
        for row in rows:
            if row["geometry"] == geometry:
                line = [
                    row["section"],
                    row["variant"],
                    judge.heading(row["quantity"]),
                    row["paper"],
                ]
                for scene in here:
                    line += scene.beside(row)
                found[geometry].append(line)
    return found


def compare(executable, files, paper, folder, coarse=False, jobs=2, draw_only=False, command=""):
    """Run the studies in `files`, write tables, figures and page.md; whether no run failed."""
    studies, paper_rows = [Study(file, coarse) for file in files], tables.read_rows(paper)
    check_paper(paper, paper_rows, [variant for study in studies for variant in study.variants])
    planned = [runs.tasks(study, folder / study.name) for study in studies]
    everything = [task for tasks in planned for task in tasks]
    folder.mkdir(parents=True, exist_ok=True)
    done = iter(
        runs.read_all(everything) if draw_only else runs.run_all(executable, everything, jobs)
    )
    scenes = [Scene(study, [next(done) for _ in tasks]) for study, tasks in zip(studies, planned)]
    style.use()
    pictures = {}
    for scene in scenes:
        tables.write(scene.table(), folder / scene.study.name)
        pictures[scene.study.name] = draw(scene, folder)
    beside = against_paper(paper_rows, scenes)
    for geometry, rows in beside.items():
        tables.write(rows, folder / f"paper_{geometry}")
    (folder / "page.md").write_text(page.page(scenes, pictures, beside, command), encoding="utf-8")
    print(f"\n{folder / 'page.md'}")
    count = sum(len(scene.failures()) for scene in scenes)
    if count:
        print(f"{count} of {len(everything)} runs failed; the page says why.")
    return not any(scene.failures() for scene in scenes)


def copy_page(folder, target):
    """A copy of the page, with its figures in the folder pictures next to it."""
    text = (folder / "page.md").read_text(encoding="utf-8")
    (target.parent / "pictures").mkdir(parents=True, exist_ok=True)
    for picture in sorted(folder.glob("*.png")):
        if f"({picture.name})" in text:
            (target.parent / "pictures" / picture.name).write_bytes(picture.read_bytes())
            text = text.replace(f"({picture.name})", f"(pictures/{picture.name})")
    target.write_text(text, encoding="utf-8")
    print(target)


def krause_walloth(arguments, root):
    """The study as the command line wants it."""
    data = root / "parameters" / "studies"
    folder = pathlib.Path(arguments.folder or "output/krause-walloth").resolve()
    good = compare(
        arguments.executable,
        [data / f"{name}.ini" for name in SCENES],
        data / PAPER,
        folder,
        arguments.coarse,
        arguments.jobs or 2,
        arguments.draw_only,
        "./dev study krause-walloth" + " --coarse" * arguments.coarse,
    )
    if arguments.page:
        copy_page(folder, arguments.page.resolve())
    return good
