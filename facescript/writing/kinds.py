"""A kind of face that is data to the rows that define it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from facescript.ir.kind import Fill, Kind, KindHead, KindPoint, KindShape, Measures, Pull, Shade, Tone, TonedStop
from facescript.resolve.kinds.fills import LINES
from facescript.resolve.units import SHARE
from facescript.writing.amounts import number, one
from facescript.writing.context import Row

Pair = tuple[float, float]


def kind(kind: Kind) -> list[Row]:
    """The head of a kind, and its rows below."""
    head = f"kind {kind.name} = eyes {number(kind.distance)} apart, at {_numbers(kind.eyes_at)}"
    shapes = [Row(1, _shape(shape), shape.span) for shape in kind.shapes]
    pulls = [Row(1, _pull(pull), pull.span) for pull in kind.pulls]
    shades = [Row(1, _shade(shade), shade.span) for shade in kind.shades]
    return [Row(0, head, kind.span), *(Row(1, text, kind.span) for text in _rows(kind)), *shapes, *pulls, *shades]


def _rows(kind: Kind) -> Iterator[str]:
    yield from _head(kind.head)
    if kind.colours:
        yield f"colours {', '.join(f'{name} {colour}' for name, colour in kind.colours)}"
    yield f"outline {_pairs(kind.outline)}"
    yield f"shell {_numbers(kind.shell)}"
    yield f"nose base {number(kind.nose[0])}, width {number(kind.nose[1])}"
    yield f"jaw from {number(kind.jaw.start)}, drop {number(kind.jaw.drop)}"
    for eye in kind.eyes:
        named = f" {eye.name} at {_pair(eye.at)}," if eye.name else ""
        yield f"eye{named} {_measures(eye)}"
    yield f"mouth {_measures(kind.mouth)}"
    if kind.points:
        yield f"point {', '.join(f'{name} {_pair(at)}' for name, at in kind.points)}"
    if kind.hair:
        yield f"locks {_pairs(kind.hair)}"


def _head(head: KindHead) -> Iterator[str]:
    if head.voice is not None:
        voice = head.voice
        factors = ("rate", "pitch", "range", "volume")
        engine = f'{voice.engine} "{voice.variant}"' if voice.engine != "espeak" else voice.variant
        said = [f", {name} {one(getattr(voice, name), SHARE)}" for name in factors if getattr(voice, name) != 1.0]
        yield f"voice {voice.language} {engine}".rstrip() + "".join(said)
    if head.channels:
        yield f"has {', '.join(head.channels)}"
    for name, choices in head.looks:
        yield f"look {name} {', '.join(choices)}"
    for family, tints in head.tints:
        named = (
            f"{tint.name} {tint.colour}" + "".join([" with ", " ".join(tint.goes)] if tint.goes else [])
            for tint in tints
        )
        yield f"tints {family} {', '.join(named)}"
    for name, value in head.amounts:
        yield f"amount {name} {one(value, SHARE)}"


def _measures(measures: Measures) -> str:
    return ", ".join(f"{name} {_numbers(values)}" for name, values in measures.values)


# ------------------------------------------------------------------------------------------------ shapes


def _shape(shape: KindShape) -> str:
    depth = f" {number(shape.depth)}" if shape.depth is not None else ""
    parts = [f"shape {shape.id}", f"in {shape.group}", f"law {shape.law}{depth}", f"fill {_fill(shape.fill)}"]
    if shape.opacity != 1.0:
        parts.append(f"opacity {one(shape.opacity, SHARE)}")
    if shape.clip:
        parts.append(f"clip {' '.join(shape.clip)}")
    if shape.sides:
        parts.append("both sides" if shape.sides == "both" else "each side")
    parts += [f"when {name} {' or '.join(choices)}" for name, choices in shape.when]
    parts += [f"{outline.form} {' '.join(map(_spot, outline.points))}" for outline in shape.outlines]
    return ", ".join(parts)


def _spot(point: KindPoint) -> str:
    depth = f" z {number(point.depth)}" if point.depth is not None else ""
    return f"({_numbers(point.numbers)}{depth}{' sharp' if point.sharp else ''})"


def _fill(fill: Fill) -> str:
    if fill.form == "plain":
        return _tone(fill.stops[0].tone)
    stops = " ".join(map(_stop, fill.stops))
    if fill.form == "round":
        return f"round {_numbers(fill.where)} {stops}"
    way = "outward" if fill.outward else next((name for name, where in LINES.items() if where == fill.where), "")
    return f"{way or f'line {_numbers(fill.where)}'} {stops}"


def _stop(stop: TonedStop) -> str:
    opacity = f" opacity {one(stop.opacity, SHARE)}" if stop.opacity != 1.0 else ""
    return f"({_tone(stop.tone)} at {one(stop.at, SHARE)}{opacity})"


def _tone(tone: Tone) -> str:
    return f"{tone.name} {one(tone.share, SHARE)} {tone.other}" if tone.other else tone.name


# ------------------------------------------------------------------------------------------------ what moves


def _pull(pull: Pull) -> str:
    parts = [f"muscle {pull.signal}", f"moves {' '.join(pull.shapes)}", *(["both sides"] if pull.sides else [])]
    if pull.by:
        parts.append(f"by {_pairs(pull.by)}")
    parts += [f"at {_pair(each.at)} by {_pair(each.by)} within {number(each.within)}" for each in pull.fields]
    return ", ".join(parts)


def _shade(shade: Shade) -> str:
    terms = [
        f"{term.signal} {one(term.share, SHARE)}{f' with {term.other}' if term.other else ''}" for term in shade.terms
    ]
    sides = ", both sides" if shade.sides else ""
    most = f", at most {one(shade.most, SHARE)}" if shade.most != 1.0 else ""
    return f"shade {shade.shape}, {' + '.join(terms)}{sides}{most}"


# ------------------------------------------------------------------------------------------------ numbers


def _numbers(values: Iterable[float]) -> str:
    return " ".join(map(number, values))


def _pair(pair: Pair) -> str:
    return f"({_numbers(pair)})"


def _pairs(pairs: Iterable[Pair]) -> str:
    return " ".join(map(_pair, pairs))
