// The editor and the packages it uses to one module, and beside it the licences of those packages.
// node bundle.mjs [FOLDER]: without a folder, to the page of `facescript preview`.
import { build } from "esbuild";
import { writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { licences } from "../licences.mjs";

const folder = process.argv[2] ?? fileURLToPath(new URL("../../facescript/preview/page", import.meta.url));

const { metafile } = await build({
  absWorkingDir: fileURLToPath(new URL(".", import.meta.url)),
  entryPoints: ["src/editor.js"],
  outfile: `${folder}/editor.js`,
  bundle: true,
  platform: "browser",
  format: "esm",
  target: "es2022",
  charset: "utf8",
  legalComments: "none",
  minify: true,
  metafile: true,
});

writeFileSync(`${folder}/editor.licences.txt`, licences(metafile));
