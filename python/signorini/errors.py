# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""What can go wrong, with the message of the program."""

#: How the program begins what it says on its error stream.
NAME, WARNING = "signorini: ", "signorini: warning: "


class SignoriniError(Exception):
    """All that this package raises about the program and its runs."""


class ProgramNotFound(SignoriniError):
    """There is no program to run."""


class RunError(SignoriniError):
    """A run failed (exit status 1, or a signal). What it wrote before is whole, and stays."""

    def __init__(self, message, status=1):
        super().__init__(message)
        self.status = status  # negative: the signal that ended the program


class SceneError(RunError):
    """A mistake in the scene or in a setting (exit status 2)."""


class Interrupted(RunError):
    """A run was asked to end, and did so after a step; resume() goes on."""


def error_of(status, messages):
    """The exception for an exit status that is not 0. messages: all that the program said on its
    error stream; libraries may have printed something before it."""
    lines = [line for line in messages.splitlines() if line.strip() and WARNING not in line]
    own = [line for line in lines if line.startswith(NAME)]
    nothing = f"the program said nothing, and ended with status {status}"
    if status < 0:
        nothing = f"the program was ended by the signal {-status}"
    kind = {2: SceneError, 130: Interrupted, 143: Interrupted}.get(status, RunError)
    return kind([*own, *lines, nothing][0].removeprefix(NAME), status)
