// Acts to bars: how each comes in and lets go as its slopes, its phrase on it; and one bar as it is marked.
import { topOf } from "./rows.js";
import { fit, width } from "./text.js";
import { tint } from "./theme.js";

export const NARROW = 3;  // a bar is at least so wide, px; where several stand closer, the first stands for them
const SMALL = 8;  // a bar is drawn without slopes and edges below this, px: thousands of them must be drawn at once
const DASHED = 16;  // a bar is so wide, px, where its edge is dashed because its times are estimates
const ROOM = 5;  // pixels from a bar's edge to its text

// All bars of a lane that are in sight.
export function bars(context, view, strip) {
  const { axis, theme } = view, until = [];
  context.textBaseline = "alphabetic";
  for (const act of strip.acts) {
    const left = axis.x(act.start), right = Math.max(axis.x(act.end), left + NARROW);
    if (left > axis.width || right < -200) continue;
    if (right - left <= NARROW && left < (until[act.row] ?? -Infinity)) continue;
    until[act.row] = right + 1;
    const top = topOf(strip, act);
    if (right - left < SMALL && act.end > act.start) {
      context.fillStyle = tint(strip.lane.colour, theme, 0.45);
      context.fillRect(left, top, right - left - 0.5, strip.bar);
      phrase(context, view, strip, act);
      continue;
    }
    outline(context, axis, act, top, strip.bar);
    context.fillStyle = tint(strip.lane.colour, theme, act.end > act.start ? 0.22 : 0.9);
    context.fill();
    context.strokeStyle = tint(strip.lane.colour, theme, 0.75);
    context.lineWidth = 1;
    context.setLineDash(act.estimated && right - left > DASHED ? [3, 2] : []);
    context.stroke();
    phrase(context, view, strip, act);
  }
  context.setLineDash([]);
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
// below says nothing. With `inside` it is left out where it does not stand on the bar.
export function phrase(context, view, strip, act, inside = false) {
  if (strip.lane.name === "speech" && wordsFit(context, view, act)) return;
  const { axis, theme } = view, top = topOf(strip, act), height = strip.bar;
  const free = strip.next.has(act) ? axis.x(strip.next.get(act)) : axis.width;
  context.font = theme.label;
  context.fillStyle = theme.ink;
  const left = Math.max(axis.x(act.start), 0), right = Math.min(Math.max(axis.x(act.end), left + NARROW), axis.width);
  const y = top + (height > 24 ? 14 : height / 2 + 4), long = width(context, act.label);
  if (inside && act.start === act.end) return;
  if (act.start === act.end) return void write(context, act.label, left + 9, y, free - left - 14);
  const flat = [Math.max(axis.x(act.apex), left), Math.min(axis.x(act.release), right)];
  let start = flat[0] + ROOM, room = right - left - 2 * ROOM;
  if (long + 2 * ROOM > flat[1] - flat[0]) start = Math.max(left + ROOM, Math.min(flat[0], right - ROOM - long));
  const behind = long > room && room < long / 2 && free - right - 2 * ROOM >= long;
  if (behind && inside) return;
  if (behind) start = right + ROOM, room = long;
  else room = right - ROOM - start;
  write(context, act.label, start, y, room);
}

function write(context, text, x, y, room) {
  const shown = fit(context, text, room);
  if (shown) context.fillText(shown, x, y);
}

// Whether a line is wide enough that its words stand below it: then it need not say its text.
export function wordsFit(context, view, act) {
  context.font = view.theme.label;
  return width(context, act.label) * 0.6 < (act.end - act.start) * view.axis.scale;
}
