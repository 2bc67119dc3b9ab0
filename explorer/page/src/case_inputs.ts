// Case files of the program as states of the page: the core reads them, its result's inputs say what they hold.

import { contactCase, railCase, startCase } from "./case_text.ts";
import type { Core } from "./core.ts";
import { initialState, type State, type Values } from "./state.ts";

type Inputs = Record<string, number | string | (number | string)[]>;
interface Document { kind: string; inputs: Inputs; states?: Inputs; hertz?: { normal_force: number } }

/** What the program hands over: a case with the files that it names, or files alone. */
export interface Start { case?: string; files?: Record<string, string> }

/** Where inputs of a result are in a case file. */
const ofContact: Record<string, string> = {
  rolling_radius_1: "body1.rolling_radius", transverse_radius_1: "body1.transverse_radius",
  rolling_radius_2: "body2.rolling_radius", transverse_radius_2: "body2.transverse_radius",
  normal_force: "load.normal_force", friction_coefficient: "friction.coefficient",
  friction_kinetic_coefficient: "friction.kinetic_coefficient", friction_drop: "friction.drop", friction_half_velocity: "friction.half_velocity",
  creepage_longitudinal: "motion.creepage_longitudinal", creepage_lateral: "motion.creepage_lateral", spin: "motion.spin",
  rolling_speed: "motion.rolling_speed", force_longitudinal: "motion.force_longitudinal", force_lateral: "motion.force_lateral",
  steps: "motion.steps", poisson_ratio_1: "body1.poisson_ratio",
};
const ofRail: Record<string, string> = {
  gauge: "track.gauge", cant: "track.cant", nominal_radius: "wheelset.nominal_radius", flange_back_distance: "wheelset.flange_back_distance",
  poisson_ratio: "material.poisson_ratio", friction_coefficient: "friction.coefficient",
  lateral: "wheel.lateral", yaw: "wheel.yaw", vertical_force: "wheel.vertical_force", forward_velocity: "wheel.forward_velocity",
};
const ofSolver = /^(mx|my|grid|theory|shape|tolerance|discretisation|elements|bound|flexibility|coefficients|slope_reduction.*|motion)$/;

function number(value: unknown): number | undefined {
  const one: unknown = Array.isArray(value) ? value[0] : value;
  if (one === "inf") return Infinity;
  return one === "-inf" ? -Infinity : typeof one === "number" ? one : undefined;
}

function fill(values: Values, inputs: Inputs, places: Record<string, string>): void {
  for (const [name, key] of Object.entries(places)) {
    const value = number(inputs[name]);
    if (value !== undefined && key in values) values[key] = value;
  }
}

function young(inputs: Inputs, suffix: string): number {
  return 2 * number(inputs[`shear_modulus${suffix}`])! * (1 + number(inputs[`poisson_ratio${suffix}`])!);
}

/** Names of inputs that are not the same, but for those of the solver. */
function differing(wanted: Inputs, found: Inputs): string[] {
  const same = (one: unknown, other: unknown) => {
    const [a, b] = [number(one), number(other)];
    return a !== undefined && b !== undefined ? a === b || Math.abs(a - b) <= 1e-9 * Math.abs(a) : JSON.stringify(one) === JSON.stringify(other);
  };
  return [...new Set([...Object.keys(wanted), ...Object.keys(found)])].filter((name) => !ofSolver.test(name) && !same(wanted[name], found[name]));
}

async function documentOf(core: Core, text: string, files: Record<string, string>): Promise<Document> {
  const reply = await core.ask<Document>("start", { call: "solve", case: text, files, extent: "solution" });
  if (!reply?.result) throw new Error(reply?.error?.message ?? "the case was not solved");
  return reply.result;
}

/** Files under the ends of their paths, and the case that names them so. */
function withPlainNames(start: Start): { text: string; files: Record<string, string> } {
  let text = start.case ?? "";
  const files: Record<string, string> = {};
  for (const [path, content] of Object.entries(start.files ?? {})) {
    const name = path.replace(/^.*[\\/]/, "");
    text = text.replaceAll(`"${path}"`, `"${name}"`).replaceAll(`'${path}'`, `"${name}"`);
    files[name] = content;
  }
  return { text, files };
}

/** The state of a case, and a sentence on what of it the page does not have. Throws an Error in the reader's words. */
export async function stateOfCase(core: Core, start: Start): Promise<{ state: State; left: string }> {
  const { text, files } = withPlainNames(start), state = initialState();
  const { kind, inputs, states, hertz } = await documentOf(core, text, files);
  let own: string;
  if (kind === "wheel_rail") {
    state.view = "rail";
    const { rail } = state;
    fill(rail.values, { ...inputs, ...states }, ofRail);
    rail.values["material.young_modulus"] = young(inputs, "");
    const named = (section: string) => new RegExp(`\\[${section}\\][^[]*?profile *= *["']([^"']+)["']`, "s").exec(text)?.[1];
    rail.profiles = { rail: named("rail") ?? rail.profiles.rail, wheel: named("wheelset") ?? rail.profiles.wheel };
    rail.files = files;
    own = railCase(rail, "fastsim2");
  } else {
    const transient = inputs.motion === "transient";
    state.view = transient ? "start" : "contact";
    const { values } = transient ? state.start : state.contact;
    fill(values, { ...inputs, normal_force: inputs.normal_force ?? hertz!.normal_force }, ofContact);
    values["body1.young_modulus"] = young(inputs, "_1");
    if (!transient) state.contact.law = String(inputs.friction_law);
    own = transient ? startCase(state.start) : contactCase(state.contact, "exact");
  }
  const found = await documentOf(core, own, files);
  const missing = differing({ ...inputs, ...states }, { ...found.inputs, ...found.states });
  return { state, left: missing.length ? `The page does not have all of the case; different here: ${missing.join(", ")}.` : "" };
}

/** "case." and base64 of a Start in JSON, as `microslip explore` makes it. */
export function startOf(fragment: string): Start | undefined {
  const packed = /^#case\.([\w+/=-]*)$/.exec(fragment)?.[1];
  if (packed === undefined) return undefined;
  const bytes = Uint8Array.from(atob(packed.replaceAll("-", "+").replaceAll("_", "/")), (letter) => letter.charCodeAt(0));
  return JSON.parse(new TextDecoder().decode(bytes)) as Start;
}
