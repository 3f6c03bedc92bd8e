// Scripts to the scopes that the editor of the page gives their words, in the form of `../vscode/tokens.mjs`.
import { readFileSync } from "node:fs";
import { Grammar } from "./src/grammar.js";

const raw = JSON.parse(readFileSync(new URL("../vscode/syntaxes/face.tmLanguage.json", import.meta.url), "utf8"));
const grammar = new Grammar(raw);

function tokens(text) {
  let open = [];
  return text.split("\n").map((line, number) => {
    const read = grammar.line(line, open, number === 0);
    open = read.open;
    return runs(read.scopes);
  });
}

function runs(scopes) {
  const found = [];
  scopes.forEach((scope, at) => {
    const last = found.at(-1);
    if (last?.[3] === scope) last[1] = at + 1;
    else found.push([at, at + 1, scope ? scope.split(" ") : [], scope]);
  });
  return found.map(([start, end, names]) => [start, end, names]);
}

console.log(JSON.stringify(process.argv.slice(2).map((path) => tokens(readFileSync(path, "utf8")))));
