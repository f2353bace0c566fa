#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Runs the shipped scenes for the gallery of the manual.

gallery.py EXECUTABLE [--only NAME ...] [--all] [--limit SECONDS]

For each scene the summary of its run and its processor time go to doc/manual/gallery.json, and a
small picture to doc/manual/gallery. Both are kept with the sources. A scene is run only if it has
no entry, or if its keys or meshes have changed since; --all runs all of them. A scene that needs
more processor time than the limit is named at the end, and its entry stays as it was.
"""

import argparse
import json
import pathlib
import resource
import subprocess
import sys
import tempfile

from PIL import Image

import scenes

RESULTS = scenes.ROOT / "doc" / "manual" / "gallery.json"
PICTURES = scenes.ROOT / "doc" / "manual" / "gallery"
LARGEST_PICTURE = 40_000  # bytes
WIDTH = 760  # pixels


class Failure(Exception):
    """A run or its picture did not come to its end."""


def read_results():
    """{name of a scene: its entry}."""
    return json.loads(RESULTS.read_text(encoding="utf-8")) if RESULTS.is_file() else {}


def forecast(executable, scene):
    """What --validate says about a scene."""
    command = [executable, scene.path, "--validate=json"]
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    if result.returncode != 0:
        raise Failure(result.stderr.strip())
    return json.loads(result.stdout)


def summary_of(log):
    """The lines of a log between the last step and the table of times, without their indent."""
    lines = log.splitlines()
    steps = [number for number, line in enumerate(lines) if line.startswith("step ")]
    result = []
    for line in lines[steps[-1] + 1 :]:
        if not line.strip():
            break
        result.append(line.removeprefix("  ").rstrip())
    return [line for line in result if not line.startswith(("warning:", "note:"))]


def run(executable, scene, folder, limit):
    """Run a scene into a folder; returns (summary, processor seconds)."""

    def limits():
        resource.setrlimit(resource.RLIMIT_CPU, (limit, limit + 5))

    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    command = [executable, scene.path, "--quiet", "--set", f"Output directory={folder}"]
    result = subprocess.run(
        [*command, "--set", "Output/VTU=true"],
        capture_output=True,
        text=True,
        check=False,
        preexec_fn=limits,
    )
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if result.returncode != 0:
        raise Failure(result.stderr.strip() or f"more than {limit} s of processor time")
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return summary_of((folder / "log.txt").read_text(encoding="utf-8")), seconds


def write_picture(source, target):
    """A copy of a picture, as wide as fits into LARGEST_PICTURE bytes."""
    with Image.open(source) as image:
        picture = image.convert("RGB")
    target.parent.mkdir(parents=True, exist_ok=True)
    for width in range(WIDTH, WIDTH // 3, -40):
        height = round(picture.height * width / picture.width)
        small = picture.resize((width, height), Image.Resampling.LANCZOS)
        # An octree keeps the colours of small areas, such as a contact; the median cut loses them.
        small = small.quantize(128, Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE)
        small.save(target, optimize=True)
        if target.stat().st_size <= LARGEST_PICTURE:
            return
    raise Failure(f"{target} is larger than {LARGEST_PICTURE} bytes at every width")


def draw(scene, folder):
    """The picture of a run: the bodies, or the contact force where they cannot be drawn."""
    plot = scenes.ROOT / "tools" / "plot.py"
    subprocess.run([sys.executable, "-B", plot, folder], capture_output=True, check=False)
    for name in ("bodies", "contact_force"):
        source = folder / "pictures" / f"{name}.png"
        if source.is_file():
            write_picture(source, PICTURES / f"{scene.name}.png")
            return
    raise Failure(f"no picture in {folder / 'pictures'}")


def entry_of(executable, scene, expected, limit):
    """Run and draw a scene; returns its entry."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name) / "run"
        summary, seconds = run(executable, scene, folder, limit)
        draw(scene, folder)
    return {
        "checksum": scene.checksum,
        "scheme": expected["scheme"],
        "dimension": expected["dimension"],
        "cells": expected["cells"],
        "dofs": expected["dofs"],
        "steps": None if expected["variable_steps"] else expected["steps"],
        "processor_seconds": float(f"{seconds:.2g}"),
        "summary": summary,
    }


def parse():
    """The command line."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("executable", type=pathlib.Path, metavar="EXECUTABLE")
    parser.add_argument("--only", nargs="+", metavar="NAME", help="these scenes, whatever is kept")
    parser.add_argument("--all", action="store_true", help="all scenes, whatever is kept")
    parser.add_argument("--limit", type=int, default=600, metavar="SECONDS")
    options = parser.parse_args()
    options.executable = options.executable.resolve()
    return options


def main():
    options = parse()
    shipped = scenes.shipped()
    unknown = set(options.only or []) - {scene.name for scene in shipped}
    if unknown:
        sys.exit(f"gallery.py: there is no scene {', '.join(sorted(unknown))} in parameters")
    wanted, failures = [], []
    kept = read_results()
    for scene in shipped:
        stale = kept.get(scene.name, {}).get("checksum") != scene.checksum
        chosen = scene.name in options.only if options.only else options.all or stale
        if chosen:
            expected = forecast(options.executable, scene)
            cost = expected["dofs"] * (expected["steps"] or 1)
            wanted.append((cost, scene, expected))
    for _, scene, expected in sorted(wanted, key=lambda item: item[0]):
        try:
            entry = entry_of(options.executable, scene, expected, options.limit)
        except Failure as failure:
            failures.append(f"{scene.name}: {failure}")
            continue
        kept[scene.name] = entry
        names = {other.name for other in shipped}
        kept = {name: kept[name] for name in sorted(kept) if name in names}
        RESULTS.write_text(json.dumps(kept, indent=1) + "\n", encoding="utf-8")
        print(f"{scene.name}: {entry['processor_seconds']} s", flush=True)
    for failure in failures:
        print(f"gallery.py: {failure}", file=sys.stderr)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
