"""Statements: verbs and their modifiers, who does them, labels, actions, repeats, tables, reactions."""

from __future__ import annotations

from pathlib import Path

import pytest
from plays import aim, codes, dos, play_of, resolved, shown, verb, verbs

from facescript.ir.acts import Add, Do, GazeManner, Glance, Look, Repeat, Say, Scan, Sequence, Show, Timing, in_pass
from facescript.ir.play import Reaction

TWO = "face ada = woman\nface bruno = man\n"
CROWD = "target crowd of (-60cm 0cm 2m) (0cm 5cm 2m) (50cm 10cm 2m)\n"


@pytest.mark.parametrize(
    ("written", "text"),
    [
        ("at camera", "camera"),
        ("at cup", "target cup"),
        ("at crowd.2", "target crowd.2"),
        ("at crowd.nearest", "target crowd.nearest"),
        ("at bruno", "face bruno.eyes"),
        ("at bruno.mouth", "face bruno.mouth"),
        ("left 20deg", "towards 20 0 deg"),
        ("right", "towards -20 0 deg"),
        ("up 10deg", "towards 0 10 deg"),
        ("left 10deg down 5deg", "towards 10 -5 deg"),
        ("right 10deg to 20deg", "towards -20..-10 0 deg"),
        ("away", "away"),
    ],
)
def test_aims(written: str, text: str) -> None:
    (look,) = verbs(f"{TWO}{CROWD}target cup at 0cm -12cm 20cm\nada: look {written}\n")
    assert isinstance(look, Look)
    assert aim(look.aim) == text


def test_the_manner_of_a_look() -> None:
    text = "look left 20deg over 100ms for 2s, eyes only, head 40%, speed 80%, latency 150ms\n"
    assert verbs(text) == [
        Look(
            verbs("look left 20deg\n")[0].aim,  # type: ignore[union-attr]
            GazeManner("eyes only", 0.4, 0.8, 0.15),
            Timing(0.1, 2.0),
        )
    ]
    glance, scan = verbs(f"{CROWD}glance camera, head then eyes\nscan crowd, 300ms each, nearest first\n")
    assert isinstance(glance, Glance)
    assert glance.manner.parts == "head then eyes"
    assert scan == Scan("crowd", 0.3, "nearest first")


def test_the_manner_of_an_expression() -> None:
    smile = verbs("show smile\n")[0].mix  # type: ignore[union-attr]
    assert verbs("show smile over 100ms, spontaneous\nadd smile, posed\nshow smile\n") == [
        Show(smile, Timing(0.1, manner="spontaneous")),
        Add(smile, Timing(manner="posed")),
        Show(smile),
    ]
    (line,) = verbs('say "A [smile, spontaneous for 1s]cup[/]."\n')
    assert isinstance(line, Say)
    (cue,) = line.cues[0].body.items
    assert isinstance(cue, Do)
    assert cue.verb == Add(smile, Timing(lasting=1.0, manner="spontaneous"))


@pytest.mark.parametrize(
    ("line", "code"),
    [
        ("look cup", "FS312"),
        ("look at cap", "FS202"),
        ("look at", "FS312"),
        ("look at crowd", "FS224"),
        ("look at crowd.4", "FS224"),
        ("look at cup.2", "FS224"),
        ("look at ada", "FS226"),
        ("look at bruno.ear", "FS235"),
        ("look at teller", "FS236"),
        ("look at greet", "FS214"),
        ("glance at cup", "FS312"),
        ("follow cup", "FS222"),
        ("glanc cup", "FS204"),
        ("scan cup", "FS214"),
        ("smile 40%", "FS221"),
        ("AU4 40%", "FS221"),
        ("look at cup, eyes olny", "FS308"),
        ("look at cup, 300ms each", "FS309"),
        ("look at cup, rate 80%", "FS309"),
        ("look at cup over 1s over 2s", "FS310"),
        ("look at cup, eyes only, head only", "FS310"),
        ("show smile ease soft", "FS329"),
        ("nod over 1s", "FS309"),
        ("tilt 40%", "FS312"),
        ("wink", "FS312"),
        ("drop smle", "FS238"),
        ("drop", "FS312"),
        ("show smile, slowly", "FS308"),
        ("show smile, posed, spontaneous", "FS310"),
        ("drop smile, posed", "FS309"),
        ("background blue", "FS314"),
        ('background "nowhere.png"', "FS701"),
        ("view bruna", "FS203"),
        ("life clam", "FS206"),
        ("life calm, blink 40%", "FS302"),
        ("wait", "FS312"),
        ("stop", "FS227"),
        ("greet", "FS217"),
        ("greet cup, warmht 40%", "FS308"),
        ('play "take.csv"', "FS701"),
        ("play smile", "FS312"),
    ],
)
def test_faults_of_lines(line: str, code: str) -> None:
    text = (
        f"{TWO}face teller = unseen\n{CROWD}target cup at 0cm -12cm 20cm\n"
        f"action greet(who, warmth = 40%):\n    look at who\n    nod warmth\n"
        f'ada: {line}\nada: greet cup\nbruno: scan crowd\nteller: say "Once."\n'
    )
    assert codes(text) == [code]


def test_a_block_of_a_misspelt_kind_is_no_face() -> None:
    (item,) = resolved("togeter:\n    nod\n    blink\n")[1]
    assert item.fixes[0].edits[0].text == "together"


def test_actions_bind_arguments_and_keep_their_own_clock_and_labels() -> None:
    text = (
        f"{TWO}action greet(who, warmth = 60%):\n    look at who as turned\n    at turned.end: nod warmth\n"
        "scene hall:\n    ada: greet bruno, warmth 80% as first\n    bruno: greet ada\n    at first.end: ada: blink\n"
    )
    body = play_of(text).scenes[0].body
    first, second, _ = body.items
    assert isinstance(first, Sequence)
    assert isinstance(second, Sequence)
    assert (first.clock, first.label) == (True, "hall.first")
    assert [(do.face, verb(do.verb).split(" of")[0], do.label) for do in dos(first) + dos(second)] == [
        ("ada", "look face bruno.eyes", "hall.greet.1.turned"),
        ("ada", "nod 0.8", None),
        ("bruno", "look face ada.eyes", "hall.greet.2.turned"),
        ("bruno", "nod 0.6", None),
    ]
    assert "at hall.greet.2.turned end" in shown(play_of(text))


def test_an_argument_is_read_as_what_its_place_asks_for() -> None:
    text = "action unit(what, long = 1s):\n    add what over long\n    drop what\nunit AU1.left, long 2s\n"
    assert [verb(item) for item in verbs(text)] == ["add 1 AU1.left [brow.inner.left=1] over 2", "drop AU1.left"]


def test_a_fault_in_an_argument_is_told_where_it_is_written() -> None:
    (item,) = resolved("action greet(who):\n    look at who\n    glance who\ngreet camra\n")[1]
    assert item.span is not None
    assert (item.code, item.span.source.position(item.span.start)) == ("FS202", (4, 7))


def test_actions_that_nobody_calls_are_read_too() -> None:
    assert codes("action idle(who):\n    look at who\n    show smle\nnod\n") == ["FS201", "FS211"]


def test_actions_in_a_circle() -> None:
    (item,) = resolved("action a:\n    b\naction b:\n    nod\n    a\na\n")[1]
    assert item.code == "FS215"
    assert "a -> b -> a" in item.message


def test_an_action_that_doubles_at_every_step_is_bounded() -> None:
    lines = ["action a0:\n    nod"]
    lines += [f"action a{n}:\n    a{n - 1}\n    a{n - 1}" for n in range(1, 40)]
    assert codes("\n".join(lines) + "\na39\n") == ["FS322"]


def test_who_does_it() -> None:
    text = (
        f"{TWO}ada:\n    nod\n    bruno: blink\n    wait 1s\n"
        'bruno: say "Yes."\n    on "yes": shake\n    on "yes": ada: nod\n'
    )
    play = play_of(text)
    assert [do.face for do in dos(play.scenes[0].body)] == ["ada", "bruno", None, "bruno"]
    say = dos(play.scenes[0].body)[-1].verb
    assert [do.face for cue in say.cues for do in dos(cue.body)] == ["bruno", "ada"]  # type: ignore[union-attr]


def test_a_line_without_a_face_where_there_are_several() -> None:
    text = (
        f"{TWO}action rest:\n    wait 1s\naction bow:\n    nod\n    blink\nrest\nbow\nwait 1s\nada: bow\nbruno: bow\n"
    )
    (item,) = resolved(text)[1]
    assert item.span is not None
    assert (item.code, item.span.source.position(item.span.start)[0]) == ("FS212", 9)


def test_one_face_of_a_scene_needs_no_name() -> None:
    text = f"{TWO}scene alone with ada:\n    nod\nscene both:\n    bruno: nod\n"
    assert [do.face for scene in play_of(text).scenes for do in dos(scene.body)] == ["ada", "bruno"]


def test_labels_of_scenes_and_passes() -> None:
    text = (
        f"{CROWD}scene one:\n    nod as bow\n    repeat 2 times:\n        nod as inner\n        at inner.end: blink\n"
        "        repeat 2 times:\n            at bow.end: nod as deep\n"
        "    repeat who in crowd:\n        look at who as seen\n"
        "scene two:\n    nod as bow\n"
    )
    play = play_of(text)
    labels = [do.label for scene in play.scenes for do in dos(scene.body) if do.label]
    assert labels[:3] == ["one.bow", "one.*.inner", "one.*.*.deep"]
    assert labels[3:] == ["one.repeat2.1.seen", "one.repeat2.2.seen", "one.repeat2.3.seen", "two.bow"]
    assert in_pass("one.*.*.deep", (3, 2)) == "one.3.2.deep"
    assert "at one.*.inner end" in shown(play)
    assert "at one.bow end" in shown(play)


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("nod as bow\nblink as bow\n", "FS208"),
        ("let bow = 1s\nnod as bow\nwait bow\n", "FS208"),
        ("nod as camera\n", "FS209"),
        ("nod as smile\n", "FS210"),
        ("repeat 2 times:\n    nod as inner\nat inner.end: blink\n", "FS205"),
        ("repeat 2.5 times:\n    nod\n", "FS331"),
        ("repeat 1000000000 times:\n    nod\n", "FS331"),
        ("repeat 3s:\n    nod\n", "FS302"),
        ("repeat often:\n    nod\n", "FS207"),
        ("repeat one in camera:\n    nod\n", "FS202"),
        (f"{CROWD}repeat crowd in crowd:\n    look at crowd.1\n", "FS208"),
        (f"{CROWD}scan crowd\nrepeat face in crowd:\n    look at face.1\n", "FS209"),
    ],
)
def test_faults_of_labels_and_repeats(text: str, code: str) -> None:
    assert code in codes(text)
    assert len(codes(text)) == 1


def test_counted_timed_and_endless_repeats_stay_one_node() -> None:
    text = (
        "film 20s long\nlet often = 2\nrepeat 2 * often times:\n    nod\n"
        "repeat for 5s:\n    nod\nrepeat forever:\n    nod\n"
    )
    nodes = play_of(text).scenes[0].body.items
    assert [(node.times, node.lasting) for node in nodes if isinstance(node, Repeat)] == [
        (4, None),
        (None, 5.0),
        (None, None),
    ]


def test_tables(tmp_path: Path) -> None:
    (tmp_path / "t.csv").write_text("cue,soa,how\nlefty,105ms,smile 40%\nrighty, 2 * beat ,AU4\n\n", "utf-8")
    text = (
        "let beat = 100ms\ntarget lefty at -25deg 0deg 60cm\ntarget righty at 25deg 0deg 60cm\nscene trials:\n"
        '    repeat trial in "t.csv":\n        look at trial.cue as cued\n        wait trial.soa\n'
        "        show trial.how\n"
    )
    found = dos(play_of(text, tmp_path).scenes[0].body)
    assert [(do.label, verb(do.verb).split(" [")[0]) for do in found] == [
        ("trials.1.cued", "look target lefty"),
        (None, "wait 0.105"),
        (None, "show 0.4 smile"),
        ("trials.2.cued", "look target righty"),
        (None, "wait 0.2"),
        (None, "show 1 AU4"),
    ]


@pytest.mark.parametrize(
    ("table", "code", "words"),
    [
        ("cue,soa\nlefty,soon\n", "FS323", "row 1, column `soa`"),
        ("cue,soa\nlefty,105ms\nlefty,105\n", "FS323", "row 2, column `soa`"),
        ("cue,soa\nmiddle,105ms\n", "FS323", "row 1, column `cue`"),
        ("cue,soa\nleft y,105ms\n", "FS323", "row 1, column `cue`"),
        ("cue,delay\nlefty,105ms\n", "FS704", "`cue`, `delay`"),
        ("cue,soa\nlefty\n", "FS703", "row 1 has 1 cells under 2 columns"),
        ("cue,cue\nlefty,105ms\n", "FS703", "each column once"),
        ("", "FS703", "empty"),
        ("cue,soa\n", "FS705", "no rows"),
    ],
)
def test_faults_of_tables(tmp_path: Path, table: str, code: str, words: str) -> None:
    (tmp_path / "t.csv").write_text(table, "utf-8")
    text = (
        "target lefty at -25deg 0deg 60cm\nlook at lefty\n"
        'repeat trial in "t.csv":\n    look at trial.cue\n    wait trial.soa\n'
    )
    (item,) = resolved(text, tmp_path)[1]
    assert item.code == code
    assert words in item.message
    assert item.span is not None
    assert item.span.source.name == "script.face"


def test_reactions_and_events() -> None:
    text = (
        "target ann at 0deg 0deg 2m\nnod\n"
        'when person arrives as guest:\n    look at guest\n    say "Hi." as hi\n    stop\n'
        'when heard "no":\n    shake\nevent ann arrives at 1s\nevent heard "no" at 2s\n'
    )
    play = play_of(text)
    first, second = play.reactions
    assert isinstance(first, Reaction)
    assert (first.event.kind, first.event.binds, first.ending, second.event.text, second.ending) == (
        "arrives",
        "guest",
        "stop",
        "no",
        "resume",
    )
    assert [do.label for do in dos(first.body)] == [None, "when.1.hi"]
    assert [(event.kind, event.person, event.text, event.time) for event in play.events] == [
        ("arrives", "ann", "", 1.0),
        ("heard", None, "no", 2.0),
    ]


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("nod\nwhen rings:\n    nod\n", "FS312"),
        ("nod\nwhen heard no:\n    nod\n", "FS312"),
        ("nod\nwhen person waits:\n    nod\n", "FS312"),
        ("nod\nevent ann arrives at 2s\n", "FS202"),
        ('nod\nevent heard "no"\n', "FS312"),
        ('nod\nwhen heard "no":\n    stop\n    nod\nevent heard "no" at 2s\n', "FS227"),
        ('nod\nwhen key "q":\n    nod\n', "FS808"),
        ("scan people, 600ms each\n", "FS806"),
        ("look at people.nearest\n", "FS806"),
    ],
)
def test_faults_of_reactions(text: str, code: str) -> None:
    assert codes(text) == [code]


def test_do_has_the_span_of_its_statement() -> None:
    text = "wait 1s\nshow smile 40% over 1s\n"
    found = dos(play_of(text).scenes[0].body)
    assert all(isinstance(do, Do) for do in found)
    assert [do.span.text for do in found] == ["wait 1s", "show smile 40% over 1s"]
