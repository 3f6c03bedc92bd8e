// Texts to the edits between them, and one text that is edited here and elsewhere at once, kept the same in both places.

// The one replacement that makes a text another; it splits no character.
export function difference(before, after) {
  const shorter = Math.min(before.length, after.length);
  let from = 0, tail = 0;
  while (from < shorter && before[from] === after[from]) from++;
  if (from && isHigh(before, from - 1)) from--;
  while (tail < shorter - from && before[before.length - 1 - tail] === after[after.length - 1 - tail]) tail++;
  if (tail && isLow(before, before.length - tail)) tail--;
  return { from, to: before.length - tail, text: after.slice(from, after.length - tail) };
}

const isHigh = (text, at) => (text.charCodeAt(at) & 0xfc00) === 0xd800;
const isLow = (text, at) => (text.charCodeAt(at) & 0xfc00) === 0xdc00;

// An edit as it is after another of the same text; null where both touch the same place.
export function after(edit, other) {
  const longer = other.text.length - (other.to - other.from);
  if (edit.to < other.from || (edit.to === other.from && edit.from < edit.to)) return edit;
  if (edit.from > other.to || (edit.from === other.to && other.from < other.to))
    return { ...edit, from: edit.from + longer, to: edit.to + longer };
  return null;
}

const isNothing = ({ from, to, text }) => from === to && !text;

// The text that the server has, and that of an editor on the page. One edit at a time is under way: the next is sent
// when the server has told of a text that has it. An edit of a text that is no longer the server's is refused there,
// and made again from the text that it has now.
export class Shared {
  #version = -1;
  #text = null;
  #sent = null;
  #base = -1;
  #touched = false;
  #read;
  #send;
  #take;

  // `read()` gives the editor's text, `send(edit)` says an edit to the server, `take(edit)` makes one in the editor.
  constructor({ read, send, take }) {
    this.#read = read, this.#send = send, this.#take = take;
  }

  // Another script, or the first.
  begin(version, text) {
    this.#version = version, this.#text = text, this.#sent = null;
  }

  // The server's text now. Whether something that was written here clashed with it: what was written here stays.
  told(version, text) {
    const theirs = difference(this.#text, text), mine = difference(this.#text, this.#read());
    const known = text === this.#sent || isNothing(theirs);
    const moved = known || isNothing(mine) ? theirs : after(theirs, mine);
    if (!known && moved) this.#take(moved);
    this.begin(version, text);
    this.flush();
    return !moved;
  }

  // Something was written here, which is to be sent at the next pause.
  touch() {
    this.#touched = true;
  }

  // Sends what was written, unless an edit is under way; call it when the author pauses.
  flush() {
    if (this.#sent !== null || this.#text === null) return;
    const now = this.#read(), edit = difference(this.#text, now);
    this.#touched = false;
    if (isNothing(edit)) return;
    this.#sent = now, this.#base = this.#version;
    this.#send({ base: this.#version, ...edit });
  }

  // The server did not make the edit that was under way. Of a text that it has told of since it is made again.
  refused() {
    const stale = this.#sent !== null && this.#base < this.#version;
    this.#sent = null;
    if (stale) this.flush();
  }

  // Whether the server has all that was written.
  get settled() {
    return this.#sent === null && !this.#touched;
  }
}
