// Places in the timeline to acts and their handles; times to what they snap to.
import { RULER } from "./paint.js";
import { stripAt, topOf } from "./rows.js";

const NEAR = 6;  // pixels from an edge that still take hold of it
const SNAP = 7;  // pixels from which an edge is drawn to another

// The act at a place and which of its handles: { act, handle, strip }, the handle "" where none is to be had.
export function find(view, x, y) {
  const down = y - RULER + view.scrolled, strip = y < RULER ? undefined : stripAt(view.strips, down);
  if (!strip || strip.kind !== "lane") return null;
  const near = strip.acts.filter((act) => {
    const top = topOf(strip, act);
    return down >= top - 1 && down <= top + strip.bar + 1
      && x >= view.axis.x(act.start) - NEAR && x <= Math.max(view.axis.x(act.end), view.axis.x(act.until)) + NEAR;
  });
  if (!near.length) return null;
  const act = near.includes(view.chosen) && near.length > 1 && handleAt(view, view.chosen, x) !== "body"
    ? view.chosen
    : near.reduce((best, each) => beside(view, each, x) <= beside(view, best, x) ? each : best);
  return { act, handle: handleAt(view, act, x), strip };
}

// How far a place is from a bar, px; 0 inside.
function beside({ axis }, act, x) {
  return Math.max(axis.x(act.start) - x, x - Math.max(axis.x(act.end), axis.x(act.start) + 1), 0);
}

function handleAt({ axis }, act, x) {
  const near = Math.min(NEAR, Math.max(2, (axis.x(act.until) - axis.x(act.start)) / 4));
  if (act.handles.end && Math.abs(x - axis.x(act.until)) <= near) return "end";
  if (act.handles.start && Math.abs(x - axis.x(act.start)) <= near) return "start";
  return act.handles.body || act.handles.degree ? "body" : "";
}

// The times that an act's edges may snap to: words, edges of other acts, scenes, what is named, the playhead.
export function anchors(view, act) {
  const times = [0, view.score.duration, view.time, ...view.score.markers.map((each) => each.time)];
  for (const other of view.score.acts) if (other !== act) times.push(other.start, other.until, other.settled);
  for (const line of view.score.lines) for (const word of line.words) times.push(word.start, word.end);
  return Float64Array.from(times).sort();
}

// By how much to move so that one of the `edges` (s) snaps: to an anchor that is near, else to a frame of the film.
export function snap(view, times, edges, by) {
  let best = null;
  for (const edge of edges) {
    for (const time of nearest(times, edge + by)) {
      const off = Math.abs(time - edge - by) * view.axis.scale;
      if (off <= SNAP && (best === null || off < best.off)) best = { by: time - edge, at: time, off };
    }
  }
  if (best) return best;
  const { fps } = view.score.film;
  return { by: Math.round((edges[0] + by) * fps) / fps - edges[0], at: null };
}

function nearest(times, time) {
  const after = below(times, time);
  return [times[after - 1], times[after]].filter((each) => each !== undefined);
}

// How many of a rising list are not above a value.
export function below(list, value) {
  let low = 0, high = list.length;
  while (low < high) list[low + high >> 1] <= value ? low = (low + high >> 1) + 1 : high = low + high >> 1;
  return low;
}
