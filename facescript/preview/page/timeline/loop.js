// The stretch of the film that is played again and again: drawn on the ruler, begun and ended by keys, on and off.
import { span } from "./paint.js";

const SHORTEST = 0.1;  // seconds of a loop, at least

export class Loop {
  constructor(line) { this.line = line; }

  set(one, two) {
    const { view, clock, tools, surface } = this.line, { duration } = view.score;
    const from = Math.max(0, Math.min(one, two)), to = Math.max(Math.min(duration, Math.max(one, two)), from + 1e-3);
    view.loop = { from, to };
    clock.setLoop(from, to);
    tools.showLoop(view.loop, span(view, from, to));
    surface.draw();
  }

  // One that was drawn too short is none; else the playhead comes into it.
  settle() {
    const { view, clock } = this.line, { from, to } = view.loop;
    if (to - from < SHORTEST) this.off();
    else if (view.time < from || view.time > to) clock.seek(from);
  }

  off() {
    const { view, clock, tools, surface } = this.line;
    this.last = view.loop;
    view.loop = null;
    clock.setLoop();
    tools.showLoop(null);
    surface.draw();
  }

  // Off, or on: the chosen act, the loop that was last, or what is in sight.
  toggle() {
    const { chosen, score, axis, loop } = this.line.view;
    if (!score) return;
    if (loop) return void this.off();
    const sight = { start: Math.max(0, axis.time(0)), end: Math.min(score.duration, axis.time(axis.width)) };
    const last = this.last && this.last.to <= score.duration ? { start: this.last.from, end: this.last.to } : sight;
    const { start, end } = chosen && chosen.end - chosen.start >= SHORTEST ? chosen : last;
    this.set(start, end);
    this.settle();
  }

  // From the playhead on, or up to it.
  begin() {
    const { score, time, loop } = this.line.view;
    if (score) this.set(time, loop && loop.to > time ? loop.to : score.duration);
  }

  end() {
    const { score, time, loop } = this.line.view;
    if (score) this.set(loop && loop.from < time ? loop.from : 0, time);
  }

  // The film is another: the loop stays in it.
  again() {
    const { view } = this.line, { duration } = view.score;
    if (view.loop) this.set(Math.min(view.loop.from, duration - SHORTEST), view.loop.to);
  }
}
