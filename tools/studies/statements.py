# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Sentences about schemes, each decided by numbers."""

import math

from . import judge


def listing(pairs, form="{:.3g}"):
    """Names with their numbers in brackets, the largest first."""
    pairs = sorted(pairs, key=lambda pair: -abs(pair[1]))
    return ", ".join(f"{name} ({form.format(value)})" for name, value in pairs) or "none"


def names(pairs, others):
    """Names alone; when they are many more than the others, which are listed anyway, only that."""
    if len(pairs) > 4 and len(pairs) > len(others):
        return f"all others ({len(pairs)})" if others else f"all ({len(pairs)})"
    return ", ".join(name for name, _ in pairs) or "none"


def values(scene, observation):
    """(name, number) of all variants of which it is known."""
    pairs = [
        (variant.name, numbers.get(observation, math.nan))
        for variant, numbers in zip(scene.variants, scene.numbers)
    ]
    return [(name, value) for name, value in pairs if not math.isnan(value)]


def split(pairs, condition):
    """Those that fulfil the condition, and the others."""
    return [pair for pair in pairs if condition(pair[1])], [
        pair for pair in pairs if not condition(pair[1])
    ]


def smooth_and_not(scene, observation, what, limit=judge.SMOOTH):
    """Which are smooth, with less than a limit."""
    smooth, rough = split(values(scene, observation), lambda value: value < limit)
    return (
        [f"Oscillating {what}: {listing(rough)}.", f"Smooth {what}: {names(smooth, rough)}."]
        if smooth or rough
        else []
    )


def energy(scene, prefix=""):
    """Which keep, lose or gain energy."""
    word = "own energy" if prefix else "energy"
    most, change = dict(values(scene, prefix + "energy_most")), dict(
        values(scene, prefix + "energy_change")
    )
    drift = dict(values(scene, prefix + "energy_drift"))
    kept = [name for name in most if drift[name] <= judge.NONE]
    gain = [(name, value) for name, value in most.items() if value > judge.NONE]
    lose = [(name, change[name]) for name in most if name not in kept and most[name] <= judge.NONE]
    sentences = [
        f"Conserves {word}: {', '.join(kept) or 'none'}.",
        f"Never above the initial {word} (change at the end in %): {listing(lose, '{:+.3g}')}.",
        f"At some time above the initial {word} (at most, in %): {listing(gain, '{:+.3g}')}.",
    ]
    return sentences if most else []


def has_own_mass(scene):
    """Whether some scheme has two energies."""
    own = dict(values(scene, "own_energy_change"))
    return any(
        abs(own.get(name, value) - value) > judge.NONE
        for name, value in values(scene, "energy_change")
    )


def penetration(scene):
    """Which penetrate."""
    deep, tight = split(values(scene, "penetration_in_steps"), lambda value: value > 0)
    return (
        [
            f"Penetrates (depth in steps of approach): {listing(deep)}.",
            f"Does not penetrate: {names(tight, deep)}.",
        ]
        if deep or tight
        else []
    )


def velocity(scene):
    """Behaviour in contact, and after it."""
    zigzag, still = split(values(scene, "velocity_zigzag"), lambda value: value >= judge.SMOOTH)
    speed = dict(values(scene, "velocity_in_contact"))
    ends = [
        (name, low, dict(values(scene, "velocity_after_most"))[name])
        for name, low in values(scene, "velocity_after_least")
    ]
    ends.sort(key=lambda entry: entry[1] - entry[2])
    sentences = []
    if zigzag or still:
        at_rest = [name for name, _ in still if speed.get(name, 1.0) < judge.SMOOTH]
        frozen = [(name, speed[name]) for name, _ in still if name in speed and name not in at_rest]
        sentences += [
            f"Zigzag in contact (amplitude over the speed of approach): {listing(zigzag)}.",
            f"At rest in contact: {', '.join(at_rest) or 'none'}.",
            (
                "Without zigzag, but not at rest (largest speed over that of approach):"
                f" {listing(frozen)}."
            ),
        ]
    if ends:
        said = [f"{name}, {low:.3g} to {high:.3g}" for name, low, high in ends]
        sentences.append(f"Widest range after release: {said[0]}; narrowest: {said[-1]}.")
    return sentences


def by_figure(scene):
    """Sentences below each figure."""
    return {
        "force": smooth_and_not(scene, "force_zigzag", "force"),
        "energy": energy(scene) + (energy(scene, "own_") if has_own_mass(scene) else []),
        "displacement": penetration(scene),
        "velocity": velocity(scene),
        "pressure": smooth_and_not(scene, "pressure_scatter", "pressure", judge.SMOOTH_PRESSURE),
    }


def everywhere(scenes, observation, condition):
    """Names of the schemes that fulfil a condition in all scenes, and of those that do in none."""
    by_scene = [dict(values(scene, observation)) for scene in scenes]
    common = [name for name in by_scene[0] if all(name in numbers for numbers in by_scene)]
    return (
        [name for name in common if all(condition(numbers[name]) for numbers in by_scene)],
        [name for name in common if not any(condition(numbers[name]) for numbers in by_scene)],
    )


def summary(scenes):
    """What holds in all scenes."""
    if not scenes:
        return []
    smooth, rough = everywhere(scenes, "force_zigzag", lambda value: value < judge.SMOOTH)
    bounded, _ = everywhere(scenes, "energy_most", lambda value: value <= judge.NONE)
    tight, deep = everywhere(scenes, "penetration_in_steps", lambda value: value <= 0)
    drifts = [dict(values(scene, "energy_drift")) for scene in scenes]
    all_good = [
        (name, max(drift[name] for drift in drifts))
        for name in smooth
        if name in bounded and name in tight
    ]
    kept, _ = everywhere(scenes, "energy_drift", lambda value: value <= judge.NONE)

    def text(found):
        return ", ".join(found) or "none"

    return [
        (
            f"Smooth force in all {len(scenes)} scenes: {text(smooth)}. Oscillating in all:"
            f" {text(rough)}."
        ),
        (
            f"Energy never above the initial one in any scene: {text(bounded)}; conserved:"
            f" {text(kept)}."
        ),
        f"No penetration in any scene: {text(tight)}. Penetration in all: {text(deep)}.",
        (
            "All three, a smooth force, no gain of energy and no penetration, in all scenes (with"
            f" the largest loss, in %): {listing(all_good[::-1])}."
        ),
    ]
