// Texts to as much of them as fits.

const widths = new Map();
const MOST = 5000;  // texts whose widths are kept

export function width(context, text) {
  const key = `${context.font}\n${text}`;
  let found = widths.get(key);
  if (found === undefined) {
    if (widths.size > MOST) widths.clear();
    widths.set(key, found = context.measureText(text).width);
  }
  return found;
}

// The text, or a beginning of it and "…", or nothing.
export function fit(context, text, room) {
  const whole = width(context, text);
  if (whole <= room) return text;
  const signs = [...text];
  let count = Math.floor(signs.length * (room - 10) / whole);
  while (count > 1 && width(context, signs.slice(0, count).join("").trimEnd() + "…") > room) count--;
  return count > 1 ? signs.slice(0, count).join("").trimEnd() + "…" : "";
}
