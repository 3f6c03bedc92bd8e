// The TextMate grammar to the scopes of a line's words, as VS Code's own library finds them. Of TextMate's language only
// what our grammar uses is read here.

const WORD = "\\p{L}\\p{M}\\p{Nd}\\p{Pc}";
const EDGE = `(?:(?<=[${WORD}])(?![${WORD}])|(?<![${WORD}])(?=[${WORD}]))`;

// Oniguruma's expression as JavaScript's, whose `\w` knows no letters but English ones: one that finds, one that reads.
function expression(text) {
  let inside = false;
  const source = text.replaceAll("[^\\W\\d]", "[\\p{L}\\p{M}\\p{Pc}]").replace(/\\.|[[\]]/gsu, (part) => {
    if (part === "[" || part === "]") inside = part === "[";
    if (part === "\\w") return inside ? WORD : `[${WORD}]`;
    return { "\\b": EDGE, "\\A": "^", '\\"': '"' }[part] ?? part;
  });
  return { finds: new RegExp(source, "gu"), reads: new RegExp(source, "dyu") };
}

// A grammar as rules with their expressions read and their includes followed, each when it is first asked for.
export class Grammar {
  #repository;
  #read = new Map();

  constructor({ patterns, repository }) {
    this.#repository = repository;
    this.top = { scopes: "", rules: this.#rules(patterns) };
  }

  // The scopes of each UTF-16 unit of a line (texts, the innermost scope last), and what is open behind it; `open` is
  // what was open before it, the outermost first.
  line(text, open, first) {
    const scopes = new Array(text.length).fill("");
    const left = this.#walk(text, 0, [this.top, ...open.map((frame) => ({ ...frame, since: -1 }))], scopes, first);
    return { scopes, open: left.slice(1) };
  }

  #rules(patterns) {
    return patterns.flatMap((raw) => {
      if (raw.include) return this.#rules([this.#repository[raw.include.slice(1)]]);
      return raw.match === undefined && raw.begin === undefined ? this.#rules(raw.patterns) : [this.#rule(raw)];
    });
  }

  #rule(raw) {
    if (!this.#read.has(raw)) {
      const on = raw.match ?? raw.begin;
      this.#read.set(raw, {
        raw, on: expression(on), once: on.startsWith("\\A"), end: raw.begin === undefined ? null : expression(raw.end),
      });
    }
    return this.#read.get(raw);
  }

  // Reads from `at` to the end of a text with `open` frames, which it changes and gives back.
  #walk(text, at, open, scopes, first) {
    const found = new Map();
    for (;;) {
      const frame = open[open.length - 1];
      const next = this.#next(text, at, frame, found, first);
      paint(scopes, at, next ? next.at : text.length, frame.scopes);
      if (!next) return open;
      const match = read(next.on, text, next.at), ahead = next.at + match[0].length;
      if (next.rule) {
        const outer = under(frame.scopes, next.rule.raw.name);
        this.#capture(text, match, next.rule.raw.beginCaptures ?? next.rule.raw.captures, outer, scopes, first);
        if (next.rule.end) open.push(this.#opened(next.rule, outer, next.at));
        else if (ahead === next.at) return open;
      } else {
        open.pop();
        this.#capture(text, match, frame.rule.raw.endCaptures, frame.outer, scopes, first);
        if (ahead === frame.since) return open;  // opened and closed over nothing: what follows would not end
      }
      at = ahead;
    }
  }

  #opened(rule, outer, since) {
    rule.inner ??= this.#rules(rule.raw.patterns ?? []);
    return { rule, outer, scopes: under(outer, rule.raw.contentName), rules: rule.inner, since };
  }

  // What comes first at or behind a place: the end of the frame, or one of its rules.
  #next(text, at, frame, found, first) {
    let best = null;
    const look = (on, rule) => {
      const place = find(on, text, at, found);
      if (place >= 0 && (best === null || place < best.at)) best = { at: place, on, rule };
    };
    if (frame.rule) look(frame.rule.end, null);
    for (const rule of frame.rules) if (first || !rule.once) look(rule.on, rule);
    return best;
  }

  #capture(text, match, captures, outer, scopes, first) {
    paint(scopes, match.index, match.index + match[0].length, outer);
    for (const [group, { name, patterns }] of Object.entries(captures ?? {})) {
      const span = match.indices[group];
      if (!span) continue;
      paint(scopes, ...span, under(scopes[span[0]] ?? outer, name));
      const inner = patterns && { scopes: under(outer, name), rules: this.#rules(patterns) };
      if (inner) this.#walk(text.slice(0, span[1]), span[0], [inner], scopes, false);
    }
  }
}

function find({ finds }, text, at, found) {
  const known = found.get(finds);
  if (known !== undefined && (known < 0 || known >= at)) return known;
  finds.lastIndex = at;
  const place = finds.exec(text)?.index ?? -1;
  found.set(finds, place);
  return place;
}

function read({ reads }, text, at) {
  reads.lastIndex = at;
  return reads.exec(text);
}

function under(outer, name) {
  return outer && name ? `${outer} ${name}` : name || outer;
}

function paint(scopes, from, to, text) {
  for (let at = from; at < to; at++) scopes[at] = text;
}
