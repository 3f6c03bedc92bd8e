// Channels to lines over the same time axis: in each column of pixels from the least to the greatest value.

import { tint } from "./theme.js";

const EDGE = 8;  // pixels that curves keep from their panel's frame

export function curves(context, view, strip) {
  const { axis, theme } = view, top = strip.top + EDGE, bottom = strip.top + strip.height - EDGE;
  const y = (value) => bottom - (value - strip.least) * (bottom - top) / (strip.most - strip.least || 1);
  context.fillStyle = theme.line;
  context.fillRect(0, Math.round(y(0)), axis.width, 1);
  context.save();
  context.lineWidth = 1.5;
  context.lineJoin = "round";
  for (const channel of strip.channels) {
    context.strokeStyle = shown(channel.colour, theme);
    context.setLineDash(channel.dash);
    course(context, axis, channel, y);
    context.stroke();
  }
  context.restore();
  context.font = theme.small;
  context.textBaseline = "alphabetic";
  context.fillStyle = theme.soft;
  context.fillText(amount(strip.most, strip.unit), 4, top + 9);
  context.fillText(amount(strip.least, strip.unit), 4, bottom - 1);
}

// Black lines have the ink's colour, which is light in the dark, as the others are then.
export const shown = (colour, theme) => colour === "#000000" ? theme.ink : tint(colour, theme, 1);

function course(context, axis, { values, every }, y) {
  const first = Math.max(0, Math.floor(axis.time(-2) / every)), last = Math.ceil(axis.time(axis.width + 2) / every);
  const end = Math.min(values.length - 1, last), column = Math.max(1, Math.floor(1 / (axis.scale * every)));
  context.beginPath();
  for (let at = first; at <= end; at += column) {
    let low = at, high = at;
    for (let n = at + 1; n < at + column && n <= end; n++) {
      if (values[n] < values[low]) low = n;
      if (values[n] > values[high]) high = n;
    }
    for (const n of low < high ? [low, high] : [high, low]) context.lineTo(axis.x(n * every), y(values[n]));
  }
}

function amount(value, unit) {
  const text = String(Math.round(value * 100) / 100);
  return unit === "1" ? text : `${text}${unit === "deg" ? "°" : ` ${unit}`}`;
}
