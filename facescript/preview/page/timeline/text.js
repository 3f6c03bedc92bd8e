// Texts in the font of the timeline's labels to how wide they are, and to as much of them as fits.

const MOST = 5000;  // texts whose widths are kept
const rule = document.createElement("canvas").getContext("2d");
const widths = new Map();

export function measureIn(font) {
  rule.font = font;
  widths.clear();
}

export function width(text) {
  let found = widths.get(text);
  if (found === undefined) {
    if (widths.size > MOST) widths.clear();
    widths.set(text, found = rule.measureText(text).width);
  }
  return found;
}

// The text, or a beginning of it and "…", or nothing.
export function fit(text, room) {
  const whole = width(text);
  if (whole <= room) return text;
  const signs = [...text];
  let count = Math.floor(signs.length * (room - 10) / whole);
  while (count > 1 && width(signs.slice(0, count).join("").trimEnd() + "…") > room) count--;
  return count > 1 ? signs.slice(0, count).join("").trimEnd() + "…" : "";
}
