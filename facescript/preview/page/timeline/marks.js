// What lies over the timeline's ground and changes often: what plays now, what is chosen, pointed at or dragged.
import { outline, phrase } from "./bars.js";
import { RULER } from "./paint.js";
import { topOf } from "./rows.js";
import { tint } from "./theme.js";

const SLOPE = 8;  // pixels from which an edge is seen to slope
const GRIP = 3;  // width of the grips at a chosen bar's edges, px

export function mark(context, view) {
  const { axis, scrolled, height } = view;
  context.setTransform(view.dense, 0, 0, view.dense, 0, 0);
  context.clearRect(0, 0, axis.width, height);
  context.save();
  context.beginPath();
  context.rect(0, RULER, axis.width, height - RULER);
  context.clip();
  context.translate(0, RULER - scrolled);
  for (const act of view.lit) fillBar(context, view, act, 0.4);
  context.fillStyle = view.theme.ink;
  context.textBaseline = "alphabetic";
  context.font = view.theme.label;
  for (const act of view.lit) phrase(context, view, place(view, act).strip, act, true);
  spoken(context, view);
  for (const act of view.caret) ring(context, view, act, view.theme.caret, [2, 2]);
  if (view.hovered && view.hovered !== view.chosen) ring(context, view, view.hovered, view.theme.soft);
  if (view.chosen) chosen(context, view, view.chosen);
  if (view.drag) dragged(context, view, view.drag);
  context.restore();
}

function place(view, act) {
  const strip = view.strips.find((each) => each.kind === "lane" && each.number === act.lane);
  return { strip, top: topOf(strip, act) };
}

function fillBar(context, view, act, strength) {
  const { strip, top } = place(view, act);
  outline(context, view.axis, act, top, strip.bar);
  context.fillStyle = tint(strip.lane.colour, view.theme, strip.lane.name === "speech" ? strength / 2 : strength);
  context.fill();
  context.strokeStyle = tint(strip.lane.colour, view.theme, 1);
  context.lineWidth = 1.5;
  context.stroke();
}

function ring(context, view, act, colour, dash = [], wide = 1.5) {
  const { strip, top } = place(view, act);
  outline(context, view.axis, act, top, strip.bar, 1);
  context.strokeStyle = colour;
  context.lineWidth = wide;
  context.lineJoin = "round";
  context.setLineDash(dash);
  context.stroke();
  context.setLineDash([]);
}

function chosen(context, view, act) {
  ring(context, view, act, view.theme.ink, [], 2);
  const { strip, top } = place(view, act), { axis } = view, slopes = (from, to) => axis.x(to) - axis.x(from) > SLOPE;
  const { start, apex, until, end, handles } = act;
  context.fillStyle = view.theme.ink;
  if (handles.start) grip(context, axis.x(start) + 2, top, strip.bar, slopes(start, apex) ? 1 : 0);
  if (handles.end) grip(context, axis.x(until) - 2, top, strip.bar, slopes(until, end) ? -1 : 0);
}

// What an edge can be taken hold of by: over its height, or where it slopes at its lower (1) or upper (-1) corner.
function grip(context, x, top, height, corner) {
  const tall = corner ? height / 2 : height - 6, y = corner > 0 ? top + height - tall : corner ? top : top + 3;
  context.beginPath();
  context.roundRect(x - GRIP / 2, y, GRIP, tall, 2);
  context.fill();
}

// The bar where it is dragged to, and a line through all lanes at what its edge has snapped to.
function dragged(context, view, drag) {
  fillBar(context, view, drag.ghost, 0.25);
  ring(context, view, drag.ghost, view.theme.accent, [], 2);
  if (drag.snapped === null) return;
  context.fillStyle = view.theme.accent;
  context.fillRect(Math.round(view.axis.x(drag.snapped)), view.scrolled, 1, view.height);
}

// The words in sight that are heard now.
export const heard = ({ words, time }) => words.filter(({ word }) => word.start <= time && time < word.end);

// Each on a ground of its own.
function spoken(context, view) {
  for (const { text, x, y, long } of heard(view)) {
    context.fillStyle = view.theme.accent;
    context.beginPath();
    context.roundRect(x - 3, y - 12, long + 6, 16, 4);
    context.fill();
    context.fillStyle = view.theme.paper;
    context.fillText(text, x, y);
  }
}
