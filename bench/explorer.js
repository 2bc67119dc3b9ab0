// Times of the explorer's core natively and in WebAssembly, for docs/explorer-core.md:
// node bench/explorer.js build/release/bin/microslip_explorer_answers build/explorer
"use strict";
const { spawnSync } = require("child_process");
const fs = require("fs");
const os = require("os");
const path = require("path");

const [answers, built] = process.argv.slice(2);
const examples = path.join(__dirname, "..", "examples");
const repeats = 60;
const read = (name) => fs.readFileSync(path.join(examples, name), "utf8");

const bodies = `[body1]
rolling_radius = "460 mm"
transverse_radius = inf
young_modulus = "210 GPa"
poisson_ratio = 0.28
[body2]
rolling_radius = inf
transverse_radius = "300 mm"
young_modulus = "210 GPa"
poisson_ratio = 0.28
[load]
normal_force = "80 kN"
[friction]
coefficient = 0.3
`;
const ellipse = (theory, elements) => (k) => ({
  call: "solve", extent: "solution", fields: true,
  case: `${bodies}[motion]
creepage_longitudinal = ${0.0018 * (1 + k / 1000)}
creepage_lateral = 0.0006
spin = 0.4
rolling_speed = 30
[solution]
theory = "${theory}"
grid = [${elements}, ${elements}]
`,
});
const files = { "60e1.prr": read("profiles/60e1.prr"), "s1002.prw": read("profiles/s1002.prw") };
const wheel = (theory) => (k) => ({
  call: "solve", extent: "solution", fields: true, files: k === 0 ? files : {},
  case: `[track]
gauge = "1435 mm"
cant = 0.05
[rail]
profile = "60e1.prr"
[wheelset]
profile = "s1002.prw"
nominal_radius = "460 mm"
flange_back_distance = "1360 mm"
[wheel]
vertical_force = "80 kN"
lateral = "${(-4 + (10 * k) / repeats).toFixed(3)} mm"
yaw = "2 mrad"
forward_velocity = "108 km/h"
[material]
young_modulus = "210 GPa"
poisson_ratio = 0.28
[friction]
coefficient = 0.3
[solution]
theory = "${theory}"
`,
});
/** The example's rollers with a crown. */
const rollers = read("rubber_roller.toml").replace(/inf(?=\n.*\n.*\n\n\[\[body2)/, "20").replace("10 kN", "4 kN").replace("grid = 80", "grid = [32, 16]");
const nip = (from, to) => (k) => ({ call: "nip", case: rollers.replace(from, to(k)) });
const kinds = {
  "FASTSIM2, 20 x 20": ellipse("fastsim2", 20),
  "exact theory, 24 x 24": ellipse("exact", 24),
  "wheel on a rail, fastsim2": wheel("fastsim2"),
  "wheel on a rail, exact": wheel("exact"),
  "nip, another load": nip("4 kN", (k) => `${4 + k / 50} kN`),
  "nip, another force": nip("-400 N", (k) => `${-400 - k} N`),
};

const median = (values) => values.slice().sort((a, b) => a - b)[Math.floor(values.length / 2)];
const ms = (seconds) => (seconds * 1e3).toFixed(2).padStart(9);
/** Of the later half: engines compile what runs often once more. */
const settled = (times) => median(times.slice(times.length / 2));

function nativeTimes(make) {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), "microslip_explorer_"));
  const lines = Array.from({ length: repeats }, (_, k) => JSON.stringify(make(k)) + "\n").join("");
  const run = spawnSync(path.resolve(answers), [], { input: lines, cwd: folder, encoding: "utf8", maxBuffer: 1 << 30 });
  fs.rmSync(folder, { recursive: true });
  return run.stdout.trim().split("\n").map((line) => JSON.parse(line).time);
}

async function timesOf(core, make) {
  const times = [];
  const whole = [];
  for (let k = 0; k < repeats; ++k) {
    const request = make(k);
    const start = performance.now();
    const reply = JSON.parse(core.answer(JSON.stringify(request)));
    whole.push((performance.now() - start) / 1e3);
    if (reply.error) throw new Error(reply.error.message);
    times.push(reply.time);
  }
  return { times, whole };
}

async function main() {
  const rows = Object.keys(kinds).map((name) => [name, ms(settled(nativeTimes(kinds[name])))]);
  for (const name of ["explorer_core.js", "explorer_core_plain.js"]) {
    const file = path.resolve(built, name);
    const start = performance.now();
    const core = await require(file)();
    const loading = performance.now() - start;
    console.log(`${name}: ${(fs.statSync(file).size / 1e6).toFixed(2)} MB, loads in ${loading.toFixed(0)} ms`);
    for (const [k, kind] of Object.keys(kinds).entries()) {
      const { times, whole } = await timesOf(core, kinds[kind]);
      rows[k].push(ms(settled(times)), ms(settled(whole)), ms(whole[0]));
    }
  }
  const heads = ["native", "core", "answer", "first", "core", "answer", "first"];
  console.log("ms".padEnd(28) + heads.map((head) => head.padStart(9)).join(""));
  for (const [name, ...columns] of rows) console.log(name.padEnd(28) + columns.join(""));
}
main();
