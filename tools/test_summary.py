#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""What the tests said, by area: a line for each folder of tests.

    test_summary.py RESULTS BUILD     a file of ctest --output-junit, and the folder it ran in

Tests that are skipped, for want of a program or package, are named: a green run without them says
less.
"""

import argparse
import collections
import json
import pathlib
import subprocess
import xml.etree.ElementTree


def folder(backtrace, graph):
    """@return the folder of tests whose CMakeLists.txt adds a test, by whatever functions"""
    node, found = graph["nodes"][backtrace], "others"
    while node is not None:
        parts = pathlib.Path(graph["files"][node["file"]]).parts
        if parts[-1] == "CMakeLists.txt" and "tests" in parts[:-2]:
            found = parts[-2]
        node = graph["nodes"][node["parent"]] if "parent" in node else None
    return found


def areas(build):
    """@return the area of each test"""
    command = ["ctest", "--test-dir", build, "--show-only=json-v1"]
    listed = json.loads(subprocess.run(command, capture_output=True, check=True).stdout)
    graph = listed["backtraceGraph"]
    return {test["name"]: folder(test["backtrace"], graph) for test in listed["tests"]}


def summary(cases, area_of):
    """@param cases name, status (run, fail, notrun or disabled) and seconds of each test"""
    counts = collections.defaultdict(collections.Counter)
    seconds = collections.Counter()
    left_out = []
    for name, status, time in cases:
        area = area_of.get(name, "others")
        counts[area][status] += 1
        seconds[area] += time
        if status not in ("run", "fail"):
            left_out.append(name)
    lines = [f"{'area':24} {'passed':>6} {'failed':>6} {'skipped':>7} {'seconds':>8}"]
    rows = sorted(counts.items()) + [("all", sum(counts.values(), collections.Counter()))]
    seconds["all"] = sum(seconds.values())
    for area, count in rows:
        skipped = count["notrun"] + count["disabled"]
        numbers = f"{count['run']:6} {count['fail']:6} {skipped:7} {seconds[area]:8.0f}"
        lines.append(f"{area:24} {numbers}")
    if left_out:
        lines.append("skipped: " + ", ".join(sorted(left_out)))
    return "\n".join(lines)


def main():
    """Prints the table."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("results", type=pathlib.Path)
    parser.add_argument("build")
    arguments = parser.parse_args()
    cases = [
        (case.get("name"), case.get("status"), float(case.get("time")))
        for case in xml.etree.ElementTree.parse(arguments.results).iter("testcase")
    ]
    print(summary(cases, areas(arguments.build)))


if __name__ == "__main__":
    main()
