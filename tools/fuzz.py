# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Bad input: mutated scenes, meshes and command lines.

Scenes of the folder parameters and small ones with meshes of all formats are changed at random, by
a character, a line, a number, a block, noise, and whatever files suffer. Each is checked, and what
is in order and small is run for a few steps, with bounded time and memory. The program may succeed
or refuse with one clear message, and nothing else: no crash, no hang, no words of libraries, no
nonsense in its tables. What it may not is kept in a folder, by the number of the case, which
gives the same case anywhere. messages.txt has all kinds of messages, how often each came, and the
number of a case.

    ./dev stress fuzz [--count 100000] [--seed 1] [--first 0] [--only NUMBER] [--jobs 2]
"""

import argparse
import collections
import concurrent.futures
import pathlib
import queue
import re
import resource
import shutil
import sys
import threading

from fuzzing import answers, cases, running, seeds
from stress import running as programs

#: Runs with more unknowns cost more than they tell.
MOST_UNKNOWNS = 3000
#: Each so many cases are run by the program itself, from its start to its end.
ALONE_EVERY = 100


class Fuzz:
    """All cases, what was found, and how often which message came."""

    def __init__(self, arguments):
        self.arguments, self.folder = arguments, arguments.folder.resolve()
        self.cases = cases.Cases(arguments.executable, arguments.seed)
        self.schemes = {entry["name"]: entry for entry in programs.schemes(arguments.executable)}
        self.messages, self.examples = collections.Counter(), {}
        self.n_found = self.n_runs = 0
        self.lock = threading.Lock()
        limits = running.LIMITS_WITH_SANITIZERS if arguments.sanitizers else running.LIMITS
        server = arguments.server
        self.places = queue.Queue()
        for job in range(arguments.jobs):
            place = self.folder / f"job{job}"
            alone = running.Alone(arguments.executable, place / "mpi", limits)
            usual = running.Server(server, place / "mpi", limits) if server else alone
            self.places.put((place, usual, alone))

    def judge(self, number):
        """One case, at any free place."""
        place, usual, alone = self.places.get()
        try:
            case, scene = self.cases[number], place / "case"
            shutil.rmtree(scene, ignore_errors=True)
            scene.mkdir(parents=True)
            case.write(scene)
            by_itself = number % ALONE_EVERY == 0 or self.arguments.only is not None
            found = self.answer(case, scene, alone if by_itself else usual)
            with self.lock:
                self.note(case, scene, found)
        finally:
            self.places.put((place, usual, alone))

    def answer(self, case, folder, program):
        """Check, and run what is worth it. @return what is wrong, or nothing"""
        arguments = [str(folder / "scene.prm"), "--quiet"]
        for setting in case.settings:
            arguments += ["--set", setting]
        arguments += ["--set", f"Output directory={folder / 'output'}"]
        status = program.run(folder, [*arguments, "--validate"])
        wrong = self.wrong(case.number, folder, status)
        facts = "" if status or wrong else answers.read(folder, "out")
        size = re.search(r"(\d+) degrees of freedom", facts)
        step = re.search(r"scheme +(\S+), (?:.*first of|\d+ steps of) (\S+)", facts)
        if not size or int(size[1]) > MOST_UNKNOWNS or not step:
            return wrong
        end = seeds.N_STEPS * float(step[2])
        status = program.run(folder, [*arguments, "--set", f"Time/End time={end!r}"])
        with self.lock:
            self.n_runs += 1
        wrong = self.wrong(case.number, folder, status)
        if not wrong and status == 0:
            wrong = answers.nonsense(folder, self.schemes[step[1]])
        return f"run: {wrong}" if wrong else ""

    def wrong(self, number, folder, status):
        """What is wrong about the answer."""
        text = answers.message(folder)
        if text:
            shape = answers.shape(status, text)
            with self.lock:
                self.messages[shape] += 1
                self.examples.setdefault(shape, number)
        return answers.wrong_answer(status, text)

    def note(self, case, scene, found):
        """Keep a finding."""
        if not found and self.arguments.only is None:
            return
        kept = self.folder / str(case.number)
        shutil.rmtree(kept, ignore_errors=True)
        shutil.copytree(scene, kept)
        (kept / "settings.txt").write_bytes("\n".join(case.settings).encode("utf-8", "replace"))
        if found:
            self.n_found += 1
            (kept / "finding.txt").write_text(found + "\n", encoding="utf-8", errors="replace")
            text = f"{case.number}: {found}\n  {kept}"
            print(text.encode("ascii", "replace").decode(), flush=True)

    def report(self, count):
        """The list of messages, and the sum. @return the exit status"""
        lines = [f"{n} {self.examples[text]} {text}\n" for text, n in self.messages.most_common()]
        (self.folder / "messages.txt").write_text(
            "".join(lines), encoding="utf-8", errors="replace"
        )
        while not self.places.empty():
            self.places.get()[1].stop()
        print(f"{count} cases, {self.n_runs} of them run, {self.n_found} answers are wrong")
        return 1 if self.n_found or (count > 100 and 20 * self.n_runs < count) else 0


def main():
    """@return 0 if all answers were right, and enough cases were worth a run."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("executable")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--server", help="fuzz_server; without it each run starts the program")
    parser.add_argument("--count", type=int, default=100000)
    parser.add_argument("--first", type=int, default=0, help="number of the first case")
    parser.add_argument("--seed", default="1")
    parser.add_argument("--only", type=int, help="one case by its number, by the program itself")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument(
        "--sanitizers", action="store_true", help="the program has them: longer, more memory"
    )
    arguments = parser.parse_args()
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    fuzz = Fuzz(arguments)
    first, count = arguments.first, arguments.count
    numbers = range(first, first + count) if arguments.only is None else [arguments.only]
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as jobs:
        for done in jobs.map(fuzz.judge, numbers):
            assert done is None
    return fuzz.report(len(numbers))


if __name__ == "__main__":
    sys.exit(main())
