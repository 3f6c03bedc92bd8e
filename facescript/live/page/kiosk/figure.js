// Frames of the run to the picture at a time: between the two frames around it, and where none come any more a face that
// waits. picture.py says how frames are written; drawing.js is the `.html` output's.

import { drawing } from "./drawing.js";

const KEPT = 24;  // frames that are held: what is drawn lies among the newest
const GONE = 0.6;  // seconds after the newest frame from which the face waits
const EASE = 0.9;  // seconds in which it comes to rest, or goes on
const TURN = 1 / 1024;  // radians: the step of a turn
const LEVEL = 1 / 255;

// The picture in `place`, told by `link`. `draw(time)` draws it at a time of the run and gives the number of the newest
// frame that is not before it.
export function figure(link, place) {
  let made = null, next = null, picture = null, frames = [], dx = 0, dy = 0, hung = null,
    waits = 0, last = 0, time = 0, shown = null;

  // What comes is of the next film, which takes the place of the one that is shown with its first frame.
  link.on("figure", (message) => {
    const points = message.numbers.length - message.shapes.length;
    const rest = message.numbers.subarray(0, points), clear = message.numbers.subarray(points);
    next = { film: { ...message, faces: [], layers: [] }, rest, clear, poses: {} };
  });
  link.on("waiting", (message) => { next.poses[message.pose] = rows(message, next); });
  link.on("layer", ({ layer }) => { (next || made).film.layers.push(layer); });
  link.on("frame", (message) => {
    if (next) made = next, next = null, frames = [], fit();
    frames = [...frames.slice(1 - KEPT), Object.assign(message, rows(message, made))];
  });

  // The steps of points, the opacities and the turns of a message.
  function rows({ numbers }, { film, rest }) {
    const all = new Int16Array(numbers.buffer, numbers.byteOffset, 2 * numbers.length);
    const points = rest.length, shapes = film.shapes.length;
    return {
      steps: all.subarray(0, points), opacity: all.subarray(points, points + shapes),
      turns: all.subarray(points + shapes),
    };
  }

  // The film fills the place, but for what would cut into where faces are: then more is seen than the film has, and
  // busts that go down to its edge go down to that of the place.
  function fit() {
    if (!made || !place.clientHeight) return;
    const { film, rest } = made, [wide, high] = film.size, [left, top, right, bottom] = film.box;
    const [across, down] = [place.clientWidth, place.clientHeight];
    const scale = Math.min(Math.max(across / wide, down / high), across / (right - left), down / (bottom - top));
    const size = [across / scale, down / scale];
    [dx, dy] = [shift(size[0], wide, (left + right) / 2), shift(size[1], high, (top + bottom) / 2)];
    const half = rest.length / 2, longer = Math.max(0, size[1] - dy - high);
    hung = Float32Array.from(rest, (value, at) => at >= half && value > high - 1 ? longer : 0);
    if (picture) picture.remove();
    picture = drawing({ ...film, size }, place, () => { shown = null; });
    picture.fitted();
    shown = null;
  }

  // Where the film begins in a place that is longer or shorter than it: in its middle, or so that `middle` is there.
  const shift = (whole, film, middle) =>
    whole >= film ? (whole - film) / 2 : Math.min(Math.max(whole / 2 - middle, whole - film), 0);

  const mix = (one, two, share) => one + (two - one) * share;

  // Puts the picture between two frames.
  function between(before, after, share) {
    const { points, opacity, turns, view } = picture, { rest, film: { step } } = made;
    for (let at = 0; at < rest.length; at++)
      points[at] = rest[at] + hung[at] + step * mix(before.steps[at], after.steps[at], share);
    for (let at = 0; at < opacity.length; at++) {
      opacity[at] = LEVEL * mix(before.opacity[at], after.opacity[at], share);
      turns[at] = TURN * mix(before.turns[at], after.turns[at], share);
    }
    for (let at = 0; at < 3; at++) view[at] = mix(before.view[at], after.view[at], share);
    view[1] += dx, view[2] += dy;
  }

  // Takes the picture so much of the way to a face that waits: it sways a little, and blinks.
  function wait(share, now) {
    const { points, opacity, turns } = picture, { rest, clear, poses, film: { step } } = made;
    const calm = matchMedia("(prefers-reduced-motion: reduce)").matches ? 0 : 1;
    const blink = Math.max(0, 1 - Math.abs(now % 4.3 - 0.12) / 0.12);
    const parts = [
      [poses.shut, blink], [poses.turned, calm * Math.sin(now / 2.7)], [poses.bowed, calm * Math.sin(now / 1.9 + 1)],
    ];
    for (let at = 0; at < rest.length; at++) {
      let steps = 0;
      for (const [pose, weight] of parts) steps += weight * pose.steps[at];
      points[at] = mix(points[at], rest[at] + hung[at] + step * steps, share);
    }
    for (let at = 0; at < opacity.length; at++) {
      let level = clear[at], turn = 0;
      for (const [pose, weight] of parts) {
        level += weight * (LEVEL * pose.opacity[at] - clear[at]);
        turn += weight * TURN * pose.turns[at];
      }
      opacity[at] = mix(opacity[at], Math.min(Math.max(level, 0), 1), share), turns[at] = mix(turns[at], turn, share);
    }
  }

  function draw(at_) {
    time = at_;
    if (!picture || !picture.ready || !frames.length) return null;
    const newest = frames[frames.length - 1], now = performance.now() / 1000;
    const passed = Math.min(now - last, 0.1) / EASE, gone = time > newest.time + GONE;
    last = now;
    waits = Math.min(Math.max(waits + (gone ? passed : -passed), 0), 1);
    const at = frames.findLastIndex((frame) => frame.time <= time);
    const before = frames[Math.max(at, 0)], after = frames[at + 1] || before;
    const share = after === before || after.cuts !== before.cuts ? 0 : (time - before.time) / (after.time - before.time);
    if (waits || before !== shown || share) {
      between(before, after, Math.max(share, 0));
      if (waits) wait(waits * waits * (3 - 2 * waits), now);
      picture.paint([[0, before.ground]], 0);
      shown = before;
    }
    return newest.number;
  }

  new ResizeObserver(() => { fit(); draw(time); }).observe(place);
  return {
    draw,
    get frames() { return frames; },
    get waiting() { return waits; },
    get film() { return made && made.film; },
  };
}
