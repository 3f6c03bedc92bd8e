// The edge between the picture and the timeline, to be dragged: how much of the page's height the timeline may have.
import { make } from "./dom.js";

const LEAST = 20, MOST = 80, USUAL = 44, STEP = 4;  // per cent of the window's height

export function split(place) {
  const edge = make("div", { class: "tl-split", role: "separator", tabindex: "0", "aria-orientation": "horizontal",
    "aria-label": "Height of the timeline", "aria-valuemin": LEAST, "aria-valuemax": MOST });
  let share = USUAL;

  function set(wanted) {
    share = Math.min(Math.max(wanted, LEAST), MOST);
    place.style.setProperty("--tl-share", `${share}vh`);
    edge.setAttribute("aria-valuenow", String(Math.round(share)));
  }

  edge.addEventListener("pointerdown", (event) => {
    edge.setPointerCapture(event.pointerId);
    event.preventDefault();
  });
  edge.addEventListener("pointermove", (event) => {
    const tall = place.getBoundingClientRect().bottom - event.clientY;
    if (edge.hasPointerCapture(event.pointerId)) set(100 * tall / innerHeight);
  });
  edge.addEventListener("dblclick", () => set(USUAL));
  edge.addEventListener("keydown", (event) => {
    const step = { ArrowUp: STEP, ArrowDown: -STEP }[event.key];
    if (!step) return;
    event.preventDefault();
    set(share + step);
  });
  set(USUAL);
  return edge;
}
