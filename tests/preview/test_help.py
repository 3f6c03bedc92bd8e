"""A page's language server: what is passed on, what is refused, and that it ends with its page."""

from __future__ import annotations

import asyncio
import os
import sys
from collections.abc import AsyncIterator
from contextlib import suppress

import pytest
import pytest_asyncio
from websockets.asyncio.client import connect
from websockets.asyncio.server import serve
from websockets.exceptions import ConnectionClosed

from facescript.preview import help as helping

ECHO = """
import json, os, sys
sent = json.dumps({"pid": os.getpid()}).encode()
while True:
    sys.stdout.buffer.write(b"Content-Length: %d\\r\\nContent-Type: x\\r\\n\\r\\n%b" % (len(sent), sent))
    sys.stdout.buffer.flush()
    head = sys.stdin.buffer.readline()
    if not head:
        break
    sys.stdin.buffer.readline()
    sent = sys.stdin.buffer.read(int(head.split(b":")[1]))
    if b"exit" in sent:
        break
"""
"""A program that says who it is and gives back what it is sent."""


@pytest_asyncio.fixture
async def address(monkeypatch: pytest.MonkeyPatch) -> AsyncIterator[str]:
    monkeypatch.setattr(helping, "COMMAND", (sys.executable, "-S", "-c", ECHO))
    monkeypatch.setattr(helping, "MOST", 2)
    async with serve(helping.Helpers().help, "127.0.0.1", 0) as server:
        yield f"ws://127.0.0.1:{next(iter(server.sockets)).getsockname()[1]}/lsp"


def alive(pid: int) -> bool:
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    return True


async def pid_of(first: str | bytes) -> int:
    return int(str(first).partition(": ")[2].rstrip("}"))


async def test_messages_pass_both_ways_and_the_server_ends_with_its_page(address: str) -> None:
    async with connect(address) as page:
        pid = await pid_of(await page.recv())
        for said in ('{"text": "Grüße, 世界 😀"}', '{"long": "' + "x" * 200_000 + '"}'):
            await page.send(said)
            assert await page.recv() == said
        assert alive(pid)
    for _ in range(100):
        if not alive(pid):
            return
        await asyncio.sleep(0.05)
    raise AssertionError("the language server is still there")


@pytest.mark.parametrize("said", ["nonsense", "[1, 2]", '"text"', b"{}", "[" * 100_000])
async def test_what_is_no_message_ends_the_connection(address: str, said: str | bytes) -> None:
    async with connect(address) as page:
        await page.recv()
        await page.send(said)
        with pytest.raises(ConnectionClosed):
            await asyncio.wait_for(page.recv(), 5)
        assert page.close_code == 1003


async def test_a_language_server_that_ends_ends_the_connection(address: str) -> None:
    async with connect(address) as page:
        await page.recv()
        await page.send('{"method": "exit"}')
        with pytest.raises(ConnectionClosed):
            await asyncio.wait_for(page.recv(), 5)


async def test_so_many_and_no_more(address: str) -> object:
    async with connect(address) as one, connect(address) as two, connect(address) as three:
        await one.recv(), await two.recv()
        with pytest.raises(ConnectionClosed):
            await asyncio.wait_for(three.recv(), 5)
        assert three.close_code == 1013
        await two.close()
        for _ in range(100):  # until the language server of the second is gone
            async with connect(address) as again:
                with suppress(ConnectionClosed):
                    return await again.recv()
            await asyncio.sleep(0.02)
    raise AssertionError("no page takes the place of one that went")


async def test_without_the_extra_it_says_what_to_install(address: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(helping, "find_spec", lambda name: None)
    async with connect(address) as page:
        with pytest.raises(ConnectionClosed):
            await page.recv()
        assert (page.close_code, "facescript[lsp]" in (page.close_reason or "")) == (helping.ABSENT, True)
