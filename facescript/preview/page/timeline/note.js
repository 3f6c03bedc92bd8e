// A few words beside the pointer: what an act is, where a drag leads, why it is refused; the last is read out too.
import { make } from "./dom.js";

const REST = 300;  // ms until what is pointed at is told
const LONG = 6000;  // ms that a sentence stays
const BESIDE = 14;  // pixels from the pointer
const EDGE = 8;  // pixels that it keeps from the timeline's edges

export class Note {
  // In `place`; its points are those of `sight`, the part of it that scrolls.
  constructor(place, sight) {
    Object.assign(this, { place, sight, x: 40, y: 40 });
    this.box = make("div", { class: "tl-note", hidden: true });
    this.voice = make("div", { class: "tl-hidden", role: "status", "aria-live": "polite" });
    place.append(this.box, this.voice);
  }

  show(lines, x = this.x, y = this.y) {
    Object.assign(this, { x, y });
    clearTimeout(this.fading);
    clearTimeout(this.coming);
    this.box.hidden = false;
    this.box.replaceChildren(...lines.map((line) => make("div", {}, line)));
    const from = this.sight.getBoundingClientRect(), whole = this.place.getBoundingClientRect();
    const most = whole.width - this.box.offsetWidth - EDGE, left = from.left - whole.left + x + BESIDE;
    const point = from.top - whole.top + y, above = point - this.box.offsetHeight - BESIDE;
    this.box.style.left = `${Math.max(EDGE, Math.min(left, most))}px`;
    this.box.style.top = `${above < EDGE - whole.top ? point + BESIDE : above}px`;
  }

  // What is pointed at: only when the pointer rests, unless something is shown already.
  hint(lines, x, y) {
    clearTimeout(this.coming);
    this.coming = setTimeout(() => this.show(lines, x, y), this.box.hidden ? REST : 0);
  }

  hide() {
    clearTimeout(this.coming);
    this.box.hidden = true;
  }

  say(text) {
    this.voice.textContent = text;
    this.show([text]);
    this.fading = setTimeout(() => this.hide(), LONG);
  }
}
