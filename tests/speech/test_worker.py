"""The synthesiser in a program of its own: the same bytes every time, and no fault of it reaches the compiler raw."""

from __future__ import annotations

import json
import os
import struct
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from facescript.speech.espeak.client import WORKER, Espeak, Sound, Utterance
from facescript.speech.model import VoiceFailure

HELLO = Utterance("Pizzerias are convenient for a quick lunch.", "gmw/en-US+f3")


def program(folder: Path, *lines: str) -> Path:
    """A worker of a test's own."""
    path = folder / "worker.py"
    path.write_text("\n".join(lines), "utf-8")
    return path


def answer(head: bytes) -> str:
    return f"out.write({framed(head)!r}); out.flush()"


def framed(head: bytes, sound: bytes = b"") -> bytes:
    return struct.pack(">I", len(head)) + head + struct.pack(">I", len(sound)) + sound


def process(espeak: Espeak) -> subprocess.Popen[bytes]:
    """The worker that runs now."""
    running = espeak._worker._process
    assert running is not None
    return running


def counting(folder: Path, *lines: str) -> Path:
    """A worker that adds a line to the file `starts` each time that it starts; `number` counts them, from 1."""
    starts = folder / "starts"
    return program(
        folder,
        "import sys, os, json",
        f"open({str(starts)!r}, 'a').write('started\\n'); number = len(open({str(starts)!r}).readlines())",
        "out = sys.stdout.buffer; sys.stdin.buffer.read(4)",
        *lines,
    )


class TestRealWorker:
    pytestmark = pytest.mark.usefixtures("synthesiser")

    def test_same_text_gives_the_same_bytes(self) -> None:
        espeak = Espeak()
        assert len({espeak.speak(HELLO).pcm for _ in range(20)}) == 1
        espeak.close()

    def test_another_process_gives_the_same_bytes_and_events(self) -> None:
        one, two = Espeak(), Espeak()
        one.speak(Utterance("Something else first.", "gmw/de"))
        assert one.speak(HELLO) == two.speak(HELLO)

    def test_another_second_gives_the_same_bytes(self) -> None:
        first = Espeak().speak(HELLO)
        time.sleep(1.1)  # the library would seed itself with the time, in seconds
        assert Espeak().speak(HELLO) == first

    def test_a_library_loaded_again_gives_the_bytes_of_a_fork(self, tmp_path: Path) -> None:
        without_fork = program(
            tmp_path,
            "import os, runpy",
            "if hasattr(os, 'fork'): del os.fork",
            f"runpy.run_path({str(WORKER)!r}, run_name='__main__')",
        )
        assert Espeak(without_fork).speak(HELLO) == Espeak().speak(HELLO)

    def test_events_are_words_and_phones_in_order(self) -> None:
        events = Espeak().speak(Utterance("My cup.", "gmw/en-US")).events
        assert [(event.kind, event.place, event.symbol) for event in events if event.place < 6] == [
            ("word", 0, ""),
            ("phone", 0, "m"),
            ("phone", 0, "aɪ"),
            ("word", 3, ""),
            ("phone", 3, "k"),
            ("phone", 3, "ˈʌ"),
            ("phone", 3, "p"),
        ]
        assert [event.sample for event in events] == sorted(event.sample for event in events)

    def test_an_unknown_voice_is_a_failure_and_the_worker_goes_on(self) -> None:
        espeak = Espeak()
        espeak.speak(HELLO)
        worker = process(espeak)
        with pytest.raises(VoiceFailure, match="no voice xx/yy"):
            espeak.speak(Utterance("Hello.", "xx/yy"))
        assert espeak.speak(HELLO).pcm and process(espeak) is worker

    def test_a_killed_worker_is_started_again(self) -> None:
        espeak = Espeak()
        first = espeak.speak(HELLO)
        process(espeak).kill()
        process(espeak).wait()
        assert espeak.speak(HELLO) == first

    def test_a_worker_killed_in_mid_line_says_it_once(self) -> None:
        espeak = Espeak()
        long = Utterance("One, two, three, four, five, six, seven, eight, nine, ten. " * 40, "gmw/en-US")
        whole = espeak.speak(long)
        heard: list[bytes] = []

        def take(stretch: Sound) -> None:
            heard.append(stretch.pcm)
            if len(heard) == 5:
                process(espeak).kill()

        assert espeak.speak(long, take) == whole
        assert b"".join(heard) == whole.pcm

    def test_a_line_given_up_does_not_stand_in_the_way_of_the_next(self) -> None:
        espeak = Espeak()
        expected = espeak.speak(HELLO)

        def refuse(stretch: Sound) -> None:
            raise KeyboardInterrupt

        with pytest.raises(KeyboardInterrupt):
            espeak.speak(HELLO, refuse)
        assert espeak.speak(HELLO) == expected

    def test_threads_share_it(self) -> None:
        espeak = Espeak()
        texts = [Utterance(f"Number {number}.", "gmw/en-US") for number in range(8)]
        expected = [espeak.speak(text) for text in texts]
        with ThreadPoolExecutor(4) as threads:
            assert list(threads.map(espeak.speak, texts)) == expected

    def test_it_ends_with_its_standard_input(self) -> None:
        process = subprocess.Popen([sys.executable, "-P", str(WORKER)], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        assert process.stdin is not None
        process.stdin.close()
        assert process.wait(timeout=10) == 0
        assert process.stdout is not None
        process.stdout.close()

    @pytest.mark.skipif(not hasattr(os, "fork"), reason="this system has no fork")
    def test_a_fork_of_the_compiler_has_a_worker_of_its_own(self) -> None:
        espeak = Espeak()
        expected = espeak.speak(HELLO).pcm
        reading, writing = os.pipe()
        child = os.fork()
        if child == 0:
            os.write(writing, b"same" if espeak.speak(HELLO).pcm == expected else b"else")
            espeak.close()
            os._exit(0)
        assert os.read(reading, 4) == b"same"
        os.waitpid(child, 0)
        assert espeak.speak(HELLO).pcm == expected


def test_a_missing_library_is_told(tmp_path: Path) -> None:
    without = program(
        tmp_path,
        "import runpy, sys",
        "sys.modules['espeakng_loader'] = None",
        f"runpy.run_path({str(WORKER)!r}, run_name='__main__')",
    )
    with pytest.raises(VoiceFailure, match="cannot be loaded"):
        Espeak(without).speak(HELLO)


def test_a_crash_is_a_failure(tmp_path: Path) -> None:
    crashing = program(tmp_path, "import os, sys", "sys.stdin.buffer.read(4)", "os.abort()")
    with pytest.raises(VoiceFailure, match="broke off"):
        Espeak(crashing).speak(HELLO)


def test_a_hang_is_a_failure_and_not_a_hang(tmp_path: Path) -> None:
    hanging = program(tmp_path, "import time", "time.sleep(60)")
    begun = time.monotonic()
    with pytest.raises(VoiceFailure, match=r"did not answer within 0\.5 s"):
        Espeak(hanging, seconds=0.5).speak(HELLO)
    assert time.monotonic() - begun < 30


def test_a_worker_that_dies_in_every_line_is_started_twice_and_no_more(tmp_path: Path) -> None:
    dying = counting(tmp_path, "os.abort()")
    with pytest.raises(VoiceFailure, match="broke off"):
        Espeak(dying).speak(HELLO)
    assert (tmp_path / "starts").read_text().count("started") == 2


def test_what_was_heard_before_it_broke_off_is_not_heard_again(tmp_path: Path) -> None:
    parts = [framed(json.dumps({"rate": 22050, "events": [], "more": at < 2}).encode(), bytes([at])) for at in range(3)]
    dying = counting(tmp_path, f"out.write({parts[0] + parts[1][:-1]!r} if number == 1 else {b''.join(parts)!r})")
    heard: list[bytes] = []
    assert Espeak(dying).speak(HELLO, lambda stretch: heard.append(stretch.pcm)).pcm == b"\0\1\2"
    assert heard == [b"\0", b"\1", b"\2"]


@pytest.mark.parametrize(
    "said", [b"\xff\xff\xff\xff", b"\0\0\0\2{]\0\0\0\0", b"\0\0\0\x10half"], ids=["too long", "no JSON", "cut"]
)
def test_nonsense_is_a_failure(tmp_path: Path, said: bytes) -> None:
    babbling = program(tmp_path, "import sys", f"sys.stdout.buffer.write({said!r})", "sys.stdout.flush()")
    with pytest.raises(VoiceFailure, match="broke off"):
        Espeak(babbling).speak(HELLO)


def test_a_failure_it_tells_is_passed_on(tmp_path: Path) -> None:
    head = json.dumps({"failure": "it is hoarse"}).encode()
    hoarse = program(tmp_path, "import sys", "out = sys.stdout.buffer", answer(head), "sys.stdin.buffer.read()")
    with pytest.raises(VoiceFailure, match="it is hoarse"):
        Espeak(hoarse).speak(HELLO)


def test_a_text_has_bounds() -> None:
    with pytest.raises(VoiceFailure, match="200000 characters"):
        Espeak().speak(Utterance("a" * 200_001, "gmw/en-US"))
