// What a bundle was made of (esbuild's metafile) to the text of the licences of the packages in it.
import { existsSync, readdirSync, readFileSync } from "node:fs";

function licence(folder) {
  const { name, version, license } = JSON.parse(readFileSync(`${folder}/package.json`, "utf8"));
  const file = readdirSync(folder).find((found) => /^licen[cs]e/i.test(found));
  if (file === undefined) throw new Error(`${name} brings no licence`);
  return `${name} ${version} (${license})\n\n${readFileSync(`${folder}/${file}`, "utf8").trim()}\n`;
}

export function licences(metafile) {
  const folders = Object.keys(metafile.inputs)
    .map((path) => path.match(/^.*node_modules\/(?:@[^/]+\/)?[^/]+/)?.[0])
    .filter((folder) => folder !== undefined && existsSync(`${folder}/package.json`));
  return [...new Set(folders)].sort().map(licence).join(`\n${"-".repeat(80)}\n\n`);
}
