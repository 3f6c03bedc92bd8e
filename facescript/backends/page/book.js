// Follows the reading: which chapter it is in, what stands beside the faces now, and where it was left the last time.
(() => {
"use strict";
const player = window.facescript, root = document.documentElement;
const of = (selector) => [...document.querySelectorAll(selector)];
const chapters = of(".fb-chapter"), entries = of(".fb-contents a"), shown = of(".fb-picture, .fb-link");
const beside = document.querySelector(".beside"), bar = document.querySelector(".chapter-now");
const text = document.querySelector("[data-facescript=text]"), steps = of(".chapter-now button");
const start = (element) => Number(element.dataset.start), end = (element) => Number(element.dataset.end);
const calm = matchMedia("(prefers-reduced-motion: reduce)");
let chapter = -1, line = null, touched = -Infinity;

// ---------------------------------------------------------------- chapters

function inChapter(time) {
  const number = Math.max(0, chapters.findLastIndex((each) => start(each) <= time + 1e-3));
  if (number === chapter) return;
  chapter = number;
  for (const entry of entries) entry.removeAttribute("aria-current");
  entries[number]?.setAttribute("aria-current", "true");
  bar.querySelector("span").textContent = chapters[number].querySelector("h2").textContent;
  steps[0].disabled = number === 0;
  steps[1].disabled = number === chapters.length - 1;
}

function go(number) {
  player.seek(start(chapters[number]) + 1e-3);
  chapters[number].scrollIntoView({ behavior: calm.matches ? "auto" : "smooth", block: "start" });
}

bar.hidden = chapters.length < 2;
steps.forEach((button) => button.addEventListener("click", () => go(chapter + Number(button.dataset.step))));
entries.forEach((entry, number) => entry.addEventListener("click", (event) => {
  event.preventDefault();
  history.replaceState(null, "", entry.hash);
  go(number);
}));

// ---------------------------------------------------------------- beside the faces

const copies = new Map(shown.map((each) => [each, each.cloneNode(true)]));

function besides(time) {
  const now = shown.filter((each) => start(each) <= time && time < end(each));
  now.sort((one, other) => one.matches(".fb-link") - other.matches(".fb-link"));
  const wanted = now.map((each) => copies.get(each));
  if (wanted.length === beside.children.length && wanted.every((each, place) => each === beside.children[place])) return;
  for (const each of [...beside.children]) if (!wanted.includes(each)) each.remove();
  wanted.forEach((each, place) => beside.children[place] === each || beside.insertBefore(each, beside.children[place] || null));
}

// ---------------------------------------------------------------- the page scrolls with the text where it is one column

function follow() {
  const now = document.querySelector(".fs-line.now");
  if (!now || now === line) return;
  line = now;
  const alone = text.scrollHeight > text.clientHeight + 1 && getComputedStyle(text).overflowY !== "visible";
  if (alone || !player.playing || performance.now() - touched < 4000) return;
  now.scrollIntoView({ behavior: calm.matches ? "auto" : "smooth", block: "start" });
}

for (const kind of ["wheel", "touchmove"]) addEventListener(kind, () => { touched = performance.now(); }, { passive: true });

// ---------------------------------------------------------------- the place where it was left

const key = `facescript ${document.title} ${player.duration}`;
let kept = performance.now();

function keep() {
  kept = performance.now();
  try { localStorage.setItem(key, player.time < player.duration - 1 ? player.time.toFixed(2) : "0"); } catch { /* it may not */ }
}

function left() {
  const number = chapters.findIndex((each) => `#${each.id}` === location.hash);
  if (number >= 0) return start(chapters[number]) + 1e-3;
  try { return Number(localStorage.getItem(key)) || 0; } catch { return 0; }
}

addEventListener("pagehide", keep);
document.addEventListener("visibilitychange", keep);
root.classList.add("fb-follows");
player.watch((time) => {
  inChapter(time);
  besides(time);
  follow();
  if (player.playing && performance.now() - kept > 2000) keep();
});
const place = left();
player.seek(place);
if (place) chapters[Math.max(0, chapters.findLastIndex((each) => start(each) <= place))].scrollIntoView();
})();
