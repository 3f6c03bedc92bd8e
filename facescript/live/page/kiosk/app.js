// Puts the page together: the wire to the run, its clock, the picture, the sound, captions, and what can be touched.

import { captions } from "./captions.js";
import { clock } from "./clock.js";
import { figure } from "./figure.js";
import { touch } from "./touch.js";
import { voice } from "./voice.js";
import { reached, wire } from "./wire.js";

const STALE = 3000;  // ms without a frame after which the wire is let go, and laid anew
const CALM = 2500;  // ms after which a pointer that does not move is hidden
const WAIT = 1200;  // ms that nothing comes until the page says that it waits

const one = (id) => document.getElementById(id);
const link = wire(reached("live")), time = clock();
const picture = figure(link, one("face")), said = captions(link, one("caption")), offered = touch(link, one("touch"));
const sound = voice(link, time, (heard) => { one("hear").hidden = heard; });

let came = 0, drew = null, connected = false;

link.on("state", ({ state }) => {
  connected = state === "connected";
  if (connected) came = performance.now();
});
link.on("figure", ({ title, pace }) => {
  time.begin(pace);
  drew = null;
  if (title) document.title = title, one("title").textContent = title, one("face").dataset.label = title;
});
link.on("frame", (frame) => { time.came(frame.time), came = performance.now(); });
link.on("line", () => { if (!sound.heard) one("hear").hidden = false; });

function step() {
  requestAnimationFrame(step);
  sound.follow();
  if (!time.ready) return;
  const now = time.now(), number = picture.draw(now);
  if (picture.waiting) sound.still();
  said.show(picture.waiting ? -1 : now);
  if (number !== null && number !== drew) link.say("drew", { number: drew = number });
}

// What the page says of the server: nothing, unless it is gone for a while.
setInterval(() => {
  const silent = performance.now() - came, text = silent < WAIT || document.hidden ? "" : "One moment, please";
  if (one("state").textContent !== text) one("state").textContent = text;
  if (connected && silent > STALE && !document.hidden) link.drop(), came = performance.now();
}, 250);

// ---------------------------------------------------------------- tools

function setCaptions(on) {
  document.body.classList.toggle("silent", !on);
  one("captions-button").setAttribute("aria-pressed", String(on));
  localStorage.setItem("captions", on ? "on" : "off");
}

let calm = 0;
function stirred() {
  document.body.classList.remove("still");
  clearTimeout(calm);
  calm = setTimeout(() => document.body.classList.add("still"), CALM);
}

one("captions-button").onclick = () => setCaptions(document.body.classList.contains("silent"));
one("screen-button").onclick = () => {
  if (document.fullscreenElement) document.exitFullscreen();
  else document.documentElement.requestFullscreen().catch(() => {});
};
one("screen-button").hidden = !document.fullscreenEnabled;
for (const kind of ["pointerdown", "keydown"]) addEventListener(kind, () => { sound.begin(), stirred(); }, true);
addEventListener("pointermove", stirred);
document.addEventListener("visibilitychange", () => { came = performance.now(); });

setCaptions(localStorage.getItem("captions") !== "off");
stirred();
requestAnimationFrame(step);
link.open();
window.facescript = { time, picture, sound, offered, link };  // for tests, and for who looks at the page from its console
