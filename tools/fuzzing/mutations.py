# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Changes of a text, from a character to a block of lines. Bytes that are no text are kept as
surrogates, so every file is a text here."""

import re

from . import values

SETTING = re.compile(r"(\s*set\s+)([^=]*?)(\s*=\s*)(.*)", re.DOTALL)


def decoded(content):
    """Bytes as a text."""
    return content.decode("utf-8", "surrogateescape")


def encoded(text):
    """The bytes again."""
    return text.encode("utf-8", "surrogateescape")


class Mutator:
    """Changes with one source of randomness. pool: settings (key, value) by top-level section."""

    def __init__(self, source, pool):
        self.source, self.pool = source, pool
        self.words = pool["values"]

    def mutate(self, text, is_scene):
        """One change."""
        common = [
            (6, self.number),
            (3, self.character),
            (3, self.line),
            (2, self.block),
            (1, self.truncate),
            (1, self.noise),
            (0.3, self.encoding),
            (0.3, self.long),
        ]
        of_scenes = [(8, self.setting), (6, self.new_setting), (1, self.rename)] * is_scene
        weights, changes = zip(*common, *of_scenes)
        return self.source.choices(changes, weights)[0](text)

    def place(self, text):
        """Anywhere."""
        return self.source.randrange(len(text) + 1)

    def lines(self, text):
        """With their ends; at least one."""
        return text.splitlines(keepends=True) or [""]

    def number(self, text):
        """Another number."""
        found = list(values.NUMBER.finditer(text))
        if not found:
            return self.character(text)
        match = self.source.choice(found)
        return (
            text[: match.start()] + values.number(self.source, match[0]) + text[match.end() :]
        )

    def character(self, text):
        """Replaced, removed, or one more."""
        at, width = self.place(text), self.source.choice((0, 1, 1))
        new = self.source.choice(["", self.source.choice(values.SIGNS), chr(self.place("." * 126))])
        return text[:at] + new + text[at + width :]

    def line(self, text):
        """Removed, doubled, moved, exchanged, or joined with the next one."""
        lines = self.lines(text)
        a, b = (self.source.randrange(len(lines)) for _ in range(2))
        kind = self.source.randrange(5)
        if kind == 0:
            del lines[a]
        elif kind == 1:
            lines.insert(b, lines[a])
        elif kind == 2:
            lines.insert(b, lines.pop(a))
        elif kind == 3:
            lines[a], lines[b] = lines[b], lines[a]
        else:
            lines[a] = lines[a].rstrip("\n") + self.source.choice(("", " ", "\\\n"))
        return "".join(lines)

    def block(self, text):
        """Some lines removed, doubled or exchanged with others."""
        lines = self.lines(text)
        a, b = sorted(self.source.randrange(len(lines) + 1) for _ in range(2))
        b = min(b, a + 20)
        kind, block = self.source.randrange(3), lines[a:b]
        if kind == 0:
            del lines[a:b]
        elif kind == 1:
            at = self.source.randrange(len(lines) + 1)
            lines[at:at] = block
        else:
            lines[a:b] = reversed(block)
        return "".join(lines)

    def truncate(self, text):
        """The end, or the beginning, is missing."""
        at = self.place(text)
        return text[:at] if self.source.random() < 0.8 else text[at:]

    def noise(self, text):
        """Random bytes."""
        at = self.place(text)
        noise = decoded(self.source.randbytes(self.source.choice((1, 4, 100))))
        return text[:at] + noise + text[at + self.source.choice((0, len(noise))) :]

    def encoding(self, text):
        """Of another system."""
        kind = self.source.randrange(5)
        if kind == 0:
            return "\ufeff" + text
        if kind == 1:
            return text.replace("\n", "\r\n")
        if kind == 2:
            return text.replace("\n", "\r")
        if kind == 3:
            return decoded(text.encode("utf-16", "surrogatepass"))
        return text.replace(" ", self.source.choice(("\u00a0", "\t", "", "  ")))

    def long(self, text):
        """Very long, somewhere."""
        at = self.place(text)
        return text[:at] + values.long_text(self.source) + text[at:]

    def setting(self, text):
        """Another value for a key."""
        lines = self.lines(text)
        settings = [n for n, line in enumerate(lines) if SETTING.match(line)]
        if not settings:
            return self.line(text)
        n = self.source.choice(settings)
        begin, key, equal, _ = SETTING.match(lines[n]).groups()
        lines[n] = begin + key + equal + self.value(key) + "\n"
        return "".join(lines)

    def value(self, key):
        """Half of the time one that this key has somewhere."""
        known = self.pool["keys"].get(key.strip())
        if known and self.source.random() < 0.5:
            return self.source.choice(known)
        return values.value(self.source, self.words)

    def new_setting(self, text):
        """A key that belongs to this section."""
        lines = self.lines(text)
        at = self.source.randrange(len(lines) + 1)
        path = open_sections(lines[:at])
        section = path[0] if path else ""
        settings = self.pool["sections"].get((section, len(path)), self.pool["sections"]["", 0])
        key, value = self.source.choice(settings)
        if self.source.random() < 0.4:
            value = self.value(key)
        lines.insert(at, f"  set {key} = {value}\n")
        return "".join(lines)

    def rename(self, text):
        """A word that occurs gets another one that occurs."""
        words = re.findall(r"[A-Za-z][\w']*", text)
        if not words:
            return self.character(text)
        old, new = self.source.choice(words), self.source.choice(words)
        return text.replace(old, new, self.source.choice((1, -1)))


def open_sections(lines):
    """The names of those that are open behind these lines."""
    path = []
    for line in lines:
        words = line.split("#")[0].strip()
        if words.startswith("subsection "):
            path.append(words[11:].strip())
        elif words == "end" and path:
            path.pop()
    return path


def pool_of(texts):
    """Settings of texts: all values, values by key, and (key, value) by top-level section and
    depth."""
    pool = {"values": set(), "keys": {}, "sections": {}}
    for text in texts:
        lines = text.splitlines()
        for n, line in enumerate(lines):
            match = SETTING.match(line.split("#")[0].rstrip())
            if match:
                key, value = match[2].strip(), match[4].strip()
                path = open_sections(lines[:n])
                place = (path[0] if path else "", len(path))
                pool["values"].add(value)
                pool["keys"].setdefault(key, set()).add(value)
                pool["sections"].setdefault(place, set()).add((key, value))
    return {
        "values": sorted(pool["values"]),
        "keys": {key: sorted(found) for key, found in pool["keys"].items()},
        "sections": {place: sorted(found) for place, found in pool["sections"].items()},
    }
