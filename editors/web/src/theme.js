// What the editor looks like: the page's own colours, of which it takes properties, in light and in dark.
import { EditorView } from "@codemirror/view";

export const theme = EditorView.theme({
  "&": {
    height: "100%", backgroundColor: "var(--card)", color: "var(--ink)", fontSize: "14px",
    "--face-comment": "light-dark(#6a6660, #a39d94)", "--face-keyword": "light-dark(#8a2b86, #dd9bdb)",
    "--face-verb": "light-dark(#1f5fa8, #86bdf5)", "--face-modifier": "light-dark(#7a4d00, #e0b062)",
    "--face-type": "light-dark(#0b6a5f, #6fd0c2)", "--face-name": "light-dark(#9a3412, #f0a17c)",
    "--face-constant": "light-dark(#0b6a5f, #8ed3a0)", "--face-number": "light-dark(#a01d4c, #f39bb6)",
    "--face-text": "light-dark(#3a6a16, #b2d68c)", "--face-sign": "light-dark(#57534e, #b9b2a8)",
    "--face-fault": "light-dark(#b3161b, #ff8a80)",
  },
  "&.cm-focused": { outline: "none" },  // the panel around it shows that
  ".cm-scroller": { fontFamily: "var(--mono)", lineHeight: "1.55" },
  ".cm-content": { caretColor: "var(--ink)", paddingBottom: "30vh" },
  ".cm-cursor, .cm-dropCursor": { borderLeftColor: "var(--ink)", borderLeftWidth: "2px" },
  ".cm-gutters": { backgroundColor: "var(--card)", color: "var(--soft)", border: "none" },
  ".cm-activeLine, .cm-activeLineGutter": { backgroundColor: "color-mix(in srgb, var(--ink) 5%, transparent)" },
  ".cm-line.cm-face-lit": { backgroundColor: "var(--lit)" },
  "& > .cm-scroller > .cm-selectionLayer .cm-selectionBackground, &.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground": {
    backgroundColor: "light-dark(#cfe1f7, #2c486a)",
  },
  ".cm-selectionMatch": { backgroundColor: "color-mix(in srgb, var(--accent) 16%, transparent)" },
  "&.cm-focused .cm-matchingBracket": { backgroundColor: "color-mix(in srgb, var(--accent) 22%, transparent)" },
  ".cm-face-time": {
    marginLeft: "1.2em", color: "var(--soft)", fontFamily: "var(--sans)", fontSize: "12px",
    fontVariantNumeric: "tabular-nums", userSelect: "none", whiteSpace: "nowrap",
  },
  ".cm-foldPlaceholder": { backgroundColor: "transparent", color: "var(--soft)", border: "1px solid var(--line)" },
  ".cm-tooltip": {
    backgroundColor: "var(--card)", color: "var(--ink)", border: "1px solid var(--line)", borderRadius: "6px",
    boxShadow: "0 6px 24px rgb(0 0 0 / 0.18)",
  },
  ".cm-tooltip.cm-tooltip-autocomplete > ul": { fontFamily: "var(--mono)", fontSize: "13px", maxWidth: "min(30em, 90vw)" },
  ".cm-tooltip-autocomplete > ul > li[aria-selected]": { backgroundColor: "light-dark(#1f5fa8, #2c486a)", color: "#fff" },
  ".cm-completionDetail": { fontStyle: "normal", opacity: "0.8" },
  ".cm-tooltip .cm-lsp-documentation": { maxWidth: "34em", fontFamily: "var(--sans)", fontSize: "13px", lineHeight: "1.5" },
  ".cm-lsp-documentation :is(code, pre)": { fontFamily: "var(--mono)", fontSize: "12.5px", whiteSpace: "pre-wrap" },
  ".cm-diagnostic": { fontFamily: "var(--sans)", fontSize: "13px", maxWidth: "40em" },
  ".cm-diagnosticSource": { fontSize: "11px", opacity: "1", color: "var(--soft)" },
  ".cm-diagnosticAction": {
    backgroundColor: "light-dark(#1f5fa8, #a9cdf5)", color: "light-dark(#fff, #10243f)", borderRadius: "4px", padding: "3px 8px",
  },
  ".cm-panels": { backgroundColor: "var(--paper)", color: "var(--ink)", borderColor: "var(--line)" },
  ".cm-panel :is(input, button)": { font: "inherit", color: "inherit" },
  ".cm-textfield": { backgroundColor: "var(--card)", border: "1px solid var(--line)" },
  ".cm-button": { backgroundImage: "none", backgroundColor: "var(--card)", border: "1px solid var(--line)" },
});
