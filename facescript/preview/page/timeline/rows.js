// A score to what lies under one another in the timeline: names of faces, lanes, words, curves; each with its place.

export const ROW = 24, BAR = 20;  // a row of bars and a bar in it, px
const SPOKEN = 38;  // a row of speech with its sound, px
const GAP = 6, NAME = 24, WORD = 17, WORD_ROWS = 2, CURVE = 92, LEGEND = 17;

// Everything from the top down: [{ kind, top, height, face, ... }], and how high it is.
export function layOut(score, curves) {
  const strips = [];
  let top = 0;
  const put = (strip, height) => { strips.push({ ...strip, top, height }); top += height; };
  const faces = [...new Set(score.lanes.map((lane) => lane.face))];
  for (const face of new Set([...faces, ...curves.keys()])) {
    if (faces.length > 1) put({ kind: "face", face, name: face ?? "film" }, NAME);
    score.lanes.forEach((lane, number) => lane.face === face && putLane(put, score, lane, number));
    for (const panel of panels(curves.get(face) ?? [])) {
      put({ kind: "curves", face, ...panel }, Math.max(CURVE, panel.channels.length * LEGEND + 26));
    }
  }
  return { strips, height: top };
}

function putLane(put, score, lane, number) {
  const acts = score.acts.filter((act) => act.lane === number).sort((one, two) => one.start - two.start);
  const rows = 1 + Math.max(0, ...acts.map((act) => act.row)), speech = lane.name === "speech";
  const row = speech ? SPOKEN : ROW;
  const bar = row - ROW + BAR, next = following(acts);
  put({ kind: "lane", face: lane.face, lane, number, acts, next, row, bar }, rows * row + GAP);
  if (!speech) return;
  const lines = score.lines.filter((line) => line.face === lane.face && line.words.length);
  if (lines.length) put({ kind: "words", face: lane.face, lines, row: WORD, rows: WORD_ROWS }, WORD_ROWS * WORD + GAP);
}

// When the next act of the same row begins, by act.
function following(acts) {
  const last = [], found = new Map();
  for (const act of acts) {
    if (last[act.row]) found.set(last[act.row], act.start);
    last[act.row] = act;
  }
  return found;
}

// The curves of a face, a panel a unit.
function panels(channels) {
  const units = [...new Set(channels.map((channel) => channel.unit))];
  return units.map((unit) => {
    const mine = channels.filter((channel) => channel.unit === unit);
    const least = Math.min(0, ...mine.map((channel) => channel.least));
    const most = Math.max(unit === "1" ? 1 : 5, ...mine.map((channel) => channel.most));
    return { unit, channels: mine, least, most };
  });
}

export function stripAt(strips, y) {
  return strips.find((strip) => y >= strip.top && y < strip.top + strip.height);
}

// The top of a bar in the whole drawing, px.
export function topOf(strip, act) {
  return strip.top + act.row * strip.row + GAP / 2 + (strip.row - strip.bar) / 2;
}
