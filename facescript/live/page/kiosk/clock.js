// The run's time to the page's own. A frame that nothing held up on its way came with the least delay: the frames of the
// last seconds say by how much the run's clock is ahead of the page's.

const KEPT = 12, EACH = 500;  // spans that are kept, and ms of each
const PACE = 0.02;  // seconds by which what is shown comes nearer to what it should be, in each second
const TOO_FAR = 0.25;  // seconds: what is off by more is set at once
const BUFFER = 2.5;  // frames that are held back, so that one that comes late is there when it is drawn
const SPARE = 0.1;  // seconds that are waited for what comes late, at most
const MORE = 0.001, LESS = 0.0001;  // of them with each frame that comes too late to be drawn in its time, and with others
const EASED = 0.9;  // what is left of them with each line that is in time
const LONGEST = 0.25;  // seconds that a picture waits for its sound to come out of the machine, at most

export function clock() {
  let spans = [], since = 0, frame = 1 / 60, sounding = 0, spare = 0, shift = null, held = false;  // `shift`: of the run's time that is shown

  // A frame of a time of the run has come.
  function came(time) {
    const now = performance.now(), found = time - now / 1000, last = spans[spans.length - 1];
    if (last && now - last.from < EACH) last.ahead = Math.max(last.ahead, found);
    else spans = [...spans.slice(1 - KEPT), { from: now, ahead: found }];
    const late = shift !== null && time < now / 1000 + shift;
    spare = Math.min(Math.max(spare + (late ? MORE : -LESS), 0), SPARE);
    const wanted = Math.max(...spans.map((span) => span.ahead)) - BUFFER * frame - sounding - spare;
    const off = wanted - shift, most = PACE * (now - since) / 1000;
    if (shift === null || spans.length < 2 || Math.abs(off) > TOO_FAR) shift = wanted;
    else if (!held) shift += Math.sign(off) * Math.min(Math.abs(off), most);
    since = now;
  }

  return {
    came,
    // Begins anew: a run of so many frames a second.
    begin(fps) { spans = [], shift = null, frame = 1 / fps; },
    // The picture waits until the sound of the same time is heard, so many seconds after it is played.
    wait(seconds) { sounding = Math.min(seconds, LONGEST); },
    // A line came so many seconds too late to be heard from its start with its mouth: the next shall not.
    late(seconds) { spare = seconds > 0 ? Math.min(spare + seconds, SPARE) : spare * EASED; },
    // While a line sounds nothing comes nearer: its mouth stays with it.
    hold(on) { held = on; },
    get ready() { return shift !== null; },
    // The time of the run that is shown now.
    now() { return performance.now() / 1000 + shift; },
    // When a time of the run is shown, in ms of the page.
    when(time) { return (time - shift) * 1000; },
  };
}
