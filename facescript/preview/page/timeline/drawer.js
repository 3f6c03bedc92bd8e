// A button and the panel that it opens over the page.
import { make } from "./dom.js";

const AWAY = 20;  // pixels that a panel keeps from the page's top

export class Drawer {
  // `button` opens the panel `id` that bears `name`; `kind` is its class.
  constructor(button, id, name, kind = "") {
    this.button = button;
    this.panel = make("div", { class: `tl-panel ${kind}`, id, hidden: true, role: "group", "aria-label": name });
    this.place = make("span", { class: "tl-more" }, button, this.panel);
    button.setAttribute("aria-expanded", "false");
    button.setAttribute("aria-controls", id);
    button.addEventListener("click", () => this.open(this.panel.hidden));
    document.addEventListener("pointerdown", ({ target }) => this.place.contains(target) || this.open(false));
    this.place.addEventListener("keydown", (event) => {
      if (event.key !== "Escape" || this.panel.hidden) return;
      event.stopPropagation();
      this.open(false);
      button.focus();
    });
  }

  open(open) {
    this.panel.hidden = !open;
    this.panel.style.maxHeight = `${this.button.getBoundingClientRect().top - AWAY}px`;
    this.button.setAttribute("aria-expanded", String(open));
  }
}
