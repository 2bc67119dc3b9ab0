// All that a view shows follows from its state; a link holds the states of all views.

import { input, pathsWith } from "./description.ts";

export type Values = Record<string, number>; // by section.key of the case file, SI
/** What a key of a case file has, numbers in SI. */
export type Value = number | string | (number | string)[];

export interface ContactState {
  values: Values;
  given: "radii" | "ellipse"; // of which the radii follow
  law: string; // a word of the table, as all laws
  shown: "friction" | "used" | "adhesion and slip" | "slip" | "pressure" | "px" | "py";
  theory: "exact" | "fastsim2";
  elements: [along: number, across: number];
  variable: "creepage_longitudinal" | "creepage_lateral" | "spin";
  cut: number; // y over b, of the cut along
  across: number; // x over a, of the cut across
  stress: "von_mises" | "sigma_xx" | "sigma_zz" | "sigma_xz";
  more: More;
}
/** Of a case file, keys that have no field on the page. */
export type More = Record<string, Value>;
export const sides = ["left", "right"] as const;
export type WheelSide = (typeof sides)[number];
export interface RailState {
  values: Values;
  side: WheelSide; // which wheel is the main picture's
  shape: string;
  profiles: { rail: string; wheel: string }; // names of files
  files: Record<string, string>;             // those that were dropped on the page
  more: More;
}
/** What sets a component of the motion. */
export type Given = "force" | "creepage";
export interface StartState { values: Values; given: { longitudinal: Given; lateral: Given }; elements: [along: number, across: number]; frame: number }
/** Which key says how stiff the cover of a roller is. */
export const stiffnesses = ["hardness", "young_modulus", "shear_modulus"] as const;
export type Stiffness = (typeof stiffnesses)[number];
export interface NipState {
  values: Values; // terms of the cover's relaxation with a place behind their keys, as "body2.layers.1.relaxation_shares.1"
  stiffness: Stiffness;
  given: Given; // along the direction of rolling
  elements: [along: number, across: number];
  shown: "friction" | "adhesion and slip" | "pressure" | "px" | "py";
  more: More;
}
export const views = ["rail", "contact", "start", "nip"] as const;
export type View = (typeof views)[number];
export interface State { view: View; contact: ContactState; rail: RailState; start: StartState; nip: NipState }

const lawNames: Record<string, string> = { coulomb: "Coulomb", linear: "falls linearly", rational: "falls as 1/(1 + v)", exponential: "falls exponentially", polach: "Polach" };
/** The library's laws of friction with their names on the page, which has no fields for the lists of a table. */
export function laws(): Record<string, string> {
  return Object.fromEntries(input("contact", "friction.law").words!.filter((law) => law !== "table").map((law) => [law, lawNames[law] ?? law]));
}
/** The numbers of a law. */
export function keysOf(law: string): string[] {
  return pathsWith("contact", "friction", "law", law);
}
/** Surfaces of wheels and rails for the exact theory. "true" is what the library takes where the case leaves it out. */
export function shapes(): Record<string, string> {
  return { true: "as it is", ...Object.fromEntries(input("rail", "solution.shape").words!.map((shape) => [shape, shape])) };
}

/** Creepages beyond these are mistaken: of bodies that roll in the same direction their speeds differ by twice the mean at most. */
const largestCreepage = 2;
export const limits: Record<string, number> = {
  "motion.creepage_longitudinal": largestCreepage, "motion.creepage_lateral": largestCreepage,
};

/** Throws an Error that names the first number beyond its limits. */
export function requireLimits(values: Values): void {
  for (const [key, limit] of Object.entries(limits)) {
    const value = values[key];
    if (value !== undefined && !(Math.abs(value) <= limit)) throw new Error(`${key} = ${String(value)}: must be in [${String(-limit)}, ${String(limit)}]`);
  }
}

/** What the library takes where a case leaves them out. */
function defaults(view: View, ...keys: string[]): Values {
  return Object.fromEntries(keys.map((key) => [key, input(view, key).default as number]));
}

const bodies: Values = {
  "body1.rolling_radius": 0.46, "body1.transverse_radius": Infinity, "body2.rolling_radius": Infinity,
  "body2.transverse_radius": 0.3, "body1.young_modulus": 210e9, "body1.poisson_ratio": 0.28, "load.normal_force": 80e3,
};

export function initialState(): State {
  return {
    view: "rail",
    contact: {
      values: {
        ...bodies, "ellipse.a": 0.006, "ellipse.b": 0.004, "friction.coefficient": 0.3, "friction.kinetic_coefficient": 0.2, "friction.drop": 0.1, "friction.half_velocity": 1,
        "friction.second_drop": 0, "friction.second_half_velocity": 5, "friction.static_coefficient": 0.3, "friction.ratio": 0.4, "friction.decay": 0.6,
        "motion.creepage_longitudinal": 0.0012, "motion.creepage_lateral": 0.0006, "motion.spin": 0.4, "motion.rolling_speed": 30,
      },
      given: "radii", law: input("contact", "friction.law").default as string, shown: "friction", theory: "exact", elements: [24, 24], variable: "creepage_longitudinal", cut: 0, across: 0, stress: "von_mises", more: {},
    },
    rail: {
      values: {
        "wheel.lateral": 0.003, "wheel.yaw": 0.001, "wheel.vertical_force": 80e3, "wheel.forward_velocity": 30,
        "friction.coefficient": 0.3, "track.cant": 0.025, "track.gauge": 1.435, ...defaults("rail", "track.curvature"), "wheelset.nominal_radius": 0.46,
        "wheelset.flange_back_distance": 1.36,
        "material.young_modulus": 210e9, "material.poisson_ratio": 0.28,
      },
      side: "left", shape: "true", profiles: { rail: "60e1.prr", wheel: "s1002.prw" }, files: {}, more: {},
    },
    start: {
      values: {
        ...bodies, "friction.coefficient": 0.3, "motion.force_longitudinal": -12e3, "motion.force_lateral": 0,
        "motion.creepage_longitudinal": 0.0015, ...defaults("start", "motion.creepage_lateral", "motion.spin"), "motion.rolling_speed": 1, "motion.steps": 60,
      },
      given: { longitudinal: "force", lateral: "force" }, elements: [24, 24], frame: 0,
    },
    nip: {
      values: {
        "body1.rolling_radius": 0.1, "body1.transverse_radius": Infinity, "body1.young_modulus": 210e9, "body1.poisson_ratio": 0.28,
        "body2.rolling_radius": 0.15, "body2.transverse_radius": 20, "body2.young_modulus": 210e9, "body2.poisson_ratio": 0.28,
        "body2.layers.1.thickness": 0.015, "body2.layers.1.hardness": 60, "body2.layers.1.young_modulus": 4e6, "body2.layers.1.shear_modulus": 1.3e6, "body2.layers.1.poisson_ratio": 0.499,
        "body2.layers.1.relaxation_shares.1": 0.15, "body2.layers.1.relaxation_times.1": 0.5e-3, "body2.layers.1.relaxation_shares.2": 0, "body2.layers.1.relaxation_times.2": 20e-3,
        "load.normal_force": 4e3, "friction.coefficient": 0.6,
        "motion.force_longitudinal": -400, "motion.creepage_longitudinal": -0.02, "motion.rolling_speed": 5,
      },
      stiffness: "hardness", given: "force", elements: [32, 16], shown: "friction", more: {},
    },
  };
}

const version = "3";

async function through(stream: ReadableWritablePair<Uint8Array<ArrayBuffer>, BufferSource>, bytes: Uint8Array<ArrayBuffer>): Promise<Uint8Array<ArrayBuffer>> {
  return new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());
}

/** The state as the part of a link behind #. */
export async function encode(state: State): Promise<string> {
  const text = JSON.stringify(state, (_, value: unknown) => (value === Infinity ? "inf" : value === -Infinity ? "-inf" : value));
  const packed = await through(new CompressionStream("deflate-raw"), new TextEncoder().encode(text));
  const binary = Array.from(packed, (byte) => String.fromCharCode(byte)).join("");
  return `${version}.${btoa(binary).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "")}`;
}

const isOne = (value: unknown) => typeof value === "number" || typeof value === "string";
/** Members with names of the user's, and what may be there. */
const open: Record<string, (value: unknown) => boolean> = {
  files: (value) => typeof value === "string",
  more: (value) => isOne(value) || (Array.isArray(value) && value.every(isOne)),
};

/** Takes over what both have in the same type, and refuses what else is there. */
function merge(into: Record<string, unknown>, from: Record<string, unknown>, mayBe?: (value: unknown) => boolean): void {
  for (const [key, value] of Object.entries(from)) {
    const old = into[key];
    if (mayBe?.(value)) into[key] = value;
    else if (old !== undefined && typeof old === "object" && old !== null && typeof value === "object" && value !== null)
      merge(old as Record<string, unknown>, value as Record<string, unknown>, open[key]);
    else if (!mayBe && typeof value === typeof old) into[key] = value;
    else if (typeof old === "number" && (value === "inf" || value === "-inf")) into[key] = value === "inf" ? Infinity : -Infinity;
    else throw new Error(`its "${key}" is not one of this page`);
  }
}

function requireWord(name: string, word: string, words: string[]): void {
  if (!words.includes(word)) throw new Error(`its "${name}" is "${word}"; it may be ${words.join(", ")}`);
}

/** The state of a link; throws an Error that says why it is none. */
export async function decode(fragment: string): Promise<State> {
  const [, of, packed] = /^#?(\d+)\.([\w-]*)$/.exec(fragment) ?? [];
  if (!of || packed === undefined) throw new Error("the link is not one of the explorer");
  if (of !== version) throw new Error(`the link is of version ${of} of the explorer's links; this page reads version ${version}`);
  const state = initialState();
  try {
    const bytes = Uint8Array.from(atob(packed.replaceAll("-", "+").replaceAll("_", "/")), (letter) => letter.charCodeAt(0));
    const text = new TextDecoder().decode(await through(new DecompressionStream("deflate-raw"), bytes));
    merge(state as unknown as Record<string, unknown>, JSON.parse(text) as Record<string, unknown>);
    requireWord("view", state.view, [...views]);
    requireWord("law", state.contact.law, Object.keys(laws()));
    requireWord("side", state.rail.side, [...sides]);
    requireWord("shape", state.rail.shape, Object.keys(shapes()));
    for (const given of [...Object.values(state.start.given), state.nip.given]) requireWord("given", given, ["force", "creepage"]);
    requireWord("stiffness", state.nip.stiffness, [...stiffnesses]);
    for (const view of ["contact", "rail", "nip"] as const) for (const key of Object.keys(state[view].more)) input(view, key);
    for (const { values } of [state.contact, state.start, state.nip]) requireLimits(values);
  } catch (error) {
    throw new Error(`the link is damaged: ${error instanceof Error ? error.message : String(error)}`);
  }
  return state;
}
