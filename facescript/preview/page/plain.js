// A place in the page and a text to a plain text field: what stands in for editor.js where that was not built. It offers
// the same, but no colours and no help.
export class PlainEditor {
  #area = document.createElement("textarea");
  #band = document.createElement("div");
  #lit = [];
  #telling = false;

  constructor(place, { text, label, editable, edited, caret, save }) {
    Object.assign(this.#area, { value: text, readOnly: !editable, spellcheck: false, wrap: "off", className: "plain-text" });
    this.#area.setAttribute("aria-label", label);
    this.#band.className = "plain-lit";
    this.#area.addEventListener("input", () => this.#telling || edited());
    this.#area.addEventListener("click", () => caret(this.#area.selectionStart));
    this.#area.addEventListener("keyup", ({ key }) => { if (/^(Arrow|Page|Home|End)/.test(key)) caret(this.#area.selectionStart); });
    this.#area.addEventListener("keydown", (event) => {
      if (!(event.ctrlKey || event.metaKey) || event.key !== "s") return;
      event.preventDefault();
      save();
    });
    this.#area.addEventListener("scroll", () => this.#place());
    place.append(this.#band, this.#area);
  }

  get text() {
    return this.#area.value;
  }

  // By a command of the browser's, so that its undo knows of it; the caret stays with its words.
  replace(from, to, insert) {
    const area = this.#area, active = document.activeElement, longer = insert.length - (to - from), top = area.scrollTop;
    const kept = [area.selectionStart, area.selectionEnd].map((at) => at <= from ? at : Math.max(at + longer, from));
    const open = area.readOnly;
    this.#telling = true;
    area.readOnly = false;
    area.focus({ preventScroll: true });
    area.setSelectionRange(from, to);
    document.execCommand(insert ? "insertText" : "delete", false, insert);
    area.setSelectionRange(...kept);
    if (active !== area) area.blur(), active?.focus?.({ preventScroll: true });
    area.readOnly = open, area.scrollTop = top;
    this.#telling = false;
  }

  light(stretches) {
    this.#lit = stretches;
    this.#place();
  }

  show(from, to, focused) {
    const { lineHeight } = getComputedStyle(this.#area);
    this.#area.setSelectionRange(from, from);
    this.#area.scrollTop = this.#line(from) * parseFloat(lineHeight) - this.#area.clientHeight / 2;
    if (focused) this.#area.focus();
  }

  faults() {}  // the page says them over the picture

  undo() {
    this.#command("undo");
  }

  redo() {
    this.#command("redo");
  }

  focus() {
    this.#area.focus();
  }

  #command(name) {
    this.#area.focus({ preventScroll: true });
    document.execCommand(name);
  }

  #line(offset) {
    return this.#area.value.slice(0, offset).split("\n").length - 1;
  }

  // A band behind the lines that are lit, from the first to the last of them.
  #place() {
    this.#band.hidden = !this.#lit.length;
    if (this.#band.hidden) return;
    const { lineHeight, paddingTop } = getComputedStyle(this.#area), height = parseFloat(lineHeight);
    const first = Math.min(...this.#lit.map(([from]) => this.#line(from)));
    const last = Math.max(...this.#lit.map(([, to]) => this.#line(to)));
    this.#band.style.top = `${parseFloat(paddingTop) + first * height - this.#area.scrollTop}px`;
    this.#band.style.height = `${(last - first + 1) * height}px`;
  }
}
