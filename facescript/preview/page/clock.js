// The time of the film: that of the sound while there is one, else that of the page; playing, speed, a stretch to loop.

const COARSEST = 0.25;  // seconds from one step to the next of the slowest clocks
const FURTHEST = 0.006;  // seconds that are added to a clock that stands: it may do so because the sound does
const LEAD = 0.008;  // seconds until what is drawn is seen, half a frame at least

// A clock over `audio`, an element without a source or with the film's sound. `watch(act)` calls `act` with the time of
// each frame that is to be drawn, `changed(act)` when playing, speed, loop or duration are others.
export function clock(audio) {
  const watchers = [], listeners = [];
  let at = 0, since = performance.now(), pace = 0, rate = 1, playing = false, duration = 0, loop = null;
  let sounding = false, wanted = null, due = false;

  // Some browsers bring the sound's time forward in steps: between two, what has passed since the last is added, but
  // little, and no more than passed between the two before: a sound that stands still must not be run ahead of.
  function now() {
    const passed = (performance.now() - since) / 1000;
    if (sounding && (audio.seeking || wanted !== null)) return at;
    if (sounding && audio.currentTime !== at) {
      pace = audio.currentTime > at && passed < COARSEST ? passed : 0;
      at = audio.currentTime, since = performance.now();
      return at;
    }
    const most = sounding ? Math.min(pace, FURTHEST) : Infinity;
    return Math.min(at + (playing ? Math.min(passed, most) * rate : 0), duration);
  }

  const keep = (time) => { at = time, since = performance.now(), pace = 0; };
  const tell = () => listeners.forEach((act) => act());

  function seek(time) {
    const to = Math.min(Math.max(time, 0), duration);
    keep(to);
    if (sounding && wanted === null) audio.currentTime = to;
    else if (wanted !== null) wanted = to;
    redraw();
  }

  function play() {
    if (playing) return;
    const [first, last] = loop || [0, duration];
    if (now() >= last - 0.05 || now() < first) seek(first);
    keep(now());
    playing = true;
    if (sounding && wanted === null) audio.play().catch(() => pause());
    tell();
    requestAnimationFrame(step);
  }

  function pause() {
    if (!playing) return;
    const time = now();
    playing = false;
    if (sounding) audio.pause();
    keep(time);
    tell();
    redraw();
  }

  function step() {
    if (!playing) return;
    const time = now(), last = loop ? loop[1] : duration;
    if (loop && time >= last) seek(loop[0]);
    else if (time >= last - 1e-3 || (sounding && audio.ended)) return pause();
    show(Math.min(now() + LEAD * rate, duration));
    requestAnimationFrame(step);
  }

  function redraw() {
    if (!due && !playing) due = requestAnimationFrame(() => { due = false; show(now()); });
  }

  function show(time) {
    for (const watch of watchers) watch(time);
    if (sounding && audio.seeking && !playing) redraw();  // where the sound comes to is known at the end
  }

  // Another sound, or none: it goes on from where the film is.
  function setSound(url) {
    const time = now();
    keep(time);
    sounding = false, wanted = null;
    audio.pause();
    if (!url) return void audio.removeAttribute("src");
    sounding = true, wanted = time;
    audio.src = url;
    audio.onloadedmetadata = () => {
      const to = wanted ?? at;
      wanted = null;
      audio.currentTime = to, audio.playbackRate = rate;
      if (playing) audio.play().catch(() => pause());
    };
    audio.onerror = () => { keep(now()); sounding = false, wanted = null; };
  }

  audio.addEventListener("seeked", redraw);
  return {
    now, seek, play, pause, redraw, setSound,
    get playing() { return playing; },
    get duration() { return duration; },
    get rate() { return rate; },
    get loop() { return loop; },
    setRate(value) { keep(now()); rate = value; if (sounding) audio.playbackRate = value; tell(); },
    setLoop(first, last) { loop = last > first ? [first, last] : null; tell(); },
    setDuration(value) { duration = value; if (loop && loop[0] >= value) loop = null; tell(); },
    watch(act) { watchers.push(act); },
    changed(act) { listeners.push(act); },
  };
}
