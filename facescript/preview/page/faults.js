// What is wrong with the script: a list in a drawer, and over the picture while an error stands in the way.

import { make } from "./timeline/dom.js";
import { Drawer } from "./timeline/drawer.js";

const NAMES = { error: "Error", warning: "Warning", hint: "Hint" };

// `over` lies over the picture, the drawer's button stands first in `bar`; `jump(from, to)` shows a place of the text.
export function faults(link, over, bar, jump) {
  const count = make("span", { class: "fault-count" }), list = make("ul", { class: "fault-list" });
  const button = make("button", { type: "button", class: "tl-tool" }, "Problems", count);
  const drawer = new Drawer(button, "faults-list", "Problems", "left");
  drawer.panel.append(list);
  bar.prepend(drawer.place);

  let played = false;
  link.on("score", () => { played = true; });
  link.on("diagnostics", ({ items }) => {
    list.replaceChildren(...items.map((item) => make("li", {}, entry(item))));
    if (!items.length) list.append(make("li", { class: "fault-none" }, "Nothing to report."));
    const errors = items.filter((item) => item.severity === "error");
    const worst = errors.length ? "error" : items.find((item) => item.severity === "warning")?.severity ?? "hint";
    count.textContent = items.length ? String(items.length) : "";
    count.dataset.severity = worst;
    over.hidden = !errors.length;
    over.replaceChildren(...errors.length ? told(errors) : []);
  });

  function entry(item) {
    const inside = item.start !== undefined;
    const where = !item.line ? "" : inside ? `line ${item.line}` : `${item.file}:${item.line}`;
    const text = make("span", {}, item.message);
    if (item.help) text.append(make("span", { class: "fault-help" }, item.help));
    const kind = { class: "fault", "data-severity": item.severity };
    const sign = make("span", { class: "fault-sign" }, NAMES[item.severity]);
    const code = make("span", { class: "fault-code" }, item.code), parts = [sign, code, text];
    parts.push(make("span", { class: "fault-code" }, where));
    if (!inside) return make("div", kind, ...parts);
    return make("button", { ...kind, type: "button", onclick: () => jump(item.start, item.end) }, ...parts);
  }

  function told(errors) {
    const head = errors.length > 1 ? `${errors.length} errors.` : "An error.";
    const last = played ? " The picture is the last that could be played." : "";
    return [make("p", { class: "fault-head" }, head + last), entry(errors[0])];
  }
}
