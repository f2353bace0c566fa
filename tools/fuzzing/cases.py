# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The cases by their numbers: the same seed and number give the same files anywhere."""

import dataclasses
import random
import re
import subprocess

from stress import running

from . import mutations, seeds

#: What a mutation may not make larger without end, as it would only cost time.
LIMITED = {**seeds.MOST, "Refinements": 2, "Repetitions": 9, "Maximum level": 4}


@dataclasses.dataclass
class Case:
    """Files by name, with the scene in scene.prm, and what the command line sets."""

    number: int
    files: dict
    settings: list

    def write(self, folder):
        """Into a folder that exists."""
        for name, content in self.files.items():
            (folder / name).write_bytes(content)


class Cases:
    """All of a seed."""

    def __init__(self, executable, seed):
        self.seed = seed
        self.with_meshes, self.all = seeds.load()
        known = subprocess.run(
            [executable, "--print-parameters"], capture_output=True, text=True, check=True
        ).stdout
        choices = "".join(
            f"subsection Time\nset Scheme = {scheme['name']}\nend\n"
            for scheme in running.schemes(executable)
        )
        texts = [known, choices] + [files["scene.prm"].decode() for files in self.all]
        self.pool = mutations.pool_of(texts)

    def __getitem__(self, number):
        source = random.Random(f"{self.seed}-{number}")
        mutator = mutations.Mutator(source, self.pool)
        of_mesh = source.random() < 0.35
        files = dict(source.choice(self.with_meshes if of_mesh else self.all))
        if of_mesh:
            name = next(name for name in files if name != "scene.prm")
        else:
            name = "scene.prm"
        text = mutations.decoded(files[name])
        n_changes = source.choice((1, 1, 1, 2, 3, 5))
        settings = []
        for _ in range(n_changes):
            if source.random() < 0.1:
                settings.append(self.setting(mutator))
            else:
                text = mutator.mutate(text, not of_mesh)
        files[name] = mutations.encoded(affordable(source, text))
        return Case(number, files, settings)

    def setting(self, mutator):
        """An argument of --set."""
        source = mutator.source
        place = source.choice(sorted(self.pool["sections"]))
        key, value = source.choice(self.pool["sections"][place])
        path = [place[0]] + ["body", "floor"][: max(0, place[1] - 1)]
        value = source.choice((value, mutator.value(key)))
        text = "/".join([*filter(None, path), key]) + "=" + value
        if source.random() < 0.2:
            text = mutator.character(text)
        # The command line of a process has no zero bytes, and words of 128 kB at most.
        return affordable(source, text.replace("\0", ""))[:100000]


def affordable(source, text):
    """Nine of ten sizes that would only cost time are made small."""
    if source.random() < 0.1:
        return text
    for key, most in LIMITED.items():
        text = re.sub(seeds.KEY % key, lambda m, n=most: f"{m[1]} {seeds.at_most(m[2], n)}", text)
    return text
