// A place in the page and a text to an editor: CodeMirror with the language's colours and, where a language server
// listens, its help. The page's source.js says what it wants of it.
import { closeBrackets, closeBracketsKeymap, completionKeymap } from "@codemirror/autocomplete";
import { defaultKeymap, history, historyKeymap, indentWithTab, isolateHistory, redo, undo } from "@codemirror/commands";
import { bracketMatching, foldGutter, foldKeymap, indentOnInput, indentUnit } from "@codemirror/language";
import { lintGutter, lintKeymap, setDiagnostics } from "@codemirror/lint";
import { highlightSelectionMatches, searchKeymap } from "@codemirror/search";
import { Annotation, Compartment, EditorState, StateEffect, StateField } from "@codemirror/state";
import {
  Decoration, EditorView, drawSelection, dropCursor, highlightActiveLine, highlightActiveLineGutter, keymap, lineNumbers,
  rectangularSelection,
} from "@codemirror/view";
import { language } from "./language.js";
import { help } from "./server.js";
import { theme } from "./theme.js";
import { wrapping } from "./wrapping.js";

const told = Annotation.define();  // a change that the page made: it knows of it

const light = StateEffect.define();
const lit = StateField.define({
  create: () => Decoration.none,
  update: (marks, { changes, effects }) => effects.find((effect) => effect.is(light))?.value ?? marks.map(changes),
  provide: (field) => EditorView.decorations.from(field),
});
const lineLit = Decoration.line({ class: "cm-face-lit" });

const outfit = [
  lineNumbers(), foldGutter(), lintGutter(), highlightActiveLine(), highlightActiveLineGutter(), history(), drawSelection(),
  dropCursor(), rectangularSelection(), EditorState.allowMultipleSelections.of(true), indentOnInput(), indentUnit.of("    "),
  bracketMatching(), closeBrackets(), highlightSelectionMatches(), wrapping, language, lit, theme,
  keymap.of([
    ...closeBracketsKeymap, ...defaultKeymap, ...searchKeymap, ...historyKeymap, ...foldKeymap, ...completionKeymap,
    ...lintKeymap, indentWithTab,
  ]),
];

// `wishes`: text, label, editable, edited(), caret(offset), save().
export class Editor {
  #view;
  #helped = new Compartment();
  #end = () => {};

  constructor(place, { text, label, editable, edited, caret, save }) {
    const listener = EditorView.updateListener.of((update) => {
      if (update.docChanged && !update.transactions.every((each) => each.annotation(told))) edited();
      else if (update.selectionSet && !update.docChanged && update.transactions.some((each) => each.isUserEvent("select")))
        caret(update.state.selection.main.head);
    });
    const saving = keymap.of([{ key: "Mod-s", preventDefault: true, run: () => { save(); return true; } }]);
    const extensions = [
      saving, outfit, listener, this.#helped.of([]),
      EditorState.readOnly.of(!editable), EditorView.editable.of(editable),
      EditorView.contentAttributes.of({ "aria-label": label, tabindex: "0" }),
    ];
    this.#view = new EditorView({ state: EditorState.create({ doc: text, extensions }), parent: place });
  }

  get text() {
    return this.#view.state.doc.toString();
  }

  // Takes an edit that was made elsewhere: the caret stays with its words, and ctrl-Z takes it back.
  replace(from, to, insert) {
    this.#view.dispatch({
      changes: { from, to, insert }, annotations: [told.of(true), isolateHistory.of("full")], userEvent: "input.told",
    });
  }

  // Lights the lines of stretches of the text: [[from, to], ...].
  light(stretches) {
    const { doc } = this.#view.state, lines = new Set();
    for (const [from, to] of stretches) {
      const last = doc.lineAt(Math.min(Math.max(to, from), doc.length)).number;
      for (let line = doc.lineAt(Math.min(from, doc.length)).number; line <= last; line++) lines.add(line);
    }
    const marks = [...lines].sort((one, other) => one - other).map((line) => lineLit.range(doc.line(line).from));
    this.#view.dispatch({ effects: light.of(Decoration.set(marks)) });
  }

  // Shows a stretch and puts the caret at its beginning.
  show(from, to, focused) {
    const { length } = this.#view.state.doc;
    this.#view.dispatch({
      selection: { anchor: Math.min(from, length) }, effects: EditorView.scrollIntoView(Math.min(to, length), { y: "center" }),
    });
    if (focused) this.#view.focus();
  }

  // What is wrong, as the preview says it: for an editor that no language server helps.
  faults(items) {
    const { length } = this.#view.state.doc;
    const within = (place) => Math.min(Math.max(place, 0), length);
    const found = items.map(({ start, end, severity, message, help, code }) => ({
      from: within(start), to: within(end), severity, message: help ? `${message}\n${help}` : message, source: code,
    }));
    this.#view.dispatch(setDiagnostics(this.#view.state, found));
  }

  // Talks to a language server at an address about the file `uri` of the folder `root`; said(state) hears how that goes.
  help(address, uri, root, said) {
    this.#end();
    const { extension, end } = help({ view: this.#view, address, uri, root, said });
    this.#end = end;
    this.#view.dispatch({ effects: this.#helped.reconfigure(extension) });
  }

  undo() {
    return undo(this.#view);
  }

  redo() {
    return redo(this.#view);
  }

  focus() {
    this.#view.focus();
  }
}
