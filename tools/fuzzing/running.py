# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Runs of the program with bounded time and memory: by a server, or alone."""

import collections
import os
import resource
import subprocess

#: Processor time, and memory in addresses, of which the program and its libraries take a third (0:
#: any).
Limits = collections.namedtuple("Limits", "seconds n_bytes")
LIMITS = Limits(20, 2 << 30)
#: Sanitizers make a program ten times as slow, and need addresses of their own.
LIMITS_WITH_SANITIZERS = Limits(200, 0)
ENVIRONMENT = dict(
    os.environ,
    OMPI_ALLOW_RUN_AS_ROOT="1",
    OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
    OMPI_MCA_ess_singleton_isolated="1",
    OMP_NUM_THREADS="1",
)


class Server:
    """Runs as children of a program that is ready (tests/fuzz/fuzz_server.cc)."""

    def __init__(self, executable, session, limits):
        session.mkdir(parents=True, exist_ok=True)
        self.process = subprocess.Popen(
            [executable, str(limits.seconds), str(limits.n_bytes)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
            env={**ENVIRONMENT, "OMPI_MCA_orte_tmpdir_base": str(session)},
        )

    def run(self, folder, arguments):
        """@return the status, 128 and more after a signal; output is in folder/out, folder/err"""
        words = [argument.encode("utf-8", "surrogateescape") for argument in arguments]
        (folder / "arguments").write_bytes(b"".join(word + b"\0" for word in words))
        self.process.stdin.write(f"{folder}\n")
        self.process.stdin.flush()
        answer = self.process.stdout.readline()
        if not answer:
            raise RuntimeError(f"the server is gone, with status {self.process.wait()}")
        return int(answer)

    def stop(self):
        """It ends with its input."""
        self.process.stdin.close()
        self.process.wait()


class Alone:
    """A process for each run."""

    def __init__(self, executable, session, limits):
        session.mkdir(parents=True, exist_ok=True)
        self.executable, self.session, self.limits = executable, session, limits

    def limit(self):
        """In the child."""
        seconds, n_bytes = self.limits
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 1))
        if n_bytes:
            resource.setrlimit(resource.RLIMIT_AS, (n_bytes, n_bytes))

    def run(self, folder, arguments):
        """As above."""
        words = [argument.encode("utf-8", "surrogateescape") for argument in arguments]
        with open(folder / "out", "wb") as out, open(folder / "err", "wb") as err:
            status = subprocess.run(
                [self.executable, *words],
                stdout=out,
                stderr=err,
                env={**ENVIRONMENT, "OMPI_MCA_orte_tmpdir_base": str(self.session)},
                preexec_fn=self.limit,
                check=False,
            ).returncode
        return status if status >= 0 else 128 - status

    def stop(self):
        """Nothing is left."""
