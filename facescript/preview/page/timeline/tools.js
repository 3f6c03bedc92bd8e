// The buttons over the timeline: loop, speed, zoom, curves, and what they do by keys.
import { icon, make } from "./dom.js";

export const SPEEDS = [0.1, 0.25, 0.5, 0.75, 1, 1.25, 1.5, 2];

const ICONS = {
  loop: "M17 2.5 20.5 6 17 9.500M3.500 11V9a3 3 0 0 1 3-3h14M7 21.500 3.500 18 7 14.500M20.500 13v2a3 3 0 0 1-3 3h-14",
  out: "M6 12h12",
  into: "M6 12h12M12 6v12",
  fit: "M3.500 8V5.500a2 2 0 0 1 2-2H8M16 3.500h2.500a2 2 0 0 1 2 2V8M20.500 16v2.500a2 2 0 0 1-2 2H16M8 20.500H5.500a2 2 0 0 1-2-2V16",
  curves: "M3 17c4 0 4-11 9-11s4 9 9 9",
};

export class Tools {
  constructor(place, line) {
    this.loop = button("loop", "Loop (r)", () => line.toggleLoop(), { "aria-pressed": "false" });
    this.stretch = make("span", { class: "tl-stretch" });
    this.speed = make("select", { "aria-label": "Speed", title: "Speed (< and >)",
      onchange: ({ target }) => line.setSpeed(Number(target.value)) },
    ...SPEEDS.map((rate) => make("option", { value: rate }, `${rate}×`)));
    this.speed.value = "1";
    this.panel = make("div", { class: "tl-panel", id: "tl-curves", hidden: true, role: "group", "aria-label": "Curves" });
    this.curves = button("curves", "Curves", () => this.open(this.panel.hidden),
      { "aria-expanded": "false", "aria-controls": "tl-curves" });
    this.curves.append("Curves");
    this.zooms = [button("out", "Zoom out (-)", () => line.surface.zoom(1 / 1.5)), button("into", "Zoom in (+)", () => line.surface.zoom(1.5)),
      button("fit", "Whole film (0)", () => line.surface.zoom(0))];
    place.append(this.loop, this.stretch, make("span", { class: "tl-gap" }), make("label", { class: "tl-speed" }, this.speed),
      make("span", { class: "tl-more" }, this.curves, this.panel), make("span", { class: "tl-zooms" }, ...this.zooms));
    document.addEventListener("pointerdown", ({ target }) => this.panel.hidden || target.closest(".tl-more") || this.open(false));
    this.panel.addEventListener("keydown", (event) => {
      if (event.key !== "Escape") return;
      event.stopPropagation();
      this.open(false);
      this.curves.focus();
    });
  }

  open(open) {
    this.panel.hidden = !open;
    this.curves.setAttribute("aria-expanded", String(open));
  }

  showLoop(loop, text) {
    this.loop.setAttribute("aria-pressed", String(Boolean(loop)));
    this.stretch.textContent = loop ? text : "";
  }

  showSpeed(rate) { this.speed.value = String(rate); }
}

function button(name, title, act, attributes = {}) {
  return make("button", { type: "button", class: "tl-tool", title, "aria-label": title.replace(/ \(.*/, ""), onclick: act, ...attributes },
    icon(ICONS[name]));
}

// The keys that work wherever nothing is typed.
export function keys(line) {
  const faster = (step) => line.setSpeed(SPEEDS[Math.min(Math.max(SPEEDS.indexOf(line.clock.rate) + step, 0), SPEEDS.length - 1)]);
  const found = { r: () => line.toggleLoop(), i: () => line.loopFrom(), o: () => line.loopTo(), "0": () => line.surface.zoom(0),
    "+": () => line.surface.zoom(1.5), "=": () => line.surface.zoom(1.5), "-": () => line.surface.zoom(1 / 1.5),
    ">": () => faster(1), "<": () => faster(-1) };
  addEventListener("keydown", (event) => {
    if (event.defaultPrevented || event.target.closest?.("input:not([type=checkbox]), textarea, select, [contenteditable]")) return;
    const command = event.ctrlKey || event.metaKey;
    if (command && event.key === "z" && !event.shiftKey) line.undo();
    else if (command || event.altKey || !found[event.key]) return;
    else found[event.key]();
    event.preventDefault();
  });
}
