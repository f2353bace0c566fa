# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""One run of the program within a limit of time, and how it ended."""

import dataclasses
import json
import time

import signorini


@dataclasses.dataclass
class Ending:
    """Of a run. The status is None if the time was up, and negative after a signal."""

    status: int | None
    messages: str
    seconds: float

    def warnings(self):
        """Each once, as the program says it."""
        lines = self.messages.splitlines()
        found = [line.split("warning: ", 1)[1] for line in lines if "warning: " in line]
        return list(dict.fromkeys(found))

    def reason(self):
        """The one message of a run that was refused, or nothing."""
        lines = [line.strip() for line in self.messages.splitlines() if "warning: " not in line]
        return next((line[11:] for line in lines if line.startswith("signorini: ")), "")


def schemes(executable):
    """The table of schemes; the first one is the default."""
    return json.loads(signorini.ask("--print-schemes=json", executable=executable))


def run(executable, text, folder, time_limit, processes=1):
    """Write the scene to folder/scene.prm and run it, with results in folder/output."""
    folder.mkdir(parents=True, exist_ok=True)
    file = folder / "scene.prm"
    file.write_text(text, encoding="utf-8")
    start = time.monotonic()
    going_on = signorini.start(file, folder / "output", processes=processes, executable=executable)
    if going_on.ends_within(time_limit):
        status, messages = going_on.process.returncode, going_on.messages()
    else:
        going_on.kill()
        status, messages = None, f"no end after {time_limit:g} s"
    return Ending(status, messages.strip(), time.monotonic() - start)
