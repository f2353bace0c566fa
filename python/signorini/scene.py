# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""A scene: nested sections of keys and values, that the program runs."""

import json
import pathlib
import re
import tempfile

from . import keys, prm
from .executable import ask, find_executable

#: The key of shared libraries that add to the program.
PLUGINS = "Additional shared libraries"


class Section:
    """A section of a scene. Keys are written as in a file, section["Step size"], or as names of
    Python, section.step_size; the program tells which there are."""

    def __init__(self, scene, path):
        vars(self).update(_scene=scene, _path=tuple(path))

    def __str__(self):
        return self._path[-1] if self._path else "scene"

    def __getitem__(self, key):
        return self._scene[self._join(key)]

    def __setitem__(self, key, value):
        self._scene[self._join(key)] = value

    def __getattr__(self, name):
        if name.startswith("_"):
            raise AttributeError(name)
        known = keys.section(self._scene.program, self._path)
        inner = self._scene.section(self._path)
        if name in inner:  # a body, an obstacle or a probe, whose name is the user's
            key = name
        else:
            key = keys.key_of(self._scene.program, self._path, name)
        if isinstance(inner.get(key, known.get(key)), dict):
            return Section(self._scene, (*self._path, key))
        if key not in inner:
            raise AttributeError(f"`{self._join(key)}` is not given in this scene.")
        return inner[key]

    def __setattr__(self, name, value):
        self[keys.key_of(self._scene.program, self._path, name)] = value

    def update(self, **values):
        """Set several keys, by their names of Python."""
        for name, value in values.items():
            setattr(self, name, value)
        return self

    def add(self, *names, **values):
        """A further body, obstacle or probe, or for the section Contact a pair of two. It is
        entered in `Names` or `Pairs`, and its section is returned."""
        known = keys.section(self._scene.program, self._path)
        listing = next((key for key in ("Names", "Pairs") if key in known), None)
        if listing is None:
            raise AttributeError(f"nothing can be added to the section `{'/'.join(self._path)}`.")
        name = " : ".join(map(str, names))
        # Boundaries of a body, box[2,3], have commas of their own.
        entries = re.split(r",(?![^\[]*\])", self._given(listing))
        before = [text.strip() for text in entries if text.strip()]
        if name not in before:
            self[listing] = ", ".join([*before, name])
        self[name] = {}
        return Section(self._scene, (*self._path, name)).update(**values)

    def _given(self, key):
        return str(self._scene.section(self._path).get(key, ""))

    def _join(self, key):
        return "/".join((*self._path, key))


class Scene(Section):
    """A whole scene.

    sections: a nested dictionary, Scene({"Time": {"Step size": 1e-3}}), or one with paths,
    Scene({"Time/Step size": 1e-3}). Values are texts, numbers, bools, or sequences of numbers.
    folder: from which the names of files are relative (default: the current one).
    values: keys of the top, by their names of Python: Scene(dimension=2).
    """

    def __init__(self, sections=None, *, folder=".", executable=None, **values):
        super().__init__(self, ())
        vars(self).update(
            sections={}, folder=pathlib.Path(folder).resolve(), _executable=executable
        )
        for path, value in (sections or {}).items():
            self[path] = value
        self.update(**values)

    @classmethod
    def read(cls, path, executable=None):
        """The scene of a file, with all that it includes."""
        folder = pathlib.Path(path).parent
        return cls(prm.parse(prm.read(path), folder), folder=folder, executable=executable)

    @property
    def executable(self):
        """The program that is asked which keys there are."""
        return find_executable(self._executable)

    @property
    def program(self):
        """The executable with the plug-ins of the scene, which have keys of their own."""
        plugins = self._plugins()
        return (self.executable, *(["--set", f"{PLUGINS}={plugins}"] if plugins else []))

    def _plugins(self):
        names = [name.strip() for name in str(self.sections.get(PLUGINS, "")).split(",")]
        return ", ".join(str(self.folder / name) for name in names if name)

    def section(self, path):
        """The keys of a section as a dictionary, empty if the scene does not have it."""
        found = self.sections
        for name in path:
            found = found.get(name, {})
        return found

    def __getitem__(self, path):
        *outer, key = path.split("/")
        return self.section(outer)[key]

    def __setitem__(self, path, value):
        *outer, key = path.split("/")
        found = self.sections
        for name in outer:
            found = found.setdefault(name, {})
        if not isinstance(value, dict):
            found[key] = value
            return
        found.setdefault(key, {})
        for name, inner in value.items():
            self[f"{path}/{name}"] = inner

    def changed(self, settings):
        """A copy with other values: {"Time/Step size": 1e-3}."""
        copy = Scene(self.sections, folder=self.folder, executable=self._executable)
        for path, value in settings.items():
            copy[path] = value
        return copy

    def dictionary(self):
        """The scene as a nested dictionary of texts, in which names of files are absolute."""
        return self._texts(self.sections, ())

    def _texts(self, sections, path):
        found = {}
        for key, value in sections.items():
            if isinstance(value, dict):
                found[key] = self._texts(value, (*path, key))
            elif isinstance(value, bool):
                found[key] = str(value).lower()
            elif isinstance(value, str) or not hasattr(value, "__iter__"):
                found[key] = str(value)
            else:
                found[key] = keys.separator(self.program, path, key).join(map(str, value))
            if key == "File" and found[key]:
                found[key] = str(self.folder / found[key])
            if key == PLUGINS:
                found[key] = self._plugins()
        return found

    def flat(self):
        """dictionary() as one without sections: {"Time/Step size": "1e-3"}."""
        found, waiting = {}, [("", self.dictionary())]
        for prefix, sections in waiting:
            for key, value in sections.items():
                if isinstance(value, dict):
                    waiting.append((f"{prefix}{key}/", value))
                else:
                    found[prefix + key] = value
        return found

    def text(self):
        """The scene as a .prm, which can be run from any folder."""
        return prm.text_of(self.dictionary())

    def write(self, path):
        """text() as a file."""
        pathlib.Path(path).write_text(self.text(), encoding="utf-8")

    def validate(self):
        """What the program says about the scene before it runs it: steps, cells, expected impacts,
        notes, warnings and more, as a dictionary. Raises SceneError with the message of the
        program."""
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "scene.prm")
            self.write(path)
            return json.loads(ask(path, "--validate=json", executable=self._executable))
