#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Builds the manual with Sphinx.

build.py EXECUTABLE TARGET [--pdf]

The pages are put together in TARGET/source: README.md, CONTRIBUTING.md, CHANGELOG.md, doc,
parameters and all files that they link to as they are, at the same places, so that their links
hold; and in doc/manual what is generated: the scene reference and the list of messages from the
program and its sources, the gallery from doc/manual/gallery.json. The manual is
TARGET/html/index.html; with --pdf also TARGET/signorini.pdf, printed by Chromium from a single
page. Warnings are errors.
"""

import argparse
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

import gallery_pages
import messages
import program
import reference
from markdown import toctree
from scenes import ROOT, shipped

MANUAL = pathlib.PurePath("doc") / "manual"
TOP_LEVEL = ("README.md", "CONTRIBUTING.md", "CHANGELOG.md", "CITATION.cff")
BROWSERS = ("chromium", "chromium-browser", "google-chrome")


def copy_sources(source):
    """What is written by hand, at the places that it has in the repository."""
    shutil.rmtree(source, ignore_errors=True)
    source.mkdir(parents=True)
    for name in TOP_LEVEL:
        shutil.copy(ROOT / name, source / name)
    for name in ("doc", "parameters"):
        shutil.copytree(ROOT / name, source / name, ignore=shutil.ignore_patterns("__pycache__"))
    copy_linked(source, list(source.rglob("*.md")))


def copy_linked(source, pages):
    """Files elsewhere in the repository that pages link to, and what these link to in turn."""
    for page in pages:
        for link in re.findall(r"\]\(([^)#\s]+)", page.read_text(encoding="utf-8")):
            target = pathlib.Path(os.path.normpath(page.parent / link))
            if "://" in link or target.exists() or not target.is_relative_to(source):
                continue
            original = ROOT / target.relative_to(source)
            if original.is_file():
                target.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(original, target)
                copy_linked(source, [target] if target.suffix == ".md" else [])


def list_other_pages(source):
    """Pages that no table of contents names yet are found below a title of their own."""
    index = source / MANUAL / "index.md"
    text = index.read_text(encoding="utf-8")
    other = []
    for page in sorted(source.rglob("*.md")):
        name = os.path.relpath(page.with_suffix(""), index.parent)
        listed = re.search(rf"(^|<){re.escape(name)}>?$", text, re.MULTILINE)
        if not listed and not page.is_relative_to(index.parent):
            other.append(name)
    if other:
        index.write_text(f"{text}\n{toctree(other, 'More')}", encoding="utf-8")


def write_pages(folder, pages):
    """Pages as {name: text} into a folder."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, text in pages.items():
        (folder / name).write_text(text, encoding="utf-8")


def generate(executable, source):
    """The pages that come from the program, the sources and the runs."""
    manual = source / MANUAL
    write_pages(
        manual / "reference", reference.pages(program.keys(executable), program.schemes(executable))
    )
    known = program.call(executable, "--print-parameters") + program.call(executable, "--help")
    write_pages(manual, {"messages.md": messages.page(known)})
    results = json.loads((ROOT / MANUAL / "gallery.json").read_text(encoding="utf-8"))
    pictures = manual / "gallery"
    write_pages(pictures, gallery_pages.pages(shipped(), results, pictures))


def sphinx(builder, source, target):
    """Run a builder of Sphinx; ends the program if there are warnings."""
    command = [sys.executable, "-m", "sphinx", "-b", builder, "-q", "-n", "-W", "--keep-going"]
    command += ["-c", ROOT / MANUAL, "-d", target.parent / f"doctrees_{builder}", source, target]
    if subprocess.run(command, check=False).returncode != 0:
        sys.exit("build.py: the manual has mistakes; see above")


def print_pdf(page, target):
    """Let Chromium print a page, formulas included."""
    browser = next(filter(None, map(shutil.which, BROWSERS)), None)
    if browser is None:
        sys.exit("build.py: no Chromium to print with. On Debian: apt-get install chromium")
    command = [browser, "--headless", "--no-sandbox", "--disable-gpu", "--no-pdf-header-footer"]
    command += ["--allow-file-access-from-files", "--virtual-time-budget=600000"]
    command += [f"--print-to-pdf={target}", page.as_uri()]
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    if result.returncode != 0 or not target.is_file():
        sys.exit(f"build.py: {browser} printed nothing:\n{result.stderr}")


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("executable", type=pathlib.Path, metavar="EXECUTABLE")
    parser.add_argument("target", type=pathlib.Path, metavar="TARGET")
    parser.add_argument("--pdf", action="store_true", help="TARGET/signorini.pdf, too")
    options = parser.parse_args()
    target = options.target.resolve()
    source = target / "source"
    copy_sources(source)
    list_other_pages(source)
    generate(options.executable.resolve(), source)
    sphinx("html", source, target / "html")
    print(f"The manual, for a browser: {target / 'html' / 'index.html'}")
    if options.pdf:
        sphinx("singlehtml", source, target / "single")
        print_pdf(target / "single" / MANUAL / "index.html", target / "signorini.pdf")
        print(f"The manual, for print: {target / 'signorini.pdf'}")


if __name__ == "__main__":
    main()
