// The acts for keys and screen readers: one list with a group a lane, of which the chosen act of each lane is there.
import { make } from "./dom.js";
import { told } from "./paint.js";

export class Reader {
  constructor(element) {
    this.element = element;  // role listbox
  }

  // Groups for the lanes of a new score.
  lay(view) {
    const lanes = view.strips.filter((strip) => strip.kind === "lane");
    this.element.hidden = !lanes.length;
    this.groups = new Map(lanes.map((strip) => {
      const name = [strip.face, strip.lane.name].filter(Boolean).join(", ");
      const option = make("div", { role: "option", id: `tl-act-${strip.number}`, "aria-selected": "false" });
      const group = make("div", { role: "group", "aria-label": name }, option);
      describe(view, strip, option, strip.acts[0]);
      return [strip.number, { group, option, strip }];
    }));
    this.element.replaceChildren(...[...this.groups.values()].map(({ group }) => group));
    this.choose(view);
  }

  // The chosen act is the one that is read.
  choose(view) {
    for (const { option } of this.groups.values()) option.setAttribute("aria-selected", "false");
    const mine = view.chosen && this.groups.get(view.chosen.lane);
    if (!mine) return this.element.removeAttribute("aria-activedescendant");
    describe(view, mine.strip, mine.option, view.chosen);
    mine.option.setAttribute("aria-selected", "true");
    this.element.setAttribute("aria-activedescendant", mine.option.id);
  }
}

function describe(view, strip, option, act) {
  option.setAttribute("aria-setsize", strip.acts.length);
  option.setAttribute("aria-posinset", strip.acts.indexOf(act) + 1);
  const place = act.line ? `, line ${act.line}` : "";
  option.textContent = `${act.label}, ${told(view, act.start)} to ${told(view, act.end)}${place}`;
}

// The act that an arrow leads to from the chosen one: along its lane, or the nearest in time of the lane beside it.
export function beside(view, key) {
  const lanes = view.strips.filter((strip) => strip.kind === "lane"), from = view.chosen;
  if (!from) return nearest(lanes[0]?.acts ?? [], view.time);
  const number = lanes.findIndex((strip) => strip.number === from.lane), acts = lanes[number].acts;
  const step = { ArrowLeft: -1, ArrowRight: 1 }[key];
  if (step) return acts[acts.indexOf(from) + step];
  if (key === "Home" || key === "End") return acts.at(key === "Home" ? 0 : -1);
  return nearest(lanes[number + (key === "ArrowUp" ? -1 : 1)]?.acts ?? [], from.start);
}

function nearest(acts, time) {
  const off = (act) => Math.max(act.start - time, time - act.end, 0);
  return acts.reduce((best, act) => !best || off(act) < off(best) ? act : best, undefined);
}
