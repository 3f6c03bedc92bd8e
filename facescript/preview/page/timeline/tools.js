// The buttons over the timeline: loop, curves, zoom, and the keys that do the same.
import { icon, make } from "./dom.js";
import { Drawer } from "./drawer.js";

const STEP = 1.5;  // how much nearer a step of the zoom is

const ICONS = {
  loop: "M17 2.5 20.5 6 17 9.5M3.5 11V9a3 3 0 0 1 3-3h14M7 21.5 3.5 18 7 14.5M20.5 13v2a3 3 0 0 1-3 3h-14",
  out: "M6 12h12",
  into: "M6 12h12M12 6v12",
  fit: "M3.5 8V5.5a2 2 0 0 1 2-2H8M16 3.5h2.5a2 2 0 0 1 2 2V8M20.5 16v2.5a2 2 0 0 1-2 2H16M8 20.5H5.5a2 2 0 0 1-2-2V16",
  curves: "M3 17c4 0 4-11 9-11s4 9 9 9",
};

export class Tools {
  constructor(place, line) {
    this.place = place;
    this.loop = button("loop", "Loop (r)", () => line.loop.toggle(), { "aria-pressed": "false" });
    this.stretch = make("span", { class: "tl-stretch" });
    const curves = button("curves", "Curves");
    curves.append("Curves");
    this.curves = new Drawer(curves, "tl-curves", "Curves");
    const { surface } = line;
    const zooms = [button("out", "Zoom out (-)", () => surface.zoom(1 / STEP)),
      button("into", "Zoom in (+)", () => surface.zoom(STEP)), button("fit", "Whole film (0)", () => surface.zoom(0))];
    place.append(this.loop, this.stretch, make("span", { class: "tl-gap" }), this.curves.place, ...zooms);
  }

  showLoop(loop, text) {
    this.loop.setAttribute("aria-pressed", String(Boolean(loop)));
    this.stretch.textContent = loop ? text : "";
  }
}

function button(name, title, act, attributes = {}) {
  const label = title.replace(/ \(.*/, "");
  const all = { type: "button", class: "tl-tool", title, "aria-label": label, ...attributes };
  const made = make("button", all, icon(ICONS[name]));
  if (act) made.addEventListener("click", act);
  return made;
}

// The keys that work wherever nothing is typed.
export function keys(line) {
  const { surface } = line, nearer = () => surface.zoom(STEP);
  const found = { r: () => line.loop.toggle(), i: () => line.loop.begin(), o: () => line.loop.end(),
    "0": () => surface.zoom(0), "+": nearer, "=": nearer, "-": () => surface.zoom(1 / STEP) };
  addEventListener("keydown", (event) => {
    if (event.defaultPrevented || event.target.closest?.(TYPED)) return;
    const command = event.ctrlKey || event.metaKey;
    if (command && event.key === "z" && !event.shiftKey) line.undo();
    else if (command || event.altKey || !found[event.key]) return;
    else found[event.key]();
    event.preventDefault();
  });
}

const TYPED = "input:not([type=checkbox], [type=range]), textarea, select, [contenteditable]";
