#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Checks of the form of all tracked files.

check_sources.py length|functions|columns|folders|guard|licence|schemes|kinds [ROOT]
"""

import ast
import collections
import pathlib
import re
import subprocess
import sys

MAXIMUM_LINES = 400
MAXIMUM_FUNCTION_LINES = 60
MAXIMUM_COLUMNS = 100
MAXIMUM_FILES = 25
WITH_COLUMNS = {".h", ".cc", ".py", ".md", ".bib", ".cmake", ".sh", ".prm", ".ini"}
# Included by the compiler's command line and never by a source.
WITHOUT_GUARD = {"include/signorini/base/precompiled.h"}
# A copy for readers of results without the program, which tests/report compares with the program.
COPY_OF_SCHEMES = "tools/reporting/schemes.py"
LICENCE = "SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later"
COPYRIGHT = "by the signorini authors"


def sources(root):
    """Paths relative to root of the tracked files, or of all files where git cannot tell."""
    try:
        git = subprocess.run(
            ["git", "-C", root, "ls-files", "-z"], capture_output=True, text=True, check=True
        )
        names = [name for name in git.stdout.split("\0") if name]
    except (OSError, subprocess.CalledProcessError):  # not installed, or no repository
        names = [
            path.relative_to(root).as_posix()
            for path in root.rglob("*")
            if path.is_file() and path.relative_to(root).parts[0] not in ("build", "output", ".git")
        ]
    return [pathlib.PurePosixPath(name) for name in sorted(names) if (root / name).is_file()]


def read(root, name):
    return (root / name).read_text(encoding="utf-8")


def length(root):
    """Files have at most MAXIMUM_LINES lines."""
    for name in sources(root):
        if name.suffix in (".h", ".cc", ".py", ".cmake"):
            lines = len(read(root, name).splitlines())
            if lines > MAXIMUM_LINES:
                yield f"{name} has {lines} lines; at most {MAXIMUM_LINES}: split it by ideas"


def blank(match):
    """Blanks in place of a text, with its line breaks."""
    return re.sub(r"[^\n]", " ", match.group())


#: What may hold braces that open no block: comments, strings, characters and preprocessor lines.
NO_CODE = re.compile(
    r"""//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])'"""
    r"""|^[ \t]*\#(?:[^\n]*\\\n)*[^\n]*""",
    re.DOTALL | re.MULTILINE,
)


def functions_of_cpp(text):
    """(name, first line, number of lines) of each function, return type and braces included."""
    code = NO_CODE.sub(blank, text)
    head_start, depth_of_function, depth, head = 0, None, 0, ""
    for brace in re.finditer(r"[{};]|(?<=[^:])(?:public|private|protected):", code):
        if brace.group() == "{":
            before = code[head_start : brace.start()]
            scope = re.match(
                r"\s*(template\s*<.*>\s*)?(inline\s+)?"
                r"(namespace|class|struct|enum|union|extern)\b(?!.*\)\s*$)",
                before,
                re.DOTALL,
            )
            if (
                depth_of_function is None
                and not scope
                and "(" in before
                and not before.rstrip().endswith("=")
            ):
                depth_of_function, head = depth, before.strip()
                first = code.count("\n", 0, head_start + len(before) - len(before.lstrip())) + 1
            depth += 1
        elif brace.group() == "}":
            depth -= 1
            if depth == depth_of_function:
                name = re.search(r"[\w:~]*\s*(?=\()", head).group().strip()
                yield name, first, code.count("\n", 0, brace.start()) + 2 - first
                depth_of_function = None
        head_start = brace.end()


def functions_of_python(text):
    """(name, first line, number of lines) of each function."""
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.FunctionDef):
            yield node.name, node.lineno, node.end_lineno - node.lineno + 1


def functions(root):
    """Functions have at most MAXIMUM_FUNCTION_LINES lines."""
    languages = {".h": functions_of_cpp, ".cc": functions_of_cpp, ".py": functions_of_python}
    for name in sources(root):
        if name.suffix not in languages:
            continue
        for function, first, lines in languages[name.suffix](read(root, name)):
            if lines > MAXIMUM_FUNCTION_LINES:
                yield (
                    f"{name}:{first}: {function} has {lines} lines; at most"
                    f" {MAXIMUM_FUNCTION_LINES}: give its steps names"
                )


def columns(root):
    """Lines have at most MAXIMUM_COLUMNS columns, but for tables and addresses in documents."""
    for name in sources(root):
        if name.suffix not in WITH_COLUMNS and name.name not in ("dev", "CMakeLists.txt", "run"):
            continue
        for number, line in enumerate(read(root, name).splitlines(), 1):
            table = name.suffix == ".md" and line.lstrip().startswith("| ")
            excepted = table or name.suffix in (".md", ".bib") and "://" in line
            if len(line) > MAXIMUM_COLUMNS and not excepted:
                yield f"{name}:{number}: {len(line)} columns; at most {MAXIMUM_COLUMNS}"


def folders(root):
    """Folders have at most MAXIMUM_FILES files of their own, but for the top level."""
    files = collections.Counter(name.parent for name in sources(root) if len(name.parts) > 1)
    for folder, count in sorted(files.items()):
        if count > MAXIMUM_FILES:
            yield f"{folder} has {count} files; at most {MAXIMUM_FILES}: make folders in it"


def guard(root):
    """The include guard of include/signorini/<module>/<file>.h is signorini_<module>_<file>_h."""
    for name in sources(root):
        if name.suffix != ".h" or name.parts[0] != "include" or str(name) in WITHOUT_GUARD:
            continue
        expected = "_".join(name.with_suffix("").parts[1:]) + "_h"
        code = re.sub(r"//[^\n]*|/\*.*?\*/", "", read(root, name), flags=re.DOTALL).strip()
        if not code.startswith(f"#ifndef {expected}\n#define {expected}\n") or not code.endswith(
            "#endif"
        ):
            yield f"{name}: the include guard must be {expected}, around the whole file"


def licence(root):
    """Sources and scripts name licence and copyright in their first three lines."""
    for name in sources(root):
        list_of_sources = name.match("source/*/CMakeLists.txt")  # nothing in there to license
        script = name.parts[0] in ("dev", ".ci") or (
            name.name == "CMakeLists.txt" and not list_of_sources
        )
        if script or name.suffix in (".h", ".cc", ".py", ".cmake", ".sh"):
            top = "\n".join(read(root, name).splitlines()[:3])
            if read(root, name) and not (LICENCE in top and COPYRIGHT in top):
                yield (
                    f"{name}: the first lines must say '{LICENCE}' and 'Copyright (C) <year>"
                    f" {COPYRIGHT}'"
                )


def schemes(root):
    """Names of schemes stand in the table of schemes, its copy and tests only: no code compares
    names."""
    table = root / "source" / "schemes" / "scheme_table.cc"
    names = (
        re.findall(r'"([a-z]+(?:-[a-z]+)+)"', table.read_text(encoding="utf-8"))
        if table.exists()
        else []
    )
    literal = re.compile(rf'"[^"]*\b({"|".join(names)})\b[^"]*"|"newmark"') if names else None
    for name in sources(root):
        if str(name) == COPY_OF_SCHEMES:
            continue
        if literal and name.parts[0] in ("source", "include", "tools") and root / name != table:
            for number, line in enumerate(read(root, name).splitlines(), 1):
                code = line.partition("//")[0] if name.suffix in (".h", ".cc") else line
                if not code.lstrip().startswith("*") and literal.search(code):
                    yield (
                        f"{name}:{number}: names a scheme; ask the table of schemes (SchemeInfo)"
                        " for a property"
                    )


def kinds(root):
    """CONTRIBUTING.md names all kinds of ./dev check."""
    script, guide = root / "tools" / "check.sh", root / "CONTRIBUTING.md"
    usage = script.read_text(encoding="utf-8") if script.exists() else ""
    text = guide.read_text(encoding="utf-8") if guide.exists() else ""
    for kind in re.findall(r"^  (--[a-z-]+)", usage, re.MULTILINE):
        if not re.search(rf"^ +\./dev check {kind}\b(?!-)", text, re.MULTILINE):
            yield f"CONTRIBUTING.md must say what `./dev check {kind}` does"


CHECKS = {
    "length": length,
    "functions": functions,
    "columns": columns,
    "folders": folders,
    "guard": guard,
    "licence": licence,
    "schemes": schemes,
    "kinds": kinds,
}


def main():
    if len(sys.argv) < 2 or sys.argv[1] not in CHECKS:
        sys.exit(__doc__)
    default = pathlib.Path(__file__).resolve().parents[2]
    root = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else default
    found = list(CHECKS[sys.argv[1]](root))
    print("\n".join(found) or f"{sys.argv[1]}: {len(sources(root))} files are in order.")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
