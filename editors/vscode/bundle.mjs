// The client and the packages it uses to one file, and beside it the licences of those packages.
import { build } from "esbuild";
import { writeFileSync } from "node:fs";
import { licences } from "../licences.mjs";

const { metafile } = await build({
  entryPoints: ["src/extension.ts"],
  outfile: "dist/extension.js",
  bundle: true,
  platform: "node",
  format: "cjs",
  target: "node20",
  external: ["vscode"],
  minify: true,
  metafile: true,
});

writeFileSync("dist/licences.txt", licences(metafile));
