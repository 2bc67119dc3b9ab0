// A wheel on a rail by their profiles: dragged sideways or turned; patches, forces, both wheels, running radii.

import { forPeople, isHowRead, moreInWords, railCase, railPython, runningCase } from "./case_text.ts";
import { Chart } from "./chart.ts";
import * as colours from "./colours.ts";
import { loadScript, type Core } from "./core.ts";
import { help, input, output } from "./description.ts";
import { Keys, Seldom, Segments, button, card, controlsOf, element, fillRemarks, fillTable, long, save, sentence, statusInWords, titleOf, type KeyNumber, type Remedy } from "./elements.ts";
import { rowHeight } from "./field_map.ts";
import { Choice, Form, withoutPlace, type FieldSpec } from "./fields.ts";
import { presetButtons } from "./presets.ts";
import type { FirstAnswers, Outlines } from "./first_answers.ts";
import type { RailHead } from "./rail_head.ts";
import { drawPair, drawScene, flangeClearance, valuesAt, yawAt, yawHandle, type Layout, type Patch, type Outline, type Scene, type Side } from "./rail_picture.ts";
import { sheetsOf, type ElementFields } from "./sheet.ts";
import { initialState, shapes, type RailState, type WheelSide } from "./state.ts";
import { digits, show, shownUnit } from "./units.ts";

declare const BUILT_IN_PROFILES: Record<string, string>;
declare const FIRST_ANSWERS: FirstAnswers;
/** What rail_head.js defines. */
declare const microslipRailHead: { RailHead: typeof RailHead };

interface WheelResult {
  states: Record<string, number[]>;
  wheel: Record<string, (number | string)[]>;
  patches?: Record<string, number[]>; // none where wheel and rail do not touch
  outlines: Outlines;
  fields?: RowsOfPatch[];
  status: string; reason?: string; warnings: string[];
}
/** What the reader made of a profile. */
interface ProfileResult { role?: string; steps: string[]; assumptions: string[]; warnings: string[] }
interface Conicity {
  equivalent_conicity: [number, number][];
  over_lateral_displacement: { lateral: number; rolling_radius_difference: number; left_rolling_radius: number; right_rolling_radius: number }[];
}
type Level = "fastsim2" | "exact";
type RowsOfPatch = ElementFields & { area: number[]; bound: number[] };

const groups: Record<"Where the wheelset stands" | "Load and motion" | "Track and wheelset" | "Material", FieldSpec[]> = {
  "Where the wheelset stands": [
    { key: "wheel.lateral", label: "Moved sideways", from: -8, to: 8, step: 0.01, ends: ["8 right", "8 left"] },
    { key: "wheel.yaw", label: "Turned (yaw)", from: -10, to: 10, step: 0.1, ends: ["10 right", "10 left"] },
  ],
  "Load and motion": [
    { key: "wheel.vertical_force", label: "Load on this wheel", from: 5, to: 150, step: 1 },
    { key: "wheel.forward_velocity", label: "Speed", from: 5, to: 350, step: 1 },
    { key: "friction.coefficient", label: "Friction coefficient", from: 0.05, to: 0.6, step: 0.01, ends: ["0.05 ice", "0.6 dry"] },
  ],
  "Track and wheelset": [
    { key: "track.cant", label: "Rail leans inwards", from: 0, to: 60, step: 0.5, ends: ["upright", "1:17"] },
    { key: "track.gauge", label: "Gauge" },
    { key: "track.curvature", label: "Curve of the track", unit: "1/km" },
    { key: "wheelset.nominal_radius", label: "Wheel radius" },
    { key: "wheelset.flange_back_distance", label: "Between flange backs" },
  ],
  Material: [
    { key: "material.young_modulus", label: "Young's modulus" },
    { key: "material.poisson_ratio", label: "Poisson's ratio" },
  ],
};
const largestDifference = 8e-3; // of rolling radii that is drawn [m]: beyond it the flange runs up
const largestFile = 20e6; // [bytes] beyond which a dropped file is no profile
const knownProfiles: Record<string, string> = { "s1002.prw": "S1002 (new, European)", "60e1.prr": "60E1 (new, 60 kg/m)" };
const nameOf = (file: string): string => knownProfiles[file] ?? file;

/** Wavelengths of smoothing that can be chosen; "" as the points scatter, which is what the library takes. */
const smoothings: Record<string, string> = { "": "as its points scatter", 0: "none", 0.002: "2 mm", 0.004: "4 mm", 0.008: "8 mm", 0.016: "16 mm" };
const roles = ["wheelset", "rail"] as const;
const smoothingOf = (role: (typeof roles)[number]) => `${role}.smoothing_length`;

const side = (value: number, positive: string, negative: string): string => (value > 0 ? positive : negative);
const otherSide = { left: "right", right: "left" } as const;

/** An outline of the other wheel or rail. */
const mirrored = ({ y, z }: Outline): Outline => ({ y: y.map((value) => -value), z });

export class RailView {
  readonly root = element("section", { class: "view", "aria-label": "Wheel on rail" });
  readonly #form = new Form("rail", this.root);
  readonly #shape: Choice;
  readonly #side = new Segments<WheelSide>("which wheel is shown", { left: "Left wheel", right: "Right wheel" }, (of) => { this.#turnTo(of); });
  readonly #run = button("▷ Let it run sideways", () => { if (this.#runs) this.stop(); else this.#start(); }, "let it run sideways, or stop it");
  readonly #forces: HTMLElement;
  readonly #smoothing: Record<(typeof roles)[number], Choice>;
  readonly section = element("canvas", { class: "map", role: "slider", tabindex: "0", "aria-valuemin": "-8", "aria-valuemax": "8" });
  readonly #pair = element("canvas", { class: "map pair", role: "img", "aria-label": "Both wheels on their rails" });
  readonly #steers = element("p", { class: "steers" });
  readonly #lead = element("p");
  readonly #keys = new Keys();
  readonly #numbers = element("table", { class: "numbers" });
  readonly #more = element("p", { class: "hint" });
  readonly #spoken = element("p", { class: "spoken", "aria-live": "polite" });
  readonly #time = element("p", { class: "time" });
  readonly #hover = element("p", { class: "time" });
  readonly #names = element("p", { class: "names" });
  readonly #remarks = element("p", { class: "hint", role: "status" });
  readonly #refused = element("p", { class: "message", role: "alert" }); // why a file is not taken
  readonly #warnings = element("ul", { class: "remarks wide", role: "status" });
  readonly #conicityNow = element("p", { class: "sub" });
  readonly #radii: Chart;
  readonly #conicity: Chart;
  #head: RailHead | undefined;
  #solved: Partial<Record<Level, WheelResult>> = {};
  #solvedSide: WheelSide; // of the wheel that is shown
  #other: WheelResult | undefined; // of the other wheel
  #runs = 0;
  #reach = 0; // how far the wheelset moves sideways until a flange touches [m]
  #patches = new Map<WheelResult, Patch[]>();
  #running: Conicity | undefined;
  #runningOf = "";
  #noRunning = ""; // why there is no conicity
  #later = 0;
  #frame = 0;
  /** What does not have to follow the hand at every frame. */
  readonly #rest = new Seldom(() => { this.#drawRest(); }, () => { this.#drawRunning(); }, () => { this.#drawPair(); });
  #grabbed: { x: number; y: number; what: "wheel" | "yaw"; box: DOMRect } | undefined;
  #isTold = false;
  #layout: Layout | undefined;
  #scene: Scene | undefined;
  #keyNumbers: KeyNumber[] = [];
  #frozen: { keys: KeyNumber[]; scene: Scene } | undefined;

  constructor(readonly core: Core, public state: RailState, readonly changed: () => void) {
    const radii = element("div", { class: "chart" }), conicity = element("div", { class: "chart" });
    this.#radii = new Chart(radii);
    this.#conicity = new Chart(conicity);
    this.#shape = new Choice("Shape of the patch", shapes(), state.shape, (shape) => { this.#shapeTo(shape); }, help(input("rail", "solution.shape")));
    const smooth = (role: (typeof roles)[number], label: string) => new Choice(label, smoothings, this.#smoothed(role), (length) => { this.#smooth(role, length); }, help(input("rail", smoothingOf(role))));
    this.#solvedSide = state.side;
    this.#smoothing = { wheelset: smooth("wheelset", "Smooth the wheel"), rail: smooth("rail", "Smooth the rail") };
    this.#forces = card("", "", "All patches together. Negative: backwards, or to the right.", this.#numbers, this.#spoken);
    this.#forces.prepend(element("h3"));
    this.root.append(
      titleOf("Where wheel and rail touch, and what they do to each other", this.#lead, this.#side.root),
      controlsOf(this.#controls()),
      element("div", { class: "pictures" },
        this.#keys.root,
        card("wide pinned", "", "", this.section, this.#hover, this.#form.message, this.#refused, this.#time),
        this.#warnings,
        card("wide", "Both wheels", "The same wheelset on both rails, from behind; each wheel carries the load that is set. Profiles to scale, track shortened.", this.#run, this.#pair, this.#steers),
        this.#forces,
        card("", "Rolling radius difference", "Left wheel's radius less the right one's, over the sideways position", radii, this.#conicityNow),
        card("wide", "Equivalent conicity", "The cone that would steer as strongly, over how far the wheelset sways", conicity),
        this.#threeDimensions()));
    this.#run.className = "run";
    this.#listen();
    this.#showNames();
    this.#showSide();
  }

  set(state: RailState): void {
    this.state = state;
    this.#showSide();
    this.#shape.set(state.shape);
    for (const role of roles) this.#smoothing[role].set(this.#smoothed(role));
    this.#form.set(state.values);
    this.#remarks.textContent = this.#refused.textContent = "";
    this.#showNames();
  }

  solve(): void {
    clearTimeout(this.#later);
    if (!this.#solved.fastsim2) this.draw();
    void this.#ask("fastsim2").then((drawn) => (drawn ? this.#ask("exact") : false)).then((drawn) => { if (drawn) this.#restLater(); });
  }

  /** The other wheel and the conicity, once nothing has changed for a while. */
  #restLater(): void {
    clearTimeout(this.#later);
    this.#later = window.setTimeout(() => {
      void this.#askOther();
      void this.#askConicity();
    }, 150);
  }

  exports(): Record<string, () => void> {
    const names = () => Object.values(this.state.profiles);
    return {
      "case as TOML": () => { save("wheel_on_rail.toml", forPeople("rail", railCase(this.state, "exact"))); },
      "case as Python": () => { save("wheel_on_rail.py", railPython(this.state)); },
      profiles: () => { for (const name of names()) save(name, this.#files()[name] ?? ""); },
      "rolling radii as CSV": () => { save("rolling_radius_difference.csv", this.#radii.csv(), "text/csv"); },
      "picture as PNG": () => { this.section.toBlob((blob) => { if (blob) save("wheel_on_rail.png", blob); }); },
    };
  }

  /** Keeps what is shown as state A, or no longer. */
  freeze(isKept: boolean): void {
    this.#frozen = isKept && this.#scene ? { keys: this.#keyNumbers, scene: this.#scene } : undefined;
    this.draw();
  }

  #files(): Record<string, string> {
    return { ...BUILT_IN_PROFILES, ...this.state.files };
  }

  #smoothed(role: (typeof roles)[number]): string {
    const length = this.state.more[smoothingOf(role)];
    return length === undefined ? "" : String(length as number);
  }

  #smooth(role: (typeof roles)[number], length: string): void {
    const key = smoothingOf(role);
    this.state.more = Object.fromEntries(Object.entries(this.state.more).filter(([name]) => name !== key));
    if (length !== "") this.state.more[key] = Number(length);
    this.#smoothing[role].set(length);
    this.#showNames();
    this.solve();
    this.changed();
  }

  #turnTo(of: WheelSide): void {
    this.state.side = of;
    this.#showSide();
    this.draw();
    this.solve();
    this.changed();
  }

  /** Of the other wheel what is known of it, until it is solved again. */
  #showSide(): void {
    const { side: of } = this.state;
    this.#side.set(of);
    this.#forces.querySelector("h3")!.textContent = `Forces on the ${of} wheel`;
    if (of === this.#solvedSide) return;
    const last = this.#solved.fastsim2;
    this.#solved = this.#other ? { fastsim2: this.#other } : {};
    this.#other = last;
    this.#solvedSide = of;
  }

  /** Sways the wheelset between the flanges, from where it is. */
  #start(): void {
    const period = 8e3, reach = this.#reach || 6e-3, phase = Math.asin(Math.min(Math.max(this.state.values["wheel.lateral"]! / reach, -1), 1)), begun = performance.now();
    const step = () => {
      if (document.hidden) { this.stop(); return; }
      this.#move("wheel.lateral", Number((reach * Math.sin(phase + (2 * Math.PI * (performance.now() - begun)) / period)).toFixed(5)));
      this.#runs = requestAnimationFrame(step);
    };
    this.#run.textContent = "■ Stop";
    this.#runs = requestAnimationFrame(step);
  }

  /** Stops what runs by itself, which is one change to undo. */
  stop(): void {
    if (!this.#runs) return;
    cancelAnimationFrame(this.#runs);
    this.#runs = 0;
    this.#run.textContent = "▷ Let it run sideways";
    this.changed();
  }

  #shapeTo(shape: string): void {
    this.state.shape = shape;
    this.#shape.set(shape);
    this.solve();
    this.changed();
  }

  #controls(): HTMLElement[] {
    const made = (group: keyof typeof groups) => groups[group].map((spec) =>
      this.#form.add(spec, this.state.values[spec.key]!, (value) => { this.#change(spec.key, value); }).root);
    const group = (name: string, ...content: Node[]) => element("fieldset", {}, element("legend", {}, name), ...content);
    const choose = (role: "rail" | "wheel") => {
      const input = element("input", { type: "file", id: `file-${role}` });
      input.addEventListener("change", () => { const [file] = input.files ?? []; if (file) void this.take(file, role); });
      return element("span", { class: "file" }, input, element("label", { for: `file-${role}` }, `Open a ${role} …`));
    };
    return [
      presetButtons(),
      group("Where the wheelset stands", ...made("Where the wheelset stands")),
      group("Load and motion", ...made("Load and motion")),
      group("Shapes of wheel and rail", this.#names, this.#remarks, element("div", { class: "choices" }, choose("wheel"), choose("rail")),
        element("p", { class: "hint" }, "Simpack, MiniProf or two columns; files may also be dropped on the picture. They stay on this machine."),
        this.#smoothing.wheelset.root, this.#smoothing.rail.root, this.#shape.root,
        button("S1002 on 60E1 again", () => {
          this.state.profiles = { rail: "60e1.prr", wheel: "s1002.prw" };
          this.state.files = {};
          this.#remarks.textContent = "";
          this.#newProfiles("rail", "wheel");
        })),
      group("Track and wheelset", ...made("Track and wheelset")),
      group("Material", ...made("Material")),
      this.#more,
    ];
  }

  /** The head in three dimensions, made when it is wanted. */
  #threeDimensions(): HTMLElement {
    const head = element("div", { class: "head" }), made = element("details", { class: "panel wide" }, element("summary", {}, "Pressure on the rail head in three dimensions"), head);
    made.addEventListener("toggle", () => {
      if (!made.open || this.#head) return;
      void loadScript("rail_head.js").then(() => {
        this.#head ??= new microslipRailHead.RailHead(head);
        this.draw();
      }, (error: unknown) => { head.textContent = `No picture: ${error instanceof Error ? error.message : String(error)}.`; });
    });
    return made;
  }

  #listen(): void {
    const { section } = this, place = (event: PointerEvent) => {
      const box = this.#grabbed?.box ?? section.getBoundingClientRect();
      return [event.clientX - box.left, event.clientY - box.top] as const;
    };
    this.root.addEventListener("pointerdown", ({ target }) => { if (target !== this.#run) this.stop(); });
    section.addEventListener("pointerdown", (event) => {
      const [x, y] = place(event), layout = this.#layout;
      if (!layout) return;
      const { tip } = yawHandle(layout, this.state.values["wheel.yaw"]!), isYaw = Math.hypot(x - tip[0], y - tip[1]) < 24;
      if (!isYaw && y > layout.above.top + layout.above.height) return;
      section.setPointerCapture(event.pointerId);
      this.#isTold = true;
      this.#grabbed = { x, y, what: isYaw ? "yaw" : "wheel", box: section.getBoundingClientRect() };
    });
    section.addEventListener("pointermove", (event) => {
      const [x, y] = place(event), layout = this.#layout;
      if (!layout || !this.#scene) return;
      if (!this.#grabbed) { this.#hover.textContent = valuesAt(layout, this.#scene, [x, y]) ?? ""; return; }
      // One pixel of the hand is one pixel of the wheel, with Shift a tenth. The picture's left is the track's left, positive y.
      const across = (x - this.#grabbed.x) * (event.shiftKey ? 0.1 : 1), rounded = (value: number, to: number) => Math.round(value / to) * to;
      if (this.#grabbed.what === "yaw") this.#change("wheel.yaw", rounded(Math.min(Math.max(yawAt(layout, [x, y]), -0.02), 0.02), 1e-5));
      else this.#change("wheel.lateral", Number((this.state.values["wheel.lateral"]! - across / layout.scale).toPrecision(8)));
      this.#grabbed = { ...this.#grabbed, x, y };
    });
    for (const end of ["pointerup", "pointercancel"]) section.addEventListener(end, () => { this.#grabbed = undefined; });
    section.addEventListener("keydown", (event) => {
      const by = { ArrowLeft: ["wheel.lateral", 5e-5], ArrowRight: ["wheel.lateral", -5e-5], ArrowUp: ["wheel.yaw", 1e-4], ArrowDown: ["wheel.yaw", -1e-4] }[event.key] as [string, number] | undefined;
      if (!by) return;
      event.preventDefault();
      this.#isTold = true;
      this.#change(by[0], Number((this.state.values[by[0]]! + by[1] * (event.shiftKey ? 10 : 1)).toPrecision(8)));
    });
    section.addEventListener("dragover", (event) => { event.preventDefault(); });
    section.addEventListener("drop", (event) => {
      event.preventDefault();
      const files = [...(event.dataTransfer?.files ?? [])];
      if (files.some(({ name }) => name.endsWith(".toml"))) return; // a case, which the page takes
      for (const file of files) void this.take(file);
    });
  }

  #change(key: string, value: number): void {
    this.#move(key, value);
    this.changed();
  }

  #move(key: string, value: number): void {
    this.state.values[key] = value;
    this.#form.fields.find(({ spec }) => spec.key === key)?.set(value);
    this.draw(); // the wheel goes with the hand, before it is solved
    this.solve();
  }

  /** A profile that a person gives; the core says what it is, or why it is none. */
  async take(file: File, role?: "rail" | "wheel"): Promise<void> {
    if (file.size > largestFile) {
      this.#refused.textContent = `${file.name} has ${digits(file.size / 1e6)} MB; profiles up to ${digits(largestFile / 1e6)} MB are read`;
      return;
    }
    const bytes = new Uint8Array(await file.arrayBuffer());
    let text: string;
    try { text = new TextDecoder("utf-8", { fatal: true }).decode(bytes); } catch { text = new TextDecoder("latin1").decode(bytes); }
    const name = file.name.replaceAll(/[\\/"]/g, "_");
    const reply = await this.core.ask<ProfileResult>(`rail profile ${name}`, { call: "profile", name, text, ...(role ? { role } : {}) });
    if (!reply) return;
    if (reply.error) { this.#refused.textContent = reply.error.message; return; }
    const found = role ?? reply.result?.role;
    if (found !== "rail" && found !== "wheel") {
      this.#refused.textContent = `${name} does not say whether it is a rail or a wheel: choose it under its own name at the left`;
      return;
    }
    if (this.state.profiles[found === "rail" ? "wheel" : "rail"] === name && this.#files()[name] !== text) {
      this.#refused.textContent = `rail and wheel are both called ${name}: give one of the files another name`;
      return;
    }
    this.#refused.textContent = "";
    this.state.files[name] = text;
    this.state.profiles[found] = name;
    const { steps, assumptions, warnings } = reply.result!;
    this.#remarks.textContent = `${name}: ${[...warnings, ...assumptions, ...steps].join("; ") || "read as it is"}.`;
    this.#newProfiles(found);
  }

  /** How a case said that its profile is to be read is nothing to another one. */
  #newProfiles(...roles: ("rail" | "wheel")[]): void {
    const used = Object.values(this.state.profiles), ofOld = (key: string) => roles.some((role) => isHowRead(key, role === "rail" ? "rail" : "wheelset"));
    this.state.more = Object.fromEntries(Object.entries(this.state.more).filter(([key]) => !ofOld(key)));
    this.state.files = Object.fromEntries(Object.entries(this.state.files).filter(([name]) => used.includes(name)));
    this.#showNames();
    this.solve();
    this.changed();
  }

  #showNames(): void {
    const { profiles, more } = this.state;
    this.#names.textContent = `Wheel ${profiles.wheel} on rail ${profiles.rail}`;
    const others = Object.entries(more).filter(([key]) => !roles.some((role) => key === smoothingOf(role)));
    this.#more.textContent = moreInWords(Object.fromEntries(others));
  }

  async #ask(level: Level): Promise<boolean> {
    const { side: of } = this.state, reply = await this.core.ask<WheelResult>(`rail ${level}`, {
      call: "solve", case: railCase(this.state, level), files: this.#files(), fields: true, extent: level === "exact" ? "solution" : "full",
    });
    if (!reply || of !== this.state.side) return false;
    if (this.#form.refuse(reply.error?.message ?? "")) return false;
    const found = reply.result!;
    this.#solved[level] = { ...found, outlines: found.outlines ?? this.#solved.fastsim2?.outlines };
    if (level === "fastsim2") delete this.#solved.exact;
    this.#time.textContent = level === "exact" ? `exact theory, computed in ${digits(1e3 * (reply.time ?? 0))} ms` : `quick theory FASTSIM2, computed in ${digits(1e3 * (reply.time ?? 0))} ms; the exact one follows`;
    this.draw();
    return true;
  }

  /** The other wheel, under the same load, by the quick theory. */
  async #askOther(): Promise<void> {
    const of = otherSide[this.state.side], reply = await this.core.ask<WheelResult>("rail other", { call: "solve", case: railCase(this.state, "fastsim2", of), files: this.#files(), fields: true });
    if (!reply || of === this.state.side) return;
    this.#other = reply.result;
    this.#drawPair();
  }

  async #askConicity(): Promise<void> {
    const asked = runningCase(this.state);
    const of = asked + JSON.stringify(this.state.files);
    if (of !== this.#runningOf) {
      this.#runningOf = of;
      const reply = await this.core.ask<Conicity>("rail conicity", { call: "conicity", case: asked, files: this.#files() });
      if (!reply || of !== this.#runningOf) return;
      this.#running = reply.result;
      this.#noRunning = reply.error ? sentence(withoutPlace(reply.error.message)) : "";
    }
    this.#drawRunning();
    this.#drawPair();
  }

  #drawRunning(): void {
    if (!this.#running) {
      this.#radii.refuse(this.#noRunning);
      this.#conicity.refuse(this.#noRunning);
      this.#conicityNow.textContent = "";
      return;
    }
    const over = this.#running.over_lateral_displacement.filter((at) => Math.abs(at.rolling_radius_difference) < largestDifference), present = 1e3 * this.state.values["wheel.lateral"]!;
    this.#radii.draw({ drag: (lateral) => { this.#change("wheel.lateral", Number((lateral / 1e3).toPrecision(4))); },
      x: over.map(({ lateral }) => lateral * 1e3), xLabel: "sideways position [mm], to the left →", yLabel: "left − right [mm]", present,
      curves: [{ name: "radius difference", colour: colours.exact, values: over.map((at) => at.rolling_radius_difference * 1e3) }],
    });
    const conicity = this.#running.equivalent_conicity, at3 = conicity.find(([amplitude]) => Math.abs(amplitude - 3e-3) < 1e-6);
    this.#conicityNow.textContent = at3 ? `Swaying by 3 mm it steers as a cone of slope ${at3[1].toFixed(3)} would.` : "";
    this.#conicity.draw({
      x: conicity.map(([amplitude]) => amplitude * 1e3), xLabel: "amplitude [mm]", yLabel: "conicity", present: Math.abs(present),
      curves: [{ name: "conicity", colour: colours.exact, values: conicity.map(([, value]) => value) }],
    });
  }

  #patchesOf(solved: WheelResult): Patch[] {
    const known = this.#patches.get(solved);
    if (known) return known;
    const { patches = {}, fields } = solved;
    const made = (patches["normal_force"] ?? []).map((normal_force, i): Patch => {
      const at = (name: string) => patches[name]![i]!, f = fields?.[i];
      return {
        normal_force, ...frictionOf(f, { fx: at("fx"), fy: at("fy"), possible: NaN }), place_x: at("place_x"), place_y: at("place_y"), place_z: at("place_z"), angle: at("angle"), rail_y: at("rail_y"),
        peak_pressure: at("peak_pressure"), contact_area: at("contact_area"), slip_area: at("slip_area"), fields: f, sheets: f ? sheetsOf(f, rowHeight(f.y)) : [],
      };
    });
    this.#patches = new Map([...this.#patches].slice(-3)).set(solved, made);
    return made;
  }

  /** Once a frame, whatever has changed since the last one. */
  draw(): void {
    cancelAnimationFrame(this.#frame);
    this.#frame = requestAnimationFrame(() => { this.#drawNow(); });
  }

  #drawNow(): void {
    const solved = this.#solved.exact ?? this.#solved.fastsim2;
    if (!solved || !this.#solved.fastsim2?.outlines) {
      this.#drawBodies();
      return;
    }
    this.#drawScene(solved, this.#solved.fastsim2.outlines, solved.states["lateral"]![0]!);
    this.#showKeys(solved);
    this.#rest.soon();
  }

  #drawRest(): void {
    const solved = this.#solved.exact ?? this.#solved.fastsim2;
    if (!solved) return;
    this.#tell();
    this.#showNumbers();
    fillRemarks(this.#warnings, remarksOn(solved), this.#remedies());
    if (this.#head) this.#head.show(solved.outlines.rail, this.#patchesOf(solved));
  }

  /** Wheel and rail before the core has answered, which the page knows of its own profiles where it begins. */
  #drawBodies(): void {
    const first = initialState().rail, { values, profiles } = this.state;
    this.#showKeys(undefined);
    const isKnown = ["track.cant", "track.gauge", "wheelset.flange_back_distance"].every((key) => values[key] === first.values[key]);
    if (!isKnown || profiles.rail !== first.profiles.rail || profiles.wheel !== first.profiles.wheel || Object.keys(this.state.files).length) return;
    const { rail, wheel } = FIRST_ANSWERS.outlines, isLeft = this.state.side === first.side, lateral = first.values["wheel.lateral"]!; // of the left wheel
    this.#drawScene(undefined, isLeft ? { rail, wheel } : { rail: mirrored(rail), wheel: mirrored(wheel) }, isLeft ? lateral : -lateral);
    this.#tell();
  }

  /** `outlinesAt`: the sideways position of the wheel that the outlines show. */
  #drawScene(solved: WheelResult | undefined, outlines: Outlines, outlinesAt: number): void {
    const { values, profiles } = this.state, lateral = values["wheel.lateral"]!, moved = lateral - outlinesAt;
    const wheel = moved === 0 ? outlines.wheel : { y: outlines.wheel.y.map((y) => y + moved), z: outlines.wheel.z };
    const cant = values["track.cant"]!, lean = cant === 0 ? "upright" : `leans inwards 1:${digits(Math.round(1 / Math.tan(cant)))}`;
    const { side: of } = this.state, compared = this.#frozen?.scene.side === of ? this.#frozen.scene : undefined;
    const scene: Scene = {
      side: of, rail: outlines.rail, wheel, patches: solved ? this.#patchesOf(solved) : [], yaw: values["wheel.yaw"]!, trouble: solved ? troubleOf(solved) : "", isComputing: !solved, isTold: this.#isTold, compared,
      names: { wheel: nameOf(profiles.wheel), radius: `radius ${digits(1e3 * values["wheelset.nominal_radius"]!)} mm`, rail: nameOf(profiles.rail), lean },
    };
    this.#layout = drawScene(this.section, scene);
    this.#scene = scene;
    this.#showReach(scene, lateral);
    this.section.setAttribute("aria-valuenow", (1e3 * lateral).toFixed(2));
  }

  /** How far the wheelset may move until the flange of either wheel touches, whose profiles are the same. */
  #showReach(scene: Scene, lateral: number): void {
    const flange = flangeClearance(scene);
    if (!flange || flange.free < -5e-3 || flange.free > 0.03) return; // derailed
    this.#reach = Math.round(1e4 * (flange.free + (scene.side === "left" ? lateral : -lateral))) / 1e4;
    this.#form.fields.find(({ spec }) => spec.key === "wheel.lateral")!.hatchBeyond(this.#reach, "a flange touches the rail");
  }

  /** The state in a sentence. */
  #tell(): void {
    const { "wheel.lateral": lateral = 0, "wheel.yaw": yaw = 0 } = this.state.values;
    const stands = lateral === 0 ? "in the middle of the track" : `${Math.abs(1e3 * lateral).toFixed(1)} mm to the ${side(lateral, "left", "right")} of the track's middle`;
    const turns = yaw === 0 ? "points straight ahead" : `is turned ${Math.abs(1e3 * yaw).toFixed(1)} mrad to the ${side(yaw, "left", "right")}`;
    this.#lead.replaceChildren("Cut through the ", element("b", {}, `${this.state.side} wheel`), " and its rail", ...long(", to scale; you look along the track, the way the train goes"), `. The wheelset stands ${stands} and ${turns}. `,
      ...long("Drag the wheel (Shift: ten times finer) or the handle that turns it; arrow keys do the same."));
    const where = this.#scene!.patches.map((patch) => `${digits(patch.rail_y * 1e3)} mm`).join(" and ");
    this.section.setAttribute("aria-label", `Wheel, moved sideways; wheel and rail seen along the track, contact on the rail at y = ${where || "no place"}`);
    this.section.setAttribute("aria-valuetext", `${stands}, ${turns}`);
  }

  /** Without a result: their names. */
  #showKeys(solved: WheelResult | undefined): void {
    const patches = solved ? this.#patchesOf(solved) : [], sum = (of: (patch: Patch) => number) => patches.reduce((all, patch) => all + of(patch), 0);
    const area = sum(({ contact_area }) => contact_area), slipping = sum(({ slip_area }) => slip_area), friction = sum(({ fx, fy }) => Math.hypot(fx, fy));
    const possible = sum((patch) => patch.possible), peak = Math.max(0, ...patches.map(({ peak_pressure }) => peak_pressure));
    const wheel = (name: string) => Number(solved?.wheel[name]?.[0]), ratio = wheel("y_over_q"), limit = wheel("nadal_limit");
    const size = patches.length === 1 ? sizeOf(patches[0]!) : patches.length ? `in ${String(patches.length)} parts` : "no contact";
    const climbing = ratio > limit ? "above the limit: it can climb" : ratio > 0.7 * limit ? "close to climbing the rail" : "far from climbing the rail";
    const share = area > 0 ? 1 - slipping / area : 0, minus = (words: string) => words.replace("-", "−");
    const numbers: KeyNumber[] = [
      { name: "Load on this wheel", value: digits(wheel("force_z") / 1e3), unit: "kN", note: "upwards, from the rail", what: `What the rail carries of the wheelset through this wheel. ${output("wheel", "force_z").text}.` },
      { name: "Contact patch", value: digits(Math.round(1e6 * area)), unit: "mm²", note: size, what: `The area of steel that touches, as large as a fingernail. ${output("patch", "contact_area").text}.` },
      { name: "Highest pressure", value: Math.round(peak / 1e6).toLocaleString("en"), unit: "MPa", note: peak / 1e6 > 1000 ? `${digits(Math.round(peak / 1e5) / 10)} N on each mm²` : "", what: `The largest pressure within the contact. Rail steel yields below the surface from some 1500 MPa on; microslip computes elastic steel. ${output("patch", "peak_pressure").text}.` },
      { name: "Sticks and slides", value: "", unit: "", note: area > 0 ? `${String(Math.round(100 * share))} % sticks, ${String(Math.round(100 * (1 - share)))} % slides` : "nothing", share, what: "Shares of the contact where both surfaces stick together (adhesion) and where they slide (slip). What slides wears." },
      { name: "Friction force", value: (friction / 1e3).toFixed(1), unit: "kN", note: possible > 0 ? `${String(Math.round((100 * friction) / possible))} % of ${(possible / 1e3).toFixed(1)} kN possible` : "", what: "Along the surface, summed over the patches; possible is the friction coefficient times the pressure, summed" },
      { name: "Climbing (Y/Q)", value: minus(ratio.toFixed(2)), unit: `limit ${limit.toFixed(2)}`, note: climbing, what: `${output("wheel", "y_over_q").text}. ${output("wheel", "nadal_limit").text}.` },
    ];
    this.#keyNumbers = solved ? numbers : numbers.map((number) => ({ ...number, value: "…", unit: "", note: "computing", ...(number.share === undefined ? {} : { share: NaN }) }));
    this.#keys.show(this.#keyNumbers, this.#frozen?.keys);
  }

  #drawPair(): void {
    const solved = this.#solved.exact ?? this.#solved.fastsim2, outlines = this.#solved.fastsim2?.outlines, other = this.#other;
    if (!solved || !outlines) return;
    const words = (name: string, of: WheelResult, radius: number | undefined) => {
      const value = (key: string) => Number(of.wheel[key]?.[0]), angle = Math.max(...(of.patches?.["angle"] ?? [0]).map(Math.abs));
      return [name, `load ${digits(Math.round(value("force_z") / 100) / 10)} kN`, ...(radius === undefined ? [] : [`rolling radius ${(1e3 * radius).toFixed(2)} mm`]), `tilt of the contact ${((180 * angle) / Math.PI).toFixed(1)}°`,
        `${Math.abs(value("force_x") / 1e3).toFixed(1)} kN ${side(value("force_x"), "forwards", "backwards")}`, `${Math.abs(value("force_y") / 1e3).toFixed(1)} kN to the ${side(value("force_y"), "left", "right")}`];
    };
    const lateral = this.state.values["wheel.lateral"]!, near = nearest(this.#running, lateral);
    const sideOf = (of: WheelSide): Side | undefined => {
      const result = of === this.state.side ? solved : other, name = of === "left" ? "Left wheel" : "Right wheel", outline = of === this.state.side ? outlines : other?.outlines;
      return result && outline && { outline, patches: this.#patchesOf(result), words: words(name, result, near?.[of]) };
    };
    drawPair(this.#pair, { lateral, gauge: this.state.values["track.gauge"]!, left: sideOf("left"), right: sideOf("right") });
    if (!near) { this.#steers.textContent = ""; return; }
    const difference = near.left - near.right, size = Math.abs(1e3 * difference).toFixed(2), larger = side(difference, "left", "right"), to = side(difference, "right", "left");
    const isBack = lateral !== 0 && difference > 0 === lateral > 0;
    const told = Math.abs(difference) < 2e-5 ? "Both wheels roll on the same radius: nothing steers the wheelset."
      : `Both turn equally fast. The ${larger} wheel rolls on a radius ${size} mm larger and runs ahead, so the wheelset steers to the ${to}${isBack ? ", back to the middle" : lateral === 0 ? "" : ", away from the middle"}.`;
    this.#steers.textContent = told;
    this.#pair.setAttribute("aria-label", `Both wheels on their rails. ${told}`);
  }

  #showNumbers(): void {
    const columns = [this.#solved.exact, this.#solved.fastsim2];
    const row = (label: string, name: string, shown?: string) => {
      const { unit: si, text } = output("wheel", name), unit = shown ?? shownUnit(si);
      return { name: label, unit, what: text, values: columns.map((of) => (of ? show(Number(of.wheel[name]?.[0]), si, unit) : "…")) };
    };
    fillTable(this.#numbers, ["exact", "FASTSIM2"], [
      row("longitudinal force, forwards", "force_x"), row("lateral force, to the left", "force_y"), row("vertical force", "force_z"), row("rubbing work per metre, T-gamma", "t_gamma", "N"),
      row("Y/Q", "y_over_q"), row("Nadal's limit of Y/Q", "nadal_limit"), row("heat made, frictional power", "frictional_power"), row("patches", "patch_count"),
    ]);
    const shown = columns[0] ?? columns[1];
    if (shown) this.#spoken.textContent = `lateral force ${digits(Number(shown.wheel["force_y"]?.[0]) / 1e3)} kN, ${String(shown.wheel["patch_count"]?.[0])} patches`;
  }

  /** What the page can do about what is odd. */
  #remedies(): Remedy[] {
    const back = () => { this.#change("wheel.lateral", 0.003); };
    return [
      { when: /solved as flat/, name: "Use the curved shape", run: () => { this.#shapeTo("curved"); } },
      { when: /derailed|do not touch|profile's end|end of (a|the) profile/, name: "Back on the rail", run: back },
      { when: /hundredth of Young|may climb/, name: "Away from the flange", run: back },
      ...roles.map((role): Remedy => {
        const file = this.state.profiles[role === "rail" ? "rail" : "wheel"].replaceAll(/[.*+?^${}()|[\]\\]/g, "\\$&");
        return { when: new RegExp(`^${file}: .*(leave smoothing_length out|smooth with)`), name: `Smooth the ${role === "rail" ? "rail" : "wheel"}`, run: () => { this.#smooth(role, ""); } };
      }),
    ];
  }
}

/** Friction of a patch summed along its surface, which turns where the patch is curved, and the most that it can be. */
function frictionOf(f: RowsOfPatch | undefined, otherwise: Pick<Patch, "fx" | "fy" | "possible">): Pick<Patch, "fx" | "fy" | "possible"> {
  if (!f) return otherwise;
  const sum = (of: number[]) => of.reduce((all, value, k) => all + value * f.area[k]!, 0);
  return { fx: sum(f.px), fy: sum(f.py), possible: sum(f.bound) };
}

/** Length along and width across of a patch. */
function sizeOf({ sheets }: Patch): string {
  const corners = sheets.flatMap((sheet) => sheet.outline()), reach = (of: number[]) => (1e3 * (Math.max(...of) - Math.min(...of))).toFixed(1);
  return corners.length ? `${reach(corners.map(([x]) => x))} mm × ${reach(corners.map(([, y]) => y))} mm` : "";
}

/** Rolling radii of both wheels at a sideways position, between those that are known. */
function nearest(running: Conicity | undefined, lateral: number): { left: number; right: number } | undefined {
  const over = running?.over_lateral_displacement ?? [], i = over.findIndex((at) => at.lateral >= lateral);
  const [low, high] = [over[i - 1], over[i]];
  if (!low || !high) return undefined;
  const t = (lateral - low.lateral) / (high.lateral - low.lateral), mix = (a: number, b: number) => a + t * (b - a);
  return { left: mix(low.left_rolling_radius, high.left_rolling_radius), right: mix(low.right_rolling_radius, high.right_rolling_radius) };
}

/** Warnings of a result, its status unless it is ok, and why. */
function remarksOn({ warnings, status, reason }: WheelResult): string[] {
  return [...(status === "ok" ? [] : [statusInWords(status, reason)]), ...warnings].map(sentence);
}

/** What is wrong with where the wheel is, in few words for the picture. */
function troubleOf(solved: WheelResult): string {
  const all = remarksOn(solved).join(" ");
  if (/derailed/.test(all)) return "Derailed: the flange is not inside the rail any more";
  if (/do not touch/.test(all)) return "Lifted: wheel and rail do not touch";
  if (/flange may climb/.test(all)) return "The flange may climb: Y/Q is above Nadal's limit";
  if (/hundredth of Young/.test(all)) return "Steel yields far below this pressure";
  if (Number(solved.wheel["at_profile_end"]?.[0]) > 0) return "The contact reaches the end of a profile";
  return solved.status === "ok" ? "" : "No solution here: see below";
}
