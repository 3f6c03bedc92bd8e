"""The options `--channel`, `--at` and `--face` of `explain` to accounts of channels at moments."""

from __future__ import annotations

import argparse
import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from facescript.cli.report import OptionFault
from facescript.cli.settings import seconds
from facescript.ir.play import Face
from facescript.performance.channels import channels_of
from facescript.resolve.kinds.library import kinds_with
from facescript.resolve.suggest import nearest
from facescript.schedule.score import Score


@dataclass(frozen=True, slots=True)
class Asked:
    """Channels and times as they were written, and the face that was named for all of them."""

    channels: Sequence[str]
    moments: Sequence[tuple[str, float]]
    face: str | None


def asked(options: argparse.Namespace) -> Asked | None:
    """What `--channel`, `--at` and `--face` ask for; None where they are not there. Raises `OptionFault`."""
    for option, needed in (("channel", "at"), ("at", "channel"), ("face", "channel")):
        if getattr(options, option) and not getattr(options, needed):
            raise OptionFault("FS912", option=f"--{option}", needed=f"--{needed}")
    if not options.channel:
        return None
    moments = [(text, seconds("--at", text) or 0.0) for text in options.at]
    return Asked(options.channel, moments, options.face)


def told(score: Score, wanted: Asked, as_json: bool) -> str:
    """An account for each channel and each moment. Raises `OptionFault`."""
    from facescript.owners.account import Accounts
    from facescript.owners.telling import as_objects, as_text

    for text, time in wanted.moments:
        if time > score.duration:
            raise OptionFault("FS906", asked=f"`--at {text}`", duration=score.duration)
    seen = {face.name: face for face in score.faces if face.seen}
    places = [_place(seen, name, wanted.face) for name in wanted.channels]
    faces = {name: Accounts(score, seen[name]) for name in dict.fromkeys(name for name, _ in places)}
    accounts = [faces[face].at(name, time) for face, name in places for _, time in wanted.moments]
    return json.dumps(as_objects(accounts), ensure_ascii=False, indent=2) if as_json else as_text(accounts)


def _place(seen: Mapping[str, Face], text: str, said: str | None) -> tuple[str, str]:
    """The face and the channel that `ada.lid.left` means; `lid.left` is that of the face `said`, or of the only one."""
    first, _, rest = text.partition(".")
    face, channel = (first, rest) if first in seen else (said, text)
    if face is None and len(seen) == 1:
        face = next(iter(seen))
    if face is None or face not in seen:
        fault = f"`{text}` needs a face's name in front" if face is None else f"there is no face `{face}` to be seen"
        raise OptionFault("FS913", fault=fault, known=", ".join(f"`{name}`" for name in seen) or "nobody")
    known = channels_of(seen[face].parts)
    if channel not in known:
        raise OptionFault("FS914", name=channel, meant=_meant(channel, known))
    return face, channel


def _meant(channel: str, known: Sequence[str]) -> str:
    """What to ask for instead of a channel that a face does not have."""
    kinds, candidate = kinds_with(channel), nearest(channel, known)
    if kinds:
        return f"only these kinds of face have it: {', '.join(f'`{kind}`' for kind in kinds)}."
    return f"did you mean `{candidate}`?" if candidate else "`facescript list channels` has them."
