// Case files and links as states of the page, by the native core: nothing is lost, or it is refused by its name.
//   MICROSLIP_ANSWERS the native core; MICROSLIP the program; EXAMPLES folder of case files

import assert from "node:assert/strict";
import { execFileSync, spawn, type ChildProcess } from "node:child_process";
import { once } from "node:events";
import { mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { createInterface } from "node:readline";
import { after, before, test } from "node:test";
import { stateOfCase } from "../src/case_inputs.ts";
import { contactCase, forPeople, nipCase, railCase, startCase } from "../src/case_text.ts";
import type { Reply, Request } from "../src/core.ts";
import { readDescription } from "../src/description.ts";
import { parse } from "../src/units.ts";
import { decode, encode, initialState, keysOf, laws, shapes, stiffnesses, type Given, type More, type State, type Values } from "../src/state.ts";

const { MICROSLIP_ANSWERS: answers = "", MICROSLIP: named = "", EXAMPLES: examples = "" } = process.env;
const program = path.resolve(named);
const scratch = mkdtempSync(path.join(tmpdir(), "explorer-cases-"));

let native: ChildProcess;
let replies: AsyncIterator<string>;
const core = {
  async ask<Result>(_: string, request: Request): Promise<Reply<Result>> {
    native.stdin!.write(`${JSON.stringify(request)}\n`);
    return JSON.parse((await replies.next()).value as string) as Reply<Result>;
  },
};

before(async () => {
  native = spawn(path.resolve(answers), [], { cwd: scratch, stdio: ["pipe", "pipe", "inherit"] });
  replies = createInterface({ input: native.stdout! })[Symbol.asyncIterator]();
  await readDescription(core);
});
after(async () => {
  native.stdin!.end();
  await once(native, "exit");
  rmSync(scratch, { recursive: true });
});

type Numbers = Record<string, number>;
interface Solved { hertz?: Numbers; exact?: Numbers; fastsim2?: Numbers; wheel?: Record<string, number[]>; frames?: Numbers[] }

async function result<Result>(request: Request): Promise<Result> {
  const reply = await core.ask<Result>("", request);
  assert.equal(reply.error, undefined);
  return reply.result!;
}

const example = (name: string) => readFileSync(path.join(examples, name), "utf8");
const textOf = (state: State) => ({ contact: () => contactCase(state.contact, state.contact.theory), rail: () => railCase(state.rail, "exact"), start: () => startCase(state.start), nip: () => nipCase(state.nip) })[state.view]();

function replaced(text: string, from: string, to: string): string {
  assert.ok(text.includes(from), from);
  return text.replace(from, to);
}

/** What the page says of a case that it does not take. */
async function refusal(text: string, files: Record<string, string> = {}): Promise<string> {
  return stateOfCase(core, { case: text, files }).then(() => "taken", (error: unknown) => (error as Error).message);
}

/** Forces of the page's state, and of the file by the program. */
async function forces(state: State, byProgram: Solved): Promise<[number[], number[]]> {
  if (state.view === "rail") {
    const { wheel } = await result<Solved>({ call: "solve", case: textOf(state) });
    const of = ({ force_x, force_y, force_z, moment_z }: Record<string, number[]>) => [...force_x!, ...force_y!, ...force_z!, ...moment_z!];
    return [of(wheel!), of(byProgram.wheel!)];
  }
  const of = ({ fx, fy, mz }: Numbers) => [fx!, fy!, mz!];
  if (state.view === "start") {
    const { frames } = await result<Solved>({ call: "transient", case: textOf(state) });
    return [of(frames!.at(-1)!), of(byProgram.exact!)];
  }
  if (state.view === "nip") {
    const { given } = await result<{ given: Numbers }>({ call: "nip", case: textOf(state) });
    return [of(given), of(byProgram.exact!)];
  }
  const found = await result<Solved>({ call: "solve", case: textOf(state), extent: "solution" });
  const all = ({ exact, fastsim2, hertz }: Solved) => [...(exact ? of(exact) : []), ...of(fastsim2!), hertz!.a!, hertz!.b!];
  return [all(found), all(byProgram)];
}

/** A case file by the program. */
function solved(file: string): Solved {
  return JSON.parse(execFileSync(program, ["solve", file, "--json", "-o", path.join(scratch, "solved.h5")], { encoding: "utf8", maxBuffer: 1e9 })) as Solved;
}

test("every example is shown with the program's numbers, or refused with the names of keys", async () => {
  const refused: Record<string, RegExp> = {
    "creep_sweep.toml": /grid: unknown key/, "wheel_rail_sample.toml": /case: unknown key/, "load_spread.toml": /case: unknown key/,
    "friction_of_ones_own.toml": /friction\.table/,
    "lateral_sweep.toml": /does not have this of the case: sweep\.lateral/, "wheelset_in_curve.toml": /does not have this of the case: .*wheel\.side/,
    "coated_roller.toml": /does not have this of the case: body1\.layers\.1\.poisson_ratio, .*body1\.layers\.2\.thickness/,
    "twin_disc.toml": /does not have this of the case: material\.hardness, material\.shear_yield_strength$/,
    "two_rollers.toml": /does not have this of the case: body1\.shear_modulus, .*load\.approach, motion\.direction, solution\.theory$/,
  };
  const shown: string[] = [];
  for (const name of readdirSync(examples).filter((file) => file.endsWith(".toml"))) {
    if (refused[name]) {
      assert.match(await refusal(example(name)), refused[name], name);
      continue;
    }
    const state = await stateOfCase(core, { case: example(name) });
    const [found, wanted] = await forces(state, solved(path.join(examples, name)));
    const largest = Math.max(...wanted.map(Math.abs));
    found.forEach((value, k) => { assert.ok(Math.abs(value - wanted[k]!) <= 1e-9 * largest, `${name}: ${String(value)} on the page, ${String(wanted[k])} by the program`); });
    shown.push(name);
  }
  assert.deepEqual(shown.sort(), ["creep_curve.toml", "hertzian_contact.toml", "rubber_roller.toml", "starting_to_roll.toml", "wheel_on_rail.toml"]);
});

test("laws of friction that fall with the slip are shown with all of their numbers", async () => {
  const classical = replaced(example("hertzian_contact.toml"), '"second_order"', '"classical"');
  for (const [law, numbers] of [
    ["polach", { static_coefficient: 0.35, ratio: 0.45, decay: 0.7 }],
    ["linear", { kinetic_coefficient: 0.2, drop: 0.1, half_velocity: 1, second_drop: 0.05, second_half_velocity: 3 }],
    ["exponential", { kinetic_coefficient: 0.2, drop: 0.1, half_velocity: 1 }],
  ] as const) {
    const lines = Object.entries(numbers).map(([key, value]) => `${key} = ${String(value)}`).join("\n");
    const text = replaced(replaced(classical, 'law = "coulomb"', `law = "${law}"`), "coefficient = 0.3 ", `${lines} #`), file = path.join(scratch, "falling.toml");
    writeFileSync(file, text);
    const state = await stateOfCase(core, { case: text });
    for (const [key, value] of Object.entries(numbers)) assert.equal(state.contact.values[`friction.${key}`], value, `${law}: ${key}`);
    const [found, wanted] = await forces(state, solved(file));
    found.forEach((value, k) => { assert.ok(Math.abs(value - wanted[k]!) <= 1e-9 * Math.max(...wanted.map(Math.abs)), law); });
  }
});

/** Another number for every key, with all digits. */
function changed(values: Values): Values {
  return Object.fromEntries(Object.entries(values).map(([key, value]) => {
    if (key === "motion.steps") return [key, value + 1];
    if (key.endsWith("hardness")) return [key, value + 0.123456789];
    if (value === Infinity) return [key, 1.7 + key.length / 7];
    return [key, value === 0 ? 0.001 / 3 : value * 1.0123456789];
  }));
}

test("states come back from their case files with every number", async () => {
  const back = async (state: State) => stateOfCase(core, { case: textOf(state) });
  for (const law of Object.keys(laws())) {
    for (const theory of ["exact", "fastsim2"] as const) {
      const state: State = { ...initialState(), view: "contact" };
      state.contact = { ...state.contact, values: changed(state.contact.values), law, theory, elements: [20, 31] };
      const ofFalling: More = law === "coulomb" ? {} : { "solution.discretisation": "classical", "solution.slip_start": "above" };
      state.contact.more = { "solution.slope_reduction.initial": 0.9 / 7, "solution.slope_reduction.decay": 1 / 3, "solution.flexibility": "one", ...(theory === "exact" ? { "solution.tolerance": 1e-7 / 3, ...ofFalling } : {}) };
      const found = (await back(state)).contact, has = (key: string) => !/^(ellipse|friction)\./.test(key) || keysOf(law).includes(key);
      const keys = Object.keys(state.contact.values).filter(has);
      assert.ok(keys.length >= 12);
      for (const key of keys) assert.equal(found.values[key], state.contact.values[key], key);
      assert.deepEqual([found.law, found.theory, found.elements, found.more], [law, theory, [20, 31], state.contact.more]);
    }
  }
  for (const longitudinal of ["force", "creepage"] as Given[]) {
    for (const lateral of ["force", "creepage"] as Given[]) {
      const state: State = { ...initialState(), view: "start" };
      state.start = { ...state.start, values: changed(state.start.values), given: { longitudinal, lateral }, elements: [20, 31] };
      const found = (await back(state)).start, other = { force: "creepage", creepage: "force" };
      const left = [`motion.${other[longitudinal]}_longitudinal`, `motion.${other[lateral]}_lateral`];
      for (const key of Object.keys(state.start.values).filter((key) => !left.includes(key))) assert.equal(found.values[key], state.start.values[key], key);
      assert.deepEqual([found.given, found.elements], [{ longitudinal, lateral }, [20, 31]]);
    }
  }
  for (const given of ["force", "creepage"] as Given[]) {
    for (const stiffness of stiffnesses) {
      const state: State = { ...initialState(), view: "nip" }, ratio = { "body2.layers.1.poisson_ratio": 0.49 };
      state.nip = { ...state.nip, values: changed({ ...state.nip.values, ...ratio }), given, stiffness, elements: [20, 31], more: { "solution.tolerance": 1e-7 / 3 } };
      const found = (await back(state)).nip, other = { force: "creepage", creepage: "force" }[given];
      const left = [`motion.${other}_longitudinal`, ...stiffnesses.filter((key) => key !== stiffness).map((key) => `body2.layers.1.${key}`)];
      for (const key of Object.keys(state.nip.values).filter((key) => !left.includes(key))) assert.equal(found.values[key], state.nip.values[key], key);
      assert.deepEqual([found.given, found.stiffness, found.elements, found.more], [given, stiffness, [20, 31], state.nip.more]);
      state.nip.values["body2.layers.1.relaxation_shares.2"] = 0; // no second term
      assert.equal((await back(state)).nip.values["body2.layers.1.relaxation_shares.2"], 0);
    }
  }
  for (const shape of Object.keys(shapes())) {
    const state: State = { ...initialState(), view: "rail" };
    const more = { "solution.grid": 30, "solution.tolerance": 1e-7 / 3, "track.gauge_height": 0.0085, "wheel.roll": 1e-3 / 3, "wheel.pitch_velocity": 0, "rail.trim": [-0.034, 0.036], "rail.unit": "mm", "rail.deviation_lateral": 1e-4 / 3, "wheelset.tape_circle": 1e-4, "material.hardness": 3e9 / 7 };
    state.rail = { ...state.rail, values: changed(state.rail.values), side: shape === "flat" ? "right" : "left", shape, more };
    const found = (await back(state)).rail;
    assert.deepEqual(found, state.rail);
  }
});

test("states come back from their links with every number", async () => {
  const state = initialState();
  state.contact = { ...state.contact, values: changed(state.contact.values), given: "ellipse", law: "rational", theory: "fastsim2", elements: [20, 31], cut: 1 / 3 };
  state.contact.values["body1.rolling_radius"] = -Infinity;
  state.contact.more = { "solution.discretisation": "classical", "solution.slope_reduction.initial": 1 / 3 };
  state.rail = { ...state.rail, values: changed(state.rail.values), side: "right", shape: "conformal", profiles: { rail: "a.txt", wheel: "b.txt" }, files: { "a.txt": "1 2" }, more: { "rail.unit": "in", "rail.trim": [-0.034, 1 / 30], "wheel.roll": 1 / 3 } };
  state.start = { ...state.start, values: changed(state.start.values), given: { longitudinal: "creepage", lateral: "force" }, elements: [20, 31], frame: 7 };
  state.nip = { ...state.nip, values: changed(state.nip.values), given: "creepage", stiffness: "shear_modulus", elements: [20, 31], shown: "px", more: { "solution.tolerance": 1e-7 / 3 } };
  assert.deepEqual(await decode(await encode(state)), state);
  state.rail.more["rail.weight"] = 60;
  await assert.rejects(async () => decode(await encode(state)), /the core has no rail\.weight/);
  delete state.rail.more["rail.weight"];
  state.contact.values["motion.creepage_lateral"] = 50;
  await assert.rejects(async () => decode(await encode(state)), /motion\.creepage_lateral = 50: must be in \[-2, 2\]/);
});

test("what of bodies with layers the page does not have is named", async () => {
  const roller = example("rubber_roller.toml"), layer = replaced(roller, "[load]", '[[body2.layers]]\nthickness = "2 mm"\nyoung_modulus = "3 MPa"\npoisson_ratio = 0.4\n\n[load]');
  const ofSteel = replaced(roller, "[body2]", '[[body1.layers]]\nthickness = "2 mm"\nyoung_modulus = "3 MPa"\npoisson_ratio = 0.4\n\n[body2]');
  const rolling = replaced(roller, 'rolling_speed = "5 m/s"', 'rolling_speed = "5 m/s"\nkind = "transient"'), relaxed = /relaxation_(shares|times) = .*\n/g;
  const keys = (body: string, place: number) => ["poisson_ratio", "thickness", "young_modulus"].map((key) => `${body}.layers.${String(place)}.${key}`);
  for (const [text, lacking] of [
    [layer, keys("body2", 2)],
    [ofSteel, keys("body1", 1)],
    [replaced(replaced(roller, "[0.15, 0.1]", "[0.15, 0.1, 0.05]"), '["0.5 ms", "20 ms"]', '["0.5 ms", "20 ms", 1]'), ["body2.layers.1.relaxation_shares", "body2.layers.1.relaxation_times"]],
    [replaced(roller, "poisson_ratio = 0.499", "poisson_ratio = 0.499\nbulk_relaxation_shares = [0.1]\nbulk_relaxation_times = [1]"), ["body2.layers.1.bulk_relaxation_shares", "body2.layers.1.bulk_relaxation_times"]],
    [replaced(roller, "[motion]", "[motion]\ncreepage_lateral = 0.01"), ["motion.creepage_lateral"]],
    [replaced(roller, "[motion]", '[motion]\ndirection = "backward"'), ["motion.direction"]],
    [rolling.replaceAll(relaxed, ""), ["motion.kind"]],
  ] as const) {
    const said = await refusal(text);
    assert.ok(said.startsWith("the page does not have this of the case: "), said);
    for (const key of lacking) assert.ok(said.split(/[ ,]+/).includes(key), `${said} instead of ${key}`);
  }
});

test("what the page does not have is named", async () => {
  const rolling = example("hertzian_contact.toml"), wheel = example("wheel_on_rail.toml");
  const classical = replaced(rolling, '"second_order"', '"classical"'), lacking = "the page does not have this of the case: ";
  for (const [text, why] of [
    [replaced(classical, 'poisson_ratio = 0.28\n\n# [[body2', 'poisson_ratio = 0.3\n\n# [[body2'), `${lacking}body2.poisson_ratio`],
    [replaced(classical, 'spin = "0.4 1/m"', 'spin = "0.4 1/m"\nstep = "0.3 mm"'), `${lacking}motion.step`],
    [replaced(replaced(classical, 'coefficient = 0.3 ', 'kinetic_coefficient = 0.2\ndrop = 0.1\nhalf_velocity = 1\nmemory_distance = 0.001 #'), 'law = "coulomb"', 'law = "linear"'), `${lacking}friction.memory_distance`],
    [replaced(rolling, "creepage_longitudinal = 0.0018", "creepage_longitudinal = 50"), "motion.creepage_longitudinal = 50: must be in [-2, 2]"],
    [replaced(wheel, 'coefficient = 0.3', 'coefficient = [0.3, 0.2]\nangle = [0.1, 0.2]'), `${lacking}friction.angle, friction.coefficient`],
    [replaced(wheel, "[friction]", "[interior]\nx = [0.0]\ny = [0.0]\nz = [-0.004]\n[friction]"), `${lacking}interior.x, interior.y, interior.z`],
    [replaced(replaced(wheel, '# shape = "flat"', 'shape = "flat" #'), "[friction]", '[[rail.layers]]\nthickness = "0.1 mm"\nyoung_modulus = "2 GPa"\npoisson_ratio = 0.4\n[friction]'),
      `${lacking}rail.layers.1.poisson_ratio, rail.layers.1.thickness, rail.layers.1.young_modulus`],
    [replaced(wheel, "profiles/s1002.prw", "profiles/worn.prw"), 'wheelset.profile = "profiles/worn.prw": not here; such a file goes along with the case'],
  ] as const) assert.ok((await refusal(text)).includes(why), `${await refusal(text)} instead of ${why}`);
});

test("a profile that goes along with a case is that of the state, under the end of its path", async () => {
  const text = replaced(example("wheel_on_rail.toml"), "profiles/s1002.prw", "../worn.prw"), content = example("profiles/s1002.prw");
  const { rail } = await stateOfCase(core, { case: text, files: { "../worn.prw": content } });
  assert.deepEqual([rail.profiles, rail.files], [{ rail: "60e1.prr", wheel: "worn.prw" }, { "worn.prw": content }]);
});

test("numbers are read as people write them, in any unit of case files, as slopes, radii and per mille", () => {
  for (const [text, si, unit, wanted] of [
    ["55,5 kN", "N", "kN", 55500], ["12 kip", "N", "kN", 12 * 4448.2216152605], ["60 mph", "m/s", "km/h", 26.8224], ["145 psi", "Pa", "MPa", 145 * 6894.757293168361],
    ["2 permille", "-", "%", 0.002], ["3 \u2030", "-", "", 0.003], ["1:40", "rad", "mrad", Math.atan(1 / 40)], ["-1 : 20", "rad", "mrad", -Math.atan(1 / 20)], ["25", "rad", "mrad", 0.025],
    ["R 300 m", "1/m", "1/km", 1 / 300], ["R=-0.5 km", "1/m", "1/km", -1 / 500], ["inf", "m", "mm", Infinity],
  ] as const) {
    const found = parse(text, si, unit);
    assert.ok(found === wanted || Math.abs(Number(found) - wanted) <= 1e-12 * Math.abs(wanted), `${text}: ${String(found)}`);
  }
  for (const [text, si, unit, why] of [["55 t", "N", "kN", /"t" is not one of its units: N, kN/], ["1:0", "rad", "mrad", /not one of its units/], ["1:40", "N", "kN", /not one of its units/], ["abc", "m", "mm", /not a number/]] as const)
    assert.match(String(parse(text, si, unit)), why);
});

test("cases for people have units where they change no digit, and are the same cases", async () => {
  const kinds = { contact: (state: State) => contactCase(state.contact, "exact"), rail: (state: State) => railCase(state.rail, "exact"), start: (state: State) => startCase(state.start), nip: (state: State) => nipCase(state.nip) };
  for (const view of ["contact", "rail", "start", "nip"] as const) {
    const state = initialState();
    state[view].values = { ...changed(state[view].values), ...(view === "nip" ? { "body2.layers.1.poisson_ratio": 0.49 } : {}) };
    for (const values of [initialState(), state]) {
      const bare = kinds[view](values), told = forPeople(view, bare);
      assert.match(told, /= "[\d.]+ (kN|mm|km\/h|GPa)"/, view);
      const inputs = async (text: string) => (await result<{ inputs: Record<string, unknown> }>({ call: "inputs", case: text })).inputs;
      assert.deepEqual(await inputs(told), await inputs(bare));
    }
  }
});
