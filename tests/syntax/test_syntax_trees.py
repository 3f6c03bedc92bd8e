"""Scripts to trees: the scripts of the language's design, and each form of the language by itself."""

from __future__ import annotations

from pathlib import Path

import pytest
from outlines import HERE, SCRIPTS, bare, clean, golden, outline

from facescript.diagnostics.model import Diagnostics
from facescript.syntax import tree
from facescript.syntax.parser import parse, parse_phrases
from facescript.text import Source, Span


@pytest.mark.parametrize("path", SCRIPTS, ids=lambda path: path.stem)
def test_scripts_give_their_trees(path: Path) -> None:
    golden(HERE / "trees" / f"{path.stem}.txt", outline(clean(path.read_text("utf-8"))))


def test_the_page_of_the_language_gives_its_tree() -> None:
    golden(HERE / "trees" / "evening.txt", outline(clean((HERE / "evening.face").read_text("utf-8"))))


@pytest.mark.parametrize(
    ("line", "rows"),
    [
        ('say "Hello."', 'Act say "Hello."'),
        ("life still", "Act life still"),
        ("life mine = calm, blink 8/min", "Declaration life mine calm | blink <8 /min>"),
        ("background #dfe8f280 over 2s", "Act background #dfe8f280 over <2 s>"),
        ("view all", "Act view all"),
        ("film 1280x720, 30fps, seed 7, 24s long", "Setting film <1280 by 720> | <30 fps> | seed <7> | <24 s> long"),
        ("event person arrives at 3s", "Setting event person arrives at <3 s>"),
        ('use "studio.face"', 'Use "studio.face"'),
        ("target chart at -25% 5%", "Declaration target chart at <-25 %> <5 %>"),
        ("target crowd of (-60cm 0cm 2m) (0cm 5cm)",
         "Declaration target crowd of [<-60 cm> <0 cm> <2 m>] [<0 cm> <5 cm>]"),
        ("let x = 2 * beat - (3s / 2)", "LetDefinition x <2> * beat - (<3 s> / <2>)"),
        ("let share = 1.5", "LetDefinition share <1.5 >"),
        ("expression e(lift = 40%, side) = smile.left -5% + a-b",
         "ExpressionDefinition e lift = <40 %> | side smile/left <-5 %> + a-b"),
        ("show wry(lift = 60%, 2) 80%", "Act show wry(lift = <60 %> | <2>) <80 %>"),
        ("scan crowd.2, 600ms each", "Act scan crowd/2 | <600 ms> each"),
        ('wait until hello."cup".2.end', 'Act wait until hello/"cup"/2/end'),
        ("at hello.end+300ms: nod", "Moment hello/end + <300 ms>\n  Act nod"),
        ("repeat 3 times: rex: nod", "Repeat <3> times\n  Cast rex\n    Act nod"),
        ('repeat trial in "trials.csv": nod', 'Repeat trial in "trials.csv"\n  Act nod'),
        ("in  turn : nod", "Group in turn\n  Act nod"),
        ('when heard "no": stop', 'When heard "no"\n  Act stop'),
        ("scene night with rex, kong: nod", "Scene night rex | kong\n  Act nod"),
        ("action think(): nod", "ActionDefinition think\n  Act nod"),
        ("阿梅: look at 山", "Cast 阿梅\n  Act look at 山"),
        ("नमस्ते: nod", "Cast नमस्ते\n  Act nod"),
        ('say "a \\"b\\" \\[c]"', 'Act say "a \\"b\\" \\[c]"'),
        ("look at camera over 0ms, eyes only as cued", "Act look at camera over <0 ms> | eyes only as cued"),
        ("show happy, # why\n    at 2s", "Act show happy | at <2 s>"),
        ("face ada = woman\n    at 10% 20%\n    life calm",
         "Declaration face ada woman\n  at <10 %> <20 %>\n  life calm"),
        ("target t moves\n    0s -1cm 2cm\n    1s 3cm 4cm",
         "Declaration target t moves\n  <0 s> <-1 cm> <2 cm>\n  <1 s> <3 cm> <4 cm>"),
        ('say "a"\n    "b"\n    on "b".2: nod', 'Act say "a"\n  "b"\n  On "b" 2\n    Act nod'),
        ("ada:\n  nod\n  bruno: nod\nnod", "Cast ada\n  Act nod\n  Cast bruno\n    Act nod\nAct nod"),
    ],
)  # fmt: skip
def test_a_line_gives_its_tree(line: str, rows: str) -> None:
    assert outline(clean(line)) == f"{rows}\n"


def test_what_goes_on_after_comma_plus_and_equals_is_one_line() -> None:
    joined = clean("expression e = smile 10% + AU6 20%\nlook at cup, eyes only\n")
    broken = clean("expression e =\n  smile 10% +\n # why\nAU6 20%\nlook at cup,   # where\n    eyes only\n")
    assert bare(broken) == bare(joined)


def test_line_ends_of_other_systems_are_line_ends() -> None:
    text = 'scene a:\n    say "x"\n        "y"\n'
    assert bare(clean(text.replace("\n", "\r\n"))) == bare(clean(text))


def test_two_ways_to_type_a_name_make_one_name() -> None:
    first, second = clean("zoe\u0308: nod\nzo\u00eb: nod\n").items
    assert isinstance(first, tree.Cast)
    assert isinstance(second, tree.Cast)
    assert first.face.text == second.face.text == "zo\u00eb"


def test_spans_are_the_words_of_the_source() -> None:
    text = '# a comment\n\nscene a:\n    ada: say "x" as y\n'
    (scene,) = clean(text).items
    assert isinstance(scene, tree.Scene)
    assert scene.span.text == 'scene a:\n    ada: say "x" as y'
    (cast,) = scene.body
    assert isinstance(cast, tree.Cast)
    assert cast.span.source.position(cast.span.start) == (4, 5)
    (act,) = cast.body
    assert isinstance(act, tree.Act)
    assert [word.span.text for word in act.phrases[0].words] == ["say", '"x"', "as", "y"]


def test_a_cue_is_phrases_with_their_places_in_the_text() -> None:
    source = Source("script.face", 'say "Hello [look at cup, eyes only]you."')
    diagnostics = Diagnostics()
    phrases = parse_phrases(Span(source, 12, 34), diagnostics)
    assert phrases is not None
    assert [phrase.span.text for phrase in phrases] == ["look at cup", "eyes only"]
    assert list(diagnostics) == []


@pytest.mark.parametrize(
    ("cue", "code"), [("smile 40", ""), ("smile +", "FS125"), ("smile 2 s", "FS113"), ("a: b", "FS121"), ("", "FS125")]
)
def test_a_cue_that_cannot_be_read_is_told_where_it_stands(cue: str, code: str) -> None:
    source = Source("script.face", f'say "x [{cue}]"')
    diagnostics = Diagnostics()
    parse_phrases(Span(source, 8, 8 + len(cue)), diagnostics)
    assert [item.code for item in diagnostics] == ([code] if code else [])
    assert all(item.span is not None and 8 <= item.span.start <= item.span.end <= 8 + len(cue) for item in diagnostics)


def test_lines_left_out_tell_their_names() -> None:
    source = Source("script.face", 'scene a!:\n    ada: say "x" as hello\nscene b:\n    nod\n')
    script = parse(source, Diagnostics())
    assert script.lost >= {"ada", "hello"}
    assert [type(item).__name__ for item in script.items] == ["Scene"]
