// Draws a face at any time of its film (drawing.js, which stands above this in the same function), from the parts that
// the page brings. `draw(time)` is what player.js calls, which stands below.
const one = (name) => document.querySelector(`[data-facescript="${name}"]`);
const film = JSON.parse(document.getElementById("facescript-film").textContent);

// ---------------------------------------------------------------- packed numbers (packing.py)

async function unpack(text) {
  const bytes = Uint8Array.from(atob(text), (sign) => sign.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

async function rows(text, count, scale) {
  if (!count) return [];
  const planes = await unpack(text), size = planes.length / 4, width = size / count, found = [];
  for (let row = 0; row < count; row++) {
    const values = new Float32Array(width);
    for (let at = row * width, column = 0, sum = 0; column < width; at++, column++) {
      const folded = (planes[at] | planes[at + size] << 8 | planes[at + 2 * size] << 16 | planes[at + 3 * size] << 24) >>> 0;
      sum += folded & 1 ? -(folded >>> 1) - 1 : folded >>> 1;
      values[column] = sum * scale;
    }
    found.push(values);
  }
  return found;
}

// ---------------------------------------------------------------- frames

const KEPT = 4;  // parts held unpacked
const held = new Map(), asked = new Map();
const cuts = new Set(film.cuts), place = one("face");
const picture = drawing(film, place, () => redraw());

async function faces() {
  for (const face of film.faces) {
    [face.x, face.y] = await rows(face.mean, 2, film.steps.place);
    const ways = await rows(face.ways, 2 * face.steps.length, 1);
    face.moves = face.steps.map((step, way) => [ways[2 * way], ways[2 * way + 1]]
      .map((row) => row.map((value) => value * step)));
  }
}

const scriptOf = (number) => document.getElementById(`facescript-part-${number}`);

function textOf(number) {
  const script = scriptOf(number);
  if (script) return Promise.resolve(script.textContent);
  return new Promise((done, failed) => {
    waiting.set(number, done);
    const script = document.createElement("script");
    script.src = `${film.folder}/${number}.js`;
    script.onerror = () => failed(new Error(`${script.src} is not there`));
    document.head.append(script);
  });
}
const waiting = new Map();

function partOf(number) {
  if (number >= film.parts.length || held.has(number)) return held.get(number);
  if (!asked.has(number)) asked.set(number, load(number));
}

async function load(number) {
  const ways = film.parts[number].reduce((sum, each) => sum + each, 0);
  held.set(number, await rows(await textOf(number), ways + 2 * film.shapes.length + 3, 1));
  asked.delete(number);
  if (held.size > KEPT) held.delete([...held.keys()].sort((one, two) => Math.abs(two - number) - Math.abs(one - number))[0]);
  redraw();
}

// Takes what is drawn at a time; false where its part is still to come.
function taken(time) {
  const at = Math.min(Math.max(time * film.fps, 0), film.frames - 1.0001), frame = Math.floor(at);
  const number = Math.floor(frame / film.partFrames), part = partOf(number);
  if ((frame + 5 * film.fps) / film.partFrames >= number + 1) partOf(number + 1);
  const here = frame - number * film.partFrames, share = cuts.has(frame + 1) ? 0 : at - frame;
  if (part) picture.take(part, film.parts[number], here, share);
  return Boolean(part);
}

let drawn = -1;

function draw(time) {
  if (!picture.ready || !taken(time)) return;
  picture.paint(film.grounds, time * film.fps);
  drawn = time;
  place.classList.add("drawn");
}

function fitCanvas() {
  if (picture.fitted()) redraw();
}
