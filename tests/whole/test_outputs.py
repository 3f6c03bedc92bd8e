"""Every example builds; every kind of output is made twice, byte for byte the same."""

from __future__ import annotations

import csv
import io
import json
import wave
from pathlib import Path

import jsonschema
import numpy as np
import pytest

from facescript.cli.main import main
from facescript.performance.channels import NAMES

ROOT = Path(__file__).parents[2]
EXAMPLES = sorted(path.name for path in (ROOT / "examples").glob("*.face") if path.name != "studio.face")
KINDS = ("mp4", "webm", "gif", "svg", "csv", "jsonl", "png", "wav", "vtt", "srt", "json")


@pytest.fixture(autouse=True)
def in_examples(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT / "examples")


@pytest.mark.parametrize("example", EXAMPLES)
def test_example_builds(example: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    outputs = [word for kind in ("csv", "json") for word in ("-o", str(tmp_path / f"out.{kind}"))]
    assert main(["build", example, *outputs, "--quiet"]) == 0
    assert "warning" not in capsys.readouterr().err
    assert main(["build", example, "-o", str(tmp_path / "out.png"), "--at", "300ms", "--size", "320x240"]) == 0


@pytest.mark.parametrize("example", EXAMPLES)
def test_example_is_in_the_layout(example: str) -> None:
    assert main(["fmt", "--check", example]) == 0


def test_all_kinds_twice_the_same(tmp_path: Path) -> None:
    for run in ("one", "two"):
        (tmp_path / run).mkdir()
        outputs = [word for kind in KINDS for word in ("-o", str(tmp_path / run / f"evening.{kind}"))]
        size = ["--size", "320x180", "--to", "2s", "--fps", "15"]
        assert main(["build", "evening.face", *outputs, *size, "--quiet"]) == 0
    for kind in KINDS:
        first, second = ((tmp_path / run / f"evening.{kind}").read_bytes() for run in ("one", "two"))
        assert first, kind
        assert first == second, kind


def test_csv_has_time_and_every_channel(tmp_path: Path) -> None:
    assert main(["build", "gestures.face", "-o", str(tmp_path / "out.csv"), "--fps", "200"]) == 0
    rows = list(csv.DictReader((tmp_path / "out.csv").open(encoding="utf-8")))
    assert list(rows[0]) == ["time", *NAMES, "marker"]
    times = np.array([float(row["time"]) for row in rows])
    assert np.allclose(np.diff(times), 1 / 200, atol=2e-6)


def test_jsonl_says_the_same_as_csv(tmp_path: Path) -> None:
    outputs = ["-o", str(tmp_path / "out.csv"), "-o", str(tmp_path / "out.jsonl")]
    assert main(["build", "cueing.face", *outputs, "--fps", "20"]) == 0
    rows = list(csv.DictReader((tmp_path / "out.csv").open(encoding="utf-8")))
    objects = [json.loads(line) for line in (tmp_path / "out.jsonl").open(encoding="utf-8")]
    assert len(rows) == len(objects)
    for row, thing in zip(rows, objects, strict=True):
        assert row.pop("marker").split() == thing.pop("markers", [])
        assert {name: float(value) for name, value in row.items()} == pytest.approx(thing)
    assert any("cued" in row for row in (tmp_path / "out.jsonl").read_text().splitlines())


def test_standard_output(tmp_path: Path, capfdbinary: pytest.CaptureFixture[bytes]) -> None:
    assert main(["build", "hello.face", "-o", "-", "--as", "wav"]) == 0
    with wave.open(io.BytesIO(capfdbinary.readouterr().out)) as sound:
        assert sound.getnframes() > 4000


def test_numbered_pictures(tmp_path: Path) -> None:
    words = ["-o", str(tmp_path / "p-%03d.png"), "--fps", "5", "--size", "160x160", "--to", "1s"]
    assert main(["build", "degrees.face", *words]) == 0
    assert sorted(path.name for path in tmp_path.iterdir()) == [f"p-{number:03d}.png" for number in range(1, 6)]


def test_json_fits_its_schema(tmp_path: Path) -> None:
    assert main(["build", "kiosk.face", "-o", str(tmp_path / "out.json")]) == 0
    whole = json.loads((tmp_path / "out.json").read_text("utf-8"))
    schema, times = whole.pop("schema"), whole.pop("times")
    jsonschema.validate(whole, schema)
    assert {row["face"] for row in times} >= {"mia"}
    whole["play"]["film"]["width"] = "wide"
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate(whole, schema)
