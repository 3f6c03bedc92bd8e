"""Grounds to pixels: colours, gradients, picture files, and what is said of files that cannot be used."""

from __future__ import annotations

import io

import numpy as np
import pytest
from PIL import Image

from facescript.pictures import MOST_PIXELS, PictureFailure
from facescript.rig.picture import Linear, Stop
from facescript.stage.backcloth import WHITE, Backcloth
from facescript.stage.ground import Backdrop, Clear, Photo
from facescript.stage.photo import photo
from facescript.world import WorldFailure

WIDTH, HEIGHT = 64, 36


def cloth(**files: bytes) -> Backcloth:
    def read(path: str) -> bytes:
        if path not in files:
            raise WorldFailure("there is no such file")
        return files[path]

    return Backcloth(WIDTH, HEIGHT, read)


def picture(size: tuple[int, int], colour: object, mode: str = "RGB", kind: str = "PNG") -> bytes:
    file = io.BytesIO()
    Image.new(mode, size, colour).save(file, kind)  # type: ignore[arg-type]
    return file.getvalue()


def test_a_colour_fills_the_film() -> None:
    assert (cloth().paint((("#dfe8f2", 1.0),)) == 0xFFDFE8F2).all()


def test_layers_mix_by_their_shares() -> None:
    pixels = cloth().paint((("#000000", 1.0), ("#ff8000", 0.5)))
    assert hex(int(pixels[5, 5])) in ("0xff7f4000", "0xff804000")
    assert (cloth().paint((("#123456", 1.0), ("#fedcba", 1.0))) == 0xFFFEDCBA).all()


def test_a_gradient_spans_the_film() -> None:
    pixels = cloth().paint(((Backdrop(Linear((Stop(0, "#000000"), Stop(1, "#ffffff")))), 1.0),))
    blue = pixels[:, 10] & 0xFF
    assert blue[0] < 12
    assert blue[-1] > 243
    assert (np.diff(blue.astype(int)) > 0).all()


def test_nothing_is_clear_or_what_lies_under_it() -> None:
    assert (cloth().paint(((Clear(), 1.0),)) == 0).all()
    white = Backcloth(WIDTH, HEIGHT, lambda path: b"", WHITE)
    assert (white.paint(((Clear(), 1.0),)) == 0xFFFFFFFF).all()


def test_a_way_to_nothing_and_back_is_premultiplied() -> None:
    for ground in (((Clear(), 1.0), ("#ff8000", 0.5)), (("#ff8000", 1.0), (Clear(), 0.5))):
        pixel = int(cloth().paint(ground)[5, 5])
        assert [pixel >> shift & 0xFF for shift in (24, 16, 8, 0)] == pytest.approx([127, 127, 64, 0], abs=1)


def test_the_same_ground_is_painted_once() -> None:
    one = cloth(a=picture((8, 8), "red"))
    ground = (("#000000", 1.0), (Photo("a"), 0.5))
    assert one.paint(ground) is one.paint(tuple(ground))


@pytest.mark.parametrize("kind", ["PNG", "JPEG", "WEBP", "GIF", "BMP"])
def test_pictures_of_every_kind_fill_the_film(kind: str) -> None:
    pixels = cloth(a=picture((100, 100), (0, 0, 255), kind=kind)).paint(((Photo("a"), 1.0),))
    red, green, blue = (pixels >> shift & 0xFF for shift in (16, 8, 0))
    assert max(red.max(), green.max()) < 8
    assert blue.min() > 247


def test_a_picture_is_cut_evenly_not_squeezed() -> None:
    wide = Image.new("RGB", (300, 36), "red")
    wide.paste("white", (118, 0, 182, 36))
    file = io.BytesIO()
    wide.save(file, "PNG")
    assert (photo(file.getvalue(), WIDTH, HEIGHT)[:, 2:-2] == 0xFFFFFFFF).all()


def test_clear_parts_of_a_picture_are_white() -> None:
    assert (photo(picture((8, 8), (0, 0, 0, 0), "RGBA"), WIDTH, HEIGHT) == 0xFFFFFFFF).all()


@pytest.mark.parametrize(
    ("data", "reason"),
    [
        (b"", "none of"),
        (b"not a picture", "none of"),
        (picture((40, 40), "red")[:60], "broken"),
        (picture((MOST_PIXELS // 1000 + 1, 1000), 0, "1"), "million pixels"),
    ],
    ids=["empty", "text", "cut", "huge"],
)
def test_a_bad_picture_is_named_with_its_reason(data: bytes, reason: str) -> None:
    with pytest.raises(PictureFailure, match=f"`a` cannot be used: .*{reason}"):
        cloth(a=data).paint(((Photo("a"), 1.0),))


def test_a_missing_picture_is_named() -> None:
    with pytest.raises(PictureFailure, match=r"`sky\.png` cannot be used: there is no such file"):
        cloth().paint(((Photo("sky.png"), 1.0),))
