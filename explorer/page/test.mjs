// Bundles the tests and runs them: node test.mjs, with the variables that tests/page.test.ts names.
import { build } from "esbuild";
import { spawnSync } from "node:child_process";
import { rmSync } from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";

const here = path.dirname(fileURLToPath(import.meta.url)), bundle = path.join(here, "tests/page.test.bundle.mjs");
await build({ entryPoints: [path.join(here, "tests/page.test.ts")], outfile: bundle, bundle: true, platform: "node", format: "esm", packages: "external" });
const { status } = spawnSync(process.execPath, ["--test", bundle], { stdio: "inherit" });
rmSync(bundle);
process.exit(status ?? 1);
