#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The summary of the tests: each test counts once, in its folder, and what is skipped is named."""

import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools"))
import test_summary  # noqa: E402  (the path comes first)


class Summary(unittest.TestCase):
    """See the beginning of the file."""

    def test_counts(self):
        """Two areas, with all that can become of a test."""
        cases = [("a", "run", 1.0), ("b", "fail", 2.0), ("c", "notrun", 0.0), ("d", "run", 4.0)]
        areas = {"a": "contact", "b": "contact", "c": "fclib", "d": "fclib"}
        lines = [line.split() for line in test_summary.summary(cases, areas).splitlines()]
        self.assertEqual(lines[1], ["contact", "1", "1", "0", "3"])
        self.assertEqual(lines[2], ["fclib", "1", "0", "1", "4"])
        self.assertEqual(lines[3], ["all", "2", "1", "1", "7"])
        self.assertEqual(lines[4], ["skipped:", "c"])

    def test_area_is_the_folder_that_adds_the_test(self):
        """Not that of the function by which it is added."""
        files = ["/s/cmake/add.cmake", "/s/tests/whole_scenes/CMakeLists.txt"]
        files += ["/s/tests/fclib/CMakeLists.txt", "/s/tests/CMakeLists.txt"]
        nodes = [{"file": 3}, {"file": 2, "parent": 0}, {"file": 1, "parent": 1}]
        nodes.append({"file": 0, "parent": 2})
        graph = {"files": files, "nodes": nodes}
        self.assertEqual(test_summary.folder(3, graph), "fclib")
        self.assertEqual(test_summary.folder(0, graph), "others")


if __name__ == "__main__":
    unittest.main()
