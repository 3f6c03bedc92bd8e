"""The table of a score, and the same for programs."""

from __future__ import annotations

import json

from scheduling import scheduled

from facescript.schedule.explain import as_objects, as_text, explain


def test_estimated_times_are_marked() -> None:
    score = scheduled('nod\nsay "one two" as line\nat line.end: look left 10deg\n', estimated=True).solved
    assert score.estimated
    nod, line, first, second, look = as_text(explain(score)).splitlines()[1:]
    assert "~" not in nod
    assert "0.700   ~1.300  ~1.300" in line
    assert first.split() == ["~0.700", "~1.000", "one"]
    assert second.split() == ["~1.000", "~1.300", "two"]
    assert look.split().count("~1.300") == 2
    assert [item["estimated"] for item in as_objects(explain(score))] == [False, True, True, True, True]


def test_nothing_is_marked_where_a_voice_has_spoken() -> None:
    score = scheduled('say "one two"\nnod\n').solved
    assert "~" not in as_text(explain(score))
    assert not score.estimated


def test_objects_are_json_with_what_applies() -> None:
    score = scheduled(
        "film seed 1\n\nface ada = woman\nshow smile 40% + AU4 as grin\nlook left 20deg, eyes only\n"
    ).solved
    show, look = json.loads(json.dumps(as_objects(explain(score))))
    assert show == {
        "kind": "act",
        "file": "script.face",
        "line": 4,
        "scene": "main",
        "face": "ada",
        "what": "show smile 40% + AU4",
        "label": "grin",
        "start": 0.0,
        "settled": 0.5,
        "estimated": False,
    }
    assert look["eyes"] == look["start"] == 0.5
    assert look["landed"] == look["settled"] > 0.5
    assert "head" not in look
    assert "end" not in look


def test_every_verb_is_told_as_it_is_written() -> None:
    lines = (
        "look at ball over 0ms, head 40%",
        "look at crowd.2 for 2s, eyes only",
        "look up 10deg",
        "look away",
        "glance camera",
        "scan crowd, 300ms each, nearest first",
        "show neutral",
        "show crooked 80% - AU20 30%",
        "add head.roll 8deg + lid.left 30% for 1s",
        "add head.scale 10%",
        "show smile 40% for 2s, spontaneous",
        "add AU4, posed",
        "drop head.scale",
        "nod 30%",
        "tilt right",
        "wink left 50%",
        "background #102030",
        "view ada 180%",
        "life calm",
    )
    head = (
        "face ada = woman\ntarget ball at 0cm 0cm 1m\ntarget crowd of (0cm 0cm 1m) (10cm 0cm 1m)\n"
        "expression crooked = smile.left + AU7 20%\n\n"
    )
    told = [row.what for row in explain(scheduled(head + "".join(f"{line}\n" for line in lines)).solved)]
    assert told == list(lines)


def test_a_person_is_named() -> None:
    text = (
        "target ann at 0cm 0cm 1m\n\nscene one:\n    wait 2s\n\nwhen person arrives as guest:\n    look at guest\n\n"
        "event ann arrives at 1s\n"
    )
    assert [row.what for row in explain(scheduled(text).solved)] == ["look at guest (ann)"]
