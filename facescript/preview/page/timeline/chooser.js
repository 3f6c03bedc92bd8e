// The channels of the faces to a list of boxes; those that are ticked are asked for and drawn.
import { make } from "./dom.js";

const SETS = [
  ["Gaze", ["gaze.yaw", "head.yaw", "eye.left.yaw", "gaze.pitch", "head.pitch"]],
  ["Lids", ["lid.left", "lid.right"]],
  ["Mouth", ["mouth.open", "mouth.wide", "mouth.jaw"]],
  ["Brows", ["brow.inner.left", "brow.outer.left", "brow.outer.right", "brow.lower.left"]],
  ["Smile", ["cheek.lower.left", "cheek.lower.right", "cheek.upper.left", "lip.corner.left"]],
];

export class Chooser {
  // `changed(face)` is called when the ticks of a face have changed.
  constructor(place, changed) {
    this.place = place;
    this.changed = changed;
    this.ticked = new Map();  // face: Set of names
  }

  // Boxes for the faces of a new score; ticks stay. Built only where faces or channels are others than before.
  lay(channels) {
    const key = JSON.stringify(channels);
    if (key === this.key) return;
    this.key = key;
    for (const face of [...this.ticked.keys()]) if (!channels[face]) this.ticked.delete(face);
    this.place.replaceChildren(...Object.entries(channels).map(([face, names]) => this.face(face, names)));
  }

  names(face) { return [...this.ticked.get(face) ?? []]; }

  face(face, names) {
    const ticked = this.ticked.get(face) ?? new Set(), boxes = new Map();
    this.ticked.set(face, ticked);
    const set = (chosen, on) => {
      for (const name of chosen) if (boxes.has(name)) on ? ticked.add(name) : ticked.delete(name);
      for (const [name, box] of boxes) box.checked = ticked.has(name);
      this.changed(face);
    };
    for (const name of names) {
      boxes.set(name, make("input", { type: "checkbox", onchange: ({ target }) => set([name], target.checked) }));
      boxes.get(name).checked = ticked.has(name);
    }
    const quick = SETS.map(([title, chosen]) => make("button", { type: "button", class: "tl-chip",
      onclick: () => set(chosen, !chosen.every((name) => ticked.has(name))) }, title));
    const none = make("button", { type: "button", class: "tl-chip", onclick: () => set(names, false) }, "None");
    const list = names.map((name) => make("label", { class: "tl-channel" }, boxes.get(name), name));
    return make("fieldset", { class: "tl-face" }, make("legend", {}, face),
      make("div", { class: "tl-chips" }, ...quick, none), make("div", { class: "tl-channels" }, ...list));
  }
}
