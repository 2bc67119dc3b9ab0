// What the core says of inputs and outputs: units, ranges, defaults, words and texts are those of the library's tables.

import type { Core } from "./core.ts";
import type { Value, View } from "./state.ts";

/** A key of case files; numbers in SI. */
export interface Input {
  section: string; // of the table: that of all profiles is "profile"
  unit?: string;
  range?: string; // in words
  least?: number;
  largest?: number;
  default?: Value;
  words?: string[];
  only?: { key: string; words: string[] }; // a word of the same section with which alone it goes
  state: boolean;
  text: string;
}
export interface Output { unit: string; label?: string; text: string }
/** Numbers by which one in a unit is multiplied and divided to be in SI. */
export type Scale = [times: number, over: number];
export interface Description {
  inputs: Record<"bodies" | "wheel", Record<string, Input>>;
  outputs: Record<"bodies" | "fields" | "wheel" | "patch", Record<string, Output>>;
  units: Record<string, Record<string, Scale>>;
}

let description: Description;
let builtFrom: string;
/** Which microslip the core is. */
export const version = (): string => builtFrom;

/** Takes over what a core has said, before anything of the page is made. */
export function describe(said: Description, by: string): void {
  description = said;
  builtFrom = by;
}

/** Asks a core, which the page's build does. */
export async function readDescription(core: Pick<Core, "ask">): Promise<void> {
  const reply = await core.ask<Description>("description", { call: "description" });
  if (!reply?.result) throw new Error(reply?.error?.message ?? "the core does not answer");
  describe(reply.result, (await core.ask<{ version: string }>("version", { call: "version" }))?.result?.version ?? "");
}

export const described = (): Description => description;

function named<Of>(table: Record<string, Of>, name: string): Of {
  const found = table[name];
  if (!found) throw new Error(`the core has no ${name}`);
  return found;
}

/** An input of the cases of a view; of a number of a list, whose place stands behind the key, the list. */
export function input(view: View, key: string): Input {
  return named(description.inputs[view === "rail" ? "wheel" : "bodies"], key.replace(/\.\d+$/, ""));
}

/** The paths of a section's inputs that go only with this word of another of its keys. */
export function pathsWith(view: View, section: string, key: string, word: string): string[] {
  const ofKind = description.inputs[view === "rail" ? "wheel" : "bodies"];
  return Object.keys(ofKind).filter((path) => {
    const { section: of, only } = ofKind[path]!;
    return of === section && only?.key === key && only.words.includes(word);
  });
}

export function output(of: keyof Description["outputs"], name: string): Output {
  return named(description.outputs[of], name);
}

/** Units in which numbers may be typed that are `unit` in SI. */
export function unitsFor(unit: string): Record<string, Scale> {
  return description.units[unit] ?? {};
}

/** What an input is and may be. */
export function help({ text, unit, range }: Input): string {
  return `${text}${unit ? ` [${unit}]` : ""}${range ? `, ${range}` : ""}`;
}
