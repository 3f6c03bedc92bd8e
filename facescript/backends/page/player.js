// Plays the sound, draws the face at the sound's own time (face.js), and serves whatever controls and words the page
// has: elements with data-facescript="play", "seek" and so on.
const all = (name) => [...document.querySelectorAll(`[data-facescript="${name}"]`)];
const audio = one("sound"), duration = film.duration, watchers = [];

// ---------------------------------------------------------------- the clock

const COARSEST = 0.25;  // seconds from one step to the next of the slowest clocks
const FURTHEST = 0.006;  // seconds that are added to a clock that stands: it may do so because the sound does
const LEAD = 0.008;  // seconds until what is drawn is seen, half a frame at least
const clock = { at: 0, since: performance.now(), pace: 0, rate: 1, playing: false };

// The sound's time now. Some browsers bring it forward in steps: between two, what has passed since the last is added,
// but little, and no more than passed between the two before: a sound that stands still must not be run ahead of.
function now() {
  const passed = (performance.now() - clock.since) / 1000;
  if (audio && audio.seeking) return clock.at;
  if (audio && audio.currentTime !== clock.at) {
    clock.pace = audio.currentTime > clock.at && passed < COARSEST ? passed : 0;
    clock.at = audio.currentTime, clock.since = performance.now();
    return clock.at;
  }
  const more = clock.playing ? Math.min(passed, audio ? Math.min(clock.pace, FURTHEST) : Infinity) * clock.rate : 0;
  return Math.min(clock.at + more, duration);
}

function keep(time) {
  clock.at = time, clock.since = performance.now(), clock.pace = 0;
}

function seek(time) {
  const to = Math.min(Math.max(time, 0), duration);
  keep(to);
  if (audio) audio.currentTime = to;
  redraw();
}

function play() {
  if (now() >= duration - 0.05) seek(0);
  if (audio) return void audio.play().catch(() => started(false));
  keep(now());
  started(true);
}

function pause() {
  if (audio) return audio.pause();
  keep(now());
  started(false);
}

function started(playing) {
  keep(audio ? audio.currentTime : clock.at);
  if (clock.playing !== playing) (clock.playing = playing) && requestAnimationFrame(step);
  document.documentElement.classList.toggle("fs-playing", playing);
  if (playing) document.documentElement.classList.add("fs-begun");
  for (const button of all("play")) label(button, playing ? "Pause" : "Play");
  redraw();
}

function step() {
  if (!clock.playing) return;
  show(Math.min(now() + LEAD * clock.rate, duration));
  if (!audio && now() >= duration) pause();
  else requestAnimationFrame(step);
}

let due = false;
function redraw() {
  if (!due) due = requestAnimationFrame(() => { due = false; show(now()); });
}

function show(time) {
  draw(time);
  follow(time);
  for (const watch of watchers) watch(time);
  if (audio && audio.seeking) redraw();  // where the sound comes to is known at the end
}

// ---------------------------------------------------------------- controls

const two = (number) => String(number).padStart(2, "0");
const written = (time) => {
  const s = Math.floor(time + 1e-3), hours = Math.floor(s / 3600), rest = `${two(s % 60)}`;
  return hours ? `${hours}:${two(Math.floor(s / 60) % 60)}:${rest}` : `${Math.floor(s / 60)}:${rest}`;
};
const SPEEDS = [0.5, 0.75, 1, 1.25, 1.5, 1.75, 2];
const told = one("told");
let second = -1, holding = false;

function label(element, text) {
  element.setAttribute("aria-label", text);
  element.title = text + (element.dataset.key ? ` (${element.dataset.key})` : "");
}

function tell(text) {
  if (told) told.textContent = text;
}

function setSpeed(rate) {
  keep(now());
  clock.rate = rate;
  if (audio) audio.playbackRate = rate;
  for (const choice of all("speed")) choice.value = String(rate);
}

function setVolume(volume, muted) {
  if (!audio) return;
  audio.volume = Math.min(Math.max(volume, 0), 1), audio.muted = muted;
  document.documentElement.classList.toggle("fs-muted", muted || !audio.volume);
  for (const slider of all("volume")) fillTo(slider, muted ? 0 : audio.volume);
  for (const button of all("mute")) label(button, muted ? "Sound on" : "Sound off");
}

function setCaptions(on) {
  document.documentElement.classList.toggle("fs-captioned", on);
  for (const button of all("captions")) button.setAttribute("aria-pressed", String(on));
}

function fillTo(slider, value) {
  slider.value = value;
  slider.style.setProperty("--done", `${100 * (value - slider.min) / (slider.max - slider.min || 1)}%`);
}

function tellTime(time) {
  const whole = Math.floor(time);
  if (!holding) for (const slider of all("seek")) fillTo(slider, time);
  if (whole === second) return;
  second = whole;
  for (const clock_ of all("time")) clock_.textContent = `${written(time)} / ${written(duration)}`;
  for (const slider of all("seek")) slider.setAttribute("aria-valuetext", `${written(time)} of ${written(duration)}`);
}

const KEYS = {
  " ": () => clock.playing ? pause() : play(), k: () => KEYS[" "](),
  ArrowLeft: () => skip(-5), ArrowRight: () => skip(5), j: () => skip(-10), l: () => skip(10),
  Home: () => skip(-Infinity), End: () => skip(Infinity),
  ArrowUp: () => louder(0.1), ArrowDown: () => louder(-0.1),
  m: () => audio && setVolume(audio.volume, !audio.muted),
  c: () => { setCaptions(!captioned()); tell(captioned() ? "Captions on" : "Captions off"); },
  "+": () => faster(1), "=": () => faster(1), "-": () => faster(-1), f: () => wholeScreen(),
};
const captioned = () => document.documentElement.classList.contains("fs-captioned");

function skip(seconds) {
  seek(now() + seconds);
  tell(written(clock.at));
}

function faster(steps) {
  const at = SPEEDS.indexOf(clock.rate) + steps;
  if (SPEEDS[at]) setSpeed(SPEEDS[at]), tell(`Speed ${SPEEDS[at]}`);
}

function louder(step_) {
  if (audio) setVolume(Math.round(20 * (audio.volume + step_)) / 20, false);
}

function wholeScreen() {
  const screen = one("screen") || place;
  if (document.fullscreenElement) document.exitFullscreen();
  else if (screen.requestFullscreen) screen.requestFullscreen().catch(() => {});
}

document.addEventListener("keydown", (event) => {
  const act = KEYS[event.key.length === 1 ? event.key.toLowerCase() : event.key], target = event.target;
  if (!act || event.ctrlKey || event.altKey || event.metaKey || event.defaultPrevented) return;
  if (target.closest("select, textarea, [contenteditable], input:not([type=range])")) return;
  if (event.key === " " && target.closest("button, a, summary")) return;
  if (target.matches("[data-facescript=volume]") && event.key.startsWith("Arrow")) return;
  if (event.key.startsWith("Arrow") && /Up|Down/.test(event.key) && !target.closest("[data-facescript]")) return;
  event.preventDefault();
  act();
});

const on = (name, kind, act) => all(name).forEach((element) => element.addEventListener(kind, (event) => act(element, event)));
on("play", "click", KEYS[" "]);
on("mute", "click", KEYS.m);
on("captions", "click", KEYS.c);
on("screen-button", "click", wholeScreen);
on("speed", "change", (choice) => setSpeed(Number(choice.value)));
on("volume", "input", (slider) => setVolume(Number(slider.value), false));
on("seek", "input", (slider) => { holding = true; fillTo(slider, slider.value); seek(Number(slider.value)); });
on("seek", "change", () => { holding = false; });
on("face", "click", (element, event) => event.target.closest("button, a") || KEYS[" "]());

// ---------------------------------------------------------------- words

const words = [...document.querySelectorAll(".fs-word")];
const starts = words.map((word) => Number(word.dataset.start)), ends = words.map((word) => Number(word.dataset.end));
const order = words.map((word, number) => number).sort((one_, two_) => starts[one_] - starts[two_]);
const cues = words.flatMap((word, number) => "cue" in word.dataset ? [number] : []);
const LINGER = 0.6;  // seconds that a caption stays when nothing is said
let lit, cue, touched = 0;

// The last of a rising list that is not above a value; -1 where there is none.
function lastOf(list, value, key = (each) => each) {
  let low = -1, high = list.length;
  while (high - low > 1) key(list[low + high >> 1]) <= value ? low = low + high >> 1 : high = low + high >> 1;
  return low;
}

function follow(time) {
  tellTime(time);
  const [, headline] = film.headlines[lastOf(film.headlines, time + 1e-3, ([start]) => start)];
  for (const element of all("headline")) if (element.textContent !== headline) element.textContent = headline;
  const number = order[lastOf(order, time + 1e-3, (each) => starts[each])] ?? -1;
  const word = time < ends[number] ? words[number] : undefined;
  if (word !== lit) {
    if (lit) lit.classList.remove("now");
    if (word) word.classList.add("now"), reveal(word);
    lit = word;
  }
  caption(number, time);
}

function reveal(word) {
  const line = word.closest(".fs-line"), text = line && line.closest("[data-facescript=text]");
  for (const other of document.querySelectorAll(".fs-line.now")) if (other !== line) other.classList.remove("now");
  if (!line) return;
  line.classList.add("now");
  if (!text || !clock.playing || performance.now() - touched < 4000) return;
  const own = text.scrollHeight > text.clientHeight + 1 && getComputedStyle(text).overflowY !== "visible";
  const top = own ? text.getBoundingClientRect().top : stuck(), bottom = own ? top + text.clientHeight : innerHeight;
  const at = word.getBoundingClientRect();
  if (top < 0 || at.top > top + 24 && at.bottom < top + (bottom - top) * 0.7) return;
  const calm = matchMedia("(prefers-reduced-motion: reduce)").matches;
  (own ? text : window).scrollBy({ top: at.top - top - (bottom - top) * 0.3, behavior: calm ? "auto" : "smooth" });
}

// Where a page begins below its screen, if that stays in sight while the page scrolls; else -1.
function stuck() {
  const screen = one("screen");
  return screen && getComputedStyle(screen).position === "sticky" ? screen.getBoundingClientRect().bottom : -1;
}

function caption(number, time) {
  const at = number < 0 ? -1 : lastOf(cues, number), first = cues[at], last = (cues[at + 1] ?? words.length) - 1;
  const shown = at >= 0 && time < Math.max(...ends.slice(first, last + 1)) + LINGER ? at : -1;
  if (shown !== cue) {
    cue = shown;
    for (const box_ of all("caption")) box_.replaceChildren(...(shown < 0 ? [] : cueNodes(first, last)));
  }
  for (const box_ of all("caption")) for (const each of box_.querySelectorAll("[data-word]"))
    each.classList.toggle("now", words[each.dataset.word] === lit);
}

// The words of a caption with all that is written between them.
function cueNodes(first, last) {
  const range = document.createRange(), line = document.createElement("span");
  range.setStartBefore(words[first]);
  const after = words[last].nextSibling;
  if (after && after.nodeType === Node.TEXT_NODE) range.setEndAfter(after); else range.setEndAfter(words[last]);
  line.append(range.cloneContents());
  line.lang = words[first].closest("[lang]").lang;
  [...line.querySelectorAll(".fs-word")].forEach((each, place_) => { each.dataset.word = first + place_; });
  return [line];
}

document.addEventListener("click", (event) => {
  const word = event.target.closest(".fs-word, .fs-from");
  if (word) seek(Number(word.dataset.start) + (word.matches(".fs-word") ? 0.001 : 0));
});
for (const kind of ["wheel", "touchmove"])
  addEventListener(kind, () => { touched = performance.now(); }, { passive: true });

// ---------------------------------------------------------------- beginning

if (audio) {
  audio.addEventListener("playing", () => started(true));
  for (const kind of ["pause", "ended"]) audio.addEventListener(kind, () => started(false));
  for (const kind of ["seeked", "waiting", "ratechange"]) audio.addEventListener(kind, redraw);
  audio.addEventListener("ratechange", () => { clock.rate = audio.playbackRate; });
  audio.addEventListener("error", () => tell("The sound cannot be played"));
}
document.documentElement.classList.toggle("fs-silent", !audio);
for (const slider of all("seek")) slider.max = duration;
setVolume(1, false);
setCaptions(captioned());
// What a page's own script may use, and what data files call.
window.facescript = {
  play, pause, seek, duration,
  get time() { return now(); },
  get drawn() { return drawn; },
  get playing() { return clock.playing; },
  watch(act) { watchers.push(act); },
  part(number, text) { waiting.get(number)(text); },
};
faces().then(() => new ResizeObserver(fitCanvas).observe(place));
