// Scripts to the scopes that the TextMate grammar gives their words, by the library that VS Code itself uses.
// node tokens.mjs FILE... prints JSON: for each file its lines, each a list of [start, end, scopes].
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import oniguruma from "vscode-oniguruma";
import textmate from "vscode-textmate";

const here = (path) => new URL(path, import.meta.url);
const wasm = readFileSync(createRequire(import.meta.url).resolve("vscode-oniguruma/release/onig.wasm"));
await oniguruma.loadWASM(wasm);

const registry = new textmate.Registry({
  onigLib: Promise.resolve({
    createOnigScanner: (patterns) => new oniguruma.OnigScanner(patterns),
    createOnigString: (text) => new oniguruma.OnigString(text),
  }),
  loadGrammar: async () => JSON.parse(readFileSync(here("syntaxes/face.tmLanguage.json"), "utf8")),
});
const grammar = await registry.loadGrammar("source.face");

function tokens(text) {
  let state = textmate.INITIAL;
  return text.split("\n").map((line) => {
    const found = grammar.tokenizeLine(line, state);
    state = found.ruleStack;
    return found.tokens.map((token) => [token.startIndex, token.endIndex, token.scopes.slice(1)]);
  });
}

console.log(JSON.stringify(process.argv.slice(2).map((path) => tokens(readFileSync(path, "utf8")))));
