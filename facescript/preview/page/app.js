// Puts the page together: the wire to the server, the clock, the picture, and what stands around it.

import { clock } from "./clock.js";
import { controls } from "./controls.js";
import { faults } from "./faults.js";
import { figure } from "./figure.js";
import { source } from "./source.js";
import { Timeline } from "./timeline/timeline.js";
import { reached, wire } from "./wire.js";

const AGAIN = 250;  // ms between two words to the server of where the playhead is

const one = (id) => document.getElementById(id);
const link = wire(reached("live"));
const time = clock(one("sound"));
const picture = figure(link, one("face"), () => time.redraw());
const jump = (from, to) => link.say("jump", { from, to });

time.watch((now) => one("face").classList.toggle("waiting", !picture.draw(now)));
controls(time, one("controls"));
const line = new Timeline(one("timeline"), link, time);
faults(link, one("faults"), line.tools.place, jump);
source(link, one("source"), one("source-button"), time);

link.on("state", ({ state }) => {
  one("state").textContent = state === "connected" ? "" : "the server is gone; looking for it";
});
link.on("script", ({ name }) => { one("name").textContent = name; document.title = `${name} - FaceScript`; });
link.on("score", ({ duration, playhead, was }) => {
  time.setDuration(duration);
  if (playhead !== null && Math.abs(playhead - was) > 1e-6) time.seek(playhead + (time.playing ? time.now() - was : 0));
  else if (time.now() > duration) time.seek(duration);
  time.redraw();
});

// An editor asks to be shown the film from a moment on, maybe before there is one.
let asked = null;
const begin = () => {
  if (asked === null || !time.duration) return;
  time.seek(asked);
  asked = null;
  time.play();
};
link.on("play", (message) => { asked = message.time; begin(); });
link.on("score", begin);
link.on("sound", ({ url }) => time.setSound(url));

// The server draws what is near to the playhead first.
let said = -1;
setInterval(() => {
  const now = time.now();
  if (now === said) return;
  said = now;
  link.say("playhead", { time: now, playing: time.playing });
}, AGAIN);
link.on("state", () => { said = -1; });

link.open();
window.facescript = { time, picture, link, line };  // for tests, and for who looks at the page from its console
