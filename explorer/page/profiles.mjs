// The profiles of the examples that the page has built in, by the names of their files: a definition for esbuild.
import { readFile } from "node:fs/promises";
import path from "node:path";
import { fileURLToPath } from "node:url";

const folder = path.join(path.dirname(fileURLToPath(import.meta.url)), "../../examples/profiles");
const names = ["60e1.prr", "s1002.prw"];
const texts = await Promise.all(names.map((name) => readFile(path.join(folder, name), "utf8")));
export const profileTexts = Object.fromEntries(names.map((name, k) => [name, texts[k]]));
export const builtInProfiles = { BUILT_IN_PROFILES: JSON.stringify(profileTexts) };
