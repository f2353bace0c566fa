# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The comma-separated tables of a run, also while it writes them.

A whole row ends with a line break. What follows the last one is being written, or was left behind
by a run that was killed, and is not read.
"""

import csv
import io
import pathlib


def complete_rows(path):
    """The text of a table up to its last whole row."""
    text = pathlib.Path(path).read_text(encoding="utf-8")
    return text[: text.rfind("\n") + 1]


def read_columns(path):
    """The columns of a table as lists of numbers by name, {} without rows."""
    rows = list(csv.reader(io.StringIO(complete_rows(path))))
    numbers = [[float(entry) for entry in row] for row in rows[1:]]
    return dict(zip(rows[0], map(list, zip(*numbers)))) if numbers else {}


def read_frame(path):
    """A table as a pandas frame."""
    import pandas  # pylint: disable=import-outside-toplevel

    # The default of pandas loses the last digits.
    return pandas.read_csv(io.StringIO(complete_rows(path)), float_precision="round_trip")


class GrowingTable:
    """A table that is read piece by piece."""

    def __init__(self, path):
        self.path, self.position, self.names = path, 0, []

    def new_rows(self):
        """Whole rows since the last call, as dictionaries of numbers by column. If the table was
        cut off in between, it is read from its beginning again."""
        try:
            with open(self.path, "rb") as file:
                file.seek(max(0, self.position - 1))
                data = file.read()
        except OSError:  # not there yet
            return []
        if self.position > 0:
            if data[:1] != b"\n":
                self.position = 0
                return self.new_rows()
            data = data[1:]
        data = data[: data.rfind(b"\n") + 1]
        rows = list(csv.reader(io.StringIO(data.decode())))
        if self.position == 0 and rows:
            self.names = rows.pop(0)
        self.position += len(data)
        return [dict(zip(self.names, map(float, row))) for row in rows]
