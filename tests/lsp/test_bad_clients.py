"""Clients that send nonsense: the server stays up, answers every request, and is right afterwards."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from _rough_client import RoughClient

INVALID = -32602


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("bad-clients")


@pytest.fixture(scope="module")
def client(folder: Path) -> Iterator[RoughClient]:
    with (folder / "log").open("wb") as log:
        client = RoughClient(log)
        try:
            client.begin(folder)
            yield client
            assert client.end() == 0
        finally:
            client.kill()


@pytest.fixture
def uri(client: RoughClient, folder: Path) -> Iterator[str]:
    """A document of two lines; whatever a test does, the server tells of it as it stands then."""
    uri = (folder / "a.face").as_uri()
    opened(client, uri, "nod\nshow smile\n")
    yield uri
    changed(client, uri, 10_000, {"text": "nod\n"})
    assert "Nods the head" in hover(client, uri)["result"]["contents"]["value"]
    client.tell("textDocument/didClose", {"textDocument": {"uri": uri}})


def opened(client: RoughClient, uri: str, text: str) -> None:
    document = {"uri": uri, "languageId": "face", "version": 1, "text": text}
    client.tell("textDocument/didOpen", {"textDocument": document})


def changed(client: RoughClient, uri: str, version: int, *changes: object) -> None:
    document = {"uri": uri, "version": version}
    client.tell("textDocument/didChange", {"textDocument": document, "contentChanges": changes})


def hover(client: RoughClient, uri: str, line: object = 0, character: object = 1) -> Any:
    place = {"line": line, "character": character}
    return client.ask("textDocument/hover", {"textDocument": {"uri": uri}, "position": place})


def codes(client: RoughClient, uri: str) -> list[str]:
    found = client.ask("textDocument/diagnostic", {"textDocument": {"uri": uri}})
    return [item["code"] for item in found["result"]["items"]]


def at(line: int, character: int) -> dict[str, object]:
    return {"line": line, "character": character}


@pytest.mark.parametrize("data", [b"Content-Length: 5\r\n\r\n{{{{{", b"Foo: 7\r\n\r\n", b"Content-Length: x\r\n\r\n"])
def test_what_is_no_message(client: RoughClient, uri: str, data: bytes) -> None:
    client.raw(data)


@pytest.mark.parametrize("message", [[1, 2], 5, None, {}, {"jsonrpc": "1.0"}, {"jsonrpc": "2.0", "id": "no"}])
def test_what_is_json_but_no_message(client: RoughClient, uri: str, message: object) -> None:
    client.send(message)


@pytest.mark.parametrize("params", [None, {"x": 1}, 7])
def test_a_request_with_other_params_is_refused(client: RoughClient, uri: str, params: object) -> None:
    assert client.ask("textDocument/hover", params)["error"]["code"] == INVALID


@pytest.mark.parametrize("place", [("x", -4), (-3, 0), (0, 10**12)])
def test_a_place_that_cannot_be_is_refused(client: RoughClient, uri: str, place: tuple[object, object]) -> None:
    assert hover(client, uri, *place)["error"]["code"] == INVALID


def test_a_place_beyond_the_text(client: RoughClient, uri: str) -> None:
    assert hover(client, uri, 2**30, 2**30)["result"] is None


@pytest.mark.parametrize("name", ["none.face", "..%2f..%2fetc%2fpasswd"])
def test_a_file_that_is_not_open(client: RoughClient, uri: str, folder: Path, name: str) -> None:
    assert hover(client, f"{folder.as_uri()}/{name}")["result"] is None


@pytest.mark.parametrize("address", ["http://x/y.face", "::::", "", "untitled:one"])
def test_an_address_that_is_no_file(client: RoughClient, uri: str, address: str) -> None:
    assert hover(client, address)["result"] is None


def test_changes_of_what_is_not_open(client: RoughClient, uri: str, folder: Path) -> None:
    other = (folder / "other.face").as_uri()
    changed(client, other, 3, {"text": "shake\n"})
    client.tell("textDocument/didClose", {"textDocument": {"uri": other}})


def test_versions_that_stand_still_or_go_back(client: RoughClient, uri: str) -> None:
    """Changes count in the order in which they come: a version says nothing of the text."""
    for version in (7, 7, 2):
        changed(client, uri, version, {"text": "nod\nnood\n"})
        assert codes(client, uri) == ["FS204"]
        changed(client, uri, version, {"text": "nod\n"})
        assert codes(client, uri) == []


def test_half_a_pair(client: RoughClient, uri: str) -> None:
    changed(client, uri, 2, {"text": 'say "\ud83d hi \udc00"\n'})
    assert "result" in hover(client, uri)
    changed(client, uri, 3, {"text": 'say "😀"\n'})
    changed(client, uri, 4, {"range": {"start": at(0, 6), "end": at(0, 6)}, "text": "x"})
    assert "result" in hover(client, uri, 0, 6)
    assert codes(client, uri) == []


def test_fifty_megabytes(client: RoughClient, uri: str, folder: Path) -> None:
    big = (folder / "big.face").as_uri()
    opened(client, big, ("# " + 97 * "x" + "\n") * (50 * 2**20 // 100))
    assert codes(client, big) == ["FS117"]
    changed(client, big, 2, {"range": {"start": at(9, 0), "end": at(9, 0)}, "text": "x"})
    assert codes(client, big) == ["FS117"]
    client.tell("textDocument/didClose", {"textDocument": {"uri": big}})


def test_a_flood_of_edits(client: RoughClient, uri: str) -> None:
    changed(client, uri, 2, {"text": "nod\n" * 500})
    for number in range(1_000):
        changed(client, uri, number + 3, {"range": {"start": at(0, 0), "end": at(0, 0)}, "text": "# a\n"})
    folded = client.ask("textDocument/foldingRange", {"textDocument": {"uri": uri}})["result"]
    assert [(each["startLine"], each["endLine"]) for each in folded] == [(0, 999)]


def test_what_is_refused_is_not_logged_as_a_fault(client: RoughClient, uri: str, folder: Path) -> None:
    place = {"textDocument": {"uri": uri}, "position": at(0, 1), "newName": "\ud800"}
    assert "words of the language stay" in client.ask("textDocument/rename", place)["error"]["message"]
    assert "words of the language stay" not in (folder / "log").read_text("utf-8")


def test_columns_are_utf_16_whatever_the_editor_likes_best(folder: Path) -> None:
    with (folder / "other log").open("wb") as log:
        client = RoughClient(log)
        try:
            liked = {"positionEncodings": ["utf-8", "utf-32", "utf-16"]}
            told = client.begin(folder, general=liked)["result"]["capabilities"]["positionEncoding"]
            uri = (folder / "columns.face").as_uri()
            opened(client, uri, 'say "你好😀" as a\nnod\n')
            changed(client, uri, 2, {"range": {"start": at(0, 14), "end": at(0, 15)}, "text": "b"})
            symbols = client.ask("textDocument/documentSymbol", {"textDocument": {"uri": uri}})["result"]
            assert told == "utf-16"
            assert [item["name"] for item in symbols] == ["b"]
            assert client.end() == 0
        finally:
            client.kill()
