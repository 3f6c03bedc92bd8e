"""A chat program whose answers have a face: what is typed is answered by a scripted partner, sentence by sentence.

    facescript live examples/idle.face --page --from talk://127.0.0.1:8770
    python examples/partner.py

A language model takes the place of `answer`: whatever gives its text in pieces will do.
"""

from __future__ import annotations

import asyncio
import sys
from collections.abc import AsyncIterator

from facescript.live.talk import connect

ANSWERS = {
    "hello": "Hello! It is good to see you. What would you like to know?",
    "name": "My name is Miko. I am drawn, line by line, and I follow a script.",
    "weather": "I have no window here. But I hope that it is sunny, and not too warm.",
}
ELSE = "I see. Tell me more about that, please."


async def answer(text: str) -> AsyncIterator[str]:
    """What the partner says, word by word, as a language model would."""
    found = next((said for word, said in ANSWERS.items() if word in text.lower()), ELSE)
    for word in found.split():
        await asyncio.sleep(0.03)
        yield f"{word} "


async def main(address: str) -> None:
    async with connect(address) as talk:
        face, lines = talk.face(), []
        while text := (await asyncio.to_thread(sys.stdin.readline)).strip():
            if await face.speaking():
                await face.interrupt()
            await face.do("look away")
            lines.append(await face.say_stream(answer(text)))
            await face.look("camera")
            await face.show("smile 40%", for_=2)
        for line in lines:
            print(await line.over(), flush=True)


if __name__ == "__main__":
    asyncio.run(main(sys.argv[1] if len(sys.argv) > 1 else "talk://127.0.0.1:8770"))
