// What is wrong with the script: a list beside the timeline, and over the picture while an error stands in the way.
import { make } from "./dom.js";

const NAMES = { error: "Error", warning: "Warning", hint: "Hint" };

// `list` and `over` are elements of the page; `jump(item)` shows a place in the text.
export class Faults {
  constructor(list, over, count, jump) {
    Object.assign(this, { list, over, count, jump });
  }

  show(items) {
    this.list.replaceChildren(...items.map((item) => make("li", {}, this.entry(item))));
    if (!items.length) this.list.append(make("li", { class: "tl-well" }, "Nothing to report."));
    const errors = items.filter((item) => item.severity === "error");
    this.count.textContent = summary(items, errors.length);
    this.count.dataset.severity = errors.length ? "error" : items.some((each) => each.severity === "warning") ? "warning" : "";
    this.over.hidden = !errors.length;
    if (errors.length) this.over.replaceChildren(...this.told(errors));
  }

  entry(item) {
    const place = item.line ? `${item.start === undefined && item.file ? `${item.file}:` : "line "}${item.line}` : "";
    const text = make("span", { class: "tl-what" }, item.message);
    if (item.help) text.append(make("span", { class: "tl-help" }, item.help));
    const head = make("span", { class: "tl-code" }, item.code);
    const parts = [make("span", { class: `tl-sign tl-${item.severity}` }, NAMES[item.severity] ?? item.severity), head, text,
      make("span", { class: "tl-where" }, place)];
    if (item.start === undefined) return make("div", { class: "tl-fault" }, ...parts);
    return make("button", { type: "button", class: "tl-fault", onclick: () => this.jump(item) }, ...parts);
  }

  told([first, ...others]) {
    const count = others.length ? `${others.length + 1} errors` : "An error";
    return [make("p", { class: "tl-over-head" }, `${count}. The picture is the last that could be played.`), this.entry(first)];
  }
}

function summary(items, errors) {
  if (!items.length) return "";
  const others = items.length - errors;
  if (!errors) return `${others}`;
  return others ? `${errors} + ${others}` : `${errors}`;
}
