// The lines of the run to the caption of a time.

const KEPT = 64;  // lines that are held

// Shows in `place` what is said, as `link` tells it.
export function captions(link, place) {
  let lines = new Map(), shown = "";

  link.on("figure", () => { lines = new Map(); });
  link.on("line", (message) => {
    lines.delete(message.number);
    lines.set(message.number, message);
    for (const number of [...lines.keys()].slice(0, -KEPT)) lines.delete(number);
  });
  link.on("cut", ({ number, cut }) => { if (lines.has(number)) lines.get(number).cut = cut; });

  // The last caption that has begun and is not over.
  function at(time) {
    let found = null;
    for (const line of lines.values())
      for (const [start, end, text] of line.captions)
        if (line.start + start <= time && time < Math.min(line.start + end, line.cut ?? Infinity)) found = { line, text };
    return found;
  }

  function show(time) {
    const found = at(time), key = found ? `${found.line.number} ${found.text}` : "";
    if (key === shown) return;
    shown = key;
    place.replaceChildren();
    if (!found) return;
    const said = document.createElement("span");
    if (found.line.name) said.append(Object.assign(document.createElement("b"), { textContent: found.line.name }), " ");
    said.append(found.text);
    said.lang = found.line.language;
    place.append(said);
  }

  return { show };
}
