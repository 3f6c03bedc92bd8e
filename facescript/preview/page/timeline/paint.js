// The timeline's ground as far as it is in sight: the ruler, the grid, lanes with their bars, sound, words and curves.
import { written } from "./axis.js";
import { bars } from "./bars.js";
import { sound, words } from "./spoken.js";
import { curves } from "./curves.js";
import { tint } from "./theme.js";

export const RULER = 30;  // px

// Draws all of it. `view` is what timeline.js keeps; `canvas` is as large as what is in sight, the ruler at its top.
export function paint(context, view) {
  const { axis, theme, strips, scrolled, height } = view;
  context.setTransform(view.dense, 0, 0, view.dense, 0, 0);
  context.fillStyle = theme.paper;
  context.fillRect(0, 0, axis.width, height);
  view.words = [];
  context.save();
  context.beginPath();
  context.rect(0, RULER, axis.width, height - RULER);
  context.clip();
  context.translate(0, RULER - scrolled);
  const seen = strips.filter((strip) => strip.top + strip.height > scrolled && strip.top < scrolled + height - RULER);
  for (const strip of seen) ground(context, view, strip);
  grid(context, view);
  context.font = theme.label;
  context.textBaseline = "alphabetic";
  for (const strip of seen) PAINTERS[strip.kind](context, view, strip);
  context.restore();
  ruler(context, view);
}

const PAINTERS = {
  face: () => {},
  lane: (context, view, strip) => {
    bars(context, view, strip);
    if (strip.lane.name === "speech") sound(context, view, strip);
  },
  words, curves,
};

function ground(context, { axis, theme }, strip) {
  if (strip.kind === "face") {
    context.fillStyle = theme.raised;
    context.fillRect(0, strip.top, axis.width, strip.height);
  }
  if (strip.kind === "lane") {
    context.fillStyle = tint(strip.lane.colour, theme, 0.05);
    context.fillRect(0, strip.top, axis.width, strip.height);
  }
  context.fillStyle = theme.hair;
  context.fillRect(0, strip.top + strip.height - 1, axis.width, 1);
}

function grid(context, { axis, theme, scrolled, height, score }) {
  context.fillStyle = theme.hair;
  for (const { time } of axis.marks().marks) context.fillRect(Math.round(axis.x(time)), scrolled, 1, height);
  context.fillStyle = theme.line;
  for (const scene of score.scenes.slice(1)) context.fillRect(Math.round(axis.x(scene.start)), scrolled, 1, height);
  const end = axis.x(score.duration);
  if (end > axis.width) return;
  context.fillStyle = theme.beyond;
  context.fillRect(end, scrolled, axis.width - end, height);
}

function ruler(context, { axis, theme, score, loop }) {
  context.fillStyle = theme.raised;
  context.fillRect(0, 0, axis.width, RULER);
  const { marks, step, parts } = axis.marks();
  if (loop) {
    context.fillStyle = theme.loop;
    context.fillRect(axis.x(loop.from), 0, (loop.to - loop.from) * axis.scale, RULER - 1);
    context.fillStyle = theme.accent;
    for (const time of [loop.from, loop.to]) context.fillRect(axis.x(time) - 1, 0, 2, RULER - 1);
  }
  context.font = theme.small;
  context.fillStyle = theme.soft;
  for (const { time, name } of marks) {
    const x = Math.round(axis.x(time));
    context.fillRect(x, RULER - 9, 1, 8);
    for (let n = 1; n < parts; n++) context.fillRect(Math.round(axis.x(time + step * n / parts)), RULER - 5, 1, 4);
    context.fillText(name, x + 4, RULER - 12);
  }
  context.fillStyle = theme.line;
  context.fillRect(0, RULER - 1, axis.width, 1);
  markers(context, axis, theme, score);
}

// What the author named: a small flag on the ruler.
function markers(context, axis, theme, score) {
  context.fillStyle = theme.marker;
  for (const { time } of score.markers) {
    const x = axis.x(time);
    if (x < -6 || x > axis.width + 6) continue;
    context.beginPath();
    context.moveTo(x, RULER - 1);
    context.lineTo(x - 4, RULER - 7);
    context.lineTo(x + 4, RULER - 7);
    context.fill();
  }
}

export const span = (view, from, to) => `${told(view, from)} to ${told(view, to)}`;
export const told = (view, time) => `${written(time, 0.001, view.score.duration)} s`;
