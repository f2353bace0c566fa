# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""What the program may answer: success, or one message that says what is wrong and what to do; and
no table with nonsense."""

import re

from stress import laws, verdict

#: Largest part of the energy of a step without an explanation.
ACCURACY = 1e-8
#: Words of libraries that tell nobody what to do.
JARGON = re.compile(
    r"Exc[A-Z]\w+|An error occurred|violated|tacktrace|std::|basic_string|vector::|bad_alloc"
    r"|what\(\)|terminate called|_M_|dealii|Assert|stoi|stod|stoul|regex|unknown reason|map::at"
    r"|\.cc\b|filesystem error|optional|variant|Epetra|Teuchos|p4est|MPI_"
)
STATUS_OF_TIME = (128 + 24, 128 + 14)  # SIGXCPU, SIGALRM


def read(folder, name):
    """A stream of a run."""
    return (folder / name).read_text(encoding="utf-8", errors="replace")


def message(folder):
    """What was said on the error stream, without warnings."""
    lines = read(folder, "err").rstrip("\n").split("\n")
    return "\n".join(line for line in lines if "warning: " not in line)


def wrong_answer(status, text):
    """What is wrong about status and message, or nothing."""
    if status in STATUS_OF_TIME:
        return "no end"
    if status > 128:
        return f"signal {status - 128}: {text[-200:]}"
    if status not in (0, 1, 2):
        return f"exit status {status}: {text[-200:]}"
    if status == 0:
        return f"a message without failure: {text[:200]}" if text else ""
    if not text.startswith("signorini: ") or "\n" in text:
        return f"not one message: {text[:400]!r}"
    if not text.rstrip().endswith((".", "?", ")", "`")) or len(text.split()) < 5:
        return f"no sentence: {text[:200]!r}"
    jargon = JARGON.search(text)
    return f"not for users ({jargon[0]}): {text[:300]}" if jargon else ""


def shape(status, text):
    """The message without what differs from case to case."""
    text = re.sub(r"`[^`]*`", "``", text)
    text = re.sub(r"/\S*?\.\w+(, line \d+)?", "FILE", text)
    text = re.sub(r"(FILE(, --set)?: )[^:]* = .*?: ", r"\1KEY = VALUE: ", text)
    return f"{status} {re.sub(NUMBERS, '#', text)[:160]}"


NUMBERS = r"[-+]?\d+\.?\d*([eE][-+]?\d+)?|\b-?(nan|inf)\b"


def nonsense(folder, scheme):
    """What the tables of a run that has ended say against the laws, without a warning."""
    output = folder / "output"
    if not (output / "history.csv").exists():
        return "no table"
    run = verdict.Judged(output, None, scheme, ACCURACY)
    if not run.columns:
        return "an empty table"
    broken = list(laws.finite(run))
    if not broken:
        broken = list(laws.ledger(run)) + list(laws.no_gain(run))
    warned = "warning: " in read(folder, "err")
    return "" if warned else "; ".join(broken)
