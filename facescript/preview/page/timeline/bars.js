// Acts to bars: how each comes in and lets go as its slopes, its phrase on it; and one bar as it is marked.
import { topOf } from "./rows.js";
import { fit, width } from "./text.js";
import { tint } from "./theme.js";

export const NARROW = 3;  // a bar is at least so wide, px; where several stand closer, the first stands for them
const SMALL = 8;  // a bar is drawn without slopes and edges below this, px: thousands of them must be drawn at once
const DASHED = 16;  // a bar is so wide, px, where its edge is dashed because its times are estimates
const ROOM = 5;  // pixels from a bar's edge to its text
const LEAST = 20;  // pixels from a bar to the next in which anything can be said
const BEHIND = 200;  // a bar that ends so far before the left edge, px, may have its text in sight

// All bars of a lane that are in sight, and then what they say. The font is that of labels.
export function bars(context, view, strip) {
  const { axis, theme } = view, { colour } = strip.lane, until = [], shown = [];
  const strong = tint(colour, theme, 0.9), weak = tint(colour, theme, 0.22), crowd = tint(colour, theme, 0.45);
  context.strokeStyle = tint(colour, theme, 0.75);
  context.lineWidth = 1;
  for (const act of strip.acts) {
    const left = axis.x(act.start), right = Math.max(axis.x(act.end), left + NARROW);
    if (left > axis.width || right < -BEHIND) continue;
    if (right - left <= NARROW && left < (until[act.row] ?? -Infinity)) continue;
    until[act.row] = right + 1;
    shown.push(act);
    if (right - left < SMALL && act.end > act.start) {
      context.fillStyle = crowd;
      context.fillRect(left, topOf(strip, act), right - left - 0.5, strip.bar);
      continue;
    }
    outline(context, axis, act, topOf(strip, act), strip.bar);
    context.fillStyle = act.end > act.start ? weak : strong;
    context.fill();
    const dashed = act.estimated && right - left > DASHED;
    if (dashed) context.setLineDash([3, 2]);
    context.stroke();
    if (dashed) context.setLineDash([]);
  }
  context.fillStyle = theme.ink;
  for (const act of shown) phrase(context, view, strip, act);
}

// The bar's shape as the path: a trapezoid, or for what takes no time a diamond.
export function outline(context, axis, act, top, height, grow = 0) {
  const left = axis.x(act.start) - grow, right = Math.max(axis.x(act.end), axis.x(act.start) + NARROW) + grow;
  const high = top - grow, low = top + height + grow;
  context.beginPath();
  if (act.start === act.end) {
    const middle = (high + low) / 2, x = axis.x(act.start);
    context.moveTo(x - 6 - grow, middle);
    context.lineTo(x, middle - 7 - grow);
    context.lineTo(x + 6 + grow, middle);
    context.lineTo(x, middle + 7 + grow);
  } else {
    const apex = Math.min(Math.max(axis.x(act.apex) - grow, left), right);
    const release = Math.min(Math.max(axis.x(act.release) + grow, apex), right);
    context.moveTo(left, low);
    context.lineTo(apex, high);
    context.lineTo(release, high);
    context.lineTo(right, low);
  }
  context.closePath();
}

// What is done: on the flat top, else inside the bar, else behind it where there is room. A line whose words stand
// below says nothing. With `inside` it is left out where it does not stand on the bar. The font is that of labels.
export function phrase(context, view, strip, act, inside = false) {
  const { axis } = view, last = Math.max(axis.x(act.end), axis.x(act.start) + NARROW);
  const left = last < 0 ? axis.x(act.start) : Math.max(axis.x(act.start), 0), right = Math.min(last, axis.width);
  const free = strip.next.has(act) ? axis.x(strip.next.get(act)) : axis.width;
  if (free - left < LEAST || strip.lane.name === "speech" && wordsFit(view, act)) return;
  const long = width(act.label);
  const y = topOf(strip, act) + (strip.bar > 24 ? 14 : strip.bar / 2 + 4);
  if (act.start === act.end) {
    if (!inside) write(context, act.label, left + 9, y, free - left - 14);
    return;
  }
  const apex = Math.max(axis.x(act.apex), left), release = Math.min(axis.x(act.release), right);
  const room = right - left - 2 * ROOM;
  if (long > room && room < long / 2 && free - right - 2 * ROOM >= long) {
    if (!inside) write(context, act.label, right + ROOM, y, long);
    return;
  }
  let start = apex + ROOM;
  if (long + 2 * ROOM > release - apex) start = Math.max(left + ROOM, Math.min(apex, right - ROOM - long));
  write(context, act.label, start, y, right - ROOM - start);
}

function write(context, text, x, y, room) {
  const shown = room < LEAST / 2 ? "" : fit(text, room);
  if (shown) context.fillText(shown, x, y);
}

// Whether a line is wide enough that its words stand below it: then it need not say its text.
export function wordsFit(view, act) {
  return width(act.label) * 0.6 < (act.end - act.start) * view.axis.scale;
}
