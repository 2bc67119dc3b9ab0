// Bundles the page into static files that open without a server: node build.mjs TO CORE
//   TO    folder for index.html, page.js, rail_head.js, page.css, the core's scripts with their WebAssembly zipped, its table,
//         licences.txt
//   CORE  folder with explorer_core.js, explorer_core_plain.js, hertz_table.js
import { build } from "esbuild";
import { copyFile, mkdir, readFile, rm, writeFile } from "node:fs/promises";
import { createRequire } from "node:module";
import path from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { gzipSync } from "node:zlib";
import { licencesOf } from "./licences.mjs";
import { builtInProfiles, profileTexts } from "./profiles.mjs";

const [to, core] = process.argv.slice(2).map((folder) => path.resolve(folder));
if (!to || !core) throw new Error("usage: node build.mjs TO CORE");
const here = path.dirname(fileURLToPath(import.meta.url));

/** The core's WebAssembly stands in its script in base64: beside the script, zipped, it has a good third. */
async function packCore(name) {
  const script = await readFile(path.join(core, name), "utf8"), embedded = /(data:application\/octet-stream;base64,)([A-Za-z0-9+/=]{1000,})/;
  const [, , wasm] = embedded.exec(script) ?? [];
  if (!wasm) throw new Error(`${name} has no WebAssembly within`);
  const zipped = gzipSync(Buffer.from(wasm, "base64"), { level: 9 }).toString("base64");
  await writeFile(path.join(to, name), `${script.replace(embedded, "$1")}\nconst microslipWasm = "${zipped}";\n`);
}

/** What the page shows before its core is there, as the core answers it. */
async function firstAnswers() {
  const bundle = path.join(to, "first_answers.mjs");
  await build({ entryPoints: [path.join(here, "src/first_answers.ts")], outfile: bundle, bundle: true, platform: "node", format: "esm" });
  const { firstAnswers: ask } = await import(pathToFileURL(path.resolve(bundle)).href);
  await rm(bundle);
  const made = await createRequire(import.meta.url)(path.resolve(core, "explorer_core.js"))();
  return ask({ ask: async (_, request) => JSON.parse(made.answer(JSON.stringify(request))) }, profileTexts);
}

await mkdir(to, { recursive: true });
const bundled = { outdir: to, bundle: true, minify: true, format: "iife", target: "es2022", metafile: true, absWorkingDir: here };
const page = await build({
  ...bundled, entryPoints: { page: path.join(here, "src/main.ts") },
  define: { ...builtInProfiles, FIRST_ANSWERS: JSON.stringify(await firstAnswers()) },
});
const head = await build({ ...bundled, entryPoints: { rail_head: path.join(here, "src/rail_head.ts") }, globalName: "microslipRailHead" });
await writeFile(path.join(to, "licences.txt"), await licencesOf([page.metafile, head.metafile], here, path.join(here, "../../LICENSE")));
await copyFile(path.join(here, "src/index.html"), path.join(to, "index.html"));
for (const script of ["explorer_core.js", "explorer_core_plain.js"]) await packCore(script);
await copyFile(path.join(core, "hertz_table.js"), path.join(to, "hertz_table.js"));
process.exit(); // the core keeps node awake
