// All that a view shows follows from its state; a link holds the states of all views.

export type Values = Record<string, number>; // by section.key of the case file, SI

export interface ContactState {
  values: Values;
  given: "radii" | "ellipse"; // of which the radii follow
  law: string;
  shown: "tractions" | "adhesion and slip" | "slip" | "pressure" | "px" | "py";
  theory: "exact" | "fastsim2";
  elements: number;
  variable: "creepage_longitudinal" | "creepage_lateral" | "spin";
  cut: number; // y over b
  stress: "von_mises" | "sigma_xx" | "sigma_zz" | "sigma_xz";
}
export interface RailState {
  values: Values;
  shape: "flat" | "curved";
  profiles: { rail: string; wheel: string }; // names of files
  files: Record<string, string>;             // those that were dropped on the page
}
export interface StartState { values: Values; elements: number; frame: number }
export type View = "contact" | "rail" | "start";
export interface State { view: View; contact: ContactState; rail: RailState; start: StartState }

const bodies: Values = {
  "body1.rolling_radius": 0.46, "body1.transverse_radius": Infinity, "body2.rolling_radius": Infinity,
  "body2.transverse_radius": 0.3, "body1.young_modulus": 210e9, "body1.poisson_ratio": 0.28, "load.normal_force": 80e3,
};

export function initialState(): State {
  return {
    view: "contact",
    contact: {
      values: {
        ...bodies, "ellipse.a": 0.006, "ellipse.b": 0.004, "friction.coefficient": 0.3, "friction.kinetic_coefficient": 0.2, "friction.drop": 0.1, "friction.half_velocity": 1,
        "motion.creepage_longitudinal": 0.0012, "motion.creepage_lateral": 0.0006, "motion.spin": 0.4, "motion.rolling_speed": 30,
      },
      given: "radii", law: "coulomb", shown: "tractions", theory: "exact", elements: 24, variable: "creepage_longitudinal", cut: 0, stress: "von_mises",
    },
    rail: {
      values: {
        "wheel.lateral": 0.003, "wheel.yaw": 0.002, "wheel.vertical_force": 80e3, "wheel.forward_velocity": 30,
        "friction.coefficient": 0.3, "track.cant": 0.05, "track.gauge": 1.435, "wheelset.nominal_radius": 0.46,
        "wheelset.flange_back_distance": 1.36, "material.young_modulus": 210e9, "material.poisson_ratio": 0.28,
      },
      shape: "flat", profiles: { rail: "60e1.prr", wheel: "s1002.prw" }, files: {},
    },
    start: {
      values: { ...bodies, "friction.coefficient": 0.3, "motion.force_longitudinal": -12e3, "motion.force_lateral": 0, "motion.steps": 60 },
      elements: 24, frame: 0,
    },
  };
}

const version = "1";

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

/** Takes over what both have in the same type, and refuses what else is there. */
function merge(into: Record<string, unknown>, from: Record<string, unknown>, open: boolean): void {
  for (const [key, value] of Object.entries(from)) {
    const old = into[key];
    if (old !== undefined && typeof old === "object" && old !== null && typeof value === "object" && value !== null)
      merge(old as Record<string, unknown>, value as Record<string, unknown>, key === "files");
    else if (open ? typeof value === "string" : typeof value === typeof old) into[key] = value;
    else if (typeof old === "number" && (value === "inf" || value === "-inf")) into[key] = value === "inf" ? Infinity : -Infinity;
    else throw new Error(`its "${key}" is not one of this page`);
  }
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
    merge(state as unknown as Record<string, unknown>, JSON.parse(text) as Record<string, unknown>, false);
    if (!["contact", "rail", "start"].includes(state.view)) throw new Error(`"${state.view}" is not one of its views`);
  } catch (error) {
    throw new Error(`the link is damaged: ${error instanceof Error ? error.message : String(error)}`);
  }
  return state;
}
