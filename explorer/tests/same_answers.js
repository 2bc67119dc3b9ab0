// Asks the native core and the one for browsers the same, and compares all numbers: of two bodies to 1e-12 of the largest
// of their list, or of themselves. Of a wheel on a rail overlaps of 0.1 mm are differences of coordinates of a metre, whose
// last bits depend on the functions of C's library, and iterations to 1e-6 carry them on: there forces and wear to 1e-9, and
// fields, whose elements end where pressure ends, to 1e-8. Prints what differs.
"use strict";
const { spawnSync } = require("child_process");
const fs = require("fs");
const os = require("os");
const path = require("path");

const [answers, core, examples] = process.argv.slice(2);
const tolerances = { bodies: 1e-12, wheel: 1e-9, wheelFields: 1e-8 };
const read = (name) => fs.readFileSync(path.join(examples, name), "utf8");

function replaced(text, ...pairs) {
  for (const [from, to] of pairs) {
    if (!text.includes(from)) throw new Error(`${from} is not in the example`);
    text = text.replace(from, to);
  }
  return text;
}

const ellipse = replaced(read("hertzian_contact.toml"), ["grid = [40, 40]", "grid = [24, 24]"]);
const quick = replaced(ellipse, ['theory = "exact"', 'theory = "fastsim2"'], ['discretisation = "second_order"', "#"], ["tolerance = 1e-6", "#"]);
const classical = replaced(ellipse, ['"second_order"', '"classical"']);
const starting = read("starting_to_roll.toml");
const shifted = replaced(starting, ["creepage_longitudinal = 0.0015", "force_longitudinal = -12e3"], ["steps = 60", "steps = 20"]);
const core2 = '\nyoung_modulus = "210 GPa"\npoisson_ratio = 0.28\n\n[[body2'; // rollers with a crown: nothing of cylinders but noise across
const nip = replaced(read("rubber_roller.toml"), [`inf${core2}`, `20${core2}`], ["10 kN", "4 kN"], ["grid = 80", "grid = [16, 8]"]);
const wheel = replaced(read("wheel_on_rail.toml"), ["profiles/60e1.prr", "60e1.prr"], ["profiles/s1002.prw", "s1002.prw"], ["grid = 60", "grid = 24"]);
const quickWheel = replaced(wheel, ['theory = "exact"', 'theory = "fastsim2"'], ['shape = "flat"', 'shape = "curved"']);
const files = { "60e1.prr": read("profiles/60e1.prr"), "s1002.prw": read("profiles/s1002.prw") };
const requests = [
  { call: "description" },
  { call: "inputs", case: quick },
  { call: "solve", case: quick, fields: true },
  { call: "solve", case: ellipse, fields: true },
  { call: "solve", case: ellipse + "\n[interior]\nx = [-0.002, 0.0]\ny = [0.0]\nz = [-0.001, -0.004]\n", fields: true, extent: "solution" },
  { call: "solve", case: classical, extent: "solution" },
  { call: "radii", case: ellipse, a: 0.005, b: 0.003 },
  { call: "creep_curve", case: ellipse, variable: "spin", from: 0, to: 1, count: 5 },
  { call: "creep_curve", case: quick, variable: "creepage_lateral", from: 0, to: 0.01, count: 5 },
  { call: "transient", case: shifted },
  { call: "nip", case: nip },
  { call: "nip", case: replaced(nip, ['force_longitudinal = "-400 N"', "creepage_longitudinal = 0.01"]) },
  { call: "nip_curve", case: nip, count: 5 },
  { call: "solve", case: quickWheel, files, fields: true },
  { call: "solve", case: wheel, fields: true },
  { call: "solve", case: replaced(wheel, ["6.04 mm", "2 mm"]), fields: true },
  { call: "conicity", case: wheel, amplitudes: [0.002, 0.004, 0.001] },
  { call: "profile", name: "s1002.prw", text: files["s1002.prw"] },
  { call: "profile", name: "worn.txt", text: "1 2\n3 x\n", role: "rail" },
  { call: "solve", case: replaced(ellipse, ["coefficient = 0.3 ", "coefficient = -0.3 "]) },
  { call: "solve", case: replaced(ellipse, ["normal_force =", "normal_forse ="]) },
  { call: "solve", case: replaced(ellipse, ['"80 kN"', '"80 kNm"']) },
];

// What tells of the build and the time, and how far an iteration went below its tolerance.
const others = new Set(["created", "compiler", "build_type", "commit", "version", "time", "residual"]);

// What is near zero as a difference: moments, here of some 100 N m in all; forces across and on free rollers, of a kN;
// a traction coefficient less k/p0; the height of the tape circle, which is the origin of many profiles [m].
const floors = { tape_circle: 1e-3, mz: 1, my: 1, fx: 1, fy: 1, power_by_creepage: 1, fatigue_index: 1 };

let compared = 0;
let worst = 0;
let tolerance = 0;
let total = 0;
const differences = [];
function compare(a, b, place, size = 0) {
  if (typeof a === "number" && typeof b === "number") {
    ++compared;
    const difference = Math.abs(a - b) / Math.max(Math.abs(a), Math.abs(b), size, Number.MIN_VALUE);
    if (a !== b) worst = Math.max(worst, difference);
    const allowed = place.includes("/fields[") ? tolerances.wheelFields : tolerance;
    if (a !== b && !(difference <= allowed)) differences.push(`${place}: ${a} and ${b}, ${difference.toExponential(1)}`);
  } else if (Array.isArray(a) && Array.isArray(b) && a.length === b.length) {
    const largest = a.reduce((most, value) => (typeof value === "number" ? Math.max(most, Math.abs(value)) : most), 0);
    a.forEach((value, i) => compare(value, b[i], `${place}[${i}]`, Math.max(size, largest)));
  } else if (a && b && typeof a === "object" && typeof b === "object" && !Array.isArray(a)) {
    for (const name of new Set([...Object.keys(a), ...Object.keys(b)]))
      if (!others.has(name)) compare(a[name], b[name], `${place}/${name}`, floors[name] ?? 0);
  } else if (a !== b) {
    differences.push(`${place}: ${JSON.stringify(a)} and ${JSON.stringify(b)}`);
  }
}

const folder = fs.mkdtempSync(path.join(os.tmpdir(), "microslip_explorer_"));
const lines = requests.map((request) => JSON.stringify(request)).join("\n") + "\n";
const native = spawnSync(answers, [], { input: lines, cwd: folder, encoding: "utf8", maxBuffer: 1 << 30 });
fs.rmSync(folder, { recursive: true });
if (native.status !== 0) throw new Error(`${answers} ended with ${native.status}: ${native.stderr}`);
const expected = native.stdout.trim().split("\n").map((line) => JSON.parse(line));

require(core)().then((explorer) => {
  requests.forEach((request, k) => {
    const found = JSON.parse(explorer.answer(JSON.stringify(request)));
    tolerance = request.case && request.case.includes("[wheel]") ? tolerances.wheel : tolerances.bodies;
    [compared, worst] = [0, 0];
    compare(found, expected[k], `${k} ${request.call}`);
    total += compared;
    console.log(`${k} ${request.call}: ${compared} numbers, apart by ${worst.toExponential(1)} at most`);
  });
  console.log(differences.slice(0, 40).join("\n"));
  console.log(`${requests.length} requests, ${total} numbers, ${differences.length} differ`);
  process.exit(differences.length === 0 && total > 0 ? 0 : 1);
});
