"""A verb of the score to a short text, as an author would write it."""

from __future__ import annotations

from facescript.ir.acts import (
    Add,
    AddLink,
    Drop,
    GazeManner,
    Gesture,
    Glance,
    Look,
    Perform,
    Say,
    Scan,
    SetBackground,
    SetLife,
    SetPicture,
    Show,
    Timing,
    Verb,
    View,
    Wait,
    WaitUntil,
)
from facescript.ir.values import Aim, Amount, AtCamera, AtFace, AtPerson, AtTarget, Away, Mix, Term, Towards
from facescript.schedule.defaults import seconds

LONGEST = 48
"""Characters of a line's text that are shown."""


def phrase(verb: Verb) -> str:
    """The verb with what an author chose about it; its own lengths are left out."""
    match verb:
        case Look(aim, manner, timing):
            over = "" if timing.over is None else f" over {duration(timing.over)}"
            return f"look {_towards(aim)}{over}{_length(timing)}{_manner(manner)}"
        case Glance(aim, manner):
            return f"glance {_target(aim)}{_manner(manner)}"
        case Scan(crowd, dwell, order, manner):
            each = "" if dwell is None else f", {duration(dwell)} each"
            return f"scan {crowd}{each}{'' if order == 'in order' else f', {order}'}{_manner(manner)}"
        case Show(mix, timing) | Add(mix, timing):
            return f"{type(verb).__name__.lower()} {_sum(mix)}{_length(timing)}{_felt(timing)}"
        case Gesture():
            return _gesture(verb)
        case Say(text):
            return f'say "{text if len(text) <= LONGEST else text[: LONGEST - 3] + "..."}"'
        case _:
            return _rest(verb)


def _rest(verb: Verb) -> str:
    match verb:
        case Drop(name):
            return f"drop {name}"
        case Perform(take, speed):
            return f'play "{take.path}"{"" if speed == 1.0 else f", speed {percent(speed)}"}'
        case SetBackground():
            return f"background {_ground(verb)}"
        case View(face, zoom):
            return f"view {face or 'all'}{'' if zoom == 1.0 else f' {percent(zoom)}'}"
        case SetLife(life):
            return f"life {life.name}"
        case SetPicture(picture):
            return "picture none" if picture is None else f'picture "{picture}"'
        case AddLink(address):
            return f'link "{address}"'
        case Wait(length):
            return f"wait {duration(length)}"
        case WaitUntil():
            return "wait until"
    raise ValueError(f"no verb: {verb}")


def _ground(background: SetBackground) -> str:
    if background.picture is not None:
        return f'"{background.picture}"'
    if background.gradient is None:
        return background.colour or "none"
    return f"{' to '.join(background.gradient.colours)}{_course(background.gradient.towards)}"


def _course(towards: float | None) -> str:
    if towards is None:
        return ", round"
    return {-90.0: "", 0.0: ", left to right"}.get(towards, f", towards {towards:g}deg")


def percent(share: Amount) -> str:
    return f"{round(100 * seconds(share), 1):g}%"


def duration(length: Amount) -> str:
    time = seconds(length)
    return f"{round(1000 * time):g}ms" if time < 1 else f"{round(time, 3):g}s"


def _gesture(gesture: Gesture) -> str:
    side = ""
    if gesture.kind == "tilt":
        side = " right" if any(seconds(term.degree) < 0 for term in gesture.mix.terms) else " left"
    elif gesture.kind == "wink":
        side = "".join(f" {term.name.rpartition('.')[2]}" for term in gesture.mix.terms[:1])
    return f"{gesture.kind}{side}{'' if gesture.degree == 1.0 else f' {percent(gesture.degree)}'}"


def _towards(aim: Aim) -> str:
    if isinstance(aim, Away):
        return "away"
    if isinstance(aim, Towards):
        yaw, pitch = seconds(aim.yaw), seconds(aim.pitch)
        aside = f"{'right' if yaw < 0 else 'left'} {abs(yaw):g}deg" if yaw or not pitch else ""
        up = f"{'up' if pitch > 0 else 'down'} {abs(pitch):g}deg" if pitch else ""
        return f"{aside} {up}".strip()
    return f"at {_target(aim)}"


def _target(aim: Aim) -> str:
    match aim:
        case AtTarget(name, member):
            return name if member is None else f"{name}.{member}"
        case AtFace(face, part):
            return face if part == "eyes" else f"{face}.{part}"
        case AtPerson(name):
            return name
        case AtCamera():
            return "camera"
    return _towards(aim)


def _manner(manner: GazeManner) -> str:
    parts = "" if manner.parts == "eyes then head" else f", {manner.parts}"
    return parts + ("" if manner.head_share is None else f", head {percent(manner.head_share)}")


def _length(timing: Timing) -> str:
    return "" if timing.lasting is None else f" for {duration(timing.lasting)}"


def _felt(timing: Timing) -> str:
    return f", {timing.manner}" if timing.manner else ""


def _sum(mix: Mix) -> str:
    """`smile 40% + AU4 10%`; nothing is `neutral`."""
    parts: list[str] = []
    for term in mix.terms:
        sign = "- " if seconds(term.degree) < 0 else "+ " if parts else ""
        parts.append(f"{sign}{term.name}{_degree(term)}")
    return " ".join(parts) or "neutral"


def _degree(term: Term) -> str:
    """A term's degree; of a channel, in its own unit."""
    degree = abs(seconds(term.degree))
    only = term.drivers[0] if len(term.drivers) == 1 else None
    if only is not None and only.name == term.name and degree == 1.0:
        part = term.name.rpartition(".")[2]
        if part in ("yaw", "pitch", "roll"):
            return f" {seconds(only.value):g}deg"
        if part in ("x", "y"):
            return f" {seconds(only.value):g}cm"
        return f" {percent(only.value)}"
    return "" if degree == 1.0 else f" {percent(degree)}"
