// Draws a figure on two canvases: adds up the ways in which its points move, and fills its shapes. What `.html` outputs
// and the preview share; a function, so that it needs nothing but what it is given.

const UPRIGHT = 0.05;  // radians: a gradient tilted by less is drawn upright
const SHARPEST = 1920;  // pixels across

// `film` is what figure.py makes, its faces with the rows `x`, `y` and `moves`; `place` the element that takes the
// canvases; `redraw` is called when a picture has come that lies behind. What is painted is `points` (all x, then all y),
// `opacity`, `turns` and `view`, which `take` sets from rows, and others may set by themselves.
function drawing(film, place, redraw) {
  let count = 0;
  for (const { contours } of film.shapes) for (const [first, more] of contours) count = Math.max(count, first + more);
  const points = new Float32Array(2 * count), opacity = new Float32Array(film.shapes.length);
  const turns = new Float32Array(film.shapes.length), view = new Float32Array(3);

  // Sets points, opacity, turns and view to those of a frame of some rows, and `share` of the way to the next: the
  // weights of each face's ways of moving, `ways` of them, then the shapes' opacities and turns, and the view. A row of
  // one number is one that stays.
  function take(rows, ways, frame, share) {
    const value = (row) => {
      if (row.length === 1) return row[0];
      return share ? row[frame] + (row[frame + 1] - row[frame]) * share : row[frame];
    };
    let row = 0;
    film.faces.forEach((face, place_) => {
      const size_ = face.x.length, x = points.subarray(face.first, face.first + size_);
      const y = points.subarray(count + face.first, count + face.first + size_);
      x.set(face.x), y.set(face.y);
      for (let way = 0; way < ways[place_]; way++, row++) {
        const weight = value(rows[row]), [across, down] = face.moves[way];
        if (!weight) continue;
        for (let each = 0; each < size_; each++) x[each] += weight * across[each], y[each] += weight * down[each];
      }
    });
    const shapes = film.shapes.length;
    for (let shape = 0; shape < shapes; shape++) {
      opacity[shape] = value(rows[row + shape]) * film.steps.level;
      turns[shape] = value(rows[row + shapes + shape]) * film.steps.turn;
    }
    for (let each = 0; each < 3; each++) view[each] = value(rows[row + 2 * shapes + each]) * film.steps.view[each];
  }

  const [ground, figures] = ["ground", "figures"].map((name) => {
    const canvas = document.createElement("canvas");
    canvas.className = `fs-${name}`;
    if (name === "ground") canvas.setAttribute("aria-hidden", "true");
    else canvas.role = "img", canvas.setAttribute("aria-label", place.dataset.label);
    place.append(canvas);
    return canvas.getContext("2d");
  });
  const [wide, high] = film.size;
  const paints = film.paints.map(paintOf);
  const layers = [];
  const groups = [];
  film.shapes.forEach((shape, number) => {
    const last = groups[groups.length - 1], key = `${shape.clip} ${number < film.still}`;
    if (last && last.key === key) last.members.push(number);
    else groups.push({ key, clip: shape.clip, still: number < film.still, members: [number] });
  });
  let size = 0, behind = "";
  film.layers.forEach((layer, number) => layerOf(number));

  function paintOf(paint) {
    if (typeof paint === "string") return paint;
    const [a, b, c, d] = paint.line || paint.circle;
    const gradient = paint.line
      ? figures.createLinearGradient(a, b, c, d) : figures.createRadialGradient(a, b, 0, a, b, c);
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
      const u = (at) => points[at] * cos + points[count + at] * sin;
      const v = (at) => points[count + at] * cos - points[at] * sin;
      for (let at = first; at < first + size_ - 1; at += 3) {
        if (at === first) spread(box, 0, u(at), u(at), u(at), u(at)), spread(box, 2, v(at), v(at), v(at), v(at));
        spread(box, 0, u(at), u(at + 1), u(at + 2), u(at + 3)), spread(box, 2, v(at), v(at + 1), v(at + 2), v(at + 3));
      }
    }
    const across = Math.max(box[1] - box[0], 1e-3), down = Math.max(box[3] - box[2], 1e-3), [left, , top] = box;
    const [x, y] = [cos * left - sin * top, sin * left + cos * top];
    context.transform(cos * across, sin * across, -sin * down, cos * down, x, y);
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

  // What lies behind at a frame: `grounds` say from which frame on which layers do.
  function paintGround(grounds, frame) {
    let last = 0, next = grounds.length;
    while (next - last > 1) {
      const middle = last + next >> 1;
      if (grounds[middle][0] <= frame + 1e-6) last = middle; else next = middle;
    }
    const key = [grounds[last][1], size, ...view, ...opacity.subarray(0, film.still)].join();
    if (key === behind) return;
    behind = key;
    ground.setTransform(size / wide, 0, 0, size / wide, 0, 0);
    ground.clearRect(0, 0, wide, high);
    for (const [number, share] of grounds[last][1]) paintLayer(layerOf(number), share);
    paintShapes(ground, true);
  }

  function layerOf(number) {
    const layer = film.layers[number];
    return layers[number] ??= layer && layer.picture ? pictureOf(layer.picture) : layer && paintOf(layer);
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

  // Draws what was taken over what lies behind at its frame.
  function paint(grounds, frame) {
    paintGround(grounds, frame);
    figures.setTransform(1, 0, 0, 1, 0, 0);
    figures.clearRect(0, 0, figures.canvas.width, figures.canvas.height);
    paintShapes(figures, false);
  }

  // Makes the picture as sharp as its place is wide; whether it changed.
  function fitted() {
    const across = Math.min(Math.round(place.clientWidth * devicePixelRatio), Math.max(SHARPEST, place.clientWidth));
    if (!across || across === size) return false;
    size = across, behind = "";
    for (const { canvas } of [ground, figures]) canvas.width = across, canvas.height = Math.round(across * high / wide);
    return true;
  }

  function remove() {
    for (const { canvas } of [ground, figures]) canvas.remove();
  }

  return { take, paint, fitted, remove, points, opacity, turns, view, get ready() { return size > 0; } };
}
