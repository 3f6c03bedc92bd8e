"""Film, faces, targets, lives, sounds and events of a play to the rows that declare them."""

from __future__ import annotations

from collections.abc import Iterator

from facescript.ir.acts import Voice
from facescript.ir.play import Crowd, Event, Face, Film, FixedTarget, MovingTarget, Target, Viseme
from facescript.ir.values import PicturePlace, Point
from facescript.resolve.film import SCREENS
from facescript.resolve.looks import COLOURS
from facescript.resolve.targets import LOST
from facescript.resolve.units import COUNT, FRAMES, LENGTH, SHARE, TIME
from facescript.speech.voices.registry import ENGINES
from facescript.writing.amounts import amount, one
from facescript.writing.context import Context, Row
from facescript.writing.quotes import quoted
from facescript.writing.sums import driven
from facescript.writing.verbs import Verbs

TEXTUAL = ("heard", "touched", "key", "signal")


def film(play: Film) -> str:
    """What is not as usual; nothing where all is."""
    usual = Film()
    said = []
    if (play.width, play.height) != (usual.width, usual.height):
        said.append(f"{play.width}x{play.height}")
    if play.fps != usual.fps:
        said.append(one(play.fps, FRAMES))
    if play.seed != usual.seed:
        said.append(f"seed {one(float(play.seed), COUNT)}")
    if play.long is not None:
        said.append(f"{one(play.long, TIME)} long")
    if play.screen != usual.screen:
        said.append(f"screen {_screen(play.screen)}")
    if play.wide_cm != usual.wide_cm:
        said.append(f"{one(play.wide_cm, LENGTH)} wide")
    said += [f"{name} {quoted(text)}" for name, text in (("title", play.title), ("author", play.author)) if text]
    return f"film {', '.join(said)}" if said else ""


def _screen(screen: float) -> str:
    return next((name for name, value in SCREENS.items() if value == screen), "") or one(screen, SHARE)


def face(context: Context, verbs: Verbs, face: Face) -> list[Row]:
    """A face and, below it, what is said of it."""
    head = f"face {face.name} = {face.kind}"
    voice = _voice(context, face.voice)
    rows = [Row(1, text, face.span) for text in _said(verbs, face)]
    return [Row(0, f"{head}, {voice}", face.span), *rows]


def _said(verbs: Verbs, face: Face) -> Iterator[str]:
    yield from _looks(face)
    name, knobs = verbs.life(face.life)
    if name != "calm" or knobs:
        yield ", ".join((f"life {name}", *knobs))
    if face.gaze:
        yield f"gaze {face.gaze}"
    if face.place is not None:
        yield f"at {_picture(face.place)}"
    if face.size != 1.0:
        yield f"size {one(face.size, SHARE)}"


def _looks(face: Face) -> Iterator[str]:
    """A line a look: its choice and its colour."""
    colours = {_look(family): colour for family, colour in face.looks}
    choices = dict(face.choices)
    for name in dict.fromkeys((*choices, *colours, *(["hair"] if face.hair else []))):
        still = [face.hair] if name == "hair" and face.hair else []
        yield " ".join(
            (name, *([choices[name]] if name in choices else []), *([colours[name]] if name in colours else []), *still)
        )
    for name, value in face.amounts:
        yield f"{name} {one(value, SHARE)}"


def _look(family: str) -> str:
    """The look that tints a family of colours; fur is an animal's hair."""
    looks = {family: look for look, family in COLOURS.items()} | {"fur": "hair"}
    return looks.get(family, family)


def _voice(context: Context, voice: Voice) -> str:
    if voice.engine == Voice().engine:
        called = f"voice {voice.language} {voice.variant}".rstrip()
    else:
        row = ENGINES.get(voice.engine)
        variant = context.path(voice.variant) if row is not None and row.files else voice.variant
        called = f'voice {voice.language} {voice.engine} "{variant}"'
    factors = [(name, getattr(voice, name)) for name in ("rate", "pitch", "range", "volume")]
    return called + "".join(f", {name} {one(value, SHARE)}" for name, value in factors if value != 1.0)


# ------------------------------------------------------------------------------------------------ places


def target(target: Target) -> list[Row]:
    """A target; the keys of a moving one stand below it."""
    if isinstance(target, FixedTarget):
        return [Row(0, f"target {target.name} at {_place(target.place)}", target.span)]
    if isinstance(target, Crowd):
        members = " ".join(member if isinstance(member, str) else f"({_place(member)})" for member in target.members)
        return [Row(0, f"target {target.name} of {members}", target.span)]
    return [Row(0, f"target {target.name} moves", target.span), *_keys(target)]


def _keys(target: MovingTarget) -> Iterator[Row]:
    """The keys, and `lost` where nobody knows where the target is until the next."""
    begins = {start for start, _ in target.lost}
    if any(start < 0.0 for start in begins):
        yield Row(1, LOST, target.span)
    for time, place in zip(target.times, target.places, strict=False):
        yield Row(1, f"{one(time, TIME)} {_place(place)}", target.span)
        if time in begins:
            yield Row(1, LOST, target.span)


def _place(place: Point | PicturePlace) -> str:
    if isinstance(place, PicturePlace):
        return _picture(place)
    return " ".join(one(value, LENGTH) for value in (place.x, place.y, place.z))


def _picture(place: PicturePlace) -> str:
    return f"{one(place.x, SHARE)} {one(place.y, SHARE)}"


# ------------------------------------------------------------------------------------------------ sounds, events


def viseme(viseme: Viseme) -> str:
    if viseme.like:
        share = "" if viseme.degree == 1.0 else f" {one(viseme.degree, SHARE)}"
        return f'viseme "{viseme.sound}" = "{viseme.like}"{share}'
    terms = driven((driver.name, float(driver.value)) for driver in viseme.drivers)  # type: ignore[arg-type]
    return f'viseme "{viseme.sound}" = {" + ".join(terms) or "neutral"}'


def event(event: Event) -> Row:
    happens = f'{event.kind} "{event.text}"' if event.kind in TEXTUAL else f"{event.person} {event.kind}"
    return Row(0, f"event {happens} at {amount(event.time, TIME)}", event.span)
