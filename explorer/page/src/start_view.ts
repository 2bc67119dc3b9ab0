// A contact that starts to roll under given forces: from Cattaneo's shift to Carter's steady rolling, played as an animation.

import { forPeople, startCase, toPython } from "./case_text.ts";
import { Chart } from "./chart.ts";
import * as colours from "./colours.ts";
import type { Core } from "./core.ts";
import { output } from "./description.ts";
import { Keys, Seldom, button, card, controlsOf, element, fillRemarks, save, sentence, statusInWords, titleOf } from "./elements.ts";
import { drawMap, rowHeight } from "./field_map.ts";
import { Choice, Form, type FieldSpec } from "./fields.ts";
import { presetButtons } from "./presets.ts";
import { sheetsOf } from "./sheet.ts";
import type { Given, StartState } from "./state.ts";
import { digits } from "./units.ts";

interface Frame {
  distance: number; fx: number; fy: number; mz: number; creepage_longitudinal: number; creepage_lateral: number;
  px: Numbers; py: Numbers; sx: Numbers; sy: Numbers; state: Numbers;
}
type Numbers = Float64Array | number[]; // few elements are no array of one type
interface Transient {
  hertz: { a: number; b: number }; x: Numbers; y: Numbers; bound: Numbers; frames: Frame[]; status: string; reason?: string; warnings: string[];
}

const creepage = { unit: "%", from: -1, to: 1, step: 0.005 } as const, force = { from: -40, to: 40, step: 0.5 } as const;
const groups: Record<"Contact" | "Motion" | "Bodies", FieldSpec[]> = {
  Contact: [
    { key: "load.normal_force", label: "Load", from: 5, to: 200, step: 1 },
    { key: "friction.coefficient", label: "Friction coefficient", from: 0.05, to: 0.8, step: 0.01 },
  ],
  Motion: [
    { key: "motion.force_longitudinal", label: "Force along, on the wheel", ...force },
    { key: "motion.creepage_longitudinal", label: "Braking (longitudinal creepage)", ...creepage },
    { key: "motion.force_lateral", label: "Force across, on the wheel", ...force },
    { key: "motion.creepage_lateral", label: "Drifting (lateral creepage)", ...creepage },
    { key: "motion.spin", label: "Twisting (spin)", from: -3, to: 3, step: 0.02 },
    { key: "motion.rolling_speed", label: "Rolling speed" },
    { key: "motion.steps", label: "Steps", from: 10, to: 120, step: 1 },
  ],
  Bodies: [
    { key: "body1.rolling_radius", label: "Wheel radius", from: 20, to: 1000, step: 5 },
    { key: "body1.transverse_radius", label: "Wheel, radius across" },
    { key: "body2.rolling_radius", label: "Rail, radius along" },
    { key: "body2.transverse_radius", label: "Rail head radius, across", from: 20, to: 1000, step: 5 },
    { key: "body1.young_modulus", label: "Young's modulus" },
    { key: "body1.poisson_ratio", label: "Poisson's ratio" },
  ],
};

export class StartView {
  readonly root = element("section", { class: "view", "aria-label": "Start and stop" });
  readonly #form = new Form("start", this.root);
  readonly #given: Record<keyof StartState["given"], Choice>;
  readonly #map = element("canvas", { class: "map", role: "img" });
  readonly #remarks = element("ul", { class: "remarks", role: "status" });
  readonly #spoken = element("p", { "aria-live": "polite" }, "computing …");
  readonly #lead = element("p");
  readonly #keys = new Keys();
  readonly #time = element("p", { class: "time" });
  readonly #slider = element("input", { type: "range", min: "0", max: "0", step: "1", "aria-label": "distance rolled" });
  readonly #play: HTMLButtonElement;
  readonly #cut: Chart;
  readonly #creepages: Chart;
  readonly #forces: Chart;
  readonly #history = new Seldom(() => { this.#drawHistory(); });
  #found: Transient | undefined;
  #timer = 0;

  constructor(readonly core: Core, public state: StartState, readonly changed: () => void) {
    const cut = element("div", { class: "chart" }), creepages = element("div", { class: "chart" }), forces = element("div", { class: "chart" });
    this.#cut = new Chart(cut);
    this.#creepages = new Chart(creepages);
    this.#forces = new Chart(forces);
    this.#play = button("▶ play", () => { if (this.#timer) this.stop(); else this.play(); }, "play or stop");
    this.#slider.addEventListener("input", () => { this.#show(Number(this.#slider.value)); this.changed(); });
    const made = Object.fromEntries(Object.values(groups).flat().map((spec) => [spec.key, this.#form.add(spec, state.values[spec.key]!, (value) => {
      this.state.values[spec.key] = value;
      this.#changed();
    }).root]));
    const choice = (component: keyof StartState["given"]) => new Choice(`${component}: given is`, { force: "the force", creepage: "the creepage" }, state.given[component], (given) => {
      this.state.given[component] = given as Given;
      this.#showFields();
      this.#changed();
    });
    this.#given = { longitudinal: choice("longitudinal"), lateral: choice("lateral") };
    const group = (name: keyof typeof groups) => element("fieldset", {}, element("legend", {}, name),
      ...groups[name].flatMap(({ key }) => {
        const component = /^motion\.force_(.*)$/.exec(key)?.[1] as keyof StartState["given"] | undefined;
        return component ? [this.#given[component].root, made[key]!] : [made[key]!];
      }));
    this.root.append(
      titleOf("Starting and braking: how friction builds up as a wheel begins to roll", this.#lead),
      controlsOf([presetButtons(), group("Contact"), group("Motion"), group("Bodies")]),
      element("div", { class: "pictures thirds" },
        this.#keys.root,
        card("wide pinned", "", "", element("div", { class: "choices" }, this.#play, this.#slider), this.#spoken, this.#map, this.#form.message, this.#remarks, this.#time),
        card("", "Along y = 0", "Friction force per area, and the most that friction can bear", cut),
        card("", "Creepage", "By how much the wheel turns slower or drifts", creepages),
        card("", "Forces on the upper body", "Over the distance rolled", forces)));
    this.#showFields();
  }

  set(state: StartState): void {
    this.state = state;
    for (const component of ["longitudinal", "lateral"] as const) this.#given[component].set(state.given[component]);
    this.#showFields();
    this.#form.set(state.values);
  }

  #changed(): void {
    this.solve();
    this.changed();
  }

  #showFields(): void {
    for (const { spec, root } of this.#form.fields) {
      const [, given, component] = /^motion\.(force|creepage)_(.*)$/.exec(spec.key) ?? [];
      if (component) root.hidden = this.state.given[component as keyof StartState["given"]] !== given;
    }
    this.#tell();
    this.#form.show();
  }

  /** What is done to the wheel in a sentence, and what follows. */
  #tell(): void {
    const { given, values } = this.state, friction = values["friction.coefficient"]! * values["load.normal_force"]!;
    for (const field of this.#form.fields) if (field.spec.key.startsWith("motion.force_")) field.hatchBeyond(friction, "more than friction can bear");
    const force = values["motion.force_longitudinal"]!, across = given.lateral === "force" ? values["motion.force_lateral"]! : 0, size = given.longitudinal === "force" ? Math.hypot(force, across) : Math.abs(across);
    this.#lead.textContent = size > 0
      ? `A wheel at rest is put under ${digits(size / 1e3)} kN${across === 0 ? (force < 0 ? " backwards" : " forwards") : ""}, ${digits(Math.round((100 * size) / friction))} % of what friction can bear, then it rolls. At first it slides all around the edge (Cattaneo); rolling brings that to the trailing edge, and after about one length of the contact nothing changes any more (Carter).`
      : "A wheel begins to roll with the creepage that is given: friction begins at zero and builds up from the leading edge, over about one length of the contact, until nothing changes any more.";
  }

  solve(): void {
    this.#tell();
    void this.core.ask<Transient>("start transient", { call: "transient", case: startCase(this.state) }, true).then((reply) => {
      if (!reply) return;
      this.#form.refuse(reply.error?.message ?? "");
      if (!reply.result) return;
      this.#found = reply.result;
      const { warnings, status, reason } = reply.result;
      fillRemarks(this.#remarks, [...warnings, ...(status === "ok" ? [] : [`ends at the first frame that is not solved, ${statusInWords(status, reason)}`])].map(sentence));
      this.#time.textContent = `exact theory, ${reply.result.frames.length} frames: ${digits(1e3 * (reply.time ?? 0))} ms`;
      this.#slider.max = String(reply.result.frames.length - 1);
      this.#show(Math.min(this.state.frame, reply.result.frames.length - 1));
      this.#history.soon();
    });
  }

  play(): void {
    if (!this.#found) return;
    const last = this.#found.frames.length - 1;
    if (this.state.frame >= last) this.#show(0);
    this.#play.textContent = "■ stop";
    this.#timer = window.setInterval(() => {
      if (this.state.frame >= last || document.hidden) { this.stop(); return; }
      this.#show(this.state.frame + 1);
    }, 60);
  }

  stop(): void {
    clearInterval(this.#timer);
    this.#timer = 0;
    this.#play.textContent = "▶ play";
    this.changed();
  }

  exports(): Record<string, () => void> {
    return {
      "case as TOML": () => { save("starting_to_roll.toml", forPeople("start", startCase(this.state))); },
      "case as Python": () => { save("starting_to_roll.py", toPython(forPeople("start", startCase(this.state)))); },
      "creepages as CSV": () => { save("creepages.csv", this.#creepages.csv(), "text/csv"); },
      "forces as CSV": () => { save("forces.csv", this.#forces.csv(), "text/csv"); },
      "picture as PNG": () => { this.#map.toBlob((blob) => { if (blob) save("starting_to_roll.png", blob); }); },
    };
  }

  draw(): void { this.#show(this.state.frame); }

  #show(index: number): void {
    const found = this.#found, frame = found?.frames[index];
    if (!found || !frame) return;
    this.state.frame = index;
    this.#slider.value = String(index);
    const [x, y, bound] = [found.x, found.y, found.bound].map((of) => [...of]) as [number[], number[], number[]], { a, b } = found.hertz;
    const [px, py, sx, sy, state] = [frame.px, frame.py, frame.sx, frame.sy, frame.state].map((of) => [...of]) as [number[], number[], number[], number[], number[]];
    const row = [...new Set(y)].sort((one, other) => Math.abs(one) - Math.abs(other))[0]!;
    const places = [...new Set(x)].sort((one, other) => one - other), width = places.length > 1 ? places[1]! - places[0]! : 2 * a;
    const sheets = sheetsOf({ x, y, width: x.map(() => width), pressure: bound, bound, px, py, sx, sy, state }, rowHeight(y), { a, b });
    drawMap(this.#map, { sheets, shown: "friction", arrows: true, largest: Math.max(...bound, 1e-30) });
    const at = y.flatMap((value, k) => (value === row && state[k] !== 0 ? [k] : [])).sort((one, other) => x[one]! - x[other]!);
    const end = a * Math.sqrt(Math.max(1 - (row / b) ** 2, 0)), between = (values: number[]) => [0, ...values.map((value) => value / 1e6), 0]; // both are zero at the ends of the contact
    this.#cut.draw({
      x: [-end, ...at.map((k) => x[k]!), end].map((place) => place * 1e3), xLabel: "x [mm], rolls this way →", yLabel: "MPa",
      curves: [
        { name: "most that friction can bear", colour: colours.bound, values: between(at.map((k) => bound[k]!)), dash: [4, 4] },
        { name: "friction", colour: colours.exact, values: between(at.map((k) => Math.hypot(px[k]!, py[k]!))) },
      ],
    });
    for (const chart of [this.#creepages, this.#forces]) if (chart.content) chart.draw({ ...chart.content, present: frame.distance * 1e3 });
    const text = frame.distance === 0 ? "at rest, forces put on" : `rolled ${digits(frame.distance * 1e3)} mm, ${digits(frame.distance / (2 * a))} lengths of the contact`;
    this.#spoken.textContent = text;
    this.#showKeys(found, frame);
    this.#map.setAttribute("aria-label", `adhesion, slip and tractions ${text}`);
  }

  #showKeys({ bound, hertz: { a, b }, frames }: Transient, { distance, fx, fy, creepage_longitudinal, px, py, state }: Frame): void {
    const of = (wanted: number) => [...state].filter((one) => one === wanted).length, inContact = of(1) + of(2), share = inContact > 0 ? of(1) / inContact : 1, percent = (value: number) => String(Math.round(100 * value));
    const { values } = this.state, possible = values["friction.coefficient"]! * values["load.normal_force"]!, friction = Math.hypot(fx, fy), last = frames.at(-1)!;
    const largest = (all: Numbers) => [...all].reduce((most, value) => Math.max(most, value), 0), minus = (value: string) => value.replace("-", "−");
    this.#keys.show([
      { name: "Distance rolled", value: digits(distance * 1e3), unit: "mm", note: distance === 0 ? "still at rest" : `${digits(distance / (2 * a))} contact lengths`, what: "How far the contact has moved over both surfaces. After about one length of it the state is nearly steady." },
      { name: "Contact patch", value: (2e3 * a).toFixed(1), unit: "mm long", note: `${(2e3 * b).toFixed(1)} mm wide`, what: "The ellipse of Hertz, along the direction of rolling and across." },
      { name: "Highest friction", value: digits(Math.round(largest([...px].map((p, k) => Math.hypot(p, py[k]!))) / 1e6)), unit: "MPa", note: `of at most ${digits(Math.round(largest(bound) / 1e6))} MPa`, what: "The largest friction force per area. It can be at most the friction coefficient times the pressure, which is largest in the middle." },
      { name: "Sticks and slides", value: "", unit: "", note: `${percent(share)} % sticks, ${percent(1 - share)} % slides`, share, what: "Shares of the contact where both surfaces stick together (adhesion) and where they slide (slip)." },
      { name: "Friction force", value: (friction / 1e3).toFixed(1), unit: "kN", note: `${percent(friction / possible)} % of ${(possible / 1e3).toFixed(1)} kN possible`, what: `Along the surface. ${output("bodies", "fx").text}.` },
      { name: "Creepage", value: distance === 0 ? "–" : minus((100 * creepage_longitudinal).toFixed(3)), unit: distance === 0 ? "" : "%", note: `${minus((100 * last.creepage_longitudinal).toFixed(3))} % at the end`, what: `By how much the wheel turns slower than it rolls; at rest there is none. ${output("bodies", "creepage_longitudinal").text}.` },
    ]);
  }

  #drawHistory(): void {
    const { frames } = this.#found!, rolled = frames.filter(({ distance }) => distance > 0);
    const draw = (chart: Chart, of: Frame[], yLabel: string, [along, across]: [(frame: Frame) => number, (frame: Frame) => number]) => {
      chart.draw({
        x: of.map(({ distance }) => distance * 1e3), xLabel: "distance rolled [mm]", yLabel, present: frames[this.state.frame]!.distance * 1e3,
        curves: [{ name: "along", colour: "--accent1", values: of.map(along) }, { name: "across", colour: "--accent2", values: of.map(across) }],
      });
    };
    draw(this.#creepages, rolled, "creepage [%]", [(frame) => frame.creepage_longitudinal * 100, (frame) => frame.creepage_lateral * 100]);
    draw(this.#forces, frames, "force [kN]", [({ fx }) => fx / 1e3, ({ fy }) => fy / 1e3]);
  }
}
