# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Where the program is, and how it is called."""

import os
import pathlib
import shutil
import subprocess
import tempfile

from .errors import ProgramNotFound, error_of

IN_CHECKOUT = pathlib.Path("build", "release", "signorini")


def find_executable(executable=None):
    """The path of the program: what is given, else what the environment variable SIGNORINI names,
    else signorini in PATH, else build/release/signorini of the checkout that holds this package or
    the current folder.

    Raises ProgramNotFound.
    """
    named = executable or os.environ.get("SIGNORINI")
    if named:
        found = shutil.which(named)
        if found is None:
            source = "executable" if executable else "environment variable SIGNORINI"
            raise ProgramNotFound(
                f"{source} = {named}: there is no such program. Name the file signorini that"
                " `./dev build` makes."
            )
        return os.path.abspath(found)
    found = shutil.which("signorini")
    if found is not None:
        return os.path.abspath(found)
    here, current = pathlib.Path(__file__).resolve(), pathlib.Path.cwd()
    for folder in (here.parents[2], current, *current.parents):
        if os.access(folder / IN_CHECKOUT, os.X_OK):
            return str(folder / IN_CHECKOUT)
    raise ProgramNotFound(
        "the program signorini is neither in PATH nor built in a checkout around the current"
        " folder. Build it with `./dev build`, and name it in the environment variable SIGNORINI or"
        " by the argument executable."
    )


def environment(session, parallel=False):
    """In which the program runs: one thread per process, which is fastest, and OpenMPI as root.

    session: a folder of its own for OpenMPI, as programs that start at the same time would make
    the same one.
    """
    changed = dict(
        os.environ,
        OMP_NUM_THREADS="1",
        OMPI_ALLOW_RUN_AS_ROOT="1",
        OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
        OMPI_MCA_orte_tmpdir_base=str(session),
    )
    if parallel:
        changed.pop("OMPI_MCA_ess_singleton_isolated", None)
    return changed


def command(executable, arguments, processes=1):
    """The words of a call. processes: a number, for mpirun, or the words of another launcher, such
    as ["srun", "-n", "8"]."""
    if processes == 1:
        launcher = []
    elif isinstance(processes, int):
        launcher = ["mpirun", "--oversubscribe", "-np", str(processes)]
    else:
        launcher = list(processes)
    return [*launcher, str(executable), *map(str, arguments)]


def ended_with_us():
    """The words before a call that lets Linux send SIGTERM to the program when this thread ends,
    also by a signal: nobody would see its results come. Nothing on other systems."""
    setpriv = shutil.which("setpriv")
    return [setpriv, "--pdeathsig", "TERM", "--"] if setpriv else []


def ask(*arguments, executable=None):
    """What the program prints, called with arguments that start no run, such as --version.

    Raises SceneError or RunError with its message.
    """
    found = find_executable(executable)
    try:
        with tempfile.TemporaryDirectory(prefix="signorini_") as session:
            done = subprocess.run(
                command(found, arguments),
                capture_output=True,
                text=True,
                env=environment(session),
                check=False,
            )
    except OSError as error:
        raise ProgramNotFound(f"{found}: {error.strerror}") from None
    if done.returncode != 0:
        raise error_of(done.returncode, done.stderr)
    return done.stdout
