// The player's buttons and keys.

const OFTEN = 0.1;  // seconds of the film from one number to the next while it plays: each lays the page out anew
const SPEEDS = [0.25, 0.5, 1, 1.5, 2];

export function controls(time, place) {
  place.innerHTML = `
    <button type="button" data-play aria-keyshortcuts="Space">Play</button>
    <input type="range" min="0" max="1" step="any" value="0" aria-label="Time" data-seek>
    <span class="time" data-time>0.00 / 0.00 s</span>
    <label>Speed <select data-speed>${SPEEDS.map((each) => `<option value="${each}">${each}×</option>`).join("")}
    </select></label>`;
  const one = (name) => place.querySelector(`[data-${name}]`);
  const [button, slider, told, speed] = ["play", "seek", "time", "speed"].map(one);
  let holding = false, shown = "";

  const toggle = () => time.playing ? time.pause() : time.play();
  button.addEventListener("click", toggle);
  slider.addEventListener("input", () => { holding = true; time.seek(Number(slider.value)); });
  slider.addEventListener("change", () => { holding = false; });
  speed.addEventListener("change", () => time.setRate(Number(speed.value)));
  document.addEventListener("keydown", (event) => {
    if (event.defaultPrevented || event.ctrlKey || event.altKey || event.metaKey) return;
    if (event.target.closest("input:not([type=range]), select, textarea, button, a, [contenteditable]")) return;
    const act = { " ": toggle, Home: () => time.seek(0), End: () => time.seek(time.duration) }[event.key];
    if (act) event.preventDefault(), act();
  });

  let last = -1;
  time.watch((now) => {
    if (time.playing && Math.abs(now - last) < OFTEN) return;
    last = now;
    if (!holding) slider.value = now;
    const text = `${now.toFixed(2)} / ${time.duration.toFixed(2)} s`;
    if (text !== shown) told.textContent = shown = text;
  });
  time.changed(() => {
    button.textContent = time.playing ? "Pause" : "Play";
    slider.max = time.duration;
    speed.value = String(time.rate);
  });
  speed.value = "1";
}
