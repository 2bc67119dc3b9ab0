// What the page's build asks its core once, so that controls, texts and bodies are drawn before the core has been loaded.

import { railCase } from "./case_text.ts";
import type { Core } from "./core.ts";
import { described, readDescription, version, type Description } from "./description.ts";
import type { Outline } from "./rail_picture.ts";
import { initialState } from "./state.ts";

export interface Outlines { rail: Outline; wheel: Outline }
export interface FirstAnswers { description: Description; version: string; outlines: Outlines }

const fine = 1e5; // points of outlines in hundredths of a millimetre, a twentieth of a pixel
const apart = 1e-4; // [m] points closer than that to the last one are left out

function thinned({ y, z }: Outline): Outline {
  const kept: [number, number][] = [];
  y.forEach((value, i) => {
    const last = kept.at(-1);
    if (!last || i === y.length - 1 || Math.hypot(value - last[0], z[i]! - last[1]) > apart) kept.push([value, z[i]!]);
  });
  const rounded = (value: number) => Math.round(value * fine) / fine;
  return { y: kept.map(([value]) => rounded(value)), z: kept.map(([, value]) => rounded(value)) };
}

/** The core's tables, and where wheel and rail are in the state of the beginning. */
export async function firstAnswers(core: Pick<Core, "ask">, profiles: Record<string, string>): Promise<FirstAnswers> {
  await readDescription(core);
  const reply = await core.ask<{ outlines: Outlines }>("rail", { call: "solve", case: railCase(initialState().rail, "fastsim2"), files: profiles, fields: true });
  if (!reply?.result) throw new Error(reply?.error?.message ?? "the core does not answer");
  const { rail, wheel } = reply.result.outlines;
  return { description: described(), version: version(), outlines: { rail: thinned(rail), wheel: thinned(wheel) } };
}
