// Joins the sources into the files that the package carries: modules and a style sheet for the page and the notebook widget,
// one program for the films that turn. All are kept in git, so that installing the package needs no Node.

import { createHash } from "node:crypto";
import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build, version } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const SOURCES = ["kernel", "lab", "model", "pages", "scene", "site", "space", "words"];
// What Python writes for the page: the layout of the WebAssembly module, and the tables of models, sentences and presets.
const WRITTEN = ["../src/hophoop/lab/static/tables.json", "../src/hophoop/lab/wasm/layout.json"];
const TARGETS = [
  { entry: "lab/shell/main.ts", file: "../src/hophoop/lab/static/lab.js", format: "esm" },
  // a notebook's widget is a single file
  { entry: "lab/shell/main.ts", file: "../src/hophoop/lab/static/widget.js", format: "esm", apart: false },
  { entry: "lab/player/stage3d.ts", file: "../src/hophoop/lab/static/stage3d.js", format: "esm" },
  { entry: "lab/player/svg.ts", file: "../src/hophoop/lab/static/svg.js", format: "esm" },
  { entry: "lab/map/boundaries.ts", file: "../src/hophoop/lab/static/boundaries.js", format: "esm" },
  { entry: "kernel/worker.ts", file: "../src/hophoop/lab/static/kernel.js", format: "esm" },
  { entry: "site/motion_element.ts", file: "../src/hophoop/lab/static/motion_element.js", format: "esm" },
  { entry: "site/embed.ts", file: "../src/hophoop/lab/static/embed.js", format: "esm" },
  { entry: "site/service_worker.ts", file: "../src/hophoop/lab/static/service_worker.js", format: "esm" },
  { entry: "site/backdrop.ts", file: "../src/hophoop/lab/static/backdrop.js", format: "esm" },
  { entry: "pages/lab.css", file: "../src/hophoop/lab/static/lab.css" },
  { entry: "pages/embed.css", file: "../src/hophoop/lab/static/embed.css" },
  { entry: "scene/main.ts", file: "../src/hophoop/animate/static/scene.js", format: "iife" },
];
// Copied: Python fills their places.
const PAGES = ["embed.html", "index.html", "pick.html", "site.html"];

// tests/test_web.py computes the same, to tell when a built file is older than its sources.
function stamp() {
  const within = (folder) => readdirSync(join(here, folder), { recursive: true });
  const names = SOURCES.flatMap((folder) => within(folder).map((name) => `${folder}/${name.replaceAll("\\", "/")}`));
  const hash = createHash("sha256");
  for (const name of ["build.mjs", ...WRITTEN, ...names.filter((name) => /\.(ts|json|css)$/.test(name)).sort()]) {
    hash.update(`${name}\n`).update(readFileSync(join(here, name)));
  }
  return hash.digest("hex").slice(0, 32);
}

// English is in the script; another language is a file beside it.
const LANGUAGES = readdirSync(join(here, "words")).filter((name) => name.endsWith(".json") && name !== "en.json");

const folder = process.argv[2]; // where to write instead, to compare
for (const { entry, file, format, apart = true } of TARGETS) {
  await build({
    entryPoints: [join(here, entry)],
    outfile: folder ? join(folder, file.split("/").at(-1)) : join(here, file),
    format,
    bundle: true,
    minify: true,
    lineLimit: 4000,
    target: "es2022",
    charset: "utf8",
    legalComments: "none",
    define: { STAMP: JSON.stringify(stamp()), APART: String(apart) },
    supported: { nesting: false },
    banner: {
      [entry.endsWith(".css") ? "css" : "js"]:
        `/* Built from web/${entry} by esbuild ${version}; sources ${stamp()} */`,
    },
  });
}
for (const name of PAGES) {
  const page = readFileSync(join(here, "pages", name), "utf8").replace(
    "\n",
    `\n<!-- Copied from web/pages/${name} by web/build.mjs -->\n`,
  );
  writeFileSync(join(folder ?? join(here, "../src/hophoop/lab/static"), name), page);
}
for (const name of LANGUAGES) {
  const text = JSON.stringify(JSON.parse(readFileSync(join(here, "words", name), "utf8")));
  writeFileSync(join(folder ?? join(here, "../src/hophoop/lab/static"), `words.${name}`), `${text}\n`);
}
