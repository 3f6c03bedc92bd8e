// The buttons over the timeline: loop, curves, zoom, and the keys that do the same.
import { icon, make } from "./dom.js";

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
    this.panel = make("div", { class: "tl-panel", id: "tl-curves", hidden: true, role: "group", "aria-label": "Curves" });
    this.curves = button("curves", "Curves", () => this.open(this.panel.hidden),
      { "aria-expanded": "false", "aria-controls": "tl-curves" });
    this.curves.append("Curves");
    this.zooms = [button("out", "Zoom out (-)", () => line.surface.zoom(1 / 1.5)), button("into", "Zoom in (+)", () => line.surface.zoom(1.5)),
      button("fit", "Whole film (0)", () => line.surface.zoom(0))];
    place.append(this.loop, this.stretch, make("span", { class: "tl-gap" }), make("span", { class: "tl-more" }, this.curves, this.panel), make("span", { class: "tl-zooms" }, ...this.zooms));
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
    this.panel.style.maxHeight = `${this.curves.getBoundingClientRect().top - 20}px`;
    this.curves.setAttribute("aria-expanded", String(open));
  }

  showLoop(loop, text) {
    this.loop.setAttribute("aria-pressed", String(Boolean(loop)));
    this.stretch.textContent = loop ? text : "";
  }
}

function button(name, title, act, attributes = {}) {
  return make("button", { type: "button", class: "tl-tool", title, "aria-label": title.replace(/ \(.*/, ""), onclick: act, ...attributes },
    icon(ICONS[name]));
}

// The keys that work wherever nothing is typed.
export function keys(line) {
  const found = { r: () => line.toggleLoop(), i: () => line.loopFrom(), o: () => line.loopTo(), "0": () => line.surface.zoom(0),
    "+": () => line.surface.zoom(1.5), "=": () => line.surface.zoom(1.5), "-": () => line.surface.zoom(1 / 1.5) };
  addEventListener("keydown", (event) => {
    if (event.defaultPrevented || event.target.closest?.("input:not([type=checkbox]), textarea, select, [contenteditable]")) return;
    const command = event.ctrlKey || event.metaKey;
    if (command && event.key === "z" && !event.shiftKey) line.undo();
    else if (command || event.altKey || !found[event.key]) return;
    else found[event.key]();
    event.preventDefault();
  });
}
