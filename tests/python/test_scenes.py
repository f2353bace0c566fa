# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Scenes of the Python package.

A scene that was read, written and read again is the same dictionary, and to the program, which
prints all that it makes of a scene, the written one is the file. A scene made of objects has what
was said, in the form that the program reads. Keys that the program does not know are refused, by
the program, or where Python names are used by its list.
"""

import json
import unittest

import running
import signorini
from signorini import prm

#: The quickest of those with: a mesh file of a body, one of an obstacle, expressions, friction.
VALIDATED = ("hammer_and_anvil", "chute", "bar_2d", "sliding_block", "static_hertz")


class Texts(unittest.TestCase):
    def test_every_shipped_scene_survives(self):
        files = sorted(running.PARAMETERS.rglob("*.prm"))
        self.assertGreater(len(files), 30)
        for file in files:
            with self.subTest(file.stem):
                scene = signorini.Scene.read(file)
                sections = scene.dictionary()
                self.assertGreater(len(sections["Time"]), 1)
                self.assertEqual(prm.parse(scene.text()), sections)
                self.assertEqual(signorini.Scene(sections).dictionary(), sections)

    def test_the_program_sees_the_same_scene(self):
        """In another folder, too: names of mesh files are absolute."""
        for name in VALIDATED:
            file = next(running.PARAMETERS.rglob(f"{name}.prm"))
            original = json.loads(signorini.ask(file, "--validate=json"))
            written = signorini.Scene.read(file).validate()
            for seen in (original, written):
                for changing in [key for key in seen if key == "scene" or "memory" in key]:
                    del seen[changing]
            self.assertEqual(written, original, name)
            self.assertGreater(written["cells"], 0)

    def test_names_of_plugins_are_absolute(self):
        """They add keys to the program, so it is asked with them."""
        name = "Additional shared libraries"
        scene = signorini.Scene({name: "./a.so, b.so"}, folder="/nowhere")
        self.assertEqual(scene.dictionary(), {name: "/nowhere/a.so, /nowhere/b.so"})
        with self.assertRaises(signorini.SceneError):  # as they are not there
            scene.time.update(step_size=1)

    def test_the_whole_syntax(self):
        (running.folder / "inner.prm").write_text("set Inner = 1\n", encoding="utf-8")
        text = (
            "\ufeffset A = b = c # a comment\nsubsection S\n  include inner.prm\n"
            "  subsection two : words\n  SET Long = 1, \\\n    2\n  END\nend\nset Empty =\n"
        )
        expected = {
            "A": "b = c",
            "S": {"Inner": "1", "two : words": {"Long": "1,     2"}},
            "Empty": "",
        }
        self.assertEqual(prm.parse(text, running.folder), expected)

    def test_texts_that_are_none(self):
        for text, message in (
            ("subsection S\n", "Add the missing `end`"),
            ("end\n", "`end` is not a statement"),
            ("Step size = 1\n", "is not a statement"),
            ("set A = \\\n", "within a section or a line"),
            ("include nowhere.prm\n", "nowhere.prm: cannot read this scene"),
        ):
            with self.assertRaisesRegex(signorini.SceneError, message):
                prm.parse(text)
        for value in ("a # b", "a\nset B = 1", "a\\"):
            with self.assertRaises(signorini.SceneError):
                prm.text_of({"A": value})


class Objects(unittest.TestCase):
    def test_objects_become_a_scene(self):
        scene = running.disc()
        sections = scene.dictionary()
        self.assertEqual(sections["Bodies"]["Names"], "disc")
        self.assertEqual(sections["Bodies"]["disc"]["Centre"], "0, 1.02")
        self.assertEqual(sections["Bodies"]["disc"]["Initial velocity"], "0; -1")
        self.assertEqual(sections["Bodies"]["disc"]["Young's modulus"], "500")
        self.assertEqual(sections["Contact"]["disc : floor"], {"Friction coefficient": "0.2"})
        self.assertEqual(sections["Output"]["VTU"], "false")
        self.assertEqual(scene.validate()["steps"], 40)
        self.assertEqual(scene.flat()["Time/Step size"], "0.005")

    def test_both_ways_to_a_key(self):
        scene = running.disc()
        scene.bodies.disc.radius = 2
        self.assertEqual(scene["Bodies/disc/Radius"], 2)
        scene["Time"] = {"End time": 0.1}
        self.assertEqual(scene.time.end_time, 0.1)
        self.assertEqual(scene.time["Step size"], 5e-3)
        scene.bodies.add("other", shape="box")
        self.assertEqual(scene["Bodies/Names"], "disc, other")
        for boundaries in ("other[2,3]", "other[0]", "other[2,3]"):
            scene.contact.add(boundaries, "floor")
        self.assertEqual(
            scene["Contact/Pairs"], "disc : floor, other[2,3] : floor, other[0] : floor"
        )
        changed = scene.changed({"Bodies/disc/Radius": 3})
        self.assertEqual((changed.bodies.disc.radius, scene.bodies.disc.radius), (3, 2))

    def test_what_is_unknown(self):
        scene = running.disc()
        with self.assertRaisesRegex(AttributeError, "Did you mean step_size"):
            scene.time.stepsize = 1
        with self.assertRaisesRegex(AttributeError, "`Time/Scheme` is not given"):
            print(scene.time.scheme)
        with self.assertRaisesRegex(AttributeError, "nothing can be added"):
            scene.time.add("anything")
        scene["Time/Step sise"] = 1
        with self.assertRaisesRegex(signorini.SceneError, "Time/Step sise.*mean `Step size`"):
            scene.validate()


if __name__ == "__main__":
    running.main()
