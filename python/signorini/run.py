# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Runs of the program: started, followed, ended, resumed."""

import contextlib
import os
import pathlib
import signal
import subprocess
import tempfile

from . import origin
from .errors import Interrupted, ProgramNotFound, error_of
from .executable import command, ended_with_us, environment, find_executable
from .result import Result
from .scene import Scene
from .tables import GrowingTable

#: Between two looks at the history, in seconds.
PAUSE = 0.1


class Run:
    """A run that goes on, or has ended. As a context, it is interrupted if an exception leaves the
    block: `with signorini.start(scene, folder) as run: ...`."""

    def __init__(self, scene, folder, settings, *, options=(), processes=1, executable=None):
        """scene: a file."""
        program = find_executable(executable)
        self.folder = pathlib.Path(folder).absolute()
        self.history = self.folder / "history.csv"
        #: The history of an earlier run, until this one replaces it; a resumed run goes on with it.
        self._old = None if "--resume" in options else self._stamp()
        self._session = tempfile.TemporaryDirectory(prefix="signorini_")
        self._said, self._messages = "", pathlib.Path(self._session.name, "messages.txt")
        self._asked_to_end = False
        changes = Scene(settings, folder=pathlib.Path(scene).parent, executable=executable)
        arguments = [scene, "--quiet", *options]
        for key, value in {**changes.flat(), "Output directory": self.folder}.items():
            arguments += ["--set", f"{key}={value}"]
        words = [*ended_with_us(), *command(program, arguments, processes)]
        try:
            # A pipe that nobody reads would stop the program when it is full.
            with open(self._messages, "wb") as messages:
                self.process = subprocess.Popen(
                    words,
                    stdin=subprocess.DEVNULL,
                    stdout=messages,
                    stderr=messages,
                    env=environment(self._session.name, parallel=processes != 1),
                    # Ctrl-C comes from here alone: a second one would end the program at once.
                    start_new_session=True,
                )
        except OSError as error:
            self._session.cleanup()
            raise ProgramNotFound(f"{words[0]}: {error.strerror}") from None

    def __enter__(self):
        return self

    def __exit__(self, kind, error, trace):
        if kind is not None and self.process.poll() is None:
            self.interrupt()
        if kind is None:
            self.wait()
        else:
            self._end()

    def interrupt(self):
        """Ask the run to end after its step (SIGINT). It writes a checkpoint, from which resume()
        goes on. To ask again changes nothing: a second signal would end the program at once, as
        kill() does."""
        if self._asked_to_end:
            return
        self._asked_to_end = True
        # mpirun would kill what has not ended after two seconds; its processes tell each other.
        self._send(signal.SIGINT, (self._children() or [self.process.pid])[-1:])

    def kill(self):
        """End the run at once."""
        self._send(signal.SIGKILL, [*self._children(), self.process.pid])
        self._end()

    def _children(self):
        """The processes that a launcher on this machine has started."""
        pid = self.process.pid
        children = pathlib.Path(f"/proc/{pid}/task/{pid}/children")
        try:
            return list(map(int, children.read_text(encoding="utf-8").split()))
        except OSError:  # ended, or a system without such files
            return []

    def _send(self, kind, pids):
        if self.process.poll() is None:
            for pid in pids:
                with contextlib.suppress(ProcessLookupError):
                    os.kill(pid, kind)

    def wait(self):
        """The result, when the run has come to its end.

        Raises SceneError, RunError, or, after a signal, Interrupted. Ctrl-C is handed on: the
        program ends its step, then KeyboardInterrupt goes on.
        """
        self.ends_within(None)
        status = self.process.returncode
        if status == 0:
            return Result(self.folder)
        error = error_of(status, self.messages())
        raise Interrupted(str(error), status) if self._asked_to_end else error

    def messages(self):
        """All that the program has said so far, warnings too."""
        if self._messages.exists():
            self._said = self._messages.read_text(encoding="utf-8", errors="replace")
        return self._said

    def ends_within(self, seconds):
        """Whether the program has ended, after so many seconds at most. Ctrl-C as for wait()."""
        try:
            self.process.wait(seconds)
        except subprocess.TimeoutExpired:
            return False
        except KeyboardInterrupt:
            self.interrupt()
            self._end()
            raise
        self._end()
        return True

    def _end(self):
        """Wait for the end, and leave nothing open."""
        self.process.wait()
        self.messages()
        self._session.cleanup()

    def rows(self, stop=None):
        """The rows of the history, each as a dictionary of numbers by column, while the run goes
        on; then wait() is called. A resumed run begins with the rows that are there.

        stop: a threading.Event that ends the run after its step: Ctrl-C reaches no thread but the
        main one.
        """
        table, last, ended = GrowingTable(self.history), -1, False
        while not ended:
            ended = self.ends_within(PAUSE)  # before the look: nothing is missed
            if stop is not None and stop.is_set() and not self._asked_to_end:
                self.interrupt()
            for row in table.new_rows() if self._has_begun() else ():
                # A resumed run cuts its table off and computes some steps again.
                if row["step"] > last:
                    last = row["step"]
                    yield row
        self.wait()

    def _stamp(self):
        try:
            status = self.history.stat()
        except OSError:
            return None
        return status.st_size, status.st_mtime_ns

    def _has_begun(self):
        """Whether the history is that of this run."""
        if self._old is not None and self._stamp() != self._old:
            self._old = None
        return self._old is None


def start(scene, folder, settings=None, *, processes=1, executable=None):
    """Start a run and return it, a Run, at once. It is ended after its step if the thread that
    started it ends before.

    scene: a Scene, a (nested) dictionary, or a file. folder: for the results.
    settings: values that change the scene, {"Time/Step size": 1e-3}.
    processes: a number, for mpirun, or the words of another launcher, ["srun", "-n", "8"].
    """
    folder = pathlib.Path(folder)
    if isinstance(scene, dict):
        scene = Scene(scene, executable=executable)
    if isinstance(scene, Scene):
        executable = executable or scene.executable
        folder.mkdir(parents=True, exist_ok=True)
        scene, settings = scene.changed(settings or {}), {}
        scene.write(folder / "input.prm")
        scene = folder / "input.prm"
    return Run(scene, folder, settings or {}, processes=processes, executable=executable)


def run(
    scene,
    folder,
    settings=None,
    *,
    processes=1,
    executable=None,
    on_row=None,
    stop=None,
    reuse=False,
):
    """Run a scene to its end and return the Result. As start(); besides:

    on_row: called with each row of the history, a dictionary, soon after it is written.
    stop: a threading.Event that ends the run after its step.
    reuse: take what is in the folder if it is the result of the same scene, mesh files and program.

    Raises SceneError, RunError, Interrupted with the message of the program.
    """
    made_of = None
    if reuse:
        made_of = origin.of(scene, settings or {}, executable)
        if origin.read(folder) == made_of:
            return Result(folder)
    origin.remove(folder)
    with start(scene, folder, settings, processes=processes, executable=executable) as going_on:
        for row in going_on.rows(stop):
            if on_row is not None:
                on_row(row)
        result = going_on.wait()
    if reuse:
        origin.write(folder, made_of)
    return result


def resume(folder, settings=None, *, processes=1, executable=None):
    """Go on with a run from the latest checkpoint in its folder, and return it, a Run.

    settings: what may change, such as {"Time/End time": 2} (doc/checkpoints.md).
    """
    origin.remove(folder)
    return Run(
        pathlib.Path(folder) / "scene.prm",
        folder,
        settings or {},
        options=["--resume"],
        processes=processes,
        executable=executable,
    )
