"""How many frames a second a page draws: a script to run in it."""

from __future__ import annotations


def frame_rate(seconds: float) -> str:
    """An expression whose value is the frames a second of a page over that time."""
    return f"""
new Promise(done => {{
  let first, count = 0;
  const look = now => {{
    first ??= now;
    if (now - first >= {seconds * 1000}) done(count * 1000 / (now - first));
    else {{ count++; requestAnimationFrame(look); }}
  }};
  requestAnimationFrame(look);
}})
"""
