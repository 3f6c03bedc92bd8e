// Pointer, wheel and keys over the timeline to what they do there: choose, jump, scrub, drag, loop, zoom.
import { find } from "./find.js";
import * as drag from "./drag.js";
import { RULER } from "./paint.js";
import { beside } from "./reader.js";

const FASTEST = 40;  // pixels that are scrolled for a move over the edge, at most
const GRAB = 5;  // pixels from an edge of the loop that take hold of it
const STEP = 1, PAGE = 5;  // seconds of an arrow with shift, and of a page
const FIXED = {
  body: "When this act starts cannot be changed here.",
  end: "How long this act lasts cannot be changed here.",
  degree: "How strong this act is cannot be changed here.",
};
const CURSORS = { start: "ew-resize", end: "ew-resize", body: "grab", "": "pointer" };

export class Hands {
  // `line` is the timeline: what it can do. See timeline.js.
  constructor(line) {
    this.line = line;
    const { sight, scroller, ruler, acts } = line.surface;
    sight.addEventListener("pointerdown", (event) => this.down(event));
    sight.addEventListener("pointermove", (event) => this.move(event));
    sight.addEventListener("pointerup", (event) => this.up(event));
    sight.addEventListener("pointercancel", () => this.away());
    scroller.addEventListener("pointerdown", (event) => { if (event.target === scroller) line.following = false; });
    sight.addEventListener("pointerleave", () => this.held || line.point(null));
    sight.addEventListener("dblclick", (event) => this.double(event));
    scroller.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
    for (const kind of ["touchstart", "touchmove"]) {
      sight.addEventListener(kind, (event) => this.touch(event), { passive: false });
    }
    ruler.addEventListener("keydown", (event) => this.rulerKey(event));
    acts.addEventListener("keydown", (event) => this.actKey(event));
    addEventListener("keydown", (event) => this.escape(event), true);
  }

  at(event) {
    const box = this.line.surface.sight.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  // ---------------------------------------------------------------- pointer

  down(event) {
    const { view } = this.line, [x, y] = this.at(event);
    if (event.button || !view.score || view.drag) return;
    this.line.surface.sight.setPointerCapture(event.pointerId);
    const found = find(view, x, y);
    if (y < RULER) this.held = this.loopEdge(x) ?? (event.shiftKey ? this.newLoop(x) : { kind: "scrub" });
    else if (event.pointerType === "touch" && found?.act !== (view.chosen ?? 0)) this.held = { kind: "tap", found };
    else if (found && !this.line.fresh) this.held = { kind: "tap", found };
    else if (!found) this.held = { kind: "scrub" };
    else this.held = { kind: "act", found, drag: drag.press(view, found, x, y) };
    this.pulled(event);
  }

  move(event) {
    const { view } = this.line;
    if (this.held) return this.beyond(event), this.pulled(event);
    if (!view.score) return undefined;
    const [x, y] = this.at(event), found = find(view, x, y);
    const edge = y < RULER && this.loopEdge(x);
    this.line.surface.sight.style.cursor = edge ? "ew-resize" : found ? CURSORS[found.handle] : "default";
    return this.line.point(found?.act ?? null, x, y);
  }

  // Over an edge of what is in sight the rest comes into sight.
  beyond(event) {
    const { surface, view } = this.line, [x] = this.at(event), { axis } = view, before = axis.left;
    const over = Math.max(x - axis.width, 0) + Math.min(x, 0);
    if (!over || this.held.kind === "tap") return;
    surface.scrollTo(before + Math.min(Math.max(over, -FASTEST), FASTEST));
    if (this.held.drag) this.held.drag.x -= axis.left - before;
  }

  pulled(event) {
    const { view } = this.line, [x, y] = this.at(event), { kind } = this.held, time = this.time(x);
    if (kind === "scrub") this.line.seek(time, true);
    if (kind === "loop") this.line.loop.set(this.held.from, time);
    if (kind !== "act" || !drag.pull(view, this.held.drag, x, y, event.altKey, event.ctrlKey)) return;
    view.drag = this.held.drag;
    this.line.surface.sight.style.cursor = view.drag.handle === "degree" ? "ns-resize" : "grabbing";
    drag.tell(view, view.drag, false);
    this.line.showDrag(x, y);
  }

  up(event) {
    const { held } = this, { view } = this.line;
    this.held = null;
    if (held?.found && !held.drag?.moved) this.line.choose(held.found.act, true);
    if (held?.kind === "act" && held.drag.moved) {
      drag.tell(view, held.drag, true);
      this.line.choose(held.drag.act, false);
    }
    if (held?.kind === "loop") this.line.loop.settle();
    const elsewhere = held?.kind === "scrub" || held?.kind === "tap" && !held.found;
    if (elsewhere) this.line.seek(this.time(this.at(event)[0]), false);
  }

  // A finger moves the page itself.
  away() {
    this.line.following = false;
    this.cancel();
  }

  cancel() {
    if (this.held?.kind === "act") this.line.letGo();
    this.held = null;
  }

  escape(event) {
    if (event.key !== "Escape" || !this.held) return;
    event.preventDefault();
    event.stopPropagation();
    this.cancel();
  }

  // Another score is there: of the same text, as when a voice has spoken, the act that is held is still there.
  again(found) {
    const { held } = this, act = held?.kind === "act" && found(held.drag.act);
    if (act) return void drag.rebind(this.line.view, held.drag, act);
    if (held?.kind === "act") this.held = null;
    this.line.letGo();
  }

  double(event) {
    const found = find(this.line.view, ...this.at(event));
    if (found) this.line.seek(found.act.start, false);
  }

  time(x) {
    const { axis, score } = this.line.view;
    return Math.min(Math.max(axis.time(x), 0), score.duration);
  }

  // ---------------------------------------------------------------- the loop

  loopEdge(x) {
    const { loop, axis } = this.line.view;
    if (!loop) return null;
    if (Math.abs(x - axis.x(loop.to)) <= GRAB) return { kind: "loop", from: loop.from };
    return Math.abs(x - axis.x(loop.from)) <= GRAB ? { kind: "loop", from: loop.to } : null;
  }

  newLoop(x) { return { kind: "loop", from: this.time(x) }; }

  // ---------------------------------------------------------------- wheel and two fingers

  wheel(event) {
    const [x, y] = this.at(event);
    if (!event.ctrlKey && !event.altKey && y >= RULER) return void (this.line.following = false);
    event.preventDefault();
    this.line.surface.zoom(Math.exp(-event.deltaY * (event.deltaMode ? 0.05 : 0.003)), x);
  }

  touch(event) {
    const { touches } = event;
    if (touches.length !== 2) {
      this.pinch = null;
      if (this.held && this.held.kind !== "tap" && event.cancelable) event.preventDefault();
      return;
    }
    event.preventDefault();
    this.cancel();
    const [[one], [two]] = [this.at(touches[0]), this.at(touches[1])], wide = Math.max(Math.abs(one - two), 10);
    if (this.pinch) this.line.surface.zoom(wide / this.pinch, (one + two) / 2);
    this.pinch = wide;
  }

  // ---------------------------------------------------------------- keys

  rulerKey(event) {
    const { view } = this.line, frame = 1 / (view.score?.film.fps ?? 30), far = event.shiftKey ? STEP : frame;
    const steps = { ArrowLeft: -far, ArrowDown: -far, ArrowRight: far, ArrowUp: far, PageUp: PAGE, PageDown: -PAGE,
      Home: -Infinity, End: Infinity };
    if (!(event.key in steps) || !view.score || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    this.line.seek(Math.min(Math.max(view.time + steps[event.key], 0), view.score.duration), false);
    this.line.follow(true);
  }

  actKey(event) {
    const { view } = this.line;
    if (event.ctrlKey || event.metaKey) return;
    if (event.altKey && /^Arrow/.test(event.key)) return this.nudge(event);
    if (/^Arrow|^Home$|^End$/.test(event.key)) {
      const next = beside(view, event.key);
      if (next) this.line.choose(next, false), this.line.surface.reveal(next);
    } else if (event.key === "Enter" && view.chosen) {
      this.line.choose(view.chosen, true);
      this.line.seek(view.chosen.start, false);
    } else if (event.key === "Escape" && view.chosen) this.line.choose(null, false);
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  // Alt and an arrow move the chosen act by a frame, with shift its end; up and down change how strong it is.
  nudge(event) {
    const { view } = this.line, act = view.chosen, frame = 1 / view.score.film.fps;
    event.preventDefault();
    event.stopPropagation();
    if (!act || view.drag) return;
    const across = { ArrowLeft: -frame, ArrowRight: frame }[event.key];
    const handle = across ? event.shiftKey ? "end" : "body" : "degree", may = act.handles[handle];
    if (!may) return this.line.note.say(FIXED[handle]);
    const pressed = drag.press(view, { act, handle }, 0, 0);
    if (across) pressed.by = across, pressed.ghost = drag.ghost(act, handle, across);
    else pressed.degree = drag.nudged(may, event.key === "ArrowUp" ? 1 : -1);
    view.drag = pressed;
    drag.tell(view, pressed, true);
    this.line.showDrag(view.axis.x(act.start), 0);
  }
}
