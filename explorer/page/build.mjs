// Bundles the page into static files that open without a server: node build.mjs TO CORE
//   TO    folder for index.html, page.js, page.css and copies of the core's scripts
//   CORE  folder with explorer_core.js, explorer_core_plain.js, hertz_table.js
import { build } from "esbuild";
import { copyFile, mkdir } from "node:fs/promises";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { builtInProfiles } from "./profiles.mjs";

const [to, core] = process.argv.slice(2);
if (!to || !core) throw new Error("usage: node build.mjs TO CORE");
const here = path.dirname(fileURLToPath(import.meta.url));

await mkdir(to, { recursive: true });
await build({
  entryPoints: { page: path.join(here, "src/main.ts") },
  outdir: to,
  bundle: true,
  minify: true,
  format: "iife",
  target: "es2022",
  define: builtInProfiles,
});
await copyFile(path.join(here, "src/index.html"), path.join(to, "index.html"));
for (const script of ["explorer_core.js", "explorer_core_plain.js", "hertz_table.js"])
  await copyFile(path.join(core, script), path.join(to, script));
