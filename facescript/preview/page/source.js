// The script beside the face: an editor for it, what is written to the server at once, what is written elsewhere to the
// editor; and in the playground examples to begin with.
import { Shared } from "./edits.js";
import { PlainEditor } from "./plain.js";
import { reached } from "./wire.js";

const PAUSE = 150;  // ms without a key until what was written is sent
const SHORTEST = 0.15;  // s that what takes no time is lit
const WIDE = 900;  // pixels of a window that has room for both
const UNBUILT = "A plain text field: colours and help come with the editor that `make playground` builds.";

// In `place`, told by `link`; `button` shows and hides it, `time` is the film's clock. The editor is made, and a language
// server asked for, when the script is shown for the first time: at once, unless an editor elsewhere shows it.
export function source(link, place, button, time) {
  const latest = new Map();
  let opened = null, elsewhere = false;

  async function open() {
    const { editor, examples } = await (await fetch("playground.json")).json();
    const made = editor ? (await import("./editor.js")).Editor : PlainEditor;
    return new Source({ link, place, time, made, examples, built: editor, latest });
  }

  function show(shown) {
    place.hidden = !shown;
    button.setAttribute("aria-expanded", String(shown));
    if (shown) opened ??= open().catch(() => { opened = null; });  // the server may be gone: the next time
  }

  for (const kind of ["script", "diagnostics", "score"]) link.on(kind, (message) => latest.set(kind, message));
  link.on("editor", ({ connected }) => { elsewhere = connected; });
  link.on("script", ({ scratch }) => {
    if (button.hidden) show(scratch || (innerWidth > WIDE && !elsewhere));
    button.hidden = false;
  });
  button.addEventListener("click", () => show(place.hidden));
}

class Source {
  #helped = null;
  #helps = "";
  #timer;
  #version = 0;
  #acts = { version: -1, acts: [] };
  #lit = null;

  constructor({ link, place, time, made, examples, built, latest }) {
    const script = latest.get("script");
    Object.assign(this, { link, place, time, script, name: stem(script.name) });
    this.#furnish(examples, built);
    this.editor = new made(this.text, {
      text: script.text, label: `Script ${script.name}`, editable: script.writable,
      edited: () => this.#edited(), save: () => this.#save(),
      caret: (at) => link.tell("lit", { from: at, to: at }),
    });
    this.shared = new Shared({
      read: () => this.editor.text, send: (edit) => link.say("text", edit),
      take: ({ from, to, text }) => this.editor.replace(from, to, text),
    });
    this.shared.begin(script.version, script.text);
    this.#listen();
    this.#heard(script);
    if (latest.has("diagnostics")) this.#faults(latest.get("diagnostics"));
    if (latest.has("score")) this.#scored(latest.get("score"));
  }

  #furnish(examples, built) {
    const { scratch, writable } = this.script;
    this.place.innerHTML = `
      <div class="source-bar" role="group" aria-label="Script tools">
        <label class="source-examples">Example <select><option value="">choose …</option></select></label>
        <button type="button" data-share>Share</button>
        <button type="button" data-keep>Download .face</button>
        <span class="source-told" role="status"></span>
      </div>
      <div class="source-text"></div>`;
    const one = (name) => this.place.querySelector(name);
    [this.text, this.told] = [one(".source-text"), one(".source-told")];
    one(".source-examples").hidden = !scratch;
    const select = one("select");
    for (const { name, says } of examples) select.append(new Option(`${name}: ${says}`, name));
    select.addEventListener("change", () => {
      const example = examples.find(({ name }) => name === select.value);
      if (example) this.#load(example);
    });
    one("[data-share]").addEventListener("click", () => this.#share());
    one("[data-keep]").addEventListener("click", () => this.#download());
    if (!built) this.text.after(Object.assign(document.createElement("p"), { className: "source-note", textContent: UNBUILT }));
    if (!writable) this.#say("It came from standard input and stays as it is.");
  }

  #listen() {
    const { link } = this;
    link.on("script", (script) => this.#heard(script));
    link.on("diagnostics", (message) => this.#faults(message));
    link.on("refused", ({ what, why }) => {
      if (what === "share") this.#say(`Not shared: ${why}.`);
      if (what === "text") this.shared.refused(), this.#say(`Not taken: ${why}.`);
    });
    link.on("shared", ({ url }) => {
      keep(url, `${this.name}.html`);
      this.#say("Shared: one page, with the script in it, lies among your downloads.");
    });
    link.on("said jump", ({ from, to }) => this.editor.show(from, to, false));
    link.on("score", (score) => this.#scored(score));
    this.time.watch((now) => this.#light(now));
  }

  #heard(script) {
    this.script = script, this.#version = script.version;
    if (this.shared.told(script.version, script.text))
      this.#say("It was changed elsewhere where you were writing: what you wrote stays.");
    if (script.uri !== this.#helped) this.#help(script);
  }

  #help({ uri, root }) {
    this.#helped = uri;
    this.editor.help?.(reached("lsp"), uri, root, (state, why) => {
      this.#helps = state;
      if (state === "gone") this.#say(why ? `No help: ${why}` : "The language server is gone.");
    });
  }

  #faults({ items }) {
    if (this.#helps !== "there") this.editor.faults(items.filter((item) => item.start !== undefined));
  }

  #scored({ version, acts, lanes }) {
    this.#acts = { version, acts: acts.filter(({ from, lane }) => from !== undefined && lanes[lane].name !== "life") };
    this.#lit = null;
    this.#light(this.time.now());
  }

  // Lights what is being done at a time, while the text is the one that it is known of.
  #light(now) {
    const { version, acts } = this.#acts;
    const known = version === this.#version && this.shared.settled;
    if (!known && !this.time.playing) return;  // the marks go with their lines
    const doing = ({ start, settled }) => start <= now && now < Math.max(settled, start + SHORTEST);
    const stretches = known ? acts.filter(doing).map(({ from, to }) => [from, to]) : [], key = stretches.join(" ");
    if (key !== this.#lit) this.#lit = key, this.editor.light(stretches);
  }

  #edited() {
    this.shared.touch();
    this.#lit = null;  // marks may have gone with their lines
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => { this.shared.flush(), this.#light(this.time.now()); }, PAUSE);
  }

  // Whatever is written is in the file soon; who asks for it has it at once, and is told.
  #save() {
    this.shared.flush();
    if (this.script.scratch) this.#download();
    else if (this.script.writable) this.#say(`${this.script.name} is kept as you write it.`);
  }

  #load({ name, text }) {
    this.editor.replace(0, this.editor.text.length, text);
    this.editor.show(0, 0, true);
    this.name = name;
    this.time.seek(0);
    this.shared.flush();
  }

  #share() {
    this.shared.flush();
    this.#say("Making the page …");
    this.link.say("share");
  }

  #download() {
    const url = URL.createObjectURL(new Blob([this.editor.text], { type: "text/plain" }));
    keep(url, `${this.name}.face`);
    setTimeout(() => URL.revokeObjectURL(url), 10000);
  }

  #say(text) {
    this.told.textContent = text;
  }
}

const stem = (name) => name.split("/").pop().replace(/\.\w+$/, "");

function keep(href, download) {
  const link = Object.assign(document.createElement("a"), { href, download });
  document.body.append(link);
  link.click();
  link.remove();
}
