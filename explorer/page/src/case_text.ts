// States as case files for the program, and as Python.

import type { ContactState, RailState, StartState, Values } from "./state.ts";

type Entry = number | string | number[];

function word(value: Entry): string {
  if (typeof value === "string") return JSON.stringify(value);
  if (Array.isArray(value)) return `[${value.map(word).join(", ")}]`;
  if (value === Infinity) return "inf";
  return value === -Infinity ? "-inf" : String(value);
}

export function toToml(title: string, entries: Record<string, Entry>): string {
  const sections = new Map<string, string[]>();
  for (const [path, value] of Object.entries(entries)) {
    const [section, key] = path.split(".") as [string, string];
    if (!sections.has(section)) sections.set(section, []);
    sections.get(section)!.push(`${key} = ${word(value)}`);
  }
  return `title = ${JSON.stringify(title)}\n` + [...sections].map(([name, lines]) => `\n[${name}]\n${lines.join("\n")}\n`).join("");
}

/** Both bodies of one material. */
function withBothBodies(values: Values): Record<string, Entry> {
  const { "body1.young_modulus": modulus, "body1.poisson_ratio": ratio } = values;
  return { ...values, "body2.young_modulus": modulus!, "body2.poisson_ratio": ratio! };
}

function friction(state: ContactState): Record<string, Entry> {
  const keys = state.law === "coulomb" ? ["coefficient"] : ["kinetic_coefficient", "drop", "half_velocity"];
  return { "friction.law": state.law, ...Object.fromEntries(keys.map((key) => [`friction.${key}`, state.values[`friction.${key}`]!])) };
}

export function contactCase(state: ContactState, theory: "exact" | "fastsim2" | "table", more: Record<string, Entry> = {}): string {
  const values = Object.fromEntries(Object.entries(state.values).filter(([key]) => !/^(friction|ellipse)\./.test(key)));
  const grid: Record<string, Entry> = theory === "table" ? {} : { "solution.grid": [state.elements, state.elements] };
  return toToml("A contact of the explorer", { ...withBothBodies(values), ...friction(state), "solution.theory": theory, ...grid, ...more });
}

export function railCase(state: RailState, theory: "exact" | "fastsim2" | "table"): string {
  const shape: Record<string, Entry> = theory === "exact" ? { "solution.shape": state.shape } : {};
  return toToml(`${state.profiles.wheel} on ${state.profiles.rail}`, {
    ...state.values, "rail.profile": state.profiles.rail, "wheelset.profile": state.profiles.wheel, "wheel.side": "left",
    "solution.theory": theory, ...shape,
  });
}

export function startCase(state: StartState): string {
  return toToml("Starting to roll", {
    ...withBothBodies(state.values), "motion.kind": "transient", "motion.rolling_speed": 1,
    "solution.theory": "exact", "solution.grid": [state.elements, state.elements],
  });
}

/** A program that solves the case and prints it. */
export function toPython(toml: string, files: string[]): string {
  const note = files.length ? `# Needs beside it: ${files.join(", ")}\n` : "";
  return `import microslip\n\n${note}CASE = """\n${toml}"""\n\nresult = microslip.solve_case(microslip.parse_case(CASE))\nprint(result)\n`;
}
