// Draws a face at any time of its film: adds up the ways in which its points move, and fills its shapes on a canvas.
// `draw(time)` is what player.js calls, which stands below this in the same function.
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
let count = 0;
for (const shape of film.shapes) for (const [first, points] of shape.contours) count = Math.max(count, first + points);
const points = new Float32Array(2 * count), opacity = new Float32Array(film.shapes.length);
const turns = new Float32Array(film.shapes.length), view = new Float32Array(3), cuts = new Set(film.cuts);

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

// Sets points, opacity, turns and view to those of a time; false where its part is still to come.
function take(time) {
  const at = Math.min(Math.max(time * film.fps, 0), film.frames - 1.0001), frame = Math.floor(at);
  const number = Math.floor(frame / film.partFrames), part = partOf(number);
  if ((frame + 5 * film.fps) / film.partFrames >= number + 1) partOf(number + 1);
  if (!part) return false;
  const here = frame - number * film.partFrames, share = cuts.has(frame + 1) ? 0 : at - frame;
  const value = (row) => row[here] + (row[here + 1] - row[here]) * share;
  let row = 0;
  film.faces.forEach((face, place) => {
    const size = face.x.length, x = points.subarray(face.first, face.first + size);
    const y = points.subarray(count + face.first, count + face.first + size);
    x.set(face.x), y.set(face.y);
    for (let way = 0; way < film.parts[number][place]; way++, row++) {
      const weight = value(part[row]), [across, down] = face.moves[way];
      if (weight) for (let each = 0; each < size; each++) x[each] += weight * across[each], y[each] += weight * down[each];
    }
  });
  const shapes = film.shapes.length;
  for (let shape = 0; shape < shapes; shape++) {
    opacity[shape] = value(part[row + shape]) * film.steps.level;
    turns[shape] = value(part[row + shapes + shape]) * film.steps.turn;
  }
  for (let each = 0; each < 3; each++) view[each] = value(part[row + 2 * shapes + each]) * film.steps.view[each];
  return true;
}

// ---------------------------------------------------------------- drawing

const UPRIGHT = 0.05;  // radians: a gradient tilted by less is drawn upright
const SHARPEST = 1920;  // pixels across
const place = one("face"), [ground, figures] = ["ground", "figures"].map((name) => {
  const canvas = document.createElement("canvas");
  canvas.className = `fs-${name}`;
  if (name === "ground") canvas.setAttribute("aria-hidden", "true");
  else canvas.role = "img", canvas.setAttribute("aria-label", place.dataset.label);
  place.append(canvas);
  return canvas.getContext("2d");
});
const [wide, high] = film.size;
const paints = film.paints.map(paintOf);
const layers = film.layers.map((layer) => layer && layer.picture ? pictureOf(layer.picture) : layer && paintOf(layer));
const groups = [];
film.shapes.forEach((shape, number) => {
  const last = groups[groups.length - 1], key = `${shape.clip} ${number < film.still}`;
  if (last && last.key === key) last.members.push(number);
  else groups.push({ key, clip: shape.clip, still: number < film.still, members: [number] });
});
let size = 0, behind = "";

function paintOf(paint) {
  if (typeof paint === "string") return paint;
  const [a, b, c, d] = paint.line || paint.circle;
  const gradient = paint.line ? figures.createLinearGradient(a, b, c, d) : figures.createRadialGradient(a, b, 0, a, b, c);
  for (const [offset, colour] of paint.stops) gradient.addColorStop(offset, colour);
  return gradient;
}

function pictureOf(address) {
  const picture = new Image();
  picture.onload = () => { behind = ""; redraw(); };
  picture.src = address;
  return picture;
}

function trace(context, shape) {
  for (const [first, points_] of shape.contours) {
    let at = first;
    const x = points, y = count, end = first + points_;
    context.moveTo(x[at], x[y + at]);
    for (at++; at < end; at += 3)
      context.bezierCurveTo(x[at], x[y + at], x[at + 1], x[y + at + 1], x[at + 2], x[y + at + 2]);
    context.closePath();
  }
}

// The least and the most of a cubic between its ends, where a handle lies beyond them.
function spread(box, at, a, b, c, d) {
  if (d < box[at]) box[at] = d;
  if (d > box[at + 1]) box[at + 1] = d;
  if (Math.min(b, c) >= box[at] && Math.max(b, c) <= box[at + 1]) return;
  const cubed = d - a + 3 * (b - c), squared = a - 2 * b + c, once = b - a;
  const both = -(squared + Math.sign(squared || 1) * Math.sqrt(Math.max(squared * squared - cubed * once, 0)));
  for (const t of [both / cubed, once / both]) if (t > 0 && t < 1) {
    const value = a + t * (3 * once + t * (3 * squared + t * cubed));
    box[at] = Math.min(box[at], value), box[at + 1] = Math.max(box[at + 1], value);
  }
}

const box = new Float64Array(4);

// Puts the unit square where a shape's gradient lies: its box, which is turned with the head.
function fit(context, number) {
  const turn = Math.abs(turns[number]) < UPRIGHT ? 0 : turns[number], cos = Math.cos(turn), sin = Math.sin(turn);
  box[0] = box[2] = Infinity, box[1] = box[3] = -Infinity;
  for (const [first, size_] of film.shapes[number].contours) {
    const u = (at) => points[at] * cos + points[count + at] * sin, v = (at) => points[count + at] * cos - points[at] * sin;
    for (let at = first; at < first + size_ - 1; at += 3) {
      if (at === first) spread(box, 0, u(at), u(at), u(at), u(at)), spread(box, 2, v(at), v(at), v(at), v(at));
      spread(box, 0, u(at), u(at + 1), u(at + 2), u(at + 3)), spread(box, 2, v(at), v(at + 1), v(at + 2), v(at + 3));
    }
  }
  const across = Math.max(box[1] - box[0], 1e-3), down = Math.max(box[3] - box[2], 1e-3), [left, , top] = box;
  context.transform(cos * across, sin * across, -sin * down, cos * down, cos * left - sin * top, sin * left + cos * top);
}

function fill(context, number) {
  const paint = paints[film.shapes[number].paint];
  context.globalAlpha = Math.min(opacity[number], 1);
  context.fillStyle = paint;
  context.beginPath();
  trace(context, film.shapes[number]);
  if (typeof paint === "string") return context.fill();
  fit(context, number);
  context.fill();
  look(context);
}

const look = (context) => {
  const scale = size / wide;
  context.setTransform(scale * view[0], 0, 0, scale * view[0], scale * view[1], scale * view[2]);
};

function paintShapes(context, still) {
  look(context);
  for (const group of groups) {
    const shown = group.still === still ? group.members.filter((number) => opacity[number] > 0.002) : [];
    if (!shown.length) continue;
    if (group.clip.length) {
      context.save(), context.beginPath();
      for (const number of group.clip) trace(context, film.shapes[number]);
      context.clip();
    }
    for (const number of shown) fill(context, number);
    if (group.clip.length) context.restore();
  }
}

function paintGround(time) {
  let last = 0, next = film.grounds.length;
  while (next - last > 1) {
    const middle = last + next >> 1;
    if (film.grounds[middle][0] <= time * film.fps + 1e-6) last = middle; else next = middle;
  }
  const key = [last, size, ...view, ...opacity.subarray(0, film.still)].join();
  if (key === behind) return;
  behind = key;
  ground.setTransform(size / wide, 0, 0, size / wide, 0, 0);
  ground.clearRect(0, 0, wide, high);
  for (const [number, share] of film.grounds[last][1]) paintLayer(layers[number], share);
  paintShapes(ground, true);
}

function paintLayer(layer, share) {
  ground.save();
  ground.globalAlpha = share;
  if (!layer) ground.globalCompositeOperation = "destination-out";
  if (layer instanceof Image) {
    const scale = Math.max(wide / layer.naturalWidth, high / layer.naturalHeight) || 0;
    const [across, down] = [layer.naturalWidth * scale, layer.naturalHeight * scale];
    ground.fillStyle = "#fff", ground.fillRect(0, 0, wide, high);
    ground.drawImage(layer, (wide - across) / 2, (high - down) / 2, across, down);
  } else {
    ground.fillStyle = layer || "#000";
    if (layer && typeof layer !== "string") ground.scale(wide, high), ground.fillRect(0, 0, 1, 1);
    else ground.fillRect(0, 0, wide, high);
  }
  ground.restore();
}

let drawn = -1;

function draw(time) {
  if (!size || !take(time)) return;
  paintGround(time);
  figures.setTransform(1, 0, 0, 1, 0, 0);
  figures.clearRect(0, 0, figures.canvas.width, figures.canvas.height);
  paintShapes(figures, false);
  drawn = time;
  place.classList.add("drawn");
}

function fitCanvas() {
  const across = Math.min(Math.round(place.clientWidth * devicePixelRatio), Math.max(SHARPEST, place.clientWidth));
  if (!across || across === size) return;
  size = across, behind = "";
  for (const { canvas } of [ground, figures]) canvas.width = across, canvas.height = Math.round(across * high / wide);
  redraw();
}
