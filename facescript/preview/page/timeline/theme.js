// The page's colours to those of the canvas, in light and in dark.

import { measureIn } from "./text.js";

const NAMES = ["paper", "raised", "ink", "soft", "line", "hair", "accent", "beyond", "marker", "caret"];

// Read anew where the reader's light changes: a canvas does not follow the style sheet by itself.
export function themeOf(element) {
  const style = getComputedStyle(element), theme = {};
  for (const name of NAMES) theme[name] = style.getPropertyValue(`--tl-${name}`).trim();
  theme.dark = style.getPropertyValue("--tl-dark").trim() === "1";
  theme.loop = style.getPropertyValue("--tl-loop").trim();
  theme.label = `12px ${style.fontFamily}`;
  theme.small = `11px ${style.fontFamily}`;
  measureIn(theme.label);
  return theme;
}

const mixed = new Map();

// A lane's colour (#rrggbb) so strong, 0..1, over the ground; in the dark it is lighter first, to be told apart.
export function tint(colour, theme, strength) {
  const key = `${colour} ${theme.dark} ${strength}`;
  if (!mixed.has(key)) {
    const parts = [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16));
    const shown = theme.dark ? parts.map((part) => Math.round(part + (255 - part) * 0.42)) : parts;
    mixed.set(key, `rgb(${shown.join(" ")} / ${strength})`);
  }
  return mixed.get(key);
}
