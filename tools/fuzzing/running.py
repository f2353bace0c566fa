# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Runs of the program with bounded time and memory: by a server, or alone."""

import os
import resource
import subprocess

#: Of processor time.
SECONDS = 20
#: Of addresses. The program and its libraries take a third of it.
BYTES = 2 << 30
ENVIRONMENT = dict(
    os.environ,
    OMPI_ALLOW_RUN_AS_ROOT="1",
    OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
    OMPI_MCA_ess_singleton_isolated="1",
    OMP_NUM_THREADS="1",
)


class Server:
    """Runs as children of a program that is ready (tests/fuzz/fuzz_server.cc)."""

    def __init__(self, executable, session, n_bytes):
        session.mkdir(parents=True, exist_ok=True)
        self.process = subprocess.Popen(
            [executable, str(SECONDS), str(n_bytes)],
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

    def __init__(self, executable, session, n_bytes):
        session.mkdir(parents=True, exist_ok=True)
        self.executable, self.session, self.n_bytes = executable, session, n_bytes

    def limit(self):
        """In the child."""
        resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS + 1))
        if self.n_bytes:
            resource.setrlimit(resource.RLIMIT_AS, (self.n_bytes, self.n_bytes))

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
