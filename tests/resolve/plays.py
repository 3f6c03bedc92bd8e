"""Plays as text that people can read in a diff, and helpers that resolve a script."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from tempfile import mkdtemp

from facescript.diagnostics.model import Diagnostics
from facescript.ir import acts, values
from facescript.ir.play import Crowd, FixedTarget, MovingTarget, Play
from facescript.resolve.resolver import resolve
from facescript.syntax.parser import parse
from facescript.text import Source
from facescript.world import World

EMPTY = World(Path(mkdtemp(prefix="facescript-empty-")))


def resolved(
    text: str, root: Path | None = None, name: str = "script.face", overrides: Mapping[str, str] | None = None
) -> tuple[Play | None, Diagnostics]:
    """The play of a script and all that was said of it."""
    diagnostics = Diagnostics()
    script = parse(Source(name, text), diagnostics)
    world = World(root) if root is not None else EMPTY
    return resolve(script, world, diagnostics, overrides or {}), diagnostics


def play_of(text: str, root: Path | None = None, overrides: Mapping[str, str] | None = None) -> Play:
    """The play of a script that has no errors."""
    play, diagnostics = resolved(text, root, overrides=overrides)
    assert play is not None, said(diagnostics)
    return play


def codes(text: str, root: Path | None = None) -> list[str]:
    return [item.code for item in resolved(text, root)[1]]


def said(diagnostics: Diagnostics) -> str:
    """One line a diagnostic: place, code, message."""
    lines = []
    for item in diagnostics:
        line, column = item.span.source.position(item.span.start) if item.span else (0, 0)
        file = item.span.source.name if item.span else "-"
        lines.append(f"{file}:{line}:{column}: {item.code} {item.severity}: {item.message}")
    return "".join(f"{line}\n" for line in lines)


def verbs(text: str, root: Path | None = None) -> list[acts.Verb]:
    """The verbs of a script's only scene, in order, blocks flattened."""
    return [do.verb for do in dos(play_of(text, root).scenes[0].body)]


def dos(node: acts.Node) -> list[acts.Do]:
    if isinstance(node, acts.Do):
        return [node]
    inner = (node.body,) if isinstance(node, acts.Repeat | acts.At) else node.items
    return [do for item in inner for do in dos(item)]


# ------------------------------------------------------------------------------------------------ as text


def shown(play: Play) -> str:
    """A play as indented text."""
    film = play.film
    long = "" if film.long is None else f", {film.long:g} s long"
    lines = [
        f"film {film.width}x{film.height} {film.fps:g} fps seed {film.seed}, screen {film.screen:.3f}, "
        f"{film.wide_cm:g} cm wide{long}"
    ]
    if play.background is not None:
        lines.append(verb(play.background))
    for face in play.faces:
        looks = "".join(f", {name} {value}" for name, value in face.looks)
        lines.append(f"face {face.name}: {face.kind}, {voice(face.voice)}, {life(face.life)}{looks}")
    lines += [target(item) for item in play.targets]
    for scene in play.scenes:
        lines.append(f"scene {scene.name} with {', '.join(scene.faces)}")
        lines += block(scene.body, 1)
    for reaction in play.reactions:
        event = reaction.event
        binds = f" as {event.binds}" if event.binds else ""
        lines.append(f"when {event.kind} {event.text!r}{binds}, then {reaction.ending}")
        lines += block(reaction.body, 1)
    for happens in play.events:
        lines.append(f"event {happens.kind} {happens.person or repr(happens.text)} at {amount(happens.time)}")
    return "\n".join(lines) + "\n"


def target(item: FixedTarget | MovingTarget | Crowd) -> str:
    if isinstance(item, FixedTarget):
        return f"target {item.name} {place(item.place)}"
    if isinstance(item, MovingTarget):
        keys = " ".join(f"{time:g}:{place(where)}" for time, where in zip(item.times, item.places, strict=True))
        return f"target {item.name} moves {keys}"
    return f"target {item.name} of {' '.join(m if isinstance(m, str) else place(m) for m in item.members)}"


def place(where: values.Point | values.PicturePlace) -> str:
    if isinstance(where, values.Point):
        return f"({where.x:.4g} {where.y:.4g} {where.z:.4g} cm)"
    return f"({where.x:g} {where.y:g} of the picture)"


def voice(item: acts.Voice) -> str:
    variant = f" {item.variant}" if item.variant else ""
    swing = f" range {item.range:.3g}" if item.range != 1 else ""
    return f"{item.language}{variant} rate {item.rate:.3g} pitch {item.pitch:.3g}{swing} volume {item.volume:.3g}"


def life(item: acts.Life) -> str:
    return f"life {item.name} ({', '.join(f'{name} {amount(value)}' for name, value in item.knobs)})"


def block(node: acts.Node, depth: int) -> list[str]:
    pad = "  " * depth
    label = f" as {node.label}" if node.label else ""
    if isinstance(node, acts.Do):
        who = f"{node.face}: " if node.face else ""
        lines = [f"{pad}{who}{verb(node.verb)}{label}"]
        if isinstance(node.verb, acts.Say):
            for cue in node.verb.cues:
                lines.append(f"{pad}  {when(cue)}")
                lines += [line for item in cue.body.items for line in block(item, depth + 2)]
        return lines
    if isinstance(node, acts.At):
        return [f"{pad}at {moment(node.moment)}", *block(node.body, depth + 1)]
    if isinstance(node, acts.Repeat):
        how = f"{node.times} times" if node.times is not None else "forever"
        how = f"for {amount(node.lasting)}" if node.lasting is not None else how
        return [f"{pad}repeat {how}{label}", *block(node.body, depth + 1)]
    name = type(node).__name__.lower()
    clock = " (clock)" if isinstance(node, acts.Sequence) and node.clock else ""
    return [f"{pad}{name}{clock}{label}", *(line for item in node.items for line in block(item, depth + 1))]


def when(cue: acts.Cue) -> str:
    if cue.word is not None:
        return f"on {cue.word!r} {cue.nth}"
    until = "" if cue.until is None else f" until {cue.until}"
    return f"before {cue.at}{until}"


def verb(item: acts.Verb) -> str:
    name = type(item).__name__.lower()
    if isinstance(item, acts.Look | acts.Glance):
        return f"{name} {aim(item.aim)}{manner(item.manner)}{timing(item.timing)}"
    if isinstance(item, acts.Scan):
        return f"scan {item.crowd} {amount(item.dwell)} each {item.order}{manner(item.manner)}"
    if isinstance(item, acts.Show | acts.Add):
        return f"{name} {mix(item.mix)}{timing(item.timing)}"
    if isinstance(item, acts.Gesture):
        return f"{item.kind} {amount(item.degree)} of {mix(item.mix)}{timing(item.timing)}"
    if isinstance(item, acts.Say):
        marks = "".join(f" <{s.kind} {s.start}-{s.end}{' ' + s.value if s.value else ''}>" for s in item.stretches)
        files = "".join(f" {word} {file}" for word, file in (("from", item.recording), ("timed", item.times)) if file)
        return f"say {item.text!r} in {voice(item.voice)}{marks}{files}"
    if isinstance(item, acts.Wait):
        return f"wait {amount(item.duration)}"
    if isinstance(item, acts.WaitUntil):
        return f"wait until {moment(item.moment)}"
    if isinstance(item, acts.SetBackground):
        return f"background {item.colour or item.picture or item.gradient} over {amount(item.over)}"
    if isinstance(item, acts.View):
        return f"view {item.face or 'all'} {amount(item.zoom)} over {amount(item.over)}"
    if isinstance(item, acts.SetLife):
        return f"{life(item.life)} over {amount(item.over)}"
    return f"drop {item.name}{timing(item.timing)}"


def aim(item: values.Aim) -> str:
    if isinstance(item, values.AtTarget):
        return f"target {item.name}" + (f".{item.member}" if item.member is not None else "")
    if isinstance(item, values.AtFace):
        return f"face {item.face}.{item.part}"
    if isinstance(item, values.Towards):
        return f"towards {amount(item.yaw)} {amount(item.pitch)} deg"
    if isinstance(item, values.AtPerson):
        return f"person {item.name}"
    return "camera" if isinstance(item, values.AtCamera) else "away"


def manner(item: acts.GazeManner) -> str:
    share = "" if item.head_share is None else f", head {amount(item.head_share)}"
    speed = "" if item.speed == 1.0 else f", speed {amount(item.speed)}"
    latency = "" if item.latency == 0.0 else f", latency {amount(item.latency)}"
    parts = "" if item.parts == "eyes then head" else f", {item.parts}"
    return parts + share + speed + latency


def timing(item: acts.Timing) -> str:
    parts = (("over", item.over), ("for", item.lasting), ("back in", item.back))
    text = "".join(f" {name} {amount(value)}" for name, value in parts if value is not None)
    return text + (f" ease {item.ease}" if item.ease else "")


def mix(item: values.Mix) -> str:
    return " + ".join(term(part) for part in item.terms) or "neutral"


def term(item: values.Term) -> str:
    drivers = " ".join(f"{driver.name}={amount(driver.value)}" for driver in item.drivers)
    return f"{amount(item.degree)} {item.name} [{drivers}]"


def moment(item: values.Moment) -> str:
    if item.mark is None:
        return amount(item.offset)
    word = "" if item.mark.word is None else f' "{item.mark.word}" {item.mark.nth}'
    return f"{item.mark.label}{word} {item.mark.edge} + {amount(item.offset)}"


def amount(item: values.Amount) -> str:
    if isinstance(item, values.Draw):
        return f"{item.low:.6g}..{item.high:.6g}"
    return f"{item:.6g}"
