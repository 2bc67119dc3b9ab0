// Examples to start from: each sets all that it is about.

import { button, element } from "./elements.ts";
import { initialState, type State } from "./state.ts";

declare const BUILT_IN_PROFILES: Record<string, string>;

export interface Preset { name: string; told: string; make: () => State }

function changed(change: (state: State) => void): () => State {
  return () => {
    const state = initialState();
    change(state);
    return state;
  };
}

/** A wheel as a device measures it: the built-in one with a scatter of 6 um of its points, in two columns [mm]. */
function measuredWheel(): string {
  const points = [...BUILT_IN_PROFILES["s1002.prw"]!.matchAll(/^\s*(-?[\d.]+)\s+(-?[\d.]+)\s*$/gm)].map(([, y, z]) => [Number(y), Number(z)] as const);
  let seed = 7;
  const scatter = () => { // of a sum of four even ones, which is nearly normal
    const even = () => { seed = (seed * 16807) % 2147483647; return seed / 2147483647 - 0.5; };
    return 0.006 * (even() + even() + even() + even()) * Math.sqrt(3);
  };
  return points.map(([y, z]) => `${String(y)} ${(z + scatter()).toFixed(5)}`).join("\n");
}

export const presets: readonly Preset[] = [
  { name: "Tread contact", told: "A wheel on straight track, a little off the middle: it touches on the tread.", make: changed((state) => { state.view = "rail"; }) },
  { name: "Flange contact", told: "The wheelset has swayed so far that it touches in the root of the flange: the rail pushes it back sideways.", make: changed((state) => {
    state.view = "rail";
    Object.assign(state.rail.values, { "wheel.lateral": 0.0066, "wheel.yaw": 0.004 });
  }) },
  { name: "Traction on a wet rail", told: "A locomotive's wheel turns 0.15 % faster than it rolls: on a wet rail most of the contact slides already, and friction falls the faster it slides.", make: changed((state) => {
    state.view = "contact";
    state.contact.law = "polach";
    Object.assign(state.contact.values, {
      "motion.creepage_longitudinal": -0.0015, "motion.creepage_lateral": 0, "motion.spin": 0, "motion.rolling_speed": 40 / 3.6, "load.normal_force": 100e3, "body1.rolling_radius": 0.625,
      "friction.static_coefficient": 0.2, "friction.ratio": 0.4, "friction.decay": 0.2,
    });
  }) },
  { name: "Rubber roller", told: "A steel roller on one with a rubber cover: a wide nip, and a free roller that runs faster than its radius says.", make: changed((state) => { state.view = "nip"; }) },
  { name: "Ball in a groove", told: "A ball of a bearing in its groove: a long narrow contact, twisted by spin.", make: changed((state) => {
    state.view = "contact";
    Object.assign(state.contact.values, {
      "body1.rolling_radius": 0.005, "body1.transverse_radius": 0.005, "body2.rolling_radius": 0.02, "body2.transverse_radius": -0.0058, "load.normal_force": 300,
      "friction.coefficient": 0.08, "motion.creepage_longitudinal": 0.0003, "motion.creepage_lateral": 0, "motion.spin": 12, "motion.rolling_speed": 3,
    });
  }) },
  { name: "Measured profile", told: "A measured wheel: its points scatter by 6 um, which the reader smooths away. Choose “none” to see what noise does.", make: changed((state) => {
    state.view = "rail";
    state.rail.files = { "measured_wheel.txt": measuredWheel() };
    state.rail.profiles.wheel = "measured_wheel.txt";
  }) },
];

/** Buttons, each of which says on the page which preset is wanted, by its place. */
export function presetButtons(): HTMLElement {
  const made = presets.map(({ name, told }, i) => {
    const one = button(name, () => { one.dispatchEvent(new CustomEvent("preset", { bubbles: true, detail: i })); });
    one.title = told;
    return one;
  });
  return element("fieldset", {}, element("legend", {}, "Start from an example"), element("div", { class: "presets" }, ...made));
}
