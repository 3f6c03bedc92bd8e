// The messages of the server and the clock to the timeline beneath the face, and what is done on it to messages.
import { Axis } from "./axis.js";
import { Chooser } from "./chooser.js";
import { make } from "./dom.js";
import { report } from "./drag.js";
import { below } from "./find.js";
import { Hands } from "./hands.js";
import { Loop } from "./loop.js";
import { Note } from "./note.js";
import { Reader } from "./reader.js";
import { layOut } from "./rows.js";
import { split } from "./split.js";
import { Surface } from "./surface.js";
import { Tools, keys } from "./tools.js";

const TURN = 0.85, BACK = 0.12;  // where in sight the playhead turns the page, and where it then is

const SOON = 3000;  // ms until what an edit makes of the film is there

export class Timeline {
  // `place` is an element of the page, `wire` and `clock` are the page's own.
  constructor(place, wire, clock) {
    this.wire = wire;
    this.clock = clock;
    this.view = { axis: new Axis(), strips: [], scrolled: 0, height: 0, dense: 1,  // where things are
      score: null, version: 0, peaks: [], words: [],  // what there is
      time: 0, playing: false, loop: null, lit: [],  // what plays
      caret: [], hovered: null, chosen: null, drag: null,  // what is meant
      say: (kind, values) => wire.say(kind, values), letGo: (why) => this.letGo(why) };
    this.curves = new Map();
    this.following = true;
    this.text = "";
    const bar = make("div", { class: "tl-tools", role: "group", "aria-label": "Timeline tools" });
    place.append(split(place), bar);
    this.surface = new Surface(place, this.view);
    this.note = new Note(place, this.surface.scroller);
    this.loop = new Loop(this);
    this.reader = new Reader(this.surface.acts);
    this.tools = new Tools(bar, this);
    this.chooser = new Chooser(this.tools.curves.panel, (face) => this.askCurves(face));
    this.hands = new Hands(this);
    keys(this);
    this.listen();
  }

  listen() {
    const { wire, clock } = this;
    wire.on("score", (message) => this.showScore(message));
    wire.on("sound", ({ peaks }) => { this.view.peaks = peaks; this.surface.draw(); });
    wire.on("curves", (message) => this.showCurves(message));
    wire.on("lit", ({ from, to }) => this.showCaret(from, to));
    wire.on("script", ({ text, version }) => { Object.assign(this, { text, version }); });
    wire.on("would", (edit) => this.answer(written(this.text, edit)));
    wire.on("refused", ({ what, why }) => this.answer(why) || this.letGo([what, why].filter(Boolean).join(": ")));
    wire.on("edited", () => this.edited());
    clock.watch((time) => this.tick(time));
    clock.changed(() => { if (clock.playing) this.following = true; });
  }

  // ---------------------------------------------------------------- what is shown

  showScore(message) {
    const { view } = this, before = view.score, chosen = view.chosen, same = view.version === message.version;
    const fitted = !before || Math.abs(view.axis.scale - view.axis.fit) < 1e-6;
    view.score = message;
    view.version = message.version;
    view.axis.duration = message.duration;
    view.axis.scale = fitted ? view.axis.fit : Math.max(view.axis.scale, view.axis.fit);
    this.hands.again(same ? (act) => again(before, message, act) : () => null);
    view.hovered = null;
    view.caret = [];
    view.chosen = chosen && again(before, message, chosen);
    this.loop.again();
    this.chooser.lay(message.channels ?? {});
    for (const face of this.curves.keys()) this.askCurves(face);
    this.lay();
    this.reader.lay(view);
    this.turns = turns(message);
    this.step = null;
    this.light();
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

  // Whether the timeline shows the script as it is now: its acts can be dragged.
  get fresh() { return this.view.version === this.version; }

  // ---------------------------------------------------------------- time

  tick(time) {
    const { view } = this;
    Object.assign(view, { time, playing: this.clock.playing });
    if (!view.score) return;
    if (this.clock.playing) this.follow(false);
    this.surface.placeHead();
    if (this.light()) this.surface.markLater();
  }

  // What plays now is lit; answers whether anything began or ended since, an act or a word.
  light() {
    const { view } = this, { time } = view, step = below(this.turns, time);
    if (step === this.step) return false;
    this.step = step;
    view.lit = view.score.acts.filter((act) => act.start <= time && time < act.end && act.end > act.start);
    return true;
  }

  // Keeps the playhead in sight while it plays, until the reader scrolls away; `again` brings it back.
  follow(again) {
    if (again) this.following = true;
    const { axis, time } = this.view, x = axis.x(time);
    if (!this.following || !axis.width || axis.whole <= axis.width || x >= 0 && x <= axis.width * TURN) return;
    const left = axis.left + x - axis.width * BACK;
    const more = x < 0 || axis.left + axis.width < axis.whole - 1;
    if (more && Math.abs(left - axis.left) > 1) this.surface.scrollTo(left);
  }

  seek(time, dragged) {
    this.clock.seek(time);
    if (!dragged) this.following = true;
  }

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
    if (!this.view.drag) act ? this.note.hint(act.note.split("\n"), x, y) : this.note.hide();
  }

  showDrag(x, y) {
    this.note.show(report(this.view, this.view.drag), x, y);
    this.surface.markLater();
  }

  // What the server says of a drag that goes on; false where none does.
  answer(text) {
    const { drag } = this.view;
    if (!drag || drag.given) return false;
    drag.would = text;
    this.showDrag();
    return true;
  }

  // The bar stays where it was dragged to until the score that comes of it is there, if one does.
  edited() {
    const { drag } = this.view;
    if (!drag?.given) return;
    clearTimeout(drag.given);
    drag.given = setTimeout(() => this.letGo(), SOON);
    this.note.hide();
  }

  // The drag is over: done, refused with a sentence, or given up.
  letGo(why) {
    clearTimeout(this.view.drag?.given);
    this.view.drag = null;
    if (why) this.note.say(why);
    else this.note.hide();
    this.surface.markLater();
  }

  undo() {
    this.wire.say("undo");
  }
}

// All times at which an act or a word begins or ends.
function turns({ acts, lines }) {
  const parts = [...acts, ...lines.flatMap(({ words }) => words)];
  return Float64Array.from(parts.flatMap(({ start, end }) => [start, end])).sort();
}

// The line of a text that an edit makes.
function written(text, { from, to, text: inside }) {
  const whole = text.slice(0, from) + inside + text.slice(to), at = from + inside.search(/\S|$/);
  const end = whole.indexOf("\n", at);
  return whole.slice(whole.lastIndexOf("\n", at - 1) + 1, end < 0 ? undefined : end).trim();
}

// The act of a new score that a chosen one has become: of the same lane, nearest in the text and in time.
function again(before, after, act) {
  const { face, name } = before.lanes[act.lane];
  const same = after.acts.filter(({ lane }) => after.lanes[lane].face === face && after.lanes[lane].name === name);
  const far = (each) => Math.abs((each.from ?? 0) - (act.from ?? 0)) + 20 * Math.abs(each.start - act.start);
  return same.reduce((best, each) => !best || far(each) < far(best) ? each : best, null);
}
