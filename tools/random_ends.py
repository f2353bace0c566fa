# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Ends a run again and again, and resumes it: the final tables must be those of the run that was
left alone, to the last bit.

The scene is that of tests/checkpoint: two bodies with friction whose contact follows the motion, on
a mesh that changes.

    ./dev stress kill [--count 200] [--seed 1] [--processes 2]   SIGKILL at random times
    ./dev stress full [--count 50] [--seed 1]                    files that may not grow any more
"""

import argparse
import pathlib
import random
import resource
import signal
import subprocess
import sys
import time

TESTS = pathlib.Path(__file__).resolve().parents[1] / "tests"
sys.path += [str(TESTS / "whole_scenes"), str(TESTS / "checkpoint")]

# pylint: disable=wrong-import-position
import check_history  # noqa: E402
from interrupted_scene import InterruptedRun, differences  # noqa: E402


def limit_files(length):
    """For a program that is about to start: writing beyond is an error, as on a full disk."""

    def limit():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (length, length))

    return limit


def resume_or_start(run, **how):
    return run.start(*(["--resume"] if run.has_checkpoint() else []), **how)


def complaints(calm, run, status, messages):
    """What is wrong with a run that has come to its end."""
    if status != 0:
        return [f"status {status}: {messages}"]
    return [f"{column}: {by:.1e}" for column, by in differences(calm, run).items() if by != 0.0]


def kill(calm, duration, numbers, arguments):
    """Rounds of runs that are killed until one gets to its end."""
    done = found = resumed = 0
    while done < arguments.count:
        run = InterruptedRun("killed", arguments.processes)
        status = messages = None
        while status is None:
            is_resumed = run.has_checkpoint()
            resumed += is_resumed
            began = time.monotonic()
            resume_or_start(run)
            patience = numbers.uniform(0.2, 1.0) * duration if done < arguments.count else None
            try:
                status, messages = run.end(patience)
            except subprocess.TimeoutExpired:
                run.kill()
                done += 1
        if not is_resumed:  # the machine is less busy than it was: kill earlier
            duration = min(duration, time.monotonic() - began)
        wrong = complaints(calm, run, status, messages)
        found += bool(wrong)
        print(f"{done} kills, {resumed} resumed", *wrong, sep="; ", flush=True)
        if wrong:
            break
    if resumed <= done / 4:
        sys.exit("hardly any run was resumed: nothing is shown")
    return found


def fill_up(calm, _duration, numbers, arguments):
    """Runs whose files may not grow beyond a random length, and that go on when they may."""
    largest = max(file.stat().st_size for file in calm.output.rglob("*") if file.is_file())
    found = 0
    for number in range(arguments.count):
        run = InterruptedRun("full", arguments.processes)
        length = numbers.randrange(1, largest)
        status, messages = run.start(preexec_fn=limit_files(length)).end()
        wrong = []
        if status != 1 or len(messages) != 1 or "cannot write `" not in messages[0]:
            wrong.append(f"with {length} bytes: status {status}, {messages}")
        for table in run.output.glob("*.csv"):
            if table.stat().st_size > 0 and not table.read_bytes().endswith(b"\n"):
                wrong.append(f"with {length} bytes: {table.name} ends in a part of a row")
        wrong += complaints(calm, run, *resume_or_start(run).end())
        found += bool(wrong)
        print(f"{number + 1} full disks", *wrong, sep="; ", flush=True)
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("how", choices=("kill", "full"))
    parser.add_argument("executable")
    parser.add_argument("folder")
    parser.add_argument("--count", type=int)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--processes", type=int)
    arguments = parser.parse_args()
    is_kill = arguments.how == "kill"
    arguments.count = arguments.count or (200 if is_kill else 50)
    arguments.processes = arguments.processes or (2 if is_kill else 1)
    check_history.settings.update(
        executable=str(pathlib.Path(arguments.executable).resolve()), folder=arguments.folder
    )
    begin = time.monotonic()
    calm = InterruptedRun("calm", arguments.processes).start()
    status, messages = calm.end()
    if status != 0:
        sys.exit(f"the run that is left alone ends with status {status}: {messages}")
    stress = kill if is_kill else fill_up
    numbers = random.Random(arguments.seed)
    sys.exit(1 if stress(calm, time.monotonic() - begin, numbers, arguments) else 0)


if __name__ == "__main__":
    main()
