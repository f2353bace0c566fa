# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""One run of the program within a limit of time, and how it ended."""

import dataclasses
import json
import os
import subprocess
import time


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
    table = subprocess.run(
        [executable, "--print-schemes=json"], capture_output=True, text=True, check=True
    )
    return json.loads(table.stdout)


def run(executable, text, folder, time_limit, processes=1):
    """Write the scene to folder/scene.prm and run it, with results in folder/output."""
    folder.mkdir(parents=True, exist_ok=True)
    file = folder / "scene.prm"
    file.write_text(text, encoding="utf-8")
    command = [executable, str(file), "--quiet", "--set", f"Output directory={folder / 'output'}"]
    if processes > 1:
        command = ["mpirun", "--oversubscribe", "-np", str(processes)] + command
    session = folder / "mpi"
    session.mkdir(exist_ok=True)
    environment = dict(
        os.environ,
        OMPI_ALLOW_RUN_AS_ROOT="1",
        OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
        OMP_NUM_THREADS="1",
        OMPI_MCA_orte_tmpdir_base=str(session),
    )
    start = time.monotonic()
    try:
        result = subprocess.run(
            command,
            env=environment,
            capture_output=True,
            text=True,
            errors="replace",
            timeout=time_limit,
            check=False,
        )
        status, messages = result.returncode, result.stdout + result.stderr
    except subprocess.TimeoutExpired:
        status, messages = None, f"no end after {time_limit:g} s"
    return Ending(status, messages.strip(), time.monotonic() - start)
