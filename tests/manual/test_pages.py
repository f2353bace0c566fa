# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The manual is built without a warning; every link inside of it leads to a page and a place that
exist, every key of the program has its place in the reference, and every shipped scene its page in
the gallery. In a browser, where there is one, a page shows its text and its formulas, and the
search finds a key.

test_pages.py EXECUTABLE FOLDER
"""

import html.parser
import pathlib
import re
import shutil
import subprocess
import sys
import unittest
import urllib.parse

import docutils.nodes

import common

import build
import program
import reference
import scenes


class Page(html.parser.HTMLParser):
    """The links and the places of a page."""

    def __init__(self, path):
        super().__init__()
        self.links, self.places = [], set()
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attrs):
        attributes = dict(attrs)
        if "id" in attributes:
            self.places.add(attributes["id"])
        for name in ("href", "src"):
            if attributes.get(name):
                self.links.append(attributes[name])


def broken_links(folder):
    """What does not exist of all that the pages below a folder link to in it."""
    pages = {path.resolve(): Page(path) for path in folder.rglob("*.html")}
    result = []
    for path, page in pages.items():
        for link in page.links:
            url = urllib.parse.urlsplit(link)
            if url.scheme or url.netloc:
                continue
            target = path.parent / urllib.parse.unquote(url.path) if url.path else path
            target = target.resolve()
            place = urllib.parse.unquote(url.fragment)
            if not target.is_relative_to(folder):
                continue  # the reference of the classes, which Doxygen builds beside the manual
            if not target.exists():
                result.append(f"{path.relative_to(folder)}: {link}: no such file")
            elif place and target in pages and place not in pages[target].places:
                result.append(f"{path.relative_to(folder)}: {link}: no such place")
    return result


class Pages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.target = common.settings["folder"] / "manual"
        shutil.rmtree(cls.target, ignore_errors=True)
        command = [sys.executable, "-B", build.__file__, common.settings["executable"], cls.target]
        cls.result = subprocess.run(command, capture_output=True, text=True, check=False)
        cls.html = cls.target / "html"

    def test_built_without_a_warning(self):
        self.assertEqual(self.result.returncode, 0, self.result.stdout + self.result.stderr)

    def test_links(self):
        broken = broken_links(self.html)
        self.assertEqual(broken, [], "\n".join(broken))
        self.assertGreater(len(list(self.html.rglob("*.html"))), 80)

    def test_every_key_is_in_the_reference(self):
        text = program.call(common.settings["executable"], "--print-parameters")
        n_statements = sum(line.strip().startswith("set ") for line in text.splitlines())
        keys = program.read_keys(text)
        self.assertEqual(len(keys), n_statements)
        folder = self.html / "doc" / "manual" / "reference"
        for key in keys:
            page = Page(folder / f"{reference.file_name(key.section)}.html")
            self.assertTrue(docutils.nodes.make_id(key.name) in page.places, key.path)

    def test_every_scheme_is_in_the_reference(self):
        page = (self.html / "doc" / "manual" / "reference" / "schemes.html").read_text("utf-8")
        for scheme in program.schemes(common.settings["executable"]):
            self.assertTrue(scheme["name"] in page, scheme["name"])

    def test_every_scene_has_its_page(self):
        folder = self.html / "doc" / "manual" / "gallery"
        for scene in scenes.shipped():
            page = folder / f"{scene.name.replace('/', '_')}.html"
            self.assertTrue(page.is_file(), scene.name)
            run = "What a run says" in page.read_text(encoding="utf-8")
            self.assertTrue(run, f"{scene.name} was not run: ./dev doc --gallery")

    def browse(self, page, query=""):
        """The document as a browser shows it after its scripts have run."""
        browser = next(filter(None, map(shutil.which, build.BROWSERS)), None)
        if browser is None:
            self.skipTest("no Chromium")
        command = [browser, "--headless", "--no-sandbox", "--disable-gpu"]
        command += ["--allow-file-access-from-files", "--virtual-time-budget=20000", "--dump-dom"]
        address = (self.html / page).as_uri() + query
        result = subprocess.run(
            [*command, address], capture_output=True, text=True, check=False, timeout=300
        )
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stdout

    def test_a_page_in_a_browser(self):
        self.assertTrue("Mesh a part in Gmsh" in self.browse("doc/manual/index.html"))

    def test_formulas_in_a_browser(self):
        if not pathlib.Path("/usr/share/javascript/mathjax/MathJax.js").is_file():
            self.skipTest("no MathJax")
        page = self.browse("doc/manual/contact.html")
        self.assertGreater(page.count("MathJax_SVG_Display"), 1)
        self.assertFalse(r"\sigma_\nu \le" in re.sub(r"<script.*?</script>", "", page, flags=re.S))

    def test_the_search_finds_a_key(self):
        found = self.browse("search.html", "?q=refinements")
        self.assertTrue("reference/bodies_body.html" in found)


if __name__ == "__main__":
    common.main()
