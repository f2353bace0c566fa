# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""What log.txt says: where the run comes from, its notes and warnings, summary and timers."""

import dataclasses
import re

#: Words of a warning that the guard of the laws gives.
BROKEN_LAW = "a law is broken"
#: Words of an end by a signal.
INTERRUPTED = "interrupted by"
#: What a run says that was to go on and had nothing to do.
NOTHING_TO_DO = "It had come to its end."
#: "at time 0.03 ..." and, in the summary, "since time 0.03 ... (the most of the run)".
PLACE_IN_TIME = re.compile(r"^(at|since) time \S+ ")


@dataclasses.dataclass
class Log:
    """Without a log.txt everything is empty."""

    program: str = ""  # first line: version, commit, date
    facts: list = dataclasses.field(default_factory=list)  # (name, value) of the head
    notes: list = dataclasses.field(default_factory=list)
    warnings: list = dataclasses.field(default_factory=list)  # each once, with its largest value
    broken_laws: list = dataclasses.field(default_factory=list)  # diagnoses of the guard
    summary: list = dataclasses.field(default_factory=list)  # lines
    timers: list = dataclasses.field(default_factory=list)  # (section, calls, seconds on average)
    wall_time: float = 0.0  # seconds of the slowest process
    early_end: str = ""  # why the run ended before its time

    @property
    def interrupted(self):
        """Whether somebody wanted the run to end early."""
        return INTERRUPTED in self.early_end

    @property
    def complete(self):
        """Whether the program wrote its summary: no kill, no crash."""
        return any(line.startswith("energy ") for line in self.summary)


def parse_log(text):
    """A Log. What a killed run or another version left out is empty."""
    log, before = Log(), Log()
    steps, early_ends = False, []
    for line in text.splitlines():
        content = line.strip()
        if line.startswith("signorini "):  # again where a run was resumed
            before = dataclasses.replace(log)
            log.program, log.facts, log.summary, log.timers, steps = content, [], [], [], False
            log.early_end = ""
            continue
        if content.startswith(("warning: ", "note: ")):
            kind, _, message = content.partition(": ")
            {"warning": log.warnings, "note": log.notes}[kind].append(message)
        elif re.match(r"step \d+", content):
            steps = True
        elif match := re.match(r"The run ended early, at the time ([^:]*): (.*)", content):
            log.early_end = f"at the time {match[1]}: {match[2]}"
            early_ends.append(log.early_end)
        elif content.startswith(NOTHING_TO_DO):
            log.facts, log.summary, log.timers = before.facts, before.summary, before.timers
        elif content.startswith(("|", "+--")):
            read_timer(content, log)
        elif steps and line.startswith("  "):
            log.summary.append(line[2:])
        elif match := re.match(r"  (\S[\w ]*?) {2,}(\S.*)", line):
            log.facts.append((match[1], match[2]))
    log.broken_laws = [text for text in log.warnings if BROKEN_LAW in text]
    log.broken_laws += [text for text in early_ends if BROKEN_LAW in text]
    log.warnings = last_of_each([text for text in log.warnings if BROKEN_LAW not in text])
    return log


def read_timer(line, log):
    """A row of deal.II's table: section, calls, least time and rank, mean, largest and rank."""
    cells = [cell.strip() for cell in line.strip("|").split("|")]
    seconds = re.findall(r"([\d.]+(?:e[+-]?\d+)?)s", line)
    if cells[0].startswith("Total wallclock") and seconds:
        log.wall_time = float(seconds[0])
    elif len(cells) == 5 and cells[1].isdigit() and len(seconds) >= 3:
        log.timers.append((cells[0], int(cells[1]), float(seconds[1])))


def last_of_each(warnings):
    """A warning comes when it is noticed, and in the summary again with the largest value, there
    perhaps together with others of its kind."""
    found = []
    for text in warnings:
        subjects = subjects_of(text)
        found = [one for one in found if not subjects_of(one) <= subjects] + [text]
    return found


def subjects_of(warning):
    """What the first sentence is about: names are told apart, values and times are not."""
    sentence = re.split(r"\.\s", warning, maxsplit=1)[0].replace("(the most of the run)", "")
    subjects = set()
    for part in re.split(r", (?=since time )", sentence):
        words = re.split(r"('[^']*')", PLACE_IN_TIME.sub("", part))
        words[::2] = [re.sub(r"[\d.e+-]*\d|\W", "", word) for word in words[::2]]
        subjects.add("".join(words))
    return subjects
