"""Datagrams: whatever bytes come, they are messages or are none."""

from __future__ import annotations

import struct

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from facescript.live.messages import Nonsense
from facescript.live.sources.osc_packet import BUNDLE, Message, messages

HEARD = b"/facescript/heard\0\0\0,s\0\0no\0\0"


def bundle(*parts: bytes, tag: tuple[int, int] = (0, 1)) -> bytes:
    return BUNDLE + struct.pack(">II", *tag) + b"".join(struct.pack(">i", len(part)) + part for part in parts)


def test_messages_and_bundles_are_read() -> None:
    assert messages(HEARD) == [Message("/facescript/heard", ("no",))]
    assert messages(b"/a\0\0,ifdh\0\0\0" + struct.pack(">ifdq", 1, 0.5, 2.0, 3)) == [Message("/a", (1, 0.5, 2.0, 3))]
    inner = bundle(HEARD, tag=(2_208_988_800 + 5, 2**31))
    assert [message.time for message in messages(bundle(HEARD, inner))] == [None, 5.5]


@pytest.mark.parametrize(
    "packet",
    [
        b"", b"/", HEARD[:-4], HEARD[:12], b"facescript\0\0,s\0\0no\0\0", b"/a\0\0,b\0\0", b"/a\0\0,i\0\0\0",
        bundle(HEARD)[:-4], bundle(HEARD)[:13], bundle(b""), bundle(bundle(bundle(bundle(bundle(HEARD))))),
        bundle(*[HEARD] * 300), b"/a\0\0," + b"i" * 4000, BUNDLE + bytes(8) + b"\xff" * 4,
    ],
)  # fmt: skip
def test_nonsense_is_none(packet: bytes) -> None:
    with pytest.raises(Nonsense):
        messages(packet)


@settings(max_examples=50, deadline=None)
@given(st.one_of(st.binary(max_size=120), st.binary(max_size=60).map(lambda data: bundle(data, HEARD[:20] + data))))
def test_any_bytes_are_read_or_refused(packet: bytes) -> None:
    try:
        assert len(messages(packet)) <= 256
    except Nonsense:
        return
