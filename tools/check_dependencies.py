#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Checks that each module includes only headers of the modules below it: check_dependencies.py [ROOT]."""

import pathlib
import re
import sys

# The order of the modules: which ones a module may use besides itself. A module that is not named here is an error.
# What is said about a scene stops at `simulation`: the modules that compute get the values and the small structs of
# `model`. The three chains up to contact, variational_inequality and schemes do not see each other; system is where
# they meet.
MAY_USE = {
    "base": set(),
    "linear_algebra": {"base"},
    "friction": {"base"},
    "model": {"base"},
    "mesh_files": {"base", "model"},
    "prm": {"base"},
    "time": {"base"},
    "schemes": {"base", "time"},
    "step_size": {"base", "time"},
    "scene": {"base", "model", "mesh_files", "prm", "time", "schemes"},
    "discretization": {"base", "linear_algebra", "model", "mesh_files"},
    "variational_inequality": {"base", "linear_algebra", "friction"},
}
MAY_USE["finite_elements"] = MAY_USE["discretization"] | {"discretization"}
MAY_USE["contact"] = MAY_USE["finite_elements"] | {"friction"}
MAY_USE["mass"] = MAY_USE["contact"] | {"contact"}
MAY_USE["preconditioners"] = MAY_USE["contact"] | {"contact"}
MAY_USE["system"] = MAY_USE["mass"] | MAY_USE["variational_inequality"] | {
    "mass", "variational_inequality", "preconditioners", "time"}
MAY_USE["adaptivity"] = MAY_USE["system"] | {"system", "finite_elements"}
MAY_USE["diagnostics"] = MAY_USE["contact"] | {"contact", "time"}
MAY_USE["output"] = MAY_USE["diagnostics"] | {"diagnostics", "finite_elements"}
MAY_USE["simulation"] = set(MAY_USE)

INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]signorini/(\w+)/', re.MULTILINE)


def violations(root):
    """A sentence for each forbidden include and each unknown module."""
    found = []
    for base in (root / "include" / "signorini", root / "source"):
        for path in sorted(base.glob("*/*")):
            if path.suffix not in (".h", ".cc"):
                continue
            name, module = path.relative_to(root), path.parent.name
            if module not in MAY_USE:
                found.append(f"{name}: the module {module} is not in the table of tools/{pathlib.Path(__file__).name}")
                continue
            for used in INCLUDE.findall(path.read_text(encoding="utf-8")):
                if used != module and used not in MAY_USE[module]:
                    allowed = ", ".join(sorted(MAY_USE[module])) or "no other module"
                    found.append(f"{name} includes a header of {used}, but {module} may use only: {allowed}")
    return found


def main():
    default = pathlib.Path(__file__).resolve().parent.parent
    found = violations(pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else default)
    print("\n".join(found) or "Every module uses only modules below it.")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
