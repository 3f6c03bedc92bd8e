"""What expression, gestures and life of a face ask of one driver at a moment, part by part."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from facescript.motion.drivers import Floats
from facescript.motion.expression import Layer
from facescript.motion.gesture import Gestures
from facescript.motion.life.lives import Lives
from facescript.motion.perform import SceneMotion
from facescript.owners.model import Part, Source, statement
from facescript.schedule.phrases import percent


def asked(scene: SceneMotion | None, row: int, time: float, left: float = 1.0) -> tuple[Part, ...]:
    """All parts of a driver (a row of a drive) at `time`, those that are 0 left out; their values add up to what the
    sources ask. `scene` is the one that plays, `left` how much gaze leaves of gestures."""
    if scene is None:
        return ()
    return (*shown(scene, row, time), *gestured(scene.gestures, row, time, left), *lived(scene.lives, row, time))


def shown(scene: SceneMotion, row: int, time: float) -> tuple[Part, ...]:
    """The terms of shows and adds. A show counts as far as no later one has replaced it (rule 5)."""
    at = np.array([time])
    found: list[Part] = []
    left = 1.0
    for layer in reversed(scene.expression.layers):
        weight = float(layer.weight(at)[0])
        if weight and layer.rise.start <= time:
            found += reversed([*_terms(layer, row, at, weight * left if layer.base else weight, left)])
        if layer.base:
            left *= 1.0 - weight * layer.covers(row)
    return tuple(reversed(found))


def _terms(layer: Layer, row: int, at: Floats, weight: float, left: float) -> Iterator[Part]:
    if layer.recorded is not None:
        full = float(layer.mix(at)[row, 0])
        if full and weight:
            yield Part(statement(layer.act), full, weight, _stands(layer, at, 1.0, left))
        return
    terms = layer.act.verb.mix.terms  # type: ignore[union-attr]
    for part, term in zip(layer.parts, terms, strict=True):
        full, now = float(part.column[row]), float(part.at(at)[row, 0])
        if now and weight:
            kept = now / full
            detail = f": {term.name}" if len(terms) > 1 else ""
            yield Part(statement(layer.act, detail), full, kept * weight, _stands(layer, at, kept, left))


def _stands(layer: Layer, at: Floats, kept: float, left: float) -> str:
    """What a layer does: how much of it each of these leaves is told where several come together."""
    risen, fallen = float(layer.rise.at(at)[0]), float(layer.fall.at(at)[0])
    leaves = {"rising": risen, "letting go": 1.0 - fallen, "dropped": kept, "under a later show": 1.0}
    if layer.base:
        leaves["under a later show"] = left
    found = [(state, share) for state, share in leaves.items() if share < 1.0]
    if len(found) < 2:
        return found[0][0] if found else "holds"
    return ", ".join(f"{state} ({percent(share)})" for state, share in found)


def base(scene: SceneMotion | None, row: int, time: float) -> Source | None:
    """The show or the take that owns the base of a driver: the latest that has begun and has not let go."""
    at = np.array([time])
    layers = reversed(scene.expression.layers) if scene is not None else ()
    owners = (layer for layer in layers if layer.covers(row) and layer.rise.start <= time and layer.weight(at)[0] > 0.0)
    return next((statement(layer.act) for layer in owners), None)


def gestured(gestures: Gestures, row: int, time: float, left: float) -> Iterator[Part]:
    """The gestures that are under way; their share is of the far pose, beyond it and back again where it swings. Gaze,
    which turns the head, leaves a part of them."""
    for item in gestures.movements:
        if item.start < time < item.end and row in item.rows:
            full = float(item.far[item.rows == row][0])
            share = float(item.profile((np.array([time]) - item.start) / (item.end - item.start))[0])
            done = percent((time - item.start) / (item.end - item.start))
            smaller = f", {left:.0%} of it while gaze turns the head" if left < 0.995 else ""
            if share:
                yield Part(statement(item.act), full, share * left, f"{done} of its time is over{smaller}")


def lived(lives: Lives, row: int, time: float) -> Iterator[Part]:
    """What the behaviours of the lives do; where one life fades into another both do."""
    at = np.array([time])
    for spell in lives.spells:
        if not spell.start <= time < spell.end:
            continue
        weight = float(spell.weight(at)[0])
        state = "" if weight == 1.0 else "one life fades into another"
        moved: dict[str, float] = {}
        for item in spell.moves:
            gain = dict(item.gains).get(row, 0.0)
            moved[item.by] = moved.get(item.by, 0.0) + gain * float(item.curve.at(at)[0])
        for behaviour, value in moved.items():
            if value and weight:
                yield Part(Source(f"life {spell.name}: {behaviour.replace('_', ' ')}"), value, weight, state)
