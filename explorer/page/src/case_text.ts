// States as case files for the program, and as Python.

import { input, version } from "./description.ts";
import { initialState, keysOf, stiffnesses, type ContactState, type More, type NipState, type RailState, type StartState, type Value, type Values, type View } from "./state.ts";
import { fromSi, shownUnit, toSi } from "./units.ts";

type Entries = Record<string, Value>;

function word(value: Value): string {
  if (typeof value === "string") return JSON.stringify(value);
  if (Array.isArray(value)) return `[${value.map(word).join(", ")}]`;
  if (value === Infinity) return "inf";
  return value === -Infinity ? "-inf" : String(value);
}

/** "body2.layers.1" is the first table of a list. */
function header(section: string): string {
  const list = /^(.*)\.\d+$/.exec(section)?.[1];
  return list === undefined ? `[${section}]` : `[[${list}]]`;
}

export function toToml(title: string, entries: Entries): string {
  const sections = new Map<string, string[]>();
  for (const [path, value] of Object.entries(entries)) {
    const dot = path.lastIndexOf("."), section = path.slice(0, dot), key = path.slice(dot + 1);
    if (!sections.has(section)) sections.set(section, []);
    sections.get(section)!.push(`${key} = ${word(value)}`);
  }
  return `title = ${JSON.stringify(title)}\n` + [...sections].map(([name, lines]) => `\n${header(name)}\n${lines.join("\n")}\n`).join("");
}

/** A case for people: numbers in the units of the page where that changes no digit of them, and where it is from. */
export function forPeople(view: View, toml: string): string {
  let section = "";
  const lines = toml.split("\n").map((line) => {
    const [, list, table] = /^(\[)?\[(.*?)\]\]?$/.exec(line) ?? [];
    if (table) section = list ? `${table}.1` : table;
    const [, key, number] = /^(\w+) = (-?[\d.]+(?:e[+-]?\d+)?)$/.exec(line) ?? [];
    const si = key && section ? input(view, `${section}.${key}`).unit : undefined;
    if (!key || !si || si === "-") return line;
    const value = Number(number), unit = shownUnit(si), shown = Number(fromSi(value, si, unit).toPrecision(15));
    return toSi(shown, si, unit) === value ? `${key} = "${String(shown)} ${unit}"` : `${line}  # ${si}`;
  });
  return `# From microslip's explorer, version ${version()}. Numbers without a unit are in SI.\n${lines.join("\n")}`;
}

/** Both bodies of one material. */
function withBothBodies(values: Values): Entries {
  const { "body1.young_modulus": modulus, "body1.poisson_ratio": ratio } = values;
  return { ...values, "body2.young_modulus": modulus!, "body2.poisson_ratio": ratio! };
}

function without(values: Values, left: RegExp): Values {
  return Object.fromEntries(Object.entries(values).filter(([key]) => !left.test(key)));
}

function friction({ law, values }: ContactState): Entries {
  const keys = keysOf(law).filter((key) => !key.includes("second_") || values["friction.second_drop"] !== 0);
  return { "friction.law": law, ...Object.fromEntries(keys.map((key) => [key, values[key]!])) };
}

/** Options of the theories that have no field; with the exact theory FASTSIM2 is solved beside it. */
export const ofExact = /^solution\.(discretisation|elements|tolerance|coupling|slip_start)$/;
export const ofFastsim = /^solution\.(bound|flexibility|coefficients|slope_reduction\..*)$/;

function options({ more }: ContactState, theory: "exact" | "fastsim2" | "table"): More {
  return Object.fromEntries(Object.entries(more).filter(([key]) => (theory === "exact" && ofExact.test(key)) || (theory !== "table" && ofFastsim.test(key))));
}

export function contactCase(state: ContactState, theory: "exact" | "fastsim2" | "table", more: Entries = {}): string {
  const grid: Entries = theory === "table" ? {} : { "solution.grid": state.elements };
  return toToml("A contact of the explorer",
                { ...withBothBodies(without(state.values, /^(friction|ellipse)\./)), ...friction(state), "solution.theory": theory, ...grid, ...options(state, theory), ...more });
}

/** What of a case file has no field, for people. */
export function moreInWords(more: More): string {
  const text = (value: Value): string => (Array.isArray(value) ? value.map(text).join(", ") : String(value));
  const all = Object.entries(more).map(([key, value]) => `${key} = ${text(value)}`);
  return all.length ? `Of the case file, in SI: ${all.join("; ")}.` : "";
}

export function railCase(state: RailState, theory: "exact" | "fastsim2", side = state.side): string {
  const shape: Entries = theory === "exact" && state.shape !== "true" ? { "solution.shape": state.shape } : {};
  return toToml(`${state.profiles.wheel} on ${state.profiles.rail}`, {
    ...state.values, ...state.more, "rail.profile": state.profiles.rail, "wheelset.profile": state.profiles.wheel, "wheel.side": side,
    "solution.theory": theory, ...shape,
  });
}

/** What the running of a wheelset depends on: no load, speed, friction, position or side of a wheel. */
export function runningCase(state: RailState): string {
  const ofRunning = (key: string) => /^(track|rail|wheelset)\./.test(key), { values } = initialState().rail;
  const kept = <Kept>(of: Record<string, Kept>) => Object.fromEntries(Object.entries(of).filter(([key]) => ofRunning(key)));
  return railCase({ ...state, values: { ...values, ...kept(state.values) }, more: kept(state.more) }, "fastsim2", "left");
}

export function startCase(state: StartState): string {
  const other = { force: "creepage", creepage: "force" } as const, { longitudinal, lateral } = state.given;
  const left = new RegExp(`^motion\\.(${other[longitudinal]}_longitudinal|${other[lateral]}_lateral)$`);
  return toToml("Starting to roll", {
    ...withBothBodies(without(state.values, left)), "motion.kind": "transient", "solution.theory": "exact", "solution.grid": state.elements,
  });
}

export const cover = "body2.layers.1";

/** Places of the terms of a cover's relaxation: those with a share of zero are left out. */
export function relaxationTerms(values: Values): number[] {
  const key = `${cover}.relaxation_shares.`, places = Object.keys(values).filter((name) => name.startsWith(key)).map((name) => Number(name.slice(key.length)));
  return places.filter((place) => values[`${key}${String(place)}`] !== 0);
}

function relaxation(values: Values): Entries {
  const terms = relaxationTerms(values), all = (key: string) => terms.map((place) => values[`${cover}.${key}.${String(place)}`]!);
  const entries = ["relaxation_shares", "relaxation_times"].map((key) => [`${cover}.${key}`, all(key)]);
  return terms.length ? (Object.fromEntries(entries) as Entries) : {};
}

export function nipCase(state: NipState): string {
  const { values, stiffness, given, more } = state, ofOthers = stiffnesses.filter((key) => key !== stiffness).map((key) => `${cover}.${key}`);
  const left = [...ofOthers, `motion.${given === "force" ? "creepage" : "force"}_longitudinal`];
  const kept = Object.fromEntries(Object.entries(values).filter(([key]) => !left.includes(key) && !/\.relaxation_\w+\.\d+$/.test(key)));
  return toToml("A nip of the explorer", { ...kept, ...relaxation(values), "solution.theory": "exact", "solution.grid": state.elements, ...more });
}

/** A program that solves the case and prints it. */
export function toPython(toml: string): string {
  return `import microslip\n\nCASE = """\n${toml}"""\n\nresult = microslip.solve_case(microslip.parse_case(CASE))\nprint(result)\n`;
}

/** Whether a key says how the profile of its section is to be read. */
export function isHowRead(key: string, section: "rail" | "wheelset"): boolean {
  return key.startsWith(`${section}.`) && input("rail", key).section === "profile" && !key.endsWith(".profile");
}

/** The same wheel on the same rail in Python, whose arguments have the names of the keys. */
export function railPython(state: RailState): string {
  const { profiles, shape, side } = state, all: Entries = { ...state.values, ...state.more };
  const literal = (value: Value): string => (Array.isArray(value) ? `(${value.map(literal).join(", ")})` : typeof value === "string" ? JSON.stringify(value) : String(value));
  const isState = (key: string) => input("rail", key).state, isOfFile = (key: string) => isHowRead(key, "rail") || isHowRead(key, "wheelset");
  const ofStrength = /^material\.(hardness|shear_yield_strength)$/;
  const named = (wanted: (key: string) => boolean) => Object.entries(all).filter(([key]) => wanted(key))
    .map(([key, value]) => `, ${key.replace(/^.*\./, "")}=${key.endsWith(".unit") ? String(toSi(1, "m", String(value))) : literal(value)}`).join("");
  const of = (section: string) => named((key) => key.startsWith(`${section}.`) && !isState(key) && !isOfFile(key)).slice(2);
  const file = (section: "rail" | "wheelset") => named((key) => isHowRead(key, section));
  const strength = named((key) => ofStrength.test(key)).slice(2), { "wheelset.nominal_radius": radius, "wheel.forward_velocity": velocity } = state.values;
  const pitch = "wheel.pitch_velocity" in all ? "" : `, pitch_velocity=${String(velocity)} / ${String(radius)}`;
  return `import microslip

# Needs beside it: ${profiles.rail}, ${profiles.wheel}
wheel_rail = microslip.WheelRail(
    track=microslip.Track(${of("track")}),
    rail=microslip.read_profile("${profiles.rail}", kind="rail"${file("rail")}),
    wheelset=microslip.Wheelset(${of("wheelset")}),
    wheel=microslip.read_profile("${profiles.wheel}", kind="wheel"${file("wheelset")}),${side === "left" ? "" : `
    side="${side}",`}
    material=microslip.Material.from_young(${literal(all["material.young_modulus"]!)}, ${literal(all["material.poisson_ratio"]!)}),${strength && `
    strength=microslip.SurfaceStrength(${strength}),`}
    friction=${literal(all["friction.coefficient"]!)}, theory="exact"${named((key) => key.startsWith("solution."))}${shape === "true" ? "" : `, shape="${shape}"`})
solution = wheel_rail.solve(${named(isState).slice(2)}${pitch})
print(solution)
`;
}
