// The TextMate grammar and the settings that VS Code has of the language, as a language of CodeMirror's.
import { HighlightStyle, StreamLanguage, foldService, syntaxHighlighting } from "@codemirror/language";
import { tags } from "@lezer/highlight";
import settings from "../../vscode/language-configuration.json";
import textmate from "../../vscode/syntaxes/face.tmLanguage.json";
import { Grammar } from "./grammar.js";

const grammar = new Grammar(textmate);
const opens = new RegExp(settings.indentationRules.increaseIndentPattern, "u");

const KINDS = [
  ["invalid", tags.invalid, "var(--face-fault)"],
  ["comment", tags.comment, "var(--face-comment)"],
  ["constant.character.escape", tags.escape, "var(--face-sign)"],
  ["constant.other.reading", tags.literal, "var(--face-name)"],
  ["constant.numeric", tags.number, "var(--face-number)"],
  ["constant.other.color", tags.color, "var(--face-number)"],
  ["constant.language", tags.atom, "var(--face-constant)"],
  ["constant.other.language", tags.atom, "var(--face-constant)"],
  ["keyword.other.unit", tags.unit, "var(--face-number)"],
  ["keyword.other.modifier", tags.modifier, "var(--face-modifier)"],
  ["keyword.other", tags.modifier, "var(--face-modifier)"],
  ["keyword.operator", tags.operator, "var(--face-sign)"],
  ["keyword", tags.controlKeyword, "var(--face-keyword)"],
  ["storage", tags.definitionKeyword, "var(--face-keyword)"],
  ["support.function", tags.function(tags.name), "var(--face-verb)"],
  ["support.constant", tags.constant(tags.name), "var(--face-constant)"],
  ["support", tags.standard(tags.name), "var(--face-type)"],
  ["entity.name.type", tags.typeName, "var(--face-type)"],
  ["entity.name", tags.labelName, "var(--face-name)"],
  ["variable.parameter", tags.propertyName, "var(--face-modifier)"],
  ["markup.bold", tags.strong, "var(--face-text)"],
  ["string", tags.string, "var(--face-text)"],
  ["punctuation", tags.punctuation, "var(--face-sign)"],
];
/* What the beginning of a scope says, its tag, and the property of the page that has its colour. */

const BOLD = [tags.definitionKeyword, tags.controlKeyword, tags.strong];

// A scope as the place of its row; the innermost that has one counts, but a text's quotes are text.
function kindOf(scopes) {
  const names = scopes.split(" ").reverse().filter((name) => !name.startsWith("punctuation.definition"));
  for (const name of names) {
    const row = KINDS.findIndex(([start]) => name.startsWith(start));
    if (row >= 0) return `face${row}`;
  }
  return null;
}

const face = StreamLanguage.define({
  name: "face",
  startState: () => ({ open: [], first: true, scopes: [] }),
  copyState: (state) => ({ ...state }),
  blankLine: (state) => void Object.assign(state, { open: grammar.line("", state.open, state.first).open, first: false }),
  token(stream, state) {
    if (stream.sol()) Object.assign(state, grammar.line(stream.string, state.open, state.first), { first: false });
    const scope = state.scopes[stream.pos];
    while (!stream.eol() && state.scopes[stream.pos] === scope) stream.pos++;
    return scope ? kindOf(scope) : null;
  },
  indent(_, text, { lineIndent, state, pos, unit }) {
    const line = state.doc.lineAt(pos), before = line.number > 1 ? state.doc.line(line.number - 1) : null;
    return before && text === "" ? lineIndent(before.from) + (opens.test(before.text) ? unit : 0) : null;
  },
  tokenTable: Object.fromEntries(KINDS.map(([, tag], row) => [`face${row}`, tag])),
  languageData: {
    commentTokens: { line: settings.comments.lineComment },
    closeBrackets: { brackets: settings.autoClosingPairs.map(({ open }) => open) },
    wordChars: "-",
  },
});

const colours = HighlightStyle.define(
  KINDS.map(([, tag, color]) => ({ tag, color, fontWeight: BOLD.includes(tag) ? "600" : undefined })),
);

const indentOf = (text) => text.match(/^ */)[0].length;

// A line and the deeper ones below it.
const folding = foldService.of(({ doc }, from, to) => {
  const line = doc.lineAt(from), depth = indentOf(line.text);
  let last = null;
  if (!line.text.trim()) return null;
  for (let number = line.number + 1; number <= doc.lines; number++) {
    const below = doc.line(number);
    if (!below.text.trim()) continue;
    if (indentOf(below.text) <= depth) break;
    last = below;
  }
  return last ? { from: to, to: last.to } : null;
});

export const language = [face, syntaxHighlighting(colours), folding];
