// Pointers and keys to drags of acts: edges, the middle, up and down for how strong; told to the server, which edits.
import { anchors, snap } from "./find.js";
import { told } from "./paint.js";

const FIRST = 4;  // pixels from which a press is a drag
const TALL = 120;  // pixels up or down from nought to 100 %
const OFTEN = 60;  // ms between two questions what the edit would be
const PATIENCE = 6000;  // ms until a drag that nobody answers is given up

// Begins a drag; nothing moves before the pointer does.
export function press(view, found, x, y) {
  return { act: found.act, handle: found.handle, x, y, by: 0, degree: null, snapped: null, ghost: found.act,
    moved: false, would: "", times: null, asked: 0 };
}

// The act is another object now.
export function rebind(view, drag, act) {
  Object.assign(drag, { act, times: anchors(view, act), ghost: ghost(act, drag.handle, drag.by) });
}

// The pointer is at x, y. Answers whether the drag has moved.
export function pull(view, drag, x, y, free, strong) {
  const across = x - drag.x, up = drag.y - y;
  if (!drag.moved) {
    if (Math.hypot(across, up) < FIRST) return false;
    if (drag.handle === "body" && drag.act.handles.degree && (strong || Math.abs(up) > Math.abs(across))) {
      drag.handle = "degree";
    }
    if (!drag.act.handles[drag.handle]) return false;
    drag.moved = true;
    drag.times = anchors(view, drag.act);
  }
  if (drag.handle === "degree") pullDegree(drag, up, free);
  else pullTime(view, drag, across / view.axis.scale, free);
  return true;
}

function pullDegree(drag, up, free) {
  const { least, most, now, unit } = drag.act.handles.degree, reach = unit === "1" ? 1 : (most - least) / 2;
  const step = (unit === "1" ? 0.05 : 1) / (free ? 10 : 1);
  drag.degree = clamp(Math.round((now + up * reach / TALL) / step) * step, least, most);
}

function pullTime(view, drag, by, free) {
  const { act, handle } = drag, { least, most } = act.handles[handle];
  const from = handle === "end" ? act.until : act.start;
  const edges = handle === "body" ? [act.start, act.until] : [from];
  const found = free ? { by, at: null } : snap(view, drag.times, edges, by);
  drag.by = clamp(from + found.by, least, most) - from;
  drag.snapped = Math.abs(drag.by - found.by) < 1e-6 ? found.at : null;
  drag.ghost = ghost(act, handle, drag.by);
}

// A degree one step up or down.
export function nudged({ least, most, now, unit }, steps) {
  return clamp(now + steps * (unit === "1" ? 0.05 : 1), least, most);
}

const MOVED = { body: ["start", "apex", "release", "end", "until"], start: ["start", "apex"],
  end: ["release", "end", "until"] };

// The bar as it would be: its slopes keep their lengths where there is room.
export function ghost(act, handle, by) {
  const moved = { ...act };
  const slow = handle === "end" && act.until < act.release;  // what is longer is the change at its begin
  for (const key of slow ? ["apex", "until"] : MOVED[handle] ?? []) moved[key] += by;
  moved.apex = Math.min(Math.max(moved.apex, moved.start), Math.max(moved.release, moved.start));
  moved.release = Math.max(moved.release, moved.apex);
  moved.end = Math.max(moved.end, moved.release);
  return moved;
}

// What is shown beside the pointer: the times, or how strong, and the edit that the server would make.
export function report(view, drag) {
  const { act, handle } = drag, lines = [act.label];
  if (handle === "degree") {
    const { now, unit } = act.handles.degree;
    lines.push(`${strength(now, unit)} → ${strength(drag.degree ?? now, unit)}`);
  } else {
    const from = handle === "end" ? act.until : act.start;
    const by = `${drag.by < 0 ? "−" : "+"}${Math.abs(drag.by).toFixed(3)} s`;
    lines.push(`${handle === "end" ? "end" : "start"} ${told(view, from)} → ${told(view, from + drag.by)} (${by})`);
  }
  if (drag.would) lines.push(drag.would);
  return lines;
}

export function strength(value, unit) {
  if (unit === "1") return `${Math.round(value * 100)}%`;
  return `${Math.round(value * 10) / 10}${unit === "deg" ? "°" : ` ${unit}`}`;
}

// Tells the server: now and then what the edit would be, at the end that it shall be.
export function tell(view, drag, done) {
  const now = performance.now();
  if (!done && now - drag.asked < OFTEN) return;
  drag.asked = now;
  const id = view.score.acts.indexOf(drag.act), { handle, by, degree } = drag;
  view.say("drag", { version: view.version, id, handle, by, degree, done });
  if (done) drag.given = setTimeout(() => view.letGo("Nothing answered: the text is as it was."), PATIENCE);
}

const clamp = (value, least, most) => Math.min(Math.max(value, least), most);
