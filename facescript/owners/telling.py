"""Accounts to lines for an author, and to objects for JSON."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from facescript.owners.model import Account, Part, Source, Step

WIDTH = 12
"""Columns of a number."""

UNSEEN = 1e-9
"""A rule that changes less than this is not told of."""

UNITS = {"deg": " deg", "cm": " cm", "1": ""}


def as_text(accounts: Sequence[Account]) -> str:
    """A block an account: the channel and its value, the owner, and each step of the law that changed something."""
    return "\n\n".join("\n".join(_block(account)) for account in accounts)


def as_objects(accounts: Sequence[Account]) -> list[dict[str, object]]:
    """The accounts for JSON: every step, numbers as they are."""
    return [
        {
            "face": account.face,
            "channel": account.channel.name,
            "unit": account.channel.unit,
            "time": account.time,
            "value": account.value,
            "owner": _source(account.owner) if account.owner else None,
            "steps": [_step(step) for step in account.steps],
        }
        for account in accounts
    ]


def _step(step: Step) -> dict[str, object]:
    return {"rule": step.rule, "value": step.value, "parts": [_part(part) for part in step.parts]}


def _part(part: Part) -> dict[str, object]:
    told = {"full": part.full, "share": part.share, "value": part.value}
    return {**_source(part.source), **told, **({"state": part.state} if part.state else {})}


def _source(source: Source) -> dict[str, object]:
    named = {"what": source.what, "file": source.file, "line": source.line, "label": source.label}
    return {name: value for name, value in named.items() if value is not None}


# ------------------------------------------------------------------------------------------------ text


def _block(account: Account) -> Iterator[str]:
    """Each number stands before what it is: of a rule the value that it leaves, of a part what it gives."""
    value = f"{round(account.value, 4) + 0.0:g}{UNITS[account.channel.unit]}"
    yield f"{account.face}.{account.channel.name} at {account.time:g} s: {value}"
    if account.at_rest:
        yield "  at rest: nothing moves it"
        return
    yield f"  owner: {_named(account.owner) if account.owner else 'nobody'}"
    before = account.channel.rest
    for step in account.steps:
        if step.parts or abs(step.value - before) > UNSEEN or step is account.steps[-1]:
            yield f"{_number(step.value)}  {step.rule}"
            yield from (f"{_number(part.value)}    {_told(part)}" for part in step.parts)
        before = step.value


def _told(part: Part) -> str:
    """A part's source, and where it stands."""
    scaled = "" if part.share == 1.0 else f"{part.share:.1%} of {part.full:.4g}"
    return ", ".join(text for text in (_named(part.source), part.state, scaled) if text)


def _named(source: Source) -> str:
    label = f" as {source.label}" if source.label else ""
    return source.what + label + (f" ({source.file}:{source.line})" if source.file else "")


def _number(value: float) -> str:
    return f"{round(value, 4) + 0.0:{WIDTH}.4f}"
