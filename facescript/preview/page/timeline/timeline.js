// The messages of the server and the clock to the timeline beneath the face, and what is done on it to messages.
import { Axis } from "./axis.js";
import { Chooser } from "./chooser.js";
import { make } from "./dom.js";
import { report } from "./drag.js";
import { Hands } from "./hands.js";
import { span } from "./paint.js";
import { Reader } from "./reader.js";
import { layOut } from "./rows.js";
import { Surface } from "./surface.js";
import { Tools, keys } from "./tools.js";

const SHORTEST = 0.1;  // seconds of a loop, at least
const TURN = 0.85, BACK = 0.12;  // where in sight the playhead turns the page, and where it then is

export class Timeline {
  // `place` is an element of the page, `wire` and `clock` are the page's own.
  constructor(place, wire, clock) {
    this.wire = wire;
    this.clock = clock;
    this.view = { axis: new Axis(), strips: [], scrolled: 0, height: 0, dense: 1, score: null, version: 0, loop: null, peaks: [],
      words: [], time: 0, lit: [], caret: [], hovered: null, chosen: null, drag: null,
      say: (kind, values) => wire.say(kind, values), letGo: (why) => this.letGo(why) };
    this.curves = new Map();
    this.following = true;
    const bar = make("div", { class: "tl-tools", role: "group", "aria-label": "Timeline tools" });
    this.note = make("div", { class: "tl-note", hidden: true });
    this.spoken = make("div", { class: "tl-hidden", role: "status", "aria-live": "polite" });
    place.append(bar);
    this.surface = new Surface(place, this.view);
    place.append(this.note, this.spoken);
    this.reader = new Reader(this.surface.acts);
    this.tools = new Tools(bar, this);
    this.chooser = new Chooser(this.tools.curves.panel, (face) => this.askCurves(face));
    this.hands = new Hands(this);
    this.surface.scroller.addEventListener("pointerdown", () => { this.following = false; }, { capture: true, passive: true });
    this.surface.scroller.addEventListener("wheel", () => { this.following = false; }, { capture: true, passive: true });
    keys(this);
    this.listen();
  }

  listen() {
    const { wire, clock } = this;
    wire.on("score", (message) => this.showScore(message));
    wire.on("sound", ({ peaks }) => { this.view.peaks = peaks; this.surface.draw(); });
    wire.on("curves", (message) => this.showCurves(message));
    wire.on("lit", ({ from, to }) => this.showCaret(from, to));
    wire.on("would", ({ text }) => { if (this.view.drag) this.view.drag.would = text, this.showDrag(); });
    wire.on("refused", ({ what, why }) => this.letGo([what, why].filter(Boolean).join(": ")));
    wire.on("edited", () => this.letGo());
    clock.watch((time) => this.tick(time));
  }

  // ---------------------------------------------------------------- what is shown

  showScore(message) {
    const { view } = this, before = view.score, chosen = view.chosen;
    const fitted = !before || Math.abs(view.axis.scale - view.axis.fit) < 1e-6;
    view.score = message;
    view.version = message.version;
    view.axis.duration = message.duration;
    view.axis.scale = fitted ? view.axis.fit : Math.max(view.axis.scale, view.axis.fit);
    this.letGo();
    view.hovered = null;
    view.caret = [];
    view.chosen = chosen && again(before, message, chosen);
    if (view.loop) this.setLoop(Math.min(view.loop.from, message.duration - SHORTEST), Math.min(view.loop.to, message.duration));
    this.chooser.lay(message.channels ?? {});
    for (const face of this.curves.keys()) this.askCurves(face);
    this.lay();
    this.reader.lay(view);
    this.light(true);
  }

  lay() {
    this.view.strips = layOut(this.view.score, this.curves).strips;
    this.surface.name();
    this.surface.spread();
  }

  askCurves(face) {
    const channels = this.chooser.names(face);
    if (channels.length) return this.wire.say("curves", { face, channels });
    this.curves.delete(face);
    return this.lay();
  }

  showCurves({ face, channels }) {
    if (!this.chooser.names(face).length) return;
    this.curves.set(face, channels);
    this.lay();
  }

  showCaret(from, to) {
    const acts = this.view.score?.acts ?? [];
    this.view.caret = acts.filter((act) => act.from !== undefined && act.from <= to && act.to >= from);
    this.surface.markLater();
  }

  // ---------------------------------------------------------------- time

  tick(time) {
    const { view } = this;
    view.time = time;
    if (!view.score) return;
    if (this.clock.playing) this.follow(false);
    this.light(false);
    this.surface.markLater();
  }

  // What plays now is lit here, and told to whoever else lights it.
  light(anew) {
    const { view } = this, { time } = view;
    const lit = view.score.acts.filter((act) => act.start <= time && time < act.end && act.end > act.start);
    if (!anew && lit.length === view.lit.length && lit.every((act, number) => act === view.lit[number])) return;
    view.lit = lit;
    const places = lit.filter((act) => act.from !== undefined).map(({ from, to }) => ({ from, to }));
    dispatchEvent(new CustomEvent("facescript-plays", { detail: { version: view.version, places } }));
  }

  // Keeps the playhead in sight while it plays, until the reader scrolls away; `again` brings it back.
  follow(again) {
    if (again) this.following = true;
    const { axis, time } = this.view, x = axis.x(time);
    if (!this.following || axis.whole <= axis.width || x >= 0 && x <= axis.width * TURN) return;
    const left = axis.left + x - axis.width * BACK;
    if (Math.abs(left - axis.left) > 1 && (x < 0 || axis.left + axis.width < axis.whole - 1)) this.surface.scrollTo(left);
  }

  seek(time, dragged) {
    this.clock.seek(time);
    if (!dragged) this.following = true;
  }

  // ---------------------------------------------------------------- loop

  setLoop(one, two) {
    const from = Math.max(0, Math.min(one, two)), to = Math.min(this.view.score.duration, Math.max(one, two));
    this.view.loop = { from, to: Math.max(to, from + 1e-3) };
    this.clock.setLoop(from, this.view.loop.to);
    this.tools.showLoop(this.view.loop, span(this.view, from, to));
    this.surface.draw();
  }

  // A loop that was drawn too short is none.
  endLoop() {
    const { loop } = this.view;
    if (loop.to - loop.from < SHORTEST) this.unloop();
    else if (this.view.time < loop.from || this.view.time > loop.to) this.clock.seek(loop.from);
  }

  unloop() {
    this.last = this.view.loop;
    this.view.loop = null;
    this.clock.setLoop();
    this.tools.showLoop(null);
    this.surface.draw();
  }

  toggleLoop() {
    const { view } = this;
    if (!view.score) return;
    if (view.loop) return void this.unloop();
    const { chosen, score, axis } = view, all = { from: 0, to: score.duration };
    const sight = { from: Math.max(0, axis.time(0)), to: Math.min(score.duration, axis.time(axis.width)) };
    const act = chosen && chosen.end - chosen.start >= SHORTEST && { from: chosen.start, to: chosen.end };
    const { from, to } = act || (this.last?.to <= score.duration && this.last) || (sight.to > sight.from ? sight : all);
    this.setLoop(from, to);
    this.endLoop();
  }

  loopFrom() { if (this.view.score) this.setLoop(this.view.time, this.view.loop?.to > this.view.time ? this.view.loop.to : Infinity); }

  loopTo() { if (this.view.score) this.setLoop(this.view.loop?.from < this.view.time ? this.view.loop.from : 0, this.view.time); }

  // ---------------------------------------------------------------- acts

  choose(act, jump) {
    this.view.chosen = act;
    this.reader.choose(this.view);
    this.surface.markLater();
    if (jump && act?.from !== undefined) this.wire.say("jump", { from: act.from, to: act.to });
  }

  point(act, x = 0, y = 0) {
    if (act !== this.view.hovered) this.surface.markLater();
    this.view.hovered = act;
    if (!this.view.drag) act ? this.showNote(act.note.split("\n"), x, y) : this.hideNote();
  }

  showDrag(x = this.noteX, y = this.noteY) {
    this.showNote(report(this.view, this.view.drag), x, y);
    this.surface.markLater();
  }

  // The drag is over: done, refused with a sentence, or given up.
  letGo(why) {
    clearTimeout(this.view.drag?.given);
    this.view.drag = null;
    if (why) this.say(why);
    else this.hideNote();
    this.surface.markLater();
  }

  undo() {
    this.wire.say("undo");
  }

  // ---------------------------------------------------------------- words beside the pointer

  showNote(lines, x, y) {
    [this.noteX, this.noteY] = [x, y];
    clearTimeout(this.fading);
    this.note.hidden = false;
    this.note.replaceChildren(...lines.map((line) => make("div", {}, line)));
    const { offsetLeft, offsetTop } = this.surface.scroller.offsetParent === this.note.offsetParent
      ? this.surface.scroller : { offsetLeft: 0, offsetTop: 0 };
    const most = this.note.offsetParent.clientWidth - this.note.offsetWidth - 8;
    this.note.style.left = `${Math.max(8, Math.min(offsetLeft + x + 14, most))}px`;
    this.note.style.top = `${offsetTop + y - this.note.offsetHeight - 12}px`;
  }

  hideNote() { this.note.hidden = true; }

  // A sentence to the reader, beside where the pointer was; read out too.
  say(text) {
    this.spoken.textContent = text;
    this.showNote([text], this.noteX ?? 40, this.noteY ?? 40);
    this.fading = setTimeout(() => this.hideNote(), 6000);
  }
}

// The act of a new score that a chosen one has become: of the same lane, nearest in the text and in time.
function again(before, after, act) {
  const lane = before.lanes[act.lane];
  const same = after.acts.filter((each) => after.lanes[each.lane].face === lane.face && after.lanes[each.lane].name === lane.name);
  const far = (each) => Math.abs((each.from ?? 0) - (act.from ?? 0)) + 20 * Math.abs(each.start - act.start);
  return same.reduce((best, each) => !best || far(each) < far(best) ? each : best, null);
}
