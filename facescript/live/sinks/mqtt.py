"""A run to a broker of MQTT: the layout, kept there for who comes later, frames now and then, marks and lines."""

from __future__ import annotations

from collections import deque
from contextlib import suppress

import paho.mqtt.client as mqtt
from paho.mqtt.enums import CallbackAPIVersion, MQTTErrorCode
from paho.mqtt.reasoncodes import ReasonCode

from facescript.live.address import Address
from facescript.live.model import Frame, Layout, Mark, Utterance
from facescript.live.sinks.counting import LONGEST_PAUSE, Counting
from facescript.live.sinks.messages import Named, layout_text, mark_text, utterance_text
from facescript.live.sinks.setting import Setting

USUAL_RATE = 10.0
"""Frames a second where none is asked for: a broker is for what happens, not for every picture."""

UNSENT = 20
"""Frames that may wait for a connection that takes its time; newer ones are dropped."""

QUEUED = 200
"""Marks and lines that wait while the broker is away."""

TOPIC = "face"


class MqttSink(Counting):
    """Beneath the topic of the address: `layout` and `state` are kept by the broker, `frame` is sent at most once,
    `mark` and `utterance` at least once."""

    def __init__(self, address: Address, setting: Setting) -> None:
        super().__init__(address.rate or USUAL_RATE)
        self._address, self._setting = address, setting
        self._topic = address.path or TOPIC
        self._unsent: deque[mqtt.MQTTMessageInfo] = deque()
        self._told = False
        self._client = mqtt.Client(CallbackAPIVersion.VERSION2)

    async def open(self, layout: Layout) -> None:
        self._layout, self._named = layout_text(layout), Named(layout.names)
        client = self._client
        client.on_connect, client.on_connect_fail = self._arrived, self._missed
        client.reconnect_delay_set(1, int(LONGEST_PAUSE))
        client.max_queued_messages_set(QUEUED)
        client.will_set(f"{self._topic}/state", "offline", qos=1, retain=True)
        client.connect_async(self._address.host, self._address.port, keepalive=15)
        client.loop_start()

    def frame(self, frame: Frame) -> None:
        if not self.due(frame):
            return
        while self._unsent and self._unsent[0].is_published():
            self._unsent.popleft()
        sent = False
        if len(self._unsent) < UNSENT and self._client.is_connected():
            info = self._client.publish(f"{self._topic}/frame", self._named.text(frame))
            sent = info.rc == MQTTErrorCode.MQTT_ERR_SUCCESS
            if sent:
                self._unsent.append(info)
        self._counts["sent" if sent else "dropped"] += 1

    def mark(self, mark: Mark) -> None:
        self._happened("mark", mark_text(mark))

    def utter(self, utterance: Utterance) -> None:
        self._happened("utterance", utterance_text(utterance))

    async def close(self) -> None:
        with suppress(ValueError, RuntimeError):
            self._client.publish(f"{self._topic}/state", "offline", qos=1, retain=True).wait_for_publish(1.0)
        self._client.disconnect()
        self._client.loop_stop()

    def _happened(self, what: str, text: str) -> None:
        info = self._client.publish(f"{self._topic}/{what}", text, qos=1)
        kept = info.rc != MQTTErrorCode.MQTT_ERR_QUEUE_SIZE
        self._counts["sent" if kept else "dropped"] += 1

    def _arrived(self, client: mqtt.Client, data: object, flags: object, reason: ReasonCode, more: object) -> None:
        """In the client's thread: each time that the broker is there, or that it refuses."""
        if reason.is_failure:
            self._tell(f"The broker at {self._address.host} refuses: {reason}.")
            return
        client.publish(f"{self._topic}/layout", self._layout, qos=1, retain=True)
        client.publish(f"{self._topic}/state", "online", qos=1, retain=True)

    def _missed(self, client: mqtt.Client, data: object) -> None:
        self._tell(f"No broker is at {self._address.host}:{self._address.port} yet; it is tried again.")

    def _tell(self, text: str) -> None:
        """Tells the first of its troubles."""
        if not self._told:
            self._told = True
            self._setting.tell(text)
