// Case files of the program as states of the page. The core reads them and tells what they say, by their keys; what the
// page then says of its state has to be the same, or the case is refused with the keys that the page does not have.

import { contactCase, cover, nipCase, ofExact, ofFastsim, railCase, startCase } from "./case_text.ts";
import type { Core } from "./core.ts";
import { withoutPlace } from "./fields.ts";
import { initialState, laws, limits, requireLimits, shapes, stiffnesses, type ContactState, type More, type NipState, type RailState, type StartState, type State, type Value, type Values, type View } from "./state.ts";

declare const BUILT_IN_PROFILES: Record<string, string>;

/** What a case says by section.key in SI, infinite numbers as words; with the defaults of what it leaves out. */
interface Inputs { kind: "rolling_contact" | "wheel_rail" | "wheelset"; inputs: Record<string, Value>; given: string[] }

/** What the program hands over: a case with the files that it names, or files alone. */
export interface Start { case?: string; files?: Record<string, string> }

/** Of wheels on rails the page takes over what has no field, except for what replaces one. */
const carried = /^(track|rail|wheelset|wheel|material)\.|^solution\.(grid|tolerance)$/;
const notCarried = /\.profile$|\.layers\.|^wheel\.(side|vertical)$|^material\.shear_modulus$|^track\.rail_[yz]$/;

/** The ends of the paths of files, which is all that a browser knows of them. */
function plain(files: Record<string, string>): Record<string, string> {
  return Object.fromEntries(Object.entries(files).map(([path, content]) => [path.replace(/^.*[\\/]/, ""), content]));
}

async function inputsOf(core: Pick<Core, "ask">, text: string, files: Record<string, string>): Promise<Inputs> {
  const reply = await core.ask<Inputs>("inputs", { call: "inputs", case: text, files });
  if (!reply?.result) throw new Error(reply?.error ? withoutPlace(reply.error.message) : "another case came in between");
  return reply.result;
}

function number(value: Value | undefined): number | undefined {
  if (value === "inf") return Infinity;
  return value === "-inf" ? -Infinity : typeof value === "number" ? value : undefined;
}

function fill(values: Values, inputs: Record<string, Value>): void {
  for (const key of Object.keys(values)) values[key] = number(inputs[key]) ?? values[key]!;
}

function pair(value: Value | undefined): [number, number] {
  const [along, across] = value as number[];
  return [along!, across!];
}

function moreOf({ inputs, given }: Inputs, isCarried: (key: string) => boolean): More {
  return Object.fromEntries(given.filter(isCarried).map((key) => [key, inputs[key]!]));
}

function toContact(state: ContactState, wanted: Inputs): string {
  const { inputs } = wanted;
  fill(state.values, inputs);
  state.more = moreOf(wanted, (key) => ofExact.test(key) || ofFastsim.test(key));
  const law = String(inputs["friction.law"]), theory = inputs["solution.theory"];
  if (law in laws()) state.law = law;
  state.theory = theory === "exact" ? "exact" : "fastsim2";
  state.elements = pair(inputs["solution.grid"]);
  return contactCase(state, state.theory);
}

function toStart(state: StartState, { inputs }: Inputs): string {
  fill(state.values, inputs);
  const given = (component: string) => (`motion.force_${component}` in inputs ? "force" : "creepage");
  state.given = { longitudinal: given("longitudinal"), lateral: given("lateral") };
  state.elements = pair(inputs["solution.grid"]);
  return startCase(state);
}

function toNip(state: NipState, wanted: Inputs): string {
  const { inputs } = wanted, { values } = state;
  fill(values, inputs);
  for (const key of Object.keys(values)) {
    const [, list, place] = /^(.*\.relaxation_\w+)\.(\d+)$/.exec(key) ?? [];
    if (list) values[key] = (inputs[list] as number[] | undefined)?.[Number(place) - 1] ?? (key.includes("shares") ? 0 : values[key]!);
  }
  state.stiffness = stiffnesses.find((key) => `${cover}.${key}` in inputs) ?? state.stiffness;
  state.given = "motion.force_longitudinal" in inputs ? "force" : "creepage";
  state.elements = pair(inputs["solution.grid"]);
  state.more = moreOf(wanted, (key) => ofExact.test(key));
  return nipCase(state);
}

function toRail(state: RailState, wanted: Inputs, files: Record<string, string>): string {
  const { inputs } = wanted;
  fill(state.values, inputs);
  const shape = String(inputs["solution.shape"] ?? "true");
  state.side = inputs["wheel.side"] === "right" ? "right" : "left";
  if (shape in shapes()) state.shape = shape;
  state.more = moreOf(wanted, (key) => carried.test(key) && !notCarried.test(key) && !(key in state.values));
  state.profiles = { rail: String(inputs["rail.profile"]), wheel: String(inputs["wheelset.profile"]) };
  state.files = Object.fromEntries(Object.values(state.profiles).filter((name) => files[name] !== BUILT_IN_PROFILES[name]).map((name) => [name, files[name]!]));
  return railCase(state, inputs["solution.theory"] === "fastsim2" ? "fastsim2" : "exact");
}

/** Keys of a case whose values the page does not have, those that stand in its text if any. */
function lost(wanted: Inputs, found: Inputs, isSaid: (key: string) => boolean): string[] {
  const isSame = (key: string) => JSON.stringify(wanted.inputs[key]) === JSON.stringify(found.inputs[key]);
  const all = [...new Set([...Object.keys(wanted.inputs), ...Object.keys(found.inputs)])].filter((key) => !isSaid(key) && !isSame(key));
  const inText = all.filter((key) => wanted.given.includes(key));
  return inText.length ? inText : all;
}

function lacking(keys: string[]): Error {
  return new Error(`the page does not have this of the case: ${keys.join(", ")}`);
}

function viewOf({ kind, inputs }: Inputs): View {
  if (kind !== "rolling_contact") return "rail";
  if (Object.keys(inputs).some((key) => /^body\d\.layers\./.test(key))) return "nip";
  return inputs["motion.kind"] === "transient" ? "start" : "contact";
}

/** The state of a case. Throws an Error in the reader's words, or with the names of the keys that the page does not have. */
export async function stateOfCase(core: Pick<Core, "ask">, start: Start): Promise<State> {
  const text = start.case ?? "", state = initialState(), files = { ...BUILT_IN_PROFILES, ...plain(start.files ?? {}) };
  const wanted = await inputsOf(core, text, files);
  if (wanted.kind === "wheelset") throw lacking(["wheel.side"]); // both
  state.view = viewOf(wanted);
  const own = { rail: () => toRail(state.rail, wanted, files), start: () => toStart(state.start, wanted), nip: () => toNip(state.nip, wanted), contact: () => toContact(state.contact, wanted) }[state.view]();
  const found = await inputsOf(core, own, files);
  const ofSurface = state.view === "rail" && wanted.inputs["solution.theory"] === "fastsim2" ? "solution.shape" : ""; // its rows always follow it
  const keys = lost(wanted, found, (key) => key === "title" || key === ofSurface);
  if (keys.length) throw lacking(keys);
  requireLimits(Object.fromEntries(Object.keys(limits).map((key) => [key, number(wanted.inputs[key]) ?? 0])));
  return state;
}

/** "case." and base64 of a Start in JSON, as `microslip explore` makes it. */
export function startOf(fragment: string): Start | undefined {
  const packed = /^#case\.([\w+/=-]*)$/.exec(fragment)?.[1];
  if (packed === undefined) return undefined;
  const bytes = Uint8Array.from(atob(packed.replaceAll("-", "+").replaceAll("_", "/")), (letter) => letter.charCodeAt(0));
  return JSON.parse(new TextDecoder().decode(bytes)) as Start;
}
