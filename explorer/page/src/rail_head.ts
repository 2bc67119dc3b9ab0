// Patches on the rail head in three dimensions; in two where the browser has no WebGL.

import * as three from "three";
import { fitToScreen } from "./canvas.ts";
import { css, of, ramps } from "./colours.ts";
import { element } from "./elements.ts";
import type { Outline, Patch } from "./rail_picture.ts";
import { quantities } from "./sheet.ts";

interface Cell { corners: [number, number, number][]; pressure: number }

const length = 0.06; // of the rail that is shown [m]

const pressureAt = quantities.indexOf("pressure");

/** Pieces of all patches in track axes, raised a little from the rail. */
function cellsOf(patches: Patch[]): Cell[] {
  return patches.flatMap(({ sheets, place_x, place_y, place_z, angle }) => {
    const [cos, sin] = [Math.cos(angle), Math.sin(angle)], raised = 2e-4;
    const at = (x: number, y: number): [number, number, number] => [place_x + x, place_y + y * cos - raised * sin, place_z + y * sin + raised * cos];
    return sheets.flatMap(({ chords, places }) => chords.slice(1).flatMap((upper, j) => Array.from({ length: places }, (_, i): Cell => {
      const corner = ({ left, right, y }: typeof upper, k: number) => at(left + ((right - left) * k) / places, y), lower = chords[j]!;
      return { pressure: lower.values[pressureAt]![i]!, corners: [corner(lower, i), corner(lower, i + 1), corner(upper, i + 1), corner(upper, i)] };
    })));
  });
}

function mesh(corners: [number, number, number][][], colour: (i: number) => three.Color): three.Mesh {
  const positions: number[] = [], shades: number[] = [];
  corners.forEach(([a, b, c, d], i) => {
    const { r, g, b: blue } = colour(i);
    for (const corner of [a!, b!, c!, a!, c!, d!]) {
      positions.push(...corner);
      shades.push(r, g, blue);
    }
  });
  const geometry = new three.BufferGeometry();
  geometry.setAttribute("position", new three.Float32BufferAttribute(positions, 3));
  geometry.setAttribute("color", new three.Float32BufferAttribute(shades, 3));
  geometry.computeVertexNormals();
  return new three.Mesh(geometry, new three.MeshLambertMaterial({ vertexColors: true, side: three.DoubleSide }));
}

export class RailHead {
  readonly #canvas = element("canvas", { class: "map", role: "img", "aria-label": "Pressure on the rail head; drag to turn", tabindex: "0" });
  #renderer: three.WebGLRenderer | undefined;
  readonly #scene = new three.Scene();
  readonly #camera = new three.PerspectiveCamera(32, 1, 0.005, 2);
  readonly #shown = new three.Group();
  #centre = new three.Vector3();
  #around = 0.7;
  #above = 0.75;

  constructor(readonly root: HTMLElement) {
    root.append(this.#canvas);
    try {
      this.#renderer = new three.WebGLRenderer({ canvas: this.#canvas, antialias: true, alpha: true, preserveDrawingBuffer: true });
    } catch {
      root.append(element("p", { class: "hint" }, "This browser has no WebGL: the rail head is shown from above."));
      const flat = element("canvas", { class: "map", role: "img", "aria-label": "Pressure on the rail head from above" });
      this.#canvas.replaceWith(flat);
      this.#canvas = flat;
      return;
    }
    const light = new three.DirectionalLight(0xffffff, 1.6);
    light.position.set(0.3, 0.2, 1);
    this.#scene.add(new three.AmbientLight(0xffffff, 1.6), light, this.#shown);
    this.#camera.up.set(0, 0, 1);
    this.#listen();
  }

  show(rail: Outline, patches: Patch[]): void {
    const cells = cellsOf(patches), largest = Math.max(...cells.map(({ pressure }) => pressure), 1);
    if (!this.#renderer) { this.#showFlat(cells, largest); return; }
    for (const child of [...this.#shown.children]) if (child instanceof three.Mesh) (child.geometry as three.BufferGeometry).dispose();
    this.#shown.clear();
    const every = Math.max(1, Math.floor(rail.y.length / 240)), strip: [number, number, number][][] = [];
    for (let i = 0; i + every < rail.y.length; i += every) {
      const [y, z, toY, toZ] = [rail.y[i]!, rail.z[i]!, rail.y[i + every]!, rail.z[i + every]!];
      strip.push([[-length / 2, y, z], [length / 2, y, z], [length / 2, toY, toZ], [-length / 2, toY, toZ]]);
    }
    const steel = new three.Color("#9aa4ad");
    const colours = cells.map(({ pressure }) => new three.Color(css(of(ramps().sizes, pressure / largest))));
    this.#shown.add(mesh(strip, () => steel), mesh(cells.map(({ corners }) => corners), (i) => colours[i]!));
    const [first] = [...patches].sort((one, other) => other.normal_force - one.normal_force);
    if (first) this.#centre.set(0, (Math.min(...rail.y) + Math.max(...rail.y)) / 2, -0.006);
    this.#draw();
  }

  #draw(): void {
    if (!this.#renderer) return;
    const { clientWidth, clientHeight } = this.#canvas;
    if (clientWidth === 0) return;
    this.#renderer.setPixelRatio(devicePixelRatio);
    this.#renderer.setSize(clientWidth, clientHeight, false);
    this.#camera.aspect = clientWidth / clientHeight;
    this.#camera.updateProjectionMatrix();
    const distance = 0.17, flat = Math.cos(this.#above) * distance;
    this.#camera.position.set(this.#centre.x - flat * Math.sin(this.#around), this.#centre.y - flat * Math.cos(this.#around), this.#centre.z + distance * Math.sin(this.#above));
    this.#camera.lookAt(this.#centre);
    this.#renderer.render(this.#scene, this.#camera);
  }

  #turn(around: number, above: number): void {
    this.#around += around;
    this.#above = Math.min(Math.max(this.#above + above, 0.1), 1.5);
    this.#draw();
  }

  #listen(): void {
    this.#canvas.addEventListener("pointerdown", (event) => { this.#canvas.setPointerCapture(event.pointerId); });
    this.#canvas.addEventListener("pointermove", (event) => { if (event.buttons) this.#turn(event.movementX * 0.01, event.movementY * 0.01); });
    this.#canvas.addEventListener("keydown", (event) => {
      const by = { ArrowLeft: [0.1, 0], ArrowRight: [-0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] }[event.key];
      if (!by) return;
      event.preventDefault();
      this.#turn(by[0]!, by[1]!);
    });
    new ResizeObserver(() => { this.#draw(); }).observe(this.#canvas);
  }

  #showFlat(cells: Cell[], largest: number): void {
    const { context, width, height } = fitToScreen(this.#canvas);
    const y = cells.flatMap(({ corners }) => corners.map((corner) => corner[1])), middle = (Math.min(...y) + Math.max(...y)) / 2;
    const scale = Math.min(width / 0.08, height / 0.04);
    for (const { corners, pressure } of cells) {
      context.fillStyle = css(of(ramps().sizes, pressure / largest));
      context.beginPath();
      for (const [cx, cy] of corners) context.lineTo(width / 2 - (cy - middle) * scale, height / 2 - cx * scale);
      context.fill();
    }
  }
}
