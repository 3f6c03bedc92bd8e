// Long lines go on in the next row, four columns deeper than they begin.
import { Decoration, EditorView, ViewPlugin } from "@codemirror/view";

const DEEPER = 4, MOST = 24;  // columns

const depthOf = (text) => Math.min(text.match(/^ */)[0].length, MOST) + DEEPER;

function hanging(view) {
  const marks = [];
  for (const { from, to } of view.visibleRanges) {
    for (let at = from; at <= to;) {
      const line = view.state.doc.lineAt(at), depth = depthOf(line.text);
      const style = `text-indent: -${depth}ch; padding-left: calc(${depth}ch + 6px)`;
      marks.push(Decoration.line({ attributes: { style } }).range(line.from));
      at = line.to + 1;
    }
  }
  return Decoration.set(marks);
}

export const wrapping = [
  EditorView.lineWrapping,
  ViewPlugin.fromClass(class {
    constructor(view) {
      this.decorations = hanging(view);
    }

    update({ docChanged, viewportChanged, view }) {
      if (docChanged || viewportChanged) this.decorations = hanging(view);
    }
  }, { decorations: (plugin) => plugin.decorations }),
];
