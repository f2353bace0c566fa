# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""What a study file says."""

import configparser
import dataclasses
import itertools
import re

from .expressions import Expression
from .mistake import Mistake
from .observe import DISTANCES, OBSERVATIONS
from .quantities import read_curve, read_quantities

#: Sections without a name of their own.
SECTIONS = (
    "study",
    "scene",
    "coarse",
    "variations",
    "together",
    "reference",
    "quantities",
    "schemes",
    "curves",
    "exact",
    "expected",
    "certify",
)
#: Keys of the section [study].
KEYS = (
    "scene",
    "title",
    "geometry",
    "observe",
    "variants",
    "processes",
    "pressure at",
    "exact force",
    "curve",
    "figure",
    "peers",
    "certify with",
)
#: What a [variant NAME] says besides keys of the scene.
WORDS = ("group", "paper", "full")


@dataclasses.dataclass
class Variant:
    """One line of a table: a name, where it belongs, and the keys of the scene that make it."""

    name: str
    settings: dict
    group: str = ""
    paper: str = ""
    full: str = ""  # not empty: too long for the quick version of a study that has one

    @property
    def folder(self):
        """The name as the name of a folder."""
        return re.sub(r"[^A-Za-z0-9.]+", "-", self.name).strip("-")


def read_ini(path):
    """The sections of a file; keys keep their capitals."""
    parser = configparser.ConfigParser(
        delimiters=("=",), inline_comment_prefixes=None, interpolation=None
    )
    parser.optionxform = str
    try:
        with open(path, encoding="utf-8") as file:
            parser.read_file(file)
    except (OSError, UnicodeDecodeError, configparser.Error) as error:
        raise Mistake(f"{path}: cannot be read: {error}") from None
    for section in parser.sections():
        if section not in SECTIONS and not section.startswith("variant "):
            raise Mistake(
                f"{path}: unknown section [{section}]. Valid:"
                f" {', '.join(f'[{name}]' for name in SECTIONS)}, [variant NAME]."
            )
    return parser


def read_variants(parser, path):
    """The sections [variant NAME]."""
    variants = []
    for section in parser.sections():
        if section.startswith("variant "):
            keys = dict(parser.items(section))
            words = {word: keys.pop(word) for word in WORDS if word in keys}
            variants.append(Variant(section.removeprefix("variant ").strip(), keys, **words))
    folders = [variant.folder for variant in variants]
    for variant in variants:
        if not variant.folder or folders.count(variant.folder) > 1:
            raise Mistake(
                f"{path}: [variant {variant.name}]: its results need a folder of their own. Give it"
                " another name, with other letters or digits."
            )
    return variants


class Study:
    """A scene, what varies, and what is observed."""

    def __init__(self, path, coarse=False):
        parser = read_ini(path)
        for key in parser["study"] if parser.has_section("study") else ():
            if key not in KEYS:
                raise Mistake(f"{path}: [study] has no key `{key}`. Valid: {', '.join(KEYS)}.")
        if not parser.has_option("study", "scene"):
            raise Mistake(f"{path}: [study] needs `scene = ...`, the scene to vary.")
        self.path, self.name = path, path.stem
        self.scene = (path.parent / parser["study"]["scene"]).resolve()
        if not self.scene.is_file():
            raise Mistake(
                f"{path}: scene = {parser['study']['scene']}: there is no file {self.scene}."
            )
        self.title = parser.get("study", "title", fallback=self.name)
        self.geometry = parser.get("study", "geometry", fallback="")
        self.pressure_time = self.time(parser, "pressure at")
        self.processes = self.whole_number(parser, "processes")
        self.observe = [
            name.strip()
            for name in parser.get("study", "observe", fallback="").split(",")
            if name.strip()
        ]
        self.read_quantities(parser)
        for name in self.observe:
            if name not in self.observations:
                raise Mistake(
                    f"{path}: observe = {name} is not known. Valid: {', '.join(self.observations)}."
                )
        self.read_expectations(parser)
        self.common = self.settings(parser, "scene")
        if coarse:
            if not parser.has_section("coarse"):
                raise Mistake(
                    f"{path}: --coarse needs a section [coarse] with the keys of the scene that"
                    " make it cheap."
                )
            self.common.update(self.settings(parser, "coarse"))
        self.variations = self.lists(parser, "variations")
        self.sequence = self.rows(parser, "together") or [{}]
        self.path_of_schemes = self.rows(parser, "schemes")
        self.variants = read_variants(parser, path)
        if parser.has_option("study", "variants"):
            other = (path.parent / parser["study"]["variants"]).resolve()
            self.variants = read_variants(read_ini(other), other) + self.variants
        if self.sequence == [{}] and not (self.variations or self.variants or self.path_of_schemes):
            raise Mistake(
                f"{path}: nothing varies. Give [variations], [together] or [variant NAME]."
            )

    def read_quantities(self, parser):
        """What the file derives from histories, a curve to compare it with, and which quantities a
        figure shows: (abscissa, ordinate)."""
        text = parser.get("study", "curve", fallback=None)
        self.curve_names, self.curve = (
            read_curve(self.path.parent / text, f"{self.path}: curve") if text else ((), None)
        )
        quantities = read_quantities(self.settings(parser, "quantities"), self.path, self.curve)
        self.observations = {**OBSERVATIONS, **quantities}
        text = parser.get("study", "figure", fallback=None)
        self.figure = text and tuple(name.strip() for name in text.split(" over "))[::-1]
        if text and (
            len(self.figure) != 2 or not all(name in self.observations for name in self.figure)
        ):
            raise Mistake(
                f"{self.path}: figure = {text}: give two observations or quantities, as in `figure"
                f" = impulse over force_largest`. Valid: {', '.join(self.observations)}."
            )

    def read_expectations(self, parser):
        """What runs are compared with: [reference], and the exact force."""
        text = parser.get("study", "exact force", fallback=None)
        self.exact_force = text and Expression(text, f"{self.path}: [study] exact force")
        self.curves = self.settings(parser, "curves")
        self.exact = {
            name: Expression(text, f"{self.path}: [exact] {name}")
            for name, text in self.settings(parser, "exact").items()
        }
        for name in self.exact:
            if name not in (*self.curves, *self.observations):
                raise Mistake(
                    f"{self.path}: [exact] {name}: there is neither such a curve in [curves] nor"
                    " such a quantity in [quantities]."
                )
        self.peers = parser.get("study", "peers", fallback="")
        self.expected = self.settings(parser, "expected")
        self.certify = self.rows(parser, "certify")
        self.certify_with = parser.get("study", "certify with", fallback="")
        self.reference = self.settings(parser, "reference")
        if parser.has_section("reference") and not self.reference:
            raise Mistake(
                f"{self.path}: [reference] is empty. Give the keys of the run to compare with, for"
                " example `Time/Scheme = reference`."
            )
        for name in self.observe:
            if name in DISTANCES and not self.reference:
                raise Mistake(
                    f"{self.path}: observe = {name} needs a section [reference] with the keys of"
                    " the run to compare with, for example `Time/Scheme = reference`."
                )
            if name == "force_error" and not self.exact_force:
                raise Mistake(
                    f"{self.path}: observe = {name} needs `exact force = ...` in [study], an"
                    " expression in t."
                )

    @staticmethod
    def settings(parser, section):
        """Keys of the scene and their values."""
        return dict(parser.items(section)) if parser.has_section(section) else {}

    @staticmethod
    def lists(parser, section):
        """Keys of the scene and their lists of values."""
        return {
            key: [value.strip() for value in text.split(";")]
            for key, text in Study.settings(parser, section).items()
        }

    def rows(self, parser, section):
        """Settings that change together, value by value."""
        columns = self.lists(parser, section)
        if len({len(column) for column in columns.values()}) > 1:
            raise Mistake(f"{self.path}: the keys in [{section}] need the same number of values.")
        return [dict(zip(columns, row)) for row in zip(*columns.values())]

    def whole_number(self, parser, key):
        """A number of [study], one if not given."""
        text = parser.get("study", key, fallback="1")
        if not text.isdigit() or int(text) < 1:
            raise Mistake(
                f"{self.path}: {key} = {text} is not a number of processes. Give 1, 2, ..."
            )
        return int(text)

    def time(self, parser, key):
        """A time of [study], None if not given."""
        text = parser.get("study", key, fallback=None)
        try:
            return text and float(text)
        except ValueError:
            raise Mistake(f"{self.path}: {key} = {text} is not a time. Give a number.") from None

    def runs(self):
        """(variant or None, settings) of each run; those of [together] are neighbours."""
        for variant in self.variants or [None]:
            for combination in itertools.product(*self.variations.values()):
                for row in self.sequence:
                    yield variant, {**dict(zip(self.variations, combination)), **row}
