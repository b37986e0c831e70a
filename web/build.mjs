// Joins the sources into the files that the package carries. All are kept in git, so that installing the package needs no Node.
// `node build.mjs FOLDER` writes them there instead; `npm run dev` serves the page and loads it again after each change.

import { createHash } from "node:crypto";
import { mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { basename, join } from "node:path";
import { build, context } from "esbuild";

const web = import.meta.dirname;
const carried = join(web, "../src/hophoop");
const words = join(carried, "lab/words");
const WORDS = readdirSync(words).sort();
const PART = /-[A-Z0-9]{8}\.js$/; // what several scripts share, or what comes later

const common = {
  absWorkingDir: web,
  preserveSymlinks: true, // the names of parts depend on the paths of what is in them
  bundle: true,
  minify: true,
  lineLimit: 4000,
  target: "es2022",
  charset: "utf8",
  legalComments: "none",
  supported: { nesting: false },
};

/** Everything of the page, for a folder. */
const page = (outdir) => [
  {
    ...common,
    outdir,
    entryPoints: {
      lab: "lab/shell/main.ts",
      "hophoop-motion": "site/hophoop-motion.ts",
      embed: "site/embed.ts",
      backdrop: "site/backdrop.ts",
      kernel: "kernel/worker.ts",
    },
    format: "esm",
    splitting: true,
    chunkNames: "[name]-[hash]",
    // browsers may keep the tables of words, whose names do not change
    define: { WORDS: JSON.stringify(hashOf(WORDS.map((name) => join(words, name)))) },
  },
  {
    ...common,
    outdir,
    entryPoints: ["pages/lab.css", "pages/embed.css", "site/service-worker.ts", "site/widget.ts", "site/file.ts"],
    entryNames: "[name]",
    format: "esm",
  },
  // for notebooks and for a page that is one file: browsers start no module from a disk
  { ...common, outdir, entryPoints: { worker: "kernel/worker.ts" }, format: "iife" },
];
/** The program of the films that turn. */
const film = (outdir) => ({ ...common, outdir, entryPoints: { scene: "scene/main.ts" }, format: "iife" });

function hashOf(paths) {
  const hash = createHash("sha256");
  for (const path of paths) hash.update(readFileSync(path));
  return hash.digest("hex").slice(0, 8);
}

async function buildInto(lab, films) {
  mkdirSync(lab, { recursive: true });
  for (const name of readdirSync(lab)) if (PART.test(name)) rmSync(join(lab, name));
  for (const options of [...page(lab), film(films)]) {
    const { metafile } = await build({ ...options, metafile: true });
    for (const [path, { imports }] of Object.entries(metafile.outputs)) {
      if (basename(path) === "lab.js") writePages(lab, imports);
    }
  }
}

/** The pages load what their script imports along with it. */
function writePages(folder, imports) {
  const parts = imports.filter(({ kind }) => kind === "import-statement").map(({ path }) => basename(path));
  const links = parts.map((name) => `<link rel="modulepreload" href="static/${name}">\n`).join("");
  const script = '<script type="module" src="static/lab.js">';
  for (const name of readdirSync(join(web, "pages")).filter((name) => name.endsWith(".html"))) {
    const text = readFileSync(join(web, "pages", name), "utf8");
    writeFileSync(join(folder, name), text.replace(script, links + script));
  }
}

/** The page without Python, from a folder of its own. */
async function serve() {
  const folder = mkdtempSync(join(tmpdir(), "hophoop-"));
  const files = join(folder, "static");
  mkdirSync(files);
  const link = (path, name = basename(path)) => symlinkSync(path, join(files, name));
  for (const name of ["hophoop.wasm", "hophoop-fates.wasm"]) link(join(carried, "lab/wasm", name));
  for (const name of ["icon.svg", "licences.txt"]) link(join(carried, "lab/static", name));
  for (const name of WORDS) link(join(words, name), `words.${name}`);
  const again = '<script>new EventSource("/esbuild").addEventListener("change", () => location.reload());</script>';
  const text = readFileSync(join(web, "pages/index.html"), "utf8");
  writeFileSync(join(folder, "index.html"), text.replace("</head>", `${again}\n</head>`));
  const contexts = await Promise.all(
    page(files).map((options) => context({ ...options, minify: false, sourcemap: "inline" })),
  );
  for (const one of contexts) await one.watch();
  const { port } = await contexts[0].serve({ servedir: folder, host: "127.0.0.1" });
  console.log(`http://127.0.0.1:${port}/ (Ctrl-C ends it)`);
}

const [given] = process.argv.slice(2);
if (given === "--serve") await serve();
else await buildInto(given ?? join(carried, "lab/static"), given ?? join(carried, "animate/static"));
