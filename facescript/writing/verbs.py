"""A verb of a play to the line that says it, without the name of its face."""

from __future__ import annotations

from facescript.ir.acts import (
    Add,
    AddLink,
    Drop,
    GazeManner,
    Gesture,
    Glance,
    Gradient,
    Life,
    Look,
    Perform,
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
from facescript.ir.values import Aim, Amount, AtCamera, AtFace, AtPerson, AtTarget, Away, Draw, Moment, Towards
from facescript.resolve.background import DIRECTIONS, DOWN
from facescript.resolve.lives import KINDS
from facescript.resolve.units import ANGLE, SHARE, TIME
from facescript.writing.amounts import amount, one
from facescript.writing.context import Context
from facescript.writing.labels import Labels
from facescript.writing.quotes import quoted
from facescript.writing.sums import Sums, sided


class Verbs:
    """Writes verbs; `sums` knows the expressions."""

    def __init__(self, context: Context, sums: Sums) -> None:
        self.context, self.sums = context, sums

    def verb(self, verb: Verb, labels: Labels) -> str:
        """All verbs but `say`."""
        match verb:
            case Look(aim, manner, timing):
                return f"look {self._aim(aim, labels, 'at ')}{_timing(timing)}{_manner(manner)}"
            case Glance(aim, manner, timing):
                return f"glance {self._aim(aim, labels, '')}{_timing(timing)}{_manner(manner)}"
            case Scan(crowd, dwell, order, manner):
                each = "" if dwell is None else f", {amount(dwell, TIME)} each"
                return f"scan {crowd}{each}{'' if order == 'in order' else f', {order}'}{_manner(manner)}"
            case Show(mix, timing):
                return f"show {self.sums.sum(mix)}{_timing(timing)}"
            case Add(mix, timing):
                return f"add {self.sums.sum(mix)}{_timing(timing)}"
            case Gesture(kind, degree, _, timing):
                share = "" if degree == 1.0 else f" {amount(degree, SHARE)}"
                return f"{kind}{_side(verb)}{share}{_timing(timing)}"
            case _:
                return self._of_the_scene(verb, labels)

    def _of_the_scene(self, verb: Verb, labels: Labels) -> str:
        match verb:
            case Perform(take, speed, timing):
                rate = "" if speed == 1.0 else f", speed {amount(speed, SHARE)}"
                return f'play "{self.context.path(take.path)}"{_timing(timing)}{rate}'
            case Drop(name, timing):
                return f"drop {labels.local(name) or name}{_timing(timing)}"
            case Wait(duration):
                return f"wait {amount(duration, TIME)}"
            case WaitUntil(moment):
                return f"wait until {self.moment(moment, labels)}"
            case SetBackground():
                return self.background(verb)
            case View(face, zoom, over):
                share = "" if zoom == 1.0 else f" {amount(zoom, SHARE)}"
                return f"view {face or 'all'}{share}{_over(over)}"
            case SetLife(life, over):
                name, knobs = self.life(life)
                return f"life {name}{_over(over)}{''.join(f', {knob}' for knob in knobs)}"
            case SetPicture(None):
                return "picture none"
            case SetPicture(picture, caption):
                told = f" {quoted(caption)}" if caption else ""
                return f'picture "{self.context.path(picture or "")}"{told}'
            case AddLink(address, text):
                return f'link "{address}" {quoted(text)}'
        raise ValueError(f"no verb: {verb}")

    # -------------------------------------------------------------------------------------------- parts

    def background(self, ground: SetBackground) -> str:
        if ground.gradient is not None:
            return f"background {_gradient(ground.gradient, _over(ground.over))}"
        picture = f'"{self.context.path(ground.picture)}"' if ground.picture is not None else "none"
        return f"background {ground.colour or picture}{_over(ground.over)}"

    def life(self, life: Life) -> tuple[str, list[str]]:
        """The preset, and the knobs that stand otherwise than there."""
        base = self.context.library_life(life.name)
        usual = dict(base.knobs) if base is not None else {}
        return life.name, [
            f"{name} {amount(value, KINDS.get(name, SHARE))}" for name, value in life.knobs if usual.get(name) != value
        ]

    def moment(self, moment: Moment, labels: Labels) -> str:
        """A time, or a mark and a time from it."""
        if moment.mark is None:
            return amount(moment.offset, TIME)
        mark, offset = labels.mark(moment.mark), moment.offset
        if offset == 0.0:
            return mark
        if isinstance(offset, Draw):
            return f"{mark} + ({amount(offset, TIME)})"
        return f"{mark} {'-' if offset < 0.0 else '+'} {one(abs(offset), TIME)}"

    def _aim(self, aim: Aim, labels: Labels, at: str) -> str:
        match aim:
            case Away():
                return "away"
            case Towards(yaw, pitch):
                return _direction(yaw, pitch)
            case AtCamera():
                return f"{at}camera"
            case AtTarget(name, member):
                return f"{at}{name}" if member is None else f"{at}{name}.{member}"
            case AtFace(face, part):
                return f"{at}{face}" if part == "eyes" else f"{at}{face}.{part}"
            case AtPerson(name):
                return f"{at}{labels.person(name)}"


def _direction(yaw: Amount, pitch: Amount) -> str:
    turns = [_turn(yaw, "left", "right")] if yaw != 0.0 or pitch == 0.0 else []
    return " ".join([*turns, *([_turn(pitch, "up", "down")] if pitch != 0.0 else [])])


def _turn(angle: Amount, positive: str, negative: str) -> str:
    if isinstance(angle, Draw):
        below = angle.high <= 0.0
        turned = Draw(-angle.high, -angle.low) if below else angle
        return f"{negative if below else positive} {amount(turned, ANGLE)}"
    return f"{negative if angle < 0.0 else positive} {amount(abs(angle), ANGLE)}"


def _gradient(gradient: Gradient, over: str) -> str:
    colours = " to ".join(gradient.colours)
    if gradient.towards == DOWN:
        return colours + over
    named = next((name for name, towards in DIRECTIONS.items() if towards == gradient.towards), None)
    return f"{colours}, {named or f'towards {amount(gradient.towards or 0.0, ANGLE)}'}{over}"


def _side(gesture: Gesture) -> str:
    if gesture.kind == "tilt":
        return " right" if any(term.degree == -1.0 for term in gesture.mix.terms) else " left"
    if gesture.kind == "wink":
        return "".join(f" {sided(term.name)[1]}" for term in gesture.mix.terms[:1])
    return ""


def _timing(timing: Timing) -> str:
    over, lasting, back = (
        "" if value is None else f" {word} {amount(value, TIME)}"
        for word, value in (("over", timing.over), ("for", timing.lasting), ("back in", timing.back))
    )
    ease = "" if timing.ease is None else f" ease {timing.ease}"
    return f"{over}{lasting}{back}{ease}{f', {timing.manner}' if timing.manner else ''}"


def _manner(manner: GazeManner) -> str:
    parts = "" if manner.parts == "eyes then head" else f", {manner.parts}"
    head = "" if manner.head_share is None else f", head {amount(manner.head_share, SHARE)}"
    speed = "" if manner.speed == 1.0 else f", speed {amount(manner.speed, SHARE)}"
    latency = "" if manner.latency == 0.0 else f", latency {amount(manner.latency, TIME)}"
    return f"{parts}{head}{speed}{latency}"


def _over(over: Amount) -> str:
    return "" if over == 0.0 else f" over {amount(over, TIME)}"
