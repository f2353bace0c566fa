#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Checks that each module includes only headers of the modules below it.

check_dependencies.py [ROOT]       the check
check_dependencies.py --table      the table of modules in CONTRIBUTING.md
check_dependencies.py --picture    the picture of modules in doc/architecture.md
check_dependencies.py --write      puts both into these files; without it they are compared
"""

import pathlib
import re
import sys

# The order of the modules: which ones a module may use besides itself. A module that is not named
# here is an error. What is said about a scene stops at `simulation`: the modules that compute get
# the values and the small structs of `model`. The three chains up to contact,
# variational_inequality and schemes do not see each other; system is where they meet.
MAY_USE = {
    "base": set(),
    "linear_algebra": {"base"},
    "sweeps": {"base", "linear_algebra"},
    "friction": {"base"},
    "model": {"base"},
    "mesh_files": {"base"},
    "prm": {"base"},
    "materials": {"base", "model", "prm"},
    "obstacles": {"base", "model", "mesh_files", "prm"},
    "time": {"base"},
    "schemes": {"base", "time"},
    "step_size": {"base", "time"},
    "shapes": {"base", "model", "mesh_files", "prm"},
    "scene": {"base", "model", "prm", "materials", "obstacles", "shapes", "time", "schemes"},
    "discretization": {"base", "linear_algebra", "model"},
    "variational_inequality": {"base", "linear_algebra", "friction"},
}
MAY_USE["finite_elements"] = MAY_USE["discretization"] | {"discretization"}
MAY_USE["surfaces"] = MAY_USE["finite_elements"]
MAY_USE["contact"] = MAY_USE["finite_elements"] | {"friction", "obstacles", "surfaces"}
MAY_USE["mass"] = MAY_USE["contact"] | {"contact"}
MAY_USE["multigrid"] = MAY_USE["contact"] | {"contact"}
MAY_USE["preconditioners"] = MAY_USE["multigrid"] | {"multigrid", "sweeps"}
MAY_USE["condensation"] = MAY_USE["contact"] | {"contact", "variational_inequality"}
MAY_USE["system"] = (
    MAY_USE["mass"]
    | MAY_USE["variational_inequality"]
    | {"mass", "variational_inequality", "multigrid", "preconditioners", "condensation", "time"}
)
MAY_USE["adaptivity"] = MAY_USE["system"] | {"system", "finite_elements"}
MAY_USE["diagnostics"] = MAY_USE["contact"] | {"contact", "time"}
MAY_USE["output"] = MAY_USE["diagnostics"] | {"diagnostics", "finite_elements"}
MAY_USE["goals"] = MAY_USE["adaptivity"] | MAY_USE["output"] | {"adaptivity", "output"}
MAY_USE["setup"] = MAY_USE["output"] | {"output"}
MAY_USE["fclib"] = MAY_USE["system"] | MAY_USE["output"] | {"system", "output"}
MAY_USE["checkpoint"] = MAY_USE["adaptivity"] | MAY_USE["output"] | {"adaptivity", "output", "prm"}
MAY_USE["simulation"] = set(MAY_USE)
MAY_USE["program"] = MAY_USE["simulation"] | {"simulation"}

HOLDS = {
    "base": "types, errors, spelling, expressions, the command line",
    "linear_algebra": "block matrices, masks, conjugate gradients, GMRES, the incomplete factor",
    "sweeps": "symmetric Gauss-Seidel that solves by itself, on any number of processes",
    "friction": "the law of friction of one node",
    "model": "what is simulated, as plain data: bodies, materials, pairs, parameters",
    "mesh_files": "meshes from files: readers, groups, cells split into cubes; surfaces from files",
    "prm": "the text of a `.prm`: statements, sections, expressions, messages with lines",
    "materials": "what gives the constants of a material, and its table",
    "obstacles": "rigid obstacles: distance and normal, one shape per file, and their table",
    "shapes": "shapes of bodies: boundaries and coarse meshes, one shape per file, and their table",
    "time": "state, the interface `DynamicalSystem`, the contract of a scheme",
    "schemes": "the time schemes, one file each, and their table",
    "step_size": "steps whose size follows the motion",
    "scene": "the keys of a scene: declared, read, and every cross-check of them",
    "discretization": (
        "mesh of all bodies, degrees of freedom, mass and stiffness, loads, Dirichlet conditions"
    ),
    "finite_elements": "kernels on cells and faces: moments, stress vectors, neighbours",
    "surfaces": "faces of bodies that face each other: search, segments, dual basis",
    "contact": "contact nodes, mortar coupling, what is followed, contact coordinates",
    "mass": "the mass without entries at contact nodes: its constructions, definiteness, solution",
    "variational_inequality": (
        "the bound-constrained problem and its solvers: algebra, no mesh, no time"
    ),
    "multigrid": "geometric multigrid: levels, transfer, smoothing, what held entries change",
    "preconditioners": "preconditioners of a step, in contact coordinates",
    "condensation": "steps solved for the nodes in contact, with a direct factor of the rest",
    "system": "implements `DynamicalSystem`: the one place where the three chains meet",
    "adaptivity": "error indicators, which cells they change, the state on the new mesh",
    "diagnostics": "energy ledger, momentum, contact force, penetration, errors",
    "output": "fields, tables, log",
    "goals": "meshes for a target: errors of forces and stresses, and what they ask of cells",
    "setup": "what a scene describes, before the first step: fields and a picture",
    "fclib": "problems of steps in the format of the Frictional Contact Library",
    "checkpoint": "mesh and state on the disk, and which checkpoint is whole",
    "simulation": "the order of verbs, nothing else",
    "program": "what the command line asks for: a scene, a question; the status at the end",
}

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
                found.append(
                    f"{name}: the module {module} is not in the table of"
                    f" tools/{pathlib.Path(__file__).name}"
                )
                continue
            for used in INCLUDE.findall(path.read_text(encoding="utf-8")):
                if used != module and used not in MAY_USE[module]:
                    allowed = ", ".join(sorted(MAY_USE[module])) or "no other module"
                    found.append(
                        f"{name} includes a header of {used}, but {module} may use only: {allowed}"
                    )
    return found


def direct(module):
    """The modules that a module may use and that none of the others brings along."""
    brought = set().union(*(MAY_USE[used] for used in MAY_USE[module]))
    return sorted(MAY_USE[module] - brought, key=list(MAY_USE).index)


def table():
    """The modules, what they hold, and what they may use."""
    lines = ["| module | holds | may use, with all below |", "|---|---|---|"]
    for module in MAY_USE:
        used = ", ".join(direct(module)) or "deal.II"
        lines.append(f"| `{module}` | {HOLDS[module]} | {used} |")
    return "\n".join(lines)


def level(module):
    """How many modules are below a module, in the longest chain."""
    return 1 + max((level(used) for used in MAY_USE[module]), default=-1)


def picture():
    """The modules in layers; each may use some of those in the layers below it."""
    layers = {}
    for module in MAY_USE:
        layers.setdefault(level(module), []).append(module)
    return "\n".join("    " + "  ".join(layers[number]) for number in sorted(layers, reverse=True))


#: What stands where in a document, between two lines with its name.
GENERATED = {"CONTRIBUTING.md": ("modules", table), "doc/architecture.md": ("layers", picture)}


def replaced(text, name, content):
    """A document with the content between the marks of a name."""
    marks = re.compile(rf"(<!-- {name}: [^\n]*-->\n).*?(\n<!-- end of {name} -->)", re.DOTALL)
    return marks.sub(lambda found: found.group(1) + "\n" + content + "\n" + found.group(2), text)


def outdated(root, write):
    """A sentence for each document whose generated part is outdated; `write` puts it right."""
    for file, (name, content) in GENERATED.items():
        path = root / file
        if not path.exists():
            continue
        before = path.read_text(encoding="utf-8")
        after = replaced(before, name, content())
        if f"<!-- end of {name} -->" not in before:
            yield f"{file}: there is no place for `{name}`"
        elif before != after and write:
            path.write_text(after, encoding="utf-8")
        elif before != after:
            yield (
                f"{file}: `{name}` does not say what is true. Run tools/check_dependencies.py"
                " --write."
            )


def main():
    words = sys.argv[1:]
    if words[:1] in (["--table"], ["--picture"]):
        print(table() if words[0] == "--table" else picture())
        return 0
    write = "--write" in words
    folders = [word for word in words if not word.startswith("--")]
    root = pathlib.Path(folders[0]) if folders else pathlib.Path(__file__).resolve().parent.parent
    found = violations(root) + list(outdated(root, write))
    print("\n".join(found) or "Every module uses only modules below it.")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
