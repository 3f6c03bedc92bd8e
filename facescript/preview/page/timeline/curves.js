// Channels to lines over the same time axis: in each column of pixels from the least to the greatest value.

import { tint } from "./theme.js";

const EDGE = 8;  // pixels that curves keep from their panel's frame
const THICK = 1.5;  // pixels of a line
const DENSE = 2;  // values in a pixel from which they are drawn by columns

export function curves(context, view, strip) {
  const { axis, theme } = view, top = strip.top + EDGE, bottom = strip.top + strip.height - EDGE;
  const y = (value) => bottom - (value - strip.least) * (bottom - top) / (strip.most - strip.least || 1);
  context.fillStyle = theme.line;
  context.fillRect(0, Math.round(y(0)), axis.width, 1);
  context.save();
  context.lineWidth = THICK;
  context.lineJoin = "round";
  for (const channel of strip.channels) {
    const colour = shown(channel.colour, theme), column = Math.floor(1 / (axis.scale * channel.every));
    if (column >= DENSE) columns(context, axis, channel, y, column, colour);
    else course(context, axis, channel, y, colour);
  }
  context.font = theme.small;
  context.fillStyle = theme.soft;
  context.fillText(amount(strip.most, strip.unit), 4, top + 9);
  context.fillText(amount(strip.least, strip.unit), 4, bottom - 1);
  context.restore();
}

// Black lines have the ink's colour, which is light in the dark, as the others are then.
export const shown = (colour, theme) => colour === "#000000" ? theme.ink : tint(colour, theme, 1);

// Values that stand apart: a line through them.
function course(context, axis, { values, every, dash }, y, colour) {
  const first = Math.max(0, Math.floor(axis.time(-2) / every)), last = Math.ceil(axis.time(axis.width + 2) / every);
  context.beginPath();
  for (let at = first; at <= Math.min(values.length - 1, last); at++) context.lineTo(axis.x(at * every), y(values[at]));
  context.strokeStyle = colour;
  context.setLineDash(dash);
  context.stroke();
}

// Many values in each pixel: a stroke from the least to the greatest. They are found once for a scale, then kept.
function columns(context, axis, channel, y, column, colour) {
  if (channel.kept?.column !== column) channel.kept = { column, ...extremes(channel.values, column) };
  const { lows, highs } = channel.kept, wide = channel.every * column * axis.scale;
  const first = Math.max(0, Math.floor(axis.time(0) / (channel.every * column)));
  const whole = channel.dash.reduce((sum, each) => sum + each, 0);
  context.fillStyle = colour;
  for (let at = first; at < lows.length; at++) {
    const x = axis.x(at * channel.every * column);
    if (x > axis.width) return;
    if (whole && (at * wide) % whole > channel.dash[0]) continue;
    const top = y(highs[at]) - THICK / 2;
    context.fillRect(x, top, wide + 0.3, y(lows[at]) + THICK / 2 - top);
  }
}

// The least and the greatest of every so many values and the next: neighbours touch.
function extremes(values, column) {
  const count = Math.ceil(values.length / column), lows = new Float32Array(count), highs = new Float32Array(count);
  for (let at = 0; at < count; at++) {
    let low = Infinity, high = -Infinity;
    for (let n = at * column; n <= (at + 1) * column && n < values.length; n++) {
      if (values[n] < low) low = values[n];
      if (values[n] > high) high = values[n];
    }
    lows[at] = low, highs[at] = high;
  }
  return { lows, highs };
}

function amount(value, unit) {
  const text = String(Math.round(value * 100) / 100);
  return unit === "1" ? text : `${text}${unit === "deg" ? "°" : ` ${unit}`}`;
}
