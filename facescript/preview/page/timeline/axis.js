// Times to pixels and back, and the times that are worth a mark.

const ROUND = [0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800,
  3600];  // seconds from one mark to the next
const APART = 74;  // pixels from one mark to the next, at least
const LONG = 120;  // seconds from which on times are minutes and seconds
const WIDEST = 12e6;  // pixels of a whole film: browsers end at some 16 million
const CLOSEST = 3000;  // pixels of a second

export const PAD = 16;  // pixels before 0 s and after the end, so that edges there can be taken hold of

export class Axis {
  constructor() {
    this.scale = 0;  // pixels a second; 0 until the first film is there
    this.left = 0;  // pixels that are scrolled away
    this.width = 0;  // pixels in sight
    this.duration = 0;  // seconds
  }

  x(time) { return PAD + time * this.scale - this.left; }

  time(x) { return (x + this.left - PAD) / this.scale; }

  get whole() { return 2 * PAD + this.duration * this.scale; }

  get fit() { return Math.max(1, this.width - 2 * PAD) / Math.max(this.duration, 1e-3); }

  get most() { return Math.max(this.fit, Math.min(CLOSEST, WIDEST / Math.max(this.duration, 1e-3))); }

  // Sets the scale, with the time at `x` staying there; answers how far to scroll then.
  zoom(scale, x) {
    const time = this.time(x);
    this.scale = Math.min(Math.max(scale, this.fit), this.most);
    this.left = Math.max(0, PAD + time * this.scale - x);
    return this.left;
  }

  // Marks in sight: those with a name every `step`, and `parts` of a step between them.
  marks() {
    const step = ROUND.find((each) => each * this.scale >= APART) ?? 3600;
    const parts = [10, 5, 4, 2].find((each) => step * this.scale / each >= 9) ?? 1;
    const first = Math.max(0, Math.floor(this.time(0) / step)), found = [];
    for (let n = first; n * step <= Math.min(this.time(this.width), this.duration) + 1e-9; n++) {
      found.push({ time: n * step, name: written(n * step, step, this.duration) });
    }
    return { marks: found, step, parts };
  }
}

// A time as 2.5, or in what is long as 1:30.
export function written(time, step = 0.001, duration = 0) {
  const decimals = Math.max(0, Math.ceil(-Math.log10(step) - 1e-9));
  if (duration < LONG) return time.toFixed(decimals);
  const whole = Number(time.toFixed(decimals)), minutes = Math.floor(whole / 60);
  return `${minutes}:${(whole - 60 * minutes).toFixed(decimals).padStart(decimals ? decimals + 3 : 2, "0")}`;
}
