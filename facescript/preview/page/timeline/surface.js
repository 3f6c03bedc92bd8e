// The timeline's place on the page: names at the left, beside them a canvas that shows what of the film is scrolled to.
import { PAD } from "./axis.js";
import { shown } from "./curves.js";
import { make } from "./dom.js";
import { mark } from "./marks.js";
import { RULER, paint, told } from "./paint.js";
import { themeOf, tint } from "./theme.js";

const AROUND = 62;  // pixels of the timeline besides its lanes: the bar, the scrollbar, edges

export class Surface {
  constructor(place, view) {
    Object.assign(this, { place, view });
    this.ground = make("canvas", { "aria-hidden": "true", hidden: true });
    this.over = make("canvas", { "aria-hidden": "true" });
    this.head = make("div", { class: "tl-playhead", hidden: true });
    const slider = { role: "slider", "aria-label": "Playhead", "aria-valuemin": "0", "aria-valuenow": "0" };
    this.ruler = make("div", { class: "tl-ruler", tabindex: "0", ...slider });
    this.acts = make("div", { class: "tl-acts", role: "listbox", tabindex: "0", "aria-label": "Acts", hidden: true });
    const empty = make("p", { class: "tl-empty" }, "The timeline is here once the script can be played.");
    this.sight = make("div", { class: "tl-sight" }, empty, this.ground, this.over, this.acts, this.ruler, this.head);
    this.space = make("div", { class: "tl-space" }, this.sight);
    this.scroller = make("div", { class: "tl-scroll" }, this.space);
    this.names = make("div", { class: "tl-names" });
    this.left = make("div", { class: "tl-left" }, this.names);
    place.append(make("div", { class: "tl-body" }, this.left, this.scroller));
    this.listen();
    this.themed();
  }

  listen() {
    this.scroller.addEventListener("scroll", () => this.scrolled(), { passive: true });
    this.left.addEventListener("wheel", (event) => { this.scroller.scrollTop += event.deltaY; }, { passive: true });
    new ResizeObserver(() => this.resized()).observe(this.scroller);
    for (const query of ["(prefers-color-scheme: dark)", "(prefers-contrast: more)"]) {
      matchMedia(query).addEventListener("change", () => this.themed());
    }
  }

  themed() {
    this.view.theme = themeOf(this.scroller);
    this.name();
    this.draw();
  }

  resized() {
    const { view, scroller } = this, width = scroller.clientWidth, height = scroller.clientHeight;
    const fitted = Math.abs(view.axis.scale - view.axis.fit) < 1e-6 || !view.axis.scale;
    Object.assign(view, { height, dense: devicePixelRatio || 1 });
    view.axis.width = width;
    view.axis.scale = fitted ? view.axis.fit : Math.max(view.axis.scale, view.axis.fit);
    for (const canvas of [this.ground, this.over]) {
      canvas.width = Math.round(width * view.dense);
      canvas.height = Math.round(height * view.dense);
    }
    this.sight.style.width = `${width}px`;
    this.sight.style.height = `${height}px`;
    this.spread();
  }

  // After a change of scale, of length or of lanes: the scrollbars' range, and all drawn anew.
  spread() {
    const { axis, strips } = this.view, last = strips.at(-1);
    this.space.style.width = `${Math.max(axis.whole, axis.width)}px`;
    const whole = RULER + (last ? last.top + last.height : 0);
    this.space.style.height = `${Math.max(whole, this.view.height)}px`;
    this.place.style.setProperty("--tl-whole", `${whole + AROUND}px`);
    this.scroller.scrollLeft = axis.left;
    this.scrolled();
  }

  scrolled() {
    this.view.axis.left = this.scroller.scrollLeft;
    this.view.scrolled = this.scroller.scrollTop;
    this.names.style.transform = `translateY(${RULER - this.view.scrolled}px)`;
    this.draw();
  }

  scrollTo(left) {
    this.view.axis.left = Math.min(Math.max(0, left), Math.max(0, this.view.axis.whole - this.view.axis.width));
    this.spread();
  }

  zoom(factor, x = this.view.axis.width / 2) {
    if (!this.view.score) return;
    this.view.axis.zoom(this.view.axis.scale * factor, x);
    this.spread();
  }

  // Brings an act into sight.
  reveal(act) {
    const { axis, strips, height, scrolled } = this.view;
    const strip = strips.find((each) => each.kind === "lane" && each.number === act.lane);
    const left = axis.x(act.start), right = axis.x(act.end), top = strip.top + act.row * strip.row;
    if (top < scrolled) this.scroller.scrollTop = top - 8;
    if (top + strip.row > scrolled + height - RULER) this.scroller.scrollTop = top + strip.row + RULER + 8 - height;
    if (right < 40 || left > axis.width - 40) this.scrollTo(axis.left + left - axis.width / 3);
  }

  // ---------------------------------------------------------------- drawn when the browser draws

  draw() {
    this.stale = true;
    this.markLater();
  }

  markLater() {
    this.due ??= requestAnimationFrame(() => {
      this.due = undefined;
      if (!this.view.score || !this.view.axis.width) return;
      this.ground.hidden = false;
      if (this.stale) paint(this.ground.getContext("2d", { alpha: false }), this.view);
      this.stale = false;
      mark(this.over.getContext("2d"), this.view);
      this.placeHead();
    });
  }

  // The playhead to its time; while it plays a reader is told of whole seconds only.
  placeHead() {
    const { axis, time, score, playing } = this.view, x = axis.x(time);
    this.head.style.transform = `translateX(${x}px)`;
    this.head.hidden = x < -PAD || x > axis.width + PAD;
    const said = playing ? Math.floor(time) : time;
    if (this.said === said) return;
    this.said = said;
    this.ruler.setAttribute("aria-valuenow", time.toFixed(2));
    this.ruler.setAttribute("aria-valuemax", score.duration.toFixed(2));
    this.ruler.setAttribute("aria-valuetext", `${told(this.view, time)} of ${told(this.view, score.duration)}`);
  }

  // ---------------------------------------------------------------- names at the left

  name() {
    const { strips, theme } = this.view;
    this.names.replaceChildren(...strips.map((strip) => {
      const row = make("div", { class: `tl-name tl-${strip.kind}` }, ...NAMES[strip.kind](strip, theme));
      row.style.top = `${strip.top}px`;
      row.style.height = `${strip.height}px`;
      return row;
    }));
  }
}

const dot = (colour, kind = "tl-dot") => {
  const element = make("span", { class: kind });
  element.style.background = colour;
  return element;
};

const UNITS = { deg: "degrees", cm: "cm", 1: "shares" };

const NAMES = {
  face: (strip) => [strip.name],
  lane: (strip, theme) => [dot(tint(strip.lane.colour, theme, 1)), strip.lane.name],
  words: () => ["words"],
  curves: (strip, theme) => [
    make("span", { class: "tl-unit" }, UNITS[strip.unit]),
    ...strip.channels.map((channel) => make("span", { class: "tl-entry" },
      dot(shown(channel.colour, theme), channel.dash.length ? "tl-dash" : "tl-stroke"), channel.name)),
  ],
};
