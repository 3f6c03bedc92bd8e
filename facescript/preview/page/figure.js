// Frames that the server has drawn to the picture at a time (frames.py makes them); drawing.js is the `.html` output's.

import { drawing } from "./drawing.js";

// The picture in `place`, told by `link`. `draw(time)` draws it where its frames are there; whenever they come,
// `redraw` is called.
export function figure(link, place, redraw) {
  let shown = null, next = null, drawn = -1, version = 0, wanted = 0;  // the chunk that is looked at

  link.on("figure", (message) => {
    version = message.version;
    if (shown && shown.film.figure === message.figure) return void (next = null, renew(shown, message));
    if (next && next.film.figure === message.figure) return renew(next, message);
    next = { film: { ...message, layers: [] }, chunks: new Map(), picture: null };
    for (const face of next.film.faces) face.moves = [];
  });
  link.on("mean", ({ figure: name, face, numbers }) => {
    const made = of(name), half = numbers.length / 2;
    if (made) Object.assign(made.film.faces[face], { x: numbers.subarray(0, half), y: numbers.subarray(half) });
  });
  link.on("ways", ({ figure: name, face, count, numbers }) => {
    const made = of(name), size = numbers.length / count / 2;
    const row = (at) => numbers.subarray(at * size, (at + 1) * size);
    for (let way = 0; made && way < count; way++) made.film.faces[face].moves.push([row(2 * way), row(2 * way + 1)]);
  });
  link.on("layer", ({ figure: name, layer }) => { of(name)?.film.layers.push(layer); });
  link.on("frames", (message) => {
    const made = of(message.figure);
    if (!made) return;
    made.chunks.set(message.chunk, chunkOf(message, made.film));
    if (made === next || message.chunk === wanted) redraw();
  });
  link.on("kept", ({ version: now, chunks }) => {
    for (const made of [shown, next])
      for (const number of chunks) if (made?.chunks.has(number)) made.chunks.get(number).version = now;
    if (chunks.includes(wanted)) redraw();
  });
  link.on("forget", ({ chunks }) => {
    for (const made of [shown, next]) for (const number of chunks) made?.chunks.delete(number);
  });

  const of = (name) => [next, shown].find((made) => made && made.film.figure === name);

  function renew(made, { frames, chunks }) {
    Object.assign(made.film, { frames, chunks });
    for (const number of [...made.chunks.keys()]) if (number >= chunks) made.chunks.delete(number);
  }

  // The chunk of a time and where in it the time is.
  function find(made, time) {
    const { fps, frames, chunk } = made.film, at = Math.min(Math.max(time * fps, 0), frames - 1.0001);
    const frame = Math.floor(at), number = Math.floor(frame / chunk);
    return { number, part: made.chunks.get(number), here: frame - number * chunk, share: at - frame };
  }

  // The next figure takes the place of the one that is shown as soon as the picture at the time is there.
  function change(time) {
    if (!next || !find(next, time).part) return;
    shown?.picture?.remove();
    const [wide, high] = next.film.size;
    place.style.setProperty("--wide", wide), place.style.setProperty("--high", high);
    place.style.setProperty("--ratio", `${wide} / ${high}`);
    next.picture = drawing(next.film, place, redraw);
    next.picture.fitted();
    shown = next, next = null;
  }

  function draw(time) {
    change(time);
    if (!shown || !shown.picture.ready) return false;
    const { number, part, here, share } = find(shown, time);
    wanted = number;
    if (!part) return false;
    shown.picture.take(part.rows, part.ways, here, part.cuts.has(here + 1) ? 0 : share);
    shown.picture.paint(part.grounds, here + share);
    drawn = time;
    place.dataset.version = part.version;
    return true;
  }

  new ResizeObserver(() => { if (shown?.picture.fitted()) redraw(); }).observe(place);
  return {
    draw,
    get drawn() { return drawn; },
    get version() { return version; },
    get held() { return shown ? shown.chunks.size : 0; },
    get size() { return shown ? shown.film.size : null; },
  };
}

// Rows as drawing.js takes them: one number where a row stays as it is, else one for each frame.
function chunkOf({ numbers, moving, ways, cuts, grounds, version }, film) {
  const count = ways.reduce((sum, each) => sum + each, 0) + 2 * film.shapes.length + 3, length = film.chunk + 1;
  const rows = Array.from({ length: count }, (_, row) => numbers.subarray(row, row + 1));
  moving.forEach((row, place) => {
    const from = count + place * length;
    rows[row] = numbers.subarray(from, from + length);
  });
  return { rows, ways, cuts: new Set(cuts), grounds, version };
}
