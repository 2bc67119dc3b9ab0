// Notices of what the built page has in it of others: packages of node, headers and the system that the core is compiled with.
import { readFile } from "node:fs/promises";
import path from "node:path";

const musl = "/usr/share/emscripten/system/lib/libc/musl/COPYRIGHT";

/** Paragraphs of a copyright file of Debian's, each by its fields. */
async function paragraphsOf(debian) {
  const text = await readFile(`/usr/share/doc/${debian}/copyright`, "utf8");
  return text.split(/\n\n+/).map((paragraph) => new Map([...paragraph.matchAll(/^([A-Z][\w-]+):((?:.*\n?)(?:^[ \t].*\n?)*)/gm)].map(([, name, value]) => [name, value.trim()])));
}

/** Holders and licence, that of MIT which Debian calls Expat, of what a Debian package has in these places. */
async function noticeOf(debian, isInPage) {
  const paragraphs = await paragraphsOf(debian), [, licence] = paragraphs.map((one) => /^Expat\n([^]+)$/.exec(one.get("License") ?? "")).find(Boolean) ?? [];
  const holders = paragraphs.filter((one) => one.has("Files") && one.get("Files").split(/\s+/).some(isInPage)).map((one) => one.get("Copyright").split(/\n\s*/).map((line) => `Copyright ${line}`).join("\n"));
  if (!licence || holders.length === 0) throw new Error(`no licence in the copyright file of ${debian}`);
  return `${[...new Set(holders)].join("\n")}\n\n${licence.replace(/^ /gm, "").replace(/^\.$/gm, "")}`;
}

/** Folders of the packages that are bundled, by what esbuild says of its inputs. */
function packagesIn(metafiles) {
  const inputs = metafiles.flatMap(({ inputs: of }) => Object.keys(of));
  return [...new Set(inputs.flatMap((input) => /^(.*node_modules\/(?:@[^/]+\/)?[^/]+)\//.exec(input)?.[1] ?? []))].sort();
}

/** The text of licences.txt. `from`: the folder that inputs are named from. */
export async function licencesOf(metafiles, from, own) {
  const parts = [["microslip", await readFile(own, "utf8")]];
  for (const folder of packagesIn(metafiles)) {
    const at = path.resolve(from, folder), { name, version } = JSON.parse(await readFile(path.join(at, "package.json"), "utf8"));
    parts.push([`${name} ${version}`, await readFile(path.join(at, "LICENSE"), "utf8")]);
  }
  const ofHeaders = (place) => place === "*" || place.startsWith("include/");
  parts.push(["JSON for Modern C++ (nlohmann-json)", await noticeOf("nlohmann-json3-dev", ofHeaders)], ["toml++", await noticeOf("libtomlplusplus-dev", ofHeaders)],
    ["Emscripten", await noticeOf("emscripten", (place) => place === "*")], ["musl, the C library of Emscripten", await readFile(musl, "utf8")],
    ["libc++, libc++abi and compiler-rt", "Of the LLVM project, under the Apache License 2.0 with LLVM exceptions, which ask for no notice in what is compiled with them."]);
  return `What is in this page, and under which licences\n\n${parts.map(([name]) => `  ${name}`).join("\n")}\n\n${parts.map(([name, text]) => `${"=".repeat(80)}\n${name}\n${"=".repeat(80)}\n\n${text.trim()}\n`).join("\n")}`;
}
