// Lines to what is heard of them: the sound in their bars, the words below.
import { wordsFit } from "./bars.js";
import { topOf } from "./rows.js";
import { fit, width } from "./text.js";
import { tint } from "./theme.js";

const RATE = 100;  // peaks a second
const FREE = 5, LONGEST = 240;  // pixels between two words, and of one word at most

// The sound of each line of the lane in its bar.
export function sound(context, view, strip) {
  const { axis, theme, peaks } = view;
  if (!peaks.length) return;
  context.fillStyle = tint(strip.lane.colour, theme, 0.62);
  for (const act of strip.acts) {
    const left = Math.max(axis.x(act.start), 0), right = Math.min(axis.x(act.end), axis.width);
    const full = wordsFit(view, act), top = topOf(strip, act);
    const high = strip.bar - (full ? 4 : 18), low = top + strip.bar - 2;
    const step = Math.max(1, axis.scale / RATE);
    for (let x = Math.floor(left); x < right; x += step) {
      const peak = loudest(peaks, axis.time(x) * RATE, axis.time(x + step) * RATE) / 255;
      const tall = Math.max(peak * high, 1);
      context.fillRect(x, full ? low - (high + tall) / 2 : low - tall, step > 2 ? step - 0.7 : step, tall);
    }
  }
}

function loudest(peaks, from, to) {
  let most = 0;
  for (let at = Math.max(0, Math.floor(from)); at < Math.min(to, peaks.length); at++) most = Math.max(most, peaks[at]);
  return most;
}

// The words of the face's lines where they are spoken, in two rows where they need them; a line too narrow has none.
// Where each stands is kept for what lights them.
export function words(context, view, strip) {
  const { axis, theme } = view;
  context.fillStyle = theme.ink;
  const free = Array(strip.rows).fill(-Infinity);
  for (const line of strip.lines) {
    const left = axis.x(line.start), right = axis.x(line.end);
    if (left > axis.width || right < -100 || width(line.text) * 0.6 > right - left) continue;
    for (const word of line.words) {
      const x = axis.x(word.start), row = free.findIndex((until) => until <= x);
      if (row < 0 || x > axis.width) continue;
      const text = fit(word.text, LONGEST), long = width(text), y = strip.top + (row + 1) * strip.row - 3;
      free[row] = x + long + FREE;
      if (x + long < 0) continue;
      context.fillText(text, x, y);
      view.words.push({ word, text, x, y, long });
    }
  }
}
