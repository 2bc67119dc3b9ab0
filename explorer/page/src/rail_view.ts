// A wheel on a rail by their profiles: dragged sideways or turned; patches, forces, running radii.

import { isHowRead, moreInWords, railCase, railPython, runningCase } from "./case_text.ts";
import { Chart } from "./chart.ts";
import * as colours from "./colours.ts";
import type { Core } from "./core.ts";
import { help, input, output } from "./description.ts";
import { button, element, fillRemarks, fillTable, save, sentence, statusInWords } from "./elements.ts";
import { clearMap, drawMap, fitToScreen, rowHeight } from "./field_map.ts";
import { Choice, Form, withoutPlace, type FieldSpec } from "./fields.ts";
import { RailHead, type Patch } from "./rail_head.ts";
import { cellsUpToTheEdge } from "./row_edge.ts";
import { shapes, type RailState } from "./state.ts";
import { digits, show, shownUnit } from "./units.ts";

declare const BUILT_IN_PROFILES: Record<string, string>;

interface Outline { y: number[]; z: number[] }
interface PatchFields { x: number[]; y: number[]; width: number[]; pressure: number[]; px: number[]; py: number[]; state: number[] }
interface WheelResult {
  wheel: Record<string, (number | string)[]>;
  patches?: Record<string, number[]>; // none where wheel and rail do not touch
  outlines: { rail: Outline; wheel: Outline };
  fields?: PatchFields[];
  status: string; reason?: string; warnings: string[];
}
/** What the reader made of a profile. */
interface ProfileResult { role?: string; steps: string[]; assumptions: string[]; warnings: string[] }
interface Conicity {
  equivalent_conicity: [number, number][];
  over_lateral_displacement: { lateral: number; rolling_radius_difference: number; left_rail_y: number }[];
}
type Level = "fastsim2" | "exact";

const groups: Record<"Wheelset" | "Track and wheelset" | "Material", FieldSpec[]> = {
  Wheelset: [
    { key: "wheel.lateral", label: "lateral position, to the left", from: -8, to: 8, step: 0.01 },
    { key: "wheel.yaw", label: "yaw, to the left", from: -20, to: 20, step: 0.1 },
    { key: "wheel.vertical_force", label: "wheel load", from: 5, to: 150, step: 1 },
    { key: "wheel.forward_velocity", label: "speed", from: 5, to: 350, step: 1 },
    { key: "friction.coefficient", label: "friction", from: 0.05, to: 0.8, step: 0.01 },
  ],
  "Track and wheelset": [
    { key: "track.cant", label: "rail inclination", unit: "rad" },
    { key: "track.gauge", label: "gauge" },
    { key: "wheelset.nominal_radius", label: "wheel radius" },
    { key: "wheelset.flange_back_distance", label: "between flange backs" },
  ],
  Material: [
    { key: "material.young_modulus", label: "Young's modulus" },
    { key: "material.poisson_ratio", label: "Poisson's ratio" },
  ],
};
const largestFile = 20e6; // [bytes] beyond which a dropped file is no profile

export class RailView {
  readonly root = element("section", { class: "view", "aria-label": "Wheel on rail" });
  readonly #form = new Form("rail", this.root);
  readonly #shape: Choice;
  readonly section = element("canvas", { class: "map", role: "img", tabindex: "0" });
  readonly #patchMap = element("canvas", { class: "map small", role: "img" });
  readonly #numbers = element("table", { class: "numbers" });
  readonly #more = element("p", { class: "hint" });
  readonly #spoken = element("p", { class: "spoken", "aria-live": "polite" });
  readonly #time = element("p", { class: "time" });
  readonly #names = element("p", { class: "names" });
  readonly #remarks = element("p", { class: "hint", role: "status" });
  readonly #warnings = element("ul", { class: "remarks", role: "status" });
  readonly #radii: Chart;
  readonly #conicity: Chart;
  readonly #head: RailHead;
  #solved: Partial<Record<Level, WheelResult>> = {};
  #running: Conicity | undefined;
  #runningOf = "";
  #noRunning = ""; // why there is no conicity
  #later = 0;
  #grabbed: { x: number; y: number; lateral: number; yaw: number } | undefined;

  constructor(readonly core: Core, public state: RailState, readonly changed: () => void) {
    const radii = element("div", { class: "chart" }), conicity = element("div", { class: "chart" }), head = element("div", { class: "head" });
    this.#radii = new Chart(radii);
    this.#conicity = new Chart(conicity);
    this.#head = new RailHead(head);
    this.#shape = new Choice("shape, of the exact theory", shapes(), state.shape, (shape) => {
      this.state.shape = shape;
      this.solve();
      this.changed();
    }, help(input("rail", "solution.shape")));
    this.root.append(
      element("div", { class: "controls" }, ...this.#controls()),
      element("div", { class: "pictures" },
        element("div", { class: "panel wide" },
          element("p", { class: "hint" }, "Drag the wheel sideways; with Shift, or up and down, turn it. Arrow keys do the same."),
          this.section, this.#form.message, this.#warnings, this.#time),
        element("div", { class: "panel" }, element("h3", {}, "Forces on the left wheel"), this.#numbers, this.#spoken),
        element("div", { class: "panel" }, element("h3", {}, "Pressure on the rail head"), head),
        element("div", { class: "panel" }, element("h3", {}, "Largest patch: pressure and tractions"), this.#patchMap),
        element("div", { class: "panel" }, element("h3", {}, "Rolling radius difference"), radii),
        element("div", { class: "panel" }, element("h3", {}, "Equivalent conicity"), conicity)));
    this.#listen();
    this.#showNames();
  }

  set(state: RailState): void {
    this.state = state;
    this.#shape.set(state.shape);
    this.#form.set(state.values);
    this.#remarks.textContent = "";
    this.#showNames();
  }

  solve(): void {
    void this.#ask("fastsim2").then((drawn) => { if (drawn) void this.#ask("exact"); });
    clearTimeout(this.#later);
    this.#later = window.setTimeout(() => { void this.#askConicity(); }, 250);
  }

  exports(): Record<string, () => void> {
    const names = () => Object.values(this.state.profiles);
    return {
      "case as TOML": () => { save("wheel_on_rail.toml", railCase(this.state, "exact")); },
      "case as Python": () => { save("wheel_on_rail.py", railPython(this.state)); },
      profiles: () => { for (const name of names()) save(name, this.#files()[name] ?? ""); },
      "rolling radii as CSV": () => { save("rolling_radius_difference.csv", this.#radii.csv(), "text/csv"); },
      "picture as PNG": () => { this.section.toBlob((blob) => { if (blob) save("wheel_on_rail.png", blob); }); },
    };
  }

  #files(): Record<string, string> {
    return { ...BUILT_IN_PROFILES, ...this.state.files };
  }

  #controls(): HTMLElement[] {
    const made = (group: keyof typeof groups) => groups[group].map((spec) =>
      this.#form.add(spec, this.state.values[spec.key]!, (value) => { this.#change(spec.key, value); }).root);
    const group = (name: keyof typeof groups | "Profiles", ...content: Node[]) => element("fieldset", {}, element("legend", {}, name), ...content);
    const choose = (role: "rail" | "wheel") => {
      const input = element("input", { type: "file", id: `file-${role}` });
      input.addEventListener("change", () => { const [file] = input.files ?? []; if (file) void this.take(file, role); });
      return element("div", { class: "field" }, element("label", { for: `file-${role}` }, `${role} profile from a file`), input);
    };
    return [
      group("Wheelset", ...made("Wheelset"), this.#shape.root),
      group("Profiles", this.#names, this.#remarks, choose("rail"), choose("wheel"),
        element("p", { class: "hint" }, "Simpack, MiniProf or two columns; files may also be dropped on the picture. They stay on this machine."),
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

  #listen(): void {
    const { section } = this;
    section.addEventListener("pointerdown", (event) => {
      section.setPointerCapture(event.pointerId);
      const { values } = this.state;
      this.#grabbed = { x: event.clientX, y: event.clientY, lateral: values["wheel.lateral"]!, yaw: values["wheel.yaw"]! };
    });
    section.addEventListener("pointermove", (event) => {
      if (!this.#grabbed) return;
      const { x, y, lateral, yaw } = this.#grabbed;
      const across = event.clientX - x, up = y - event.clientY, turns = event.shiftKey || Math.abs(up) > 2 * Math.abs(across);
      // The picture's left is the track's left: a drag to the left moves the wheel to positive y, by a tenth of the distance.
      if (turns) this.#change("wheel.yaw", yaw + 5e-5 * (event.shiftKey ? -across : up));
      else this.#change("wheel.lateral", lateral - 2e-5 * across);
    });
    for (const end of ["pointerup", "pointercancel"]) section.addEventListener(end, () => { this.#grabbed = undefined; });
    section.addEventListener("keydown", (event) => {
      const by = { ArrowLeft: ["wheel.lateral", 5e-5], ArrowRight: ["wheel.lateral", -5e-5], ArrowUp: ["wheel.yaw", 1e-4], ArrowDown: ["wheel.yaw", -1e-4] }[event.key] as [string, number] | undefined;
      if (!by) return;
      event.preventDefault();
      this.#change(by[0], this.state.values[by[0]]! + by[1] * (event.shiftKey ? 10 : 1));
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
    this.state.values[key] = value;
    this.#form.fields.find(({ spec }) => spec.key === key)?.set(value);
    this.solve();
    this.changed();
  }

  /** A profile that a person gives; the core says what it is, or why it is none. */
  async take(file: File, role?: "rail" | "wheel"): Promise<void> {
    if (file.size > largestFile) {
      this.#form.message.textContent = `${file.name} has ${digits(file.size / 1e6)} MB; profiles up to ${digits(largestFile / 1e6)} MB are read`;
      return;
    }
    const bytes = new Uint8Array(await file.arrayBuffer());
    let text: string;
    try { text = new TextDecoder("utf-8", { fatal: true }).decode(bytes); } catch { text = new TextDecoder("latin1").decode(bytes); }
    const name = file.name.replaceAll(/[\\/"]/g, "_");
    const reply = await this.core.ask<ProfileResult>(`profile ${name}`, { call: "profile", name, text, ...(role ? { role } : {}) });
    if (!reply) return;
    if (reply.error) { this.#form.message.textContent = reply.error.message; return; }
    const found = role ?? reply.result?.role;
    if (found !== "rail" && found !== "wheel") {
      this.#form.message.textContent = `${name} does not say whether it is a rail or a wheel: choose it under its own name at the left`;
      return;
    }
    if (this.state.profiles[found === "rail" ? "wheel" : "rail"] === name && this.#files()[name] !== text) {
      this.#form.message.textContent = `rail and wheel are both called ${name}: give one of the files another name`;
      return;
    }
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
    this.#more.textContent = moreInWords(more);
  }

  async #ask(level: Level): Promise<boolean> {
    const reply = await this.core.ask<WheelResult>(`rail ${level}`, {
      call: "solve", case: railCase(this.state, level), files: this.#files(), fields: true, extent: level === "exact" ? "solution" : "full",
    });
    if (!reply) return false;
    if (this.#form.refuse(reply.error?.message ?? "")) return false;
    const found = reply.result!;
    this.#solved[level] = { ...found, outlines: found.outlines ?? this.#solved.fastsim2?.outlines };
    if (level === "fastsim2") delete this.#solved.exact;
    this.#time.textContent = `${level === "exact" ? "exact" : "FASTSIM2"}: ${digits(1e3 * (reply.time ?? 0))} ms`;
    this.draw();
    return true;
  }

  async #askConicity(): Promise<void> {
    const asked = runningCase(this.state);
    const of = asked + JSON.stringify(this.state.files);
    if (of !== this.#runningOf) {
      const reply = await this.core.ask<Conicity>("conicity", { call: "conicity", case: asked, files: this.#files() });
      if (!reply) return;
      this.#running = reply.result;
      this.#noRunning = reply.error ? sentence(withoutPlace(reply.error.message)) : "";
      this.#runningOf = of;
    }
    this.#drawRunning();
  }

  #drawRunning(): void {
    if (!this.#running) {
      this.#radii.refuse(this.#noRunning);
      this.#conicity.refuse(this.#noRunning);
      return;
    }
    const over = this.#running.over_lateral_displacement, present = 1e3 * this.state.values["wheel.lateral"]!;
    this.#radii.draw({
      x: over.map(({ lateral }) => lateral * 1e3), xLabel: "lateral position [mm]", yLabel: "rL − rR [mm]", present,
      curves: [{ name: "radius difference", colour: colours.exact, values: over.map((at) => at.rolling_radius_difference * 1e3) }],
    });
    const conicity = this.#running.equivalent_conicity;
    this.#conicity.draw({
      x: conicity.map(([amplitude]) => amplitude * 1e3), xLabel: "amplitude [mm]", yLabel: "conicity", present: Math.abs(present),
      curves: [{ name: "conicity", colour: colours.fastsim2, values: conicity.map(([, value]) => value) }],
    });
  }

  draw(): void {
    const solved = this.#solved.exact ?? this.#solved.fastsim2, outlines = this.#solved.fastsim2?.outlines;
    if (!solved || !outlines) return;
    const patches = patchesOf(solved);
    this.#drawSection(outlines, patches);
    this.#head.show(outlines.rail, patches);
    this.#drawPatch(patches);
    this.#showNumbers();
    fillRemarks(this.#warnings, remarksOn(solved));
    this.#drawRunning();
  }

  /** Looking along the track: the track's left at the left, so y grows to the left. */
  #drawSection({ rail, wheel }: { rail: Outline; wheel: Outline }, patches: Patch[]): void {
    const context = fitToScreen(this.section), pixel = devicePixelRatio, { width, height } = context.canvas;
    const middle = (Math.min(...rail.y) + Math.max(...rail.y)) / 2, scale = Math.min(width / 0.15, height / 0.075);
    const at = (y: number, z: number): [number, number] => [width / 2 - (y - middle) * scale, height * 0.52 - (z - 0.004) * scale];
    const ink = getComputedStyle(document.body).getPropertyValue("--ink").trim();
    const line = ({ y, z }: Outline, colour: string) => {
      context.beginPath();
      y.forEach((value, i) => { context.lineTo(...at(value, z[i]!)); });
      context.strokeStyle = colour;
      context.lineWidth = 2 * pixel;
      context.stroke();
    };
    line(rail, colours.exact);
    line(wheel, colours.fastsim2);
    context.font = `${12 * pixel}px system-ui, sans-serif`;
    context.fillStyle = ink;
    context.fillText("field side", 8 * pixel, 16 * pixel);
    context.textAlign = "right";
    context.fillText("centre of the track", width - 8 * pixel, 16 * pixel);
    context.textAlign = "left";
    for (const { normal_force, place_y, place_z, angle } of patches) {
      const [px, py] = at(place_y, place_z), length = (0.012 * normal_force * scale) / 80e3 + 8 * pixel;
      context.beginPath();
      context.arc(px, py, 4 * pixel, 0, 2 * Math.PI);
      context.fillStyle = colours.accent;
      context.fill();
      context.beginPath();
      context.moveTo(px, py);
      context.lineTo(px + Math.sin(angle) * length, py - Math.cos(angle) * length);
      context.strokeStyle = colours.accent;
      context.lineWidth = 3 * pixel;
      context.stroke();
      context.fillStyle = ink;
      context.fillText(`${digits(normal_force / 1e3)} kN`, px + Math.sin(angle) * length + 6 * pixel, py - Math.cos(angle) * length);
    }
    const where = patches.map((patch) => `${digits(patch.rail_y * 1e3)} mm`).join(" and ");
    this.section.setAttribute("aria-label", `Wheel and rail seen along the track; contact on the rail at y = ${where || "no place"}`);
  }

  #drawPatch(patches: Patch[]): void {
    const [largest] = [...patches].filter(({ fields }) => fields).sort((one, other) => other.normal_force - one.normal_force);
    const f = largest?.fields;
    if (!f) { clearMap(this.#patchMap, "no patch"); return; }
    const size = Math.max(...f.px.map((px, k) => Math.hypot(px, f.py[k]!)), 1e-30);
    const height = rowHeight(f.y);
    drawMap(this.#patchMap, {
      cells: { ...f, height }, parts: cellsUpToTheEdge(f, height), colour: { values: f.pressure, unit: "MPa", scale: 1e-6, signed: false },
      arrows: { x: f.px, y: f.py, longest: size },
    });
    this.#patchMap.setAttribute("aria-label", `largest patch, peak pressure ${digits(largest.peak_pressure / 1e6)} MPa`);
  }

  #showNumbers(): void {
    const columns = [this.#solved.exact, this.#solved.fastsim2];
    const row = (label: string, name: string, shown?: string) => {
      const { unit: si, text } = output("wheel", name), unit = shown ?? shownUnit(si);
      return { name: label, unit, what: text, values: columns.map((of) => (of ? show(Number(of.wheel[name]?.[0]), si, unit) : "…")) };
    };
    fillTable(this.#numbers, ["exact", "FASTSIM2"], [
      row("longitudinal force", "force_x"), row("lateral force, to the left", "force_y"), row("vertical force", "force_z"), row("T-gamma", "t_gamma", "N"),
      row("Y/Q", "y_over_q"), row("Nadal's limit of Y/Q", "nadal_limit"), row("frictional power", "frictional_power"), row("patches", "patch_count"),
    ]);
    const shown = columns[0] ?? columns[1];
    if (shown) this.#spoken.textContent = `lateral force ${digits(Number(shown.wheel.force_y?.[0]) / 1e3)} kN, ${String(shown.wheel.patch_count?.[0])} patches`;
  }
}

/** Warnings of a result, its status unless it is ok, and why. */
function remarksOn({ warnings, status, reason }: WheelResult): string[] {
  return [...(status === "ok" ? [] : [statusInWords(status, reason)]), ...warnings].map(sentence);
}

function patchesOf(solved: WheelResult): Patch[] {
  const { patches = {}, fields } = solved;
  return (patches.normal_force ?? []).map((normal_force, i) => ({
    normal_force, place_x: patches.place_x![i]!, place_y: patches.place_y![i]!, place_z: patches.place_z![i]!, angle: patches.angle![i]!,
    rail_y: patches.rail_y![i]!, peak_pressure: patches.peak_pressure![i]!, fields: fields?.[i],
  }));
}
