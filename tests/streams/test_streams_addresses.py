"""Addresses that a run goes to: what is wrong with one is said, with one that would do."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest
from streaming import Told, frame, layout, opened

from facescript.diagnostics.catalogue import diagnose
from facescript.live.address import AddressFault, Form, parse
from facescript.live.sinks.registry import KINDS, Kind, open_sink

FORM = Form("osc://127.0.0.1:9000", path=True, options={"rate": (), "names": ("vrm0", "vrm1")})


def test_an_address_has_parts() -> None:
    found = parse("osc://studio-2.local:9000/avatar/ada?rate=29.97&names=vrm1", FORM)
    assert (found.host, found.port, found.path, found.rate) == ("studio-2.local", 9000, "avatar/ada", 29.97)
    assert found.options["names"] == "vrm1"
    assert parse("osc://[::1]:9", FORM).host == "::1"
    assert parse("vmc://localhost", Form("vmc://127.0.0.1:39539", 39539)).port == 39539


@pytest.mark.parametrize(
    ("address", "code", "reason"),
    [
        ("smoke://127.0.0.1", "FS980", ""),
        ("", "FS980", ""),
        ("osc" * 1000, "FS980", ""),
        ("osc", "FS981", "it is not of this form"),
        ("osc://", "FS981", "it names no host"),
        ("osc://127.0.0.1", "FS981", "it names no port"),
        ("osc://127.0.0.1:70000", "FS981", "there are ports up to 65535"),
        ("osc://127.0.0.1:9000?rate=0", "FS981", "`rate` is a number"),
        ("osc://127.0.0.1:9000?rate=1e9", "FS981", "`rate` is a number"),
        ("osc://127.0.0.1:9000?rate=5&rate=6", "FS981", "`rate` is there twice"),
        ("osc://127.0.0.1:9000?fps=30", "FS981", "`fps` is no option here; there is `rate`"),
        ("osc://user@127.0.0.1:9000", "FS981", "it is not of this form"),
        ("osc://127.0.0.1:9000 ", "FS981", "it is not of this form"),
        ("ws://127.0.0.1:8765/there", "FS981", "`/there` has no meaning here"),
        ("vmc://127.0.0.1?names=vrm2", "FS981", "`names` is `vrm0` or `vrm1`"),
        ("vts://127.0.0.1?face=", "FS981", "`face` has no value"),
        ("csv:", "FS981", "it has no name"),
        ("-:there", "FS981", "nothing may follow"),
    ],
)
def test_what_is_wrong_with_an_address_is_said(address: str, code: str, reason: str) -> None:
    with pytest.raises(AddressFault) as fault:
        open_sink(address)
    assert fault.value.code == code
    assert str(fault.value.values.get("reason", "")).startswith(reason)
    assert len(diagnose(code, None, **fault.value.values).message) < 900  # type: ignore[arg-type]


def test_the_examples_are_addresses() -> None:
    assert [kind.form.example for kind in KINDS if open_sink(kind.form.example, Told().setting()) is None] == []


def test_a_plug_in_brings_a_kind_of_address(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    told = tmp_path / "lamp-1.0.dist-info"
    told.mkdir()
    (told / "METADATA").write_text("Name: lamp\nVersion: 1.0\n")
    (told / "entry_points.txt").write_text(
        "[facescript.sinks]\nlamp = lamp:Lamp\nosc = lamp:Lamp\nbroken = lamp:nothing\n"
    )
    (tmp_path / "lamp.py").write_text("class Lamp:\n    def __init__(self, address):\n        self.address = address\n")
    monkeypatch.syspath_prepend(str(tmp_path))
    monkeypatch.delitem(sys.modules, "lamp", raising=False)
    assert vars(open_sink("lamp:kitchen")) == {"address": "lamp:kitchen"}
    assert type(open_sink("osc://127.0.0.1:9000")).__name__ == "OscSink"
    with pytest.raises(AddressFault, match="cannot be loaded") as fault:
        open_sink("broken:")
    assert fault.value.code == "FS982"


def test_what_is_not_installed_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "pylsl", None)
    with pytest.raises(AddressFault) as fault:
        open_sink("lsl://Ada")
    assert 'pip install "facescript[lsl]"' in diagnose(fault.value.code, None, **fault.value.values).message  # type: ignore[arg-type]


async def test_a_face_that_is_not_there_is_said() -> None:
    with pytest.raises(AddressFault) as fault:
        async with opened("vts://127.0.0.1:1?face=bob", layout("ada", "eve")):
            pass
    assert fault.value.values["reason"] == "the script has no face `bob`; there is `ada`, `eve`"


async def test_frames_come_at_the_rate_that_is_asked_for() -> None:
    of = layout()
    async with opened("osc://127.0.0.1:1?rate=24", of) as sink:
        for number in range(60):
            sink.frame(frame(number, of))
        packets = sum(sink.counts().values())
    async with opened("osc://127.0.0.1:1", of) as sink:
        sink.frame(frame(0, of))
        each = sum(sink.counts().values())
    assert packets == 24 * each


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.scheme)
async def test_a_sink_that_was_never_opened_can_be_closed(kind: Kind) -> None:
    await open_sink(kind.form.example, Told().setting()).close()
