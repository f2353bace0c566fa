# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Reading of the comma-separated tables of a run."""

import csv

import numpy

from .problem import Problem


def read_table(path):
    """Columns of a table, arrays by name. Rows that a killed run left incomplete are skipped."""
    try:
        with open(path, newline="", encoding="utf-8") as file:
            rows = list(csv.reader(file))
    except OSError as error:
        raise Problem(f"{path}: {error.strerror}") from None
    except (UnicodeDecodeError, csv.Error):
        raise Problem(f"{path} is not a table") from None
    if not rows:
        raise Problem(f"{path} is empty")
    names = [name.strip() for name in rows[0]]
    numbers = [row for row in map(_numbers, rows[1:]) if len(row) == len(names)]
    if not numbers:
        raise Problem(f"{path} has a header but no complete row")
    return dict(zip(names, numpy.array(numbers).T))


def _numbers(row):
    try:
        return [float(entry) for entry in row]
    except ValueError:
        return []


def require(table, *names):
    """The named columns, as a list."""
    missing = [name for name in names if name not in table]
    if missing:
        raise Problem(f"a table lacks the column {', '.join(missing)}")
    return [table[name] for name in names]
