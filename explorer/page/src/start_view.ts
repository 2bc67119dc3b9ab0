// A contact that starts to roll under given forces: from Cattaneo's shift to Carter's steady rolling, played as an animation.

import { startCase, toPython } from "./case_text.ts";
import { Chart } from "./chart.ts";
import * as colours from "./colours.ts";
import type { Core } from "./core.ts";
import { button, element, fillRemarks, save, sentence } from "./elements.ts";
import { drawMap, rowHeight } from "./field_map.ts";
import { Field, refuseAt, showsLast, withoutPlace, type FieldSpec } from "./fields.ts";
import type { StartState } from "./state.ts";
import { digits } from "./units.ts";

interface Frame {
  distance: number; fx: number; fy: number; mz: number; creepage_longitudinal: number; creepage_lateral: number;
  px: number[]; py: number[]; sx: number[]; sy: number[]; state: number[];
}
interface Transient {
  hertz: { a: number; b: number }; x: number[]; y: number[]; bound: number[]; frames: Frame[]; status: string; warnings: string[];
}

const specs: FieldSpec[] = [
  { key: "load.normal_force", label: "normal force", kind: "force", unit: "kN", from: 5, to: 200, step: 1 },
  { key: "motion.force_longitudinal", label: "longitudinal force on the upper body", kind: "force", unit: "kN", from: -40, to: 40, step: 0.5 },
  { key: "motion.force_lateral", label: "lateral force on the upper body", kind: "force", unit: "kN", from: -40, to: 40, step: 0.5 },
  { key: "friction.coefficient", label: "friction", kind: "number", unit: "", from: 0.05, to: 0.8, step: 0.01 },
  { key: "body1.rolling_radius", label: "radius of the upper body", kind: "length", unit: "mm", from: 20, to: 1000, step: 5 },
  { key: "body2.transverse_radius", label: "lower body, across", kind: "length", unit: "mm", from: 20, to: 1000, step: 5 },
  { key: "motion.steps", label: "steps", kind: "number", unit: "", from: 10, to: 120, step: 1 },
];

export class StartView {
  readonly root: HTMLElement;
  readonly fields: Field[] = [];
  readonly #map = element("canvas", { class: "map", role: "img" });
  readonly #message = element("p", { class: "message", role: "alert" });
  readonly #remarks = element("ul", { class: "remarks", role: "status" });
  readonly #spoken = element("p", { "aria-live": "polite" });
  readonly #time = element("p", { class: "time" });
  readonly #slider = element("input", { type: "range", min: "0", max: "0", step: "1", "aria-label": "distance rolled" });
  readonly #play: HTMLButtonElement;
  readonly #cut: Chart;
  readonly #history: Chart;
  #found: Transient | undefined;
  #timer = 0;

  constructor(readonly core: Core, public state: StartState, readonly changed: () => void) {
    const cut = element("div", { class: "chart" }), history = element("div", { class: "chart" });
    this.#cut = new Chart(cut);
    this.#history = new Chart(history);
    this.#play = button("▶ play", () => { if (this.#timer) this.stop(); else this.play(); }, "play or stop");
    this.#slider.addEventListener("input", () => { this.#show(Number(this.#slider.value)); this.changed(); });
    const made = specs.map((spec) => {
      const field = new Field("start", spec, state.values[spec.key]!, (value) => {
        this.state.values[spec.key] = value;
        this.solve();
        this.changed();
      });
      this.fields.push(field);
      return field.root;
    });
    this.root = element("section", { class: "view", "aria-label": "Start and stop" },
      element("div", { class: "controls" }, element("fieldset", {}, element("legend", {}, "Contact"), ...made),
        element("p", { class: "hint" }, "At rest the forces are put on: slip begins all around the edge (Cattaneo). Then the bodies roll: slip moves to the trailing edge, and after about one length of the contact rolling is steady (Carter).")),
      element("div", { class: "pictures" },
        element("div", { class: "panel wide" }, element("div", { class: "choices" }, this.#play, this.#slider), this.#spoken, this.#map, this.#message, this.#remarks, this.#time),
        element("div", { class: "panel" }, element("h3", {}, "Along y = 0"), cut),
        element("div", { class: "panel" }, element("h3", {}, "Creepage that the force takes"), history)));
  }

  set(state: StartState): void {
    this.state = state;
    for (const field of this.fields) field.set(state.values[field.spec.key]!);
  }

  solve(): void {
    void this.core.ask<Transient>("transient", { call: "transient", case: startCase(this.state) }).then((reply) => {
      if (!reply) return;
      const message = reply.error?.message ?? "", named = refuseAt(this.fields, message);
      this.root.classList.toggle("old", message !== "");
      this.#message.textContent = message && `${named ? "" : `${sentence(withoutPlace(message))} `}${showsLast}`;
      if (!reply.result) return;
      this.#found = reply.result;
      const { warnings, status } = reply.result;
      fillRemarks(this.#remarks, [...warnings, ...(status === "ok" ? [] : [`ends at the first frame that is ${status.replaceAll("_", " ")}`])].map(sentence));
      this.#time.textContent = `exact theory, ${reply.result.frames.length} frames: ${digits(1e3 * (reply.time ?? 0))} ms`;
      this.#slider.max = String(reply.result.frames.length - 1);
      this.#drawHistory();
      this.#show(Math.min(this.state.frame, reply.result.frames.length - 1));
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
      "case as TOML": () => { save("starting_to_roll.toml", startCase(this.state)); },
      "case as Python": () => { save("starting_to_roll.py", toPython(startCase(this.state), [])); },
      "creepages as CSV": () => { save("creepages.csv", this.#history.csv(), "text/csv"); },
      "picture as PNG": () => { this.#map.toBlob((blob) => { if (blob) save("starting_to_roll.png", blob); }); },
    };
  }

  draw(): void { this.#show(this.state.frame); }

  #show(index: number): void {
    const found = this.#found, frame = found?.frames[index];
    if (!found || !frame) return;
    this.state.frame = index;
    this.#slider.value = String(index);
    const { x, y, bound } = found, { a, b } = found.hertz;
    const row = [...new Set(y)].sort((one, other) => Math.abs(one) - Math.abs(other))[0]!;
    const places = [...new Set(x)].sort((one, other) => one - other), width = places.length > 1 ? places[1]! - places[0]! : 2 * a;
    const longest = Math.max(...bound, 1e-30);
    drawMap(this.#map, {
      cells: { x, y, width: x.map(() => width), height: rowHeight(y), state: frame.state }, colour: "state", outline: { a, b },
      arrows: { x: frame.px, y: frame.py, longest },
    });
    const at = y.flatMap((value, k) => (value === row && frame.state[k] !== 0 ? [k] : [])).sort((one, other) => x[one]! - x[other]!);
    this.#cut.draw({
      x: at.map((k) => x[k]! * 1e3), xLabel: "x [mm]", yLabel: "MPa",
      curves: [
        { name: "bound", colour: colours.bound, values: at.map((k) => bound[k]! / 1e6), dash: [4, 4] },
        { name: "|p|", colour: colours.exact, values: at.map((k) => Math.hypot(frame.px[k]!, frame.py[k]!) / 1e6) },
      ],
    });
    this.#history.draw({ ...this.#history.content!, present: frame.distance * 1e3 });
    const text = index === 0 ? "at rest, forces put on" : `rolled ${digits(frame.distance * 1e3)} mm, ${digits(frame.distance / (2 * a))} lengths of the contact`;
    this.#spoken.textContent = text;
    this.#map.setAttribute("aria-label", `adhesion, slip and tractions ${text}`);
  }

  #drawHistory(): void {
    const rolled = this.#found!.frames.slice(1);
    this.#history.draw({
      x: rolled.map(({ distance }) => distance * 1e3), xLabel: "distance rolled [mm]", yLabel: "creepage [%]",
      curves: [
        { name: "longitudinal", colour: colours.exact, values: rolled.map((frame) => frame.creepage_longitudinal * 100) },
        { name: "lateral", colour: colours.fastsim2, values: rolled.map((frame) => frame.creepage_lateral * 100) },
      ],
    });
  }
}
