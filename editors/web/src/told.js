// What a language server says of a text after each edit: what is wrong with the mends it offers, and when each
// statement is played, at the end of its line.
import { setDiagnostics } from "@codemirror/lint";
import { LSPPlugin } from "@codemirror/lsp-client";
import { StateEffect, StateField } from "@codemirror/state";
import { Decoration, EditorView, ViewPlugin, WidgetType } from "@codemirror/view";

const PAUSE = 150;  // milliseconds without an edit before it is asked
const AROUND = 5000;  // units of text before and behind what is seen for which times are asked
const SEVERITIES = [, "error", "warning", "info", "hint"];

export const asker = ViewPlugin.fromClass(class {
  constructor(view) {
    this.view = view;
    this.later(0);
  }

  update({ docChanged, viewportChanged }) {
    if (docChanged || viewportChanged) this.later(PAUSE);
  }

  destroy() {
    clearTimeout(this.timer);
  }

  later(pause) {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.ask().catch(() => {}), pause);
  }

  async ask() {
    const plugin = LSPPlugin.get(this.view), { doc } = this.view.state;
    if (!plugin?.client.connected) return;  // it is asked when it comes
    plugin.client.sync();
    const known = this.known === doc;  // what is wrong with it: to say it again would close what is shown of it
    const [faults, times] = await Promise.all([known || faultsOf(plugin, doc), timesOf(plugin, this.view)]);
    if (this.view.state.doc !== doc) return;  // a later edit asks again
    this.view.dispatch({ effects: setTimes.of(times) });
    if (!known) this.known = doc, this.view.dispatch(setDiagnostics(this.view.state, faults));
  }
});

// ---------------------------------------------------------------- what is wrong

async function faultsOf(plugin, doc) {
  const textDocument = { uri: plugin.uri };
  const { items } = await plugin.client.request("textDocument/diagnostic", { textDocument });
  if (!items.length) return [];
  const range = { start: { line: 0, character: 0 }, end: plugin.toPosition(doc.length, doc) };
  const context = { diagnostics: items, only: ["quickfix"] };
  const mends = await plugin.client.request("textDocument/codeAction", { textDocument, range, context });
  return items.map((item) => fault(plugin, doc, item, (mends ?? []).filter((mend) => linked(mend, item))));
}

const linked = (mend, item) => (mend.diagnostics ?? []).some((other) => other.code === item.code && same(other.range, item.range));
const same = (one, other) => JSON.stringify(one) === JSON.stringify(other);

function fault(plugin, doc, item, mends) {
  const from = plugin.fromPosition(item.range.start, doc), to = plugin.fromPosition(item.range.end, doc);
  const actions = mends.flatMap((mend) => {
    const changes = changesOf(plugin, doc, mend.edit);
    const apply = (view) => view.state.doc === doc && view.dispatch({ changes, userEvent: "input.fix" });
    return changes ? [{ name: mend.title, apply }] : [];
  });
  return { from, to, severity: SEVERITIES[item.severity ?? 1], source: item.code, message: item.message, actions };
}

// The changes of a mend that is in this text alone; null for one that goes into other files.
function changesOf(plugin, doc, edit) {
  const edits = edit.changes ?? Object.fromEntries(
    (edit.documentChanges ?? []).map(({ textDocument, edits }) => [textDocument.uri, edits]),
  );
  if (Object.keys(edits).join() !== plugin.uri) return null;
  return edits[plugin.uri].map(({ range, newText }) => ({
    from: plugin.fromPosition(range.start, doc), to: plugin.fromPosition(range.end, doc), insert: newText,
  }));
}

// ---------------------------------------------------------------- times

class Time extends WidgetType {
  constructor(label, more) {
    super();
    this.label = label, this.more = more;
  }

  eq(other) {
    return other.label === this.label && other.more === this.more;
  }

  toDOM() {
    const place = document.createElement("span");
    place.className = "cm-face-time";
    place.textContent = this.label;
    place.title = this.more;
    return place;
  }
}

async function timesOf(plugin, view) {
  const { doc } = view.state, { from, to } = view.viewport;
  const range = {
    start: plugin.toPosition(Math.max(from - AROUND, 0), doc),
    end: plugin.toPosition(Math.min(to + AROUND, doc.length), doc),
  };
  const hints = await plugin.client.request("textDocument/inlayHint", { textDocument: { uri: plugin.uri }, range });
  const marks = (hints ?? []).map(({ position, label, tooltip }) => Decoration.widget({
    widget: new Time(label, (tooltip?.value ?? "").replaceAll("`", "")), side: 1,
  }).range(plugin.fromPosition(position, doc)));
  return Decoration.set(marks, true);
}

const setTimes = StateEffect.define();
const times = StateField.define({
  create: () => Decoration.none,
  update: (marks, { changes, effects }) => effects.find((effect) => effect.is(setTimes))?.value ?? marks.map(changes),
  provide: (field) => EditorView.decorations.from(field),
});

export const told = [asker, times];
