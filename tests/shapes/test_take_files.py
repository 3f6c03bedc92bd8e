"""Files of recorded faces: what is read of them, with the ways in which programs write them, and what is refused."""

from __future__ import annotations

import base64

import numpy as np
import pytest

from facescript.ir.acts import Take
from facescript.shapes.rows import rows
from facescript.shapes.takes import model
from facescript.shapes.takes.files import read_take
from facescript.shapes.takes.model import Found, NotATake
from facescript.shapes.takes.played import played

SHAPES = "JawOpen,MouthSmileLeft"
HEAD = f"Timecode,BlendshapeCount,{SHAPES}\n"


def found(text: str | bytes, face: str = "ada") -> Found:
    return read_take("take", text if isinstance(text, bytes) else text.encode(), face)


def table(take: Take) -> np.ndarray:  # type: ignore[type-arg]
    """Times and columns of a take: array[frame, 1 + column]."""
    return np.frombuffer(base64.b64decode(take.data), "<f4").reshape(take.frames, -1)


def fap(on: dict[int, int], frames: int = 1, mask: int = 68, head: str = "2.1 joy.fap 10 1", tail: str = "") -> str:
    flags = " ".join("1" if at in on else "0" for at in range(1, mask + 1))
    values = " ".join(str(on[at]) for at in sorted(on))
    return head + "\n" + "".join(f"{flags}{tail}\n{number} {values}{tail}\n" for number in range(frames))


# ------------------------------------------------------------------------------------------------ Live Link Face


def test_time_codes_count_frames_and_their_parts() -> None:
    """As the app writes them at 59.94 a second: frames of a sixtieth, with thousandths; it begins whenever it is."""
    take = found(HEAD + "14:58:02:58.665,61,0.1,0\n14:58:02:59.666,61,0.2,0\n14:58:03:00.668,61,0.3,0\n").take
    assert table(take)[:, 0] == pytest.approx([0.0, 1.001 / 60, 2.003 / 60], abs=1e-6)
    assert take.duration == pytest.approx(3.0045 / 60, abs=1e-5)
    assert take.columns == ("JawOpen", "MouthSmileLeft") and take.kind == "arkit"


def test_the_rate_shows_where_frames_count_anew() -> None:
    lines = [f"00:00:0{at // 30}:{at % 30:02},2,0.{at % 9},0\n" for at in range(45)]
    assert found(HEAD + "".join(lines)).take.duration == pytest.approx(1.5)


def test_a_take_goes_on_past_midnight() -> None:
    take = found(HEAD + "23:59:59:30,2,0.1,0\n00:00:00:00,2,0.2,0\n00:00:00:30,2,0.3,0\n").take
    assert table(take)[:, 0] == pytest.approx([0.0, 0.5, 1.0])


def test_columns_in_any_order_case_and_spelling() -> None:
    header = "\ufefftimecode,BlendShapeCount,mouthSmile_L,whatever,jawopen\r\n"
    text = header + "0:0:0:0,3,0.5,x,0.25\r\n0:0:0:1,3,0.5,x,0.5\r\n"
    take = found(text).take
    assert take.columns == ("MouthSmileLeft", "JawOpen")
    assert table(take)[:, 1:].tolist() == [[0.5, 0.25], [0.5, 0.5]]


def test_rows_without_a_face_are_joined_over_and_counted() -> None:
    """The app writes a count of 0 and nothing, or empty cells, where it lost the face."""
    text = HEAD + "0:0:0:0,2,0.2,0\n0:0:0:1,0\n0:0:0:2,0,,\n0:0:0:3,2,0.8,0\n"
    assert found(text).lost == 2
    assert table(found(text).take)[:, 0] == pytest.approx([0.0, 0.05])


def test_a_row_with_the_time_of_the_one_before_is_passed_over() -> None:
    take = found(HEAD + "0:0:0:0,2,0.2,0\n0:0:0:0,2,0.3,0\n0:0:0:1,2,0.4,0\n").take
    assert table(take)[:, 1] == pytest.approx([0.2, 0.4])


def test_a_head_that_is_never_turned_is_not_told_of_and_looks_turn_the_eyes() -> None:
    """Programs that know no rotations write zeros; then the look shapes say where the eyes point."""
    header = (
        "Timecode,BlendshapeCount,EyeLookOutLeft,EyeLookInRight,HeadYaw,HeadPitch,HeadRoll,LeftEyeYaw,RightEyeYaw\n"
    )
    shown = played(found(header + "0:0:0:0,7,0,0,0,0,0,0,0\n0:0:0:1,7,0.5,0.5,0,0,0,0,0\n").take)
    assert "head.yaw" not in shown.channels and {"eye.left.yaw", "eye.right.yaw"} <= set(shown.channels)
    turned = played(found(header + "0:0:0:0,7,0,0,0,0,0,0,0\n0:0:0:1,7,0.5,0.5,0.2,0,0,-0.3,-0.3\n").take)
    assert "head.yaw" in turned.channels


# ------------------------------------------------------------------------------------------------ FAP


@pytest.mark.parametrize(
    "text",
    [
        fap({31: 100, 32: 100}, head="2.1 joy.fap 10 1"),
        fap({31: 100, 32: 100}, mask=69, head="2.1 AU Interpolation_2.fap 10 1"),
        fap({31: 100, 32: 100}, tail=" ", head="2.1 joy.fap 10 1 ").replace("\n", "\r\n"),
    ],
    ids=["plain", "69 flags, blanks in the name", "blanks and returns at the ends"],
)
def test_fap_files_as_programs_write_them(text: str) -> None:
    take = found(text).take
    assert take.columns == ("raise_l_i_eyebrow", "raise_r_i_eyebrow")
    assert (take.frames, take.duration) == (1, 0.1)


def test_a_parameter_that_a_mask_leaves_out_stays() -> None:
    first, second = fap({3: 500, 48: 9}).splitlines()[1:], fap({3: 100}).splitlines()[1:]
    text = "\n".join(["2.1 x.fap 25 2", *first, second[0], second[1].replace("0 ", "1 ", 1)])
    assert table(found(text).take)[:, 1:].tolist() == [[500.0, 9.0], [100.0, 9.0]]


def test_parameters_of_the_lips_tell_of_no_lid() -> None:
    lips = dict.fromkeys(range(51, 61), 10)
    shown = played(found(fap(lips, 1)).take)
    assert {"mouth.open", "cheek.lower.left", "lip.corner.right"} <= set(shown.channels)
    assert not any(name.startswith(("lid", "head", "eye", "brow")) for name in shown.channels)


# ------------------------------------------------------------------------------------------------ channels


def test_a_table_of_several_faces_has_columns_of_each() -> None:
    text = "time,ada.head.yaw,bruno.head.yaw,ada.gaze.yaw,marker\n1,2,3,4,\n1.5,5,6,7,\n"
    take = found(text, "bruno").take
    assert take.columns == ("head.yaw",) and table(take).tolist() == [[0.0, 3.0], [0.5, 6.0]]
    assert take.duration == 1.0


# ------------------------------------------------------------------------------------------------ what is refused


@pytest.mark.parametrize(
    ("text", "line", "reason"),
    [
        ("", 0, "it is empty"),
        (b"\xff\xfe\x00", 0, "it is not UTF-8 text"),
        ("frame,smile\n0,1\n", 1, "it is no recorded face"),
        ("Timecode,BlendshapeCount,Frown\n0:0:0:0,1,1\n", 1, "no column of it is a shape of ARKit"),
        ("Timecode,JawOpen,jawopen\n", 1, "it has the column `JawOpen` twice"),
        (HEAD, 0, "it has no rows of a face"),
        (HEAD + "0:0:0:0,2,0.1\n", 2, "there are 3 cells under 4 columns"),
        (HEAD + "0:0:0:0,2,nan,0\n", 2, "`nan` in the column `JawOpen` is no finite number"),
        (HEAD + "0:0:0:0,2,0,1_0\n", 2, "`1_0` in the column `MouthSmileLeft` is no number"),
        (HEAD + "0:0:0:0,2,0,1e9\n", 2, "`1e9` in the column `MouthSmileLeft` is beyond 10"),
        (HEAD + "half past one,2,0,0\n", 2, "`half past one` is no time code such as `00:01:23:45.678`"),
        (HEAD + "0:0:9:0,2,0,0\n0:0:1:0,2,0,0\n", 3, "its time code comes before the one above it"),
        (HEAD + "0:0:0:0,2,0,0\n", 0, "it is a single moment"),
        (HEAD + "0:0:0:0,2,0,0\n2:0:0:0,2,0,0\n", 0, "it lasts longer than 60 minutes"),
        ("time,smile\n0,1\n", 1, "no column of it is a channel, alone or with `ada.` in front"),
        ("time,lid.left\n0,1\n0,1\n", 3, "its time does not come after the one above it"),
        ("time,lid.left\n0,inf\n", 2, "`inf` in the column `lid.left` is no finite number"),
        ('time,"lid.left\n0,1', 0, "unexpected end of data"),
        ("1 " + 100_000 * " ", 1, "it is no recorded face"),
        ("2.1 x.fap 0 1\n", 1, "0 frames a second are not within 1 and 1000"),
        ("2.1 x.fap 25 99999999\n", 1, "it says that it has 99999999 frames; 1 to 36000 can be played"),
        ("2.1 x.fap 25 2\n" + fap({3: 1}).partition("\n")[2], 0, "it ends after 1 of its 2 frames"),
        (fap({3: 1}, 2), 4, "there is more behind its 1 frames"),
        (fap({3: 1}, mask=67), 2, "a mask is 68 times 0 or 1"),
        (fap({3: 1}).replace("\n0 1", "\n0 1 2"), 3, "behind its number a frame has 1 values"),
        (fap({3: 1}).replace("\n0 1", "\n0 1.5"), 3, "`1.5` is no whole number"),
        (fap({3: 9_999_999}), 3, "`9999999` is beyond 1000000"),
        (fap({}), 0, "no mask of it has a parameter"),
    ],
)
def test_what_cannot_be_played_says_where_and_why(text: str | bytes, line: int, reason: str) -> None:
    with pytest.raises(NotATake) as fault:
        found(text)
    assert fault.value.args[0].startswith(reason) and fault.value.line == line


def test_a_take_that_is_too_long_is_given_up_at_its_row(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(model, "MOST_FRAMES", 3)
    with pytest.raises(NotATake, match="more than 3 rows"):
        found(HEAD + "".join(f"0:0:0:{at},2,0,0\n" for at in range(5)))


def test_every_shape_that_a_build_writes_is_read() -> None:
    names = [row["name"] for row in rows("arkit")]
    text = f"Timecode,BlendshapeCount,{','.join(names)}\n" + "".join(f"0:0:0:{at},61{',0.5' * 61}\n" for at in (0, 1))
    assert found(text).take.columns == tuple(names)
