"""Messages of an MQTT broker to events: `TOPIC/heard` with the text, or `TOPIC` with JSON or words."""

from __future__ import annotations

import asyncio
from typing import Any

import paho.mqtt.client as mqtt
from paho.mqtt.enums import CallbackAPIVersion

from facescript.live.address import Form, parse
from facescript.live.messages import LARGEST, Nonsense, plain, told
from facescript.live.model import Source, Teller, Told
from facescript.live.sources.intake import Intake
from facescript.live.sources.setting import Setting

FORM = Form("mqtt://127.0.0.1:1883/facescript", 1883, path=True)

SOONEST, LATEST = 1, 30
"""Seconds until a broker that is not there is tried again."""

KEPT_ALIVE = 15
"""Seconds between two signs of life."""


def opened(address: str, setting: Setting) -> Source:
    """Raises `AddressFault`."""
    parts = parse(address, FORM)
    return Mqtt(parts.host, parts.port, parts.path or "facescript", setting)


class Mqtt:
    """A client of a broker, which need not be there yet. Messages that a broker has kept are of the past: they are
    counted, and nothing comes of them."""

    def __init__(self, host: str, port: int, topic: str, setting: Setting) -> None:
        self._at, self._topic, self._setting, self._intake = (host, port), topic, setting, Intake()
        self._told = False

    async def run(self, teller: Teller) -> None:
        client = mqtt.Client(CallbackAPIVersion.VERSION2)
        client.reconnect_delay_set(SOONEST, LATEST)
        client.on_connect = self._connected
        client.on_connect_fail = self._absent
        client.on_message = lambda _client, _data, message: self._take(teller, message)
        client.connect_async(*self._at, keepalive=KEPT_ALIVE)
        client.loop_start()
        try:
            await asyncio.Event().wait()
        finally:
            client.disconnect()
            await asyncio.shield(asyncio.to_thread(client.loop_stop))

    def counts(self) -> dict[str, int]:
        return self._intake.counts()

    def _connected(self, client: mqtt.Client, _data: Any, _flags: Any, reason: Any, _properties: Any) -> None:
        self._intake.count("connections")
        if reason.is_failure:
            self._setting.tell(f"The broker at {self._at[0]}:{self._at[1]} does not let it in: {str(reason).lower()}.")
            return
        client.subscribe([(self._topic, 1), (f"{self._topic}/+", 1)])

    def _absent(self, _client: mqtt.Client, _data: Any) -> None:
        if not self._told:
            self._told = True
            self._setting.tell(f"No broker is at {self._at[0]}:{self._at[1]}; it is tried again.")

    def _take(self, teller: Teller, message: mqtt.MQTTMessage) -> None:
        if message.retain:
            self._intake.count("kept")
        elif message.topic == self._topic:
            self._intake.take(teller, bytes(message.payload))
        else:
            kind = message.topic.removeprefix(f"{self._topic}/")
            self._intake.told(teller, lambda: _read(kind, bytes(message.payload)))


def _read(kind: str, payload: bytes) -> tuple[Told, ...]:
    """Raises `Nonsense`."""
    if len(payload) > LARGEST:
        raise Nonsense(f"a message has at most {LARGEST} bytes")
    try:
        return told(kind, plain(payload.decode("utf-8").strip()))
    except UnicodeDecodeError:
        raise Nonsense("it is not UTF-8") from None
