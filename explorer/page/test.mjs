// Bundles tests and runs them: node test.mjs NAME, with the variables that tests/NAME.test.ts names.
import { build } from "esbuild";
import { spawnSync } from "node:child_process";
import { rmSync } from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { builtInProfiles } from "./profiles.mjs";

const [name] = process.argv.slice(2);
if (!name) throw new Error("usage: node test.mjs NAME");
const tests = path.join(path.dirname(fileURLToPath(import.meta.url)), "tests"), bundle = path.join(tests, `${name}.test.bundle.mjs`);
await build({
  entryPoints: [path.join(tests, `${name}.test.ts`)], outfile: bundle, bundle: true, platform: "node", format: "esm", packages: "external",
  define: builtInProfiles,
});
const { status } = spawnSync(process.execPath, ["--test", bundle], { stdio: "inherit" });
rmSync(bundle);
process.exit(status ?? 1);
