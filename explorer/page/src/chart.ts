// Curves, by uPlot.

import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { element } from "./elements.ts";

export interface Curve { name: string; colour: string; values: (number | null)[]; dash?: number[]; points?: boolean }
/** A part of the x-axis with a colour of its own, behind the curves. */
export interface Band { from: number; to: number; colour: string }
export interface ChartContent { x: number[]; xLabel: string; yLabel: string; curves: Curve[]; present?: number; bands?: Band[] }

/** A chart that is redrawn in place while the names of its curves and axes stay. */
export class Chart {
  #plot: uPlot | undefined;
  #drawn = "";
  #content: ChartContent | undefined;
  readonly #remark = element("p", { class: "message", role: "status" });

  constructor(readonly root: HTMLElement, readonly height = 220) {
    root.append(this.#remark);
    new ResizeObserver(() => {
      if (this.#plot && this.root.clientWidth > 0) this.#plot.setSize({ width: this.root.clientWidth, height: this.height });
    }).observe(root);
  }

  get content(): ChartContent | undefined { return this.#content; }

  /** The remark stands below the curves: what of them is not there. */
  draw(content: ChartContent, remark = ""): void {
    this.#content = content;
    this.#remark.textContent = remark;
    const data = [content.x, ...content.curves.map((curve) => curve.values)] as uPlot.AlignedData;
    const drawn = JSON.stringify([content.xLabel, content.yLabel, content.curves.map(({ name, colour }) => [name, colour])]);
    if (this.#plot && drawn === this.#drawn) this.#plot.setData(data);
    else this.#make(content, data);
    this.#drawn = drawn;
  }

  /** No curves, and why there are none. */
  refuse(why: string): void {
    this.#plot?.destroy();
    this.#plot = undefined;
    this.#content = undefined;
    this.#remark.textContent = why;
  }

  #make(content: ChartContent, data: uPlot.AlignedData): void {
    this.#plot?.destroy();
    const ink = getComputedStyle(document.body).getPropertyValue("--ink").trim();
    const faint = getComputedStyle(document.body).getPropertyValue("--faint").trim();
    const axis = { stroke: ink, grid: { stroke: faint, width: 1 }, ticks: { stroke: faint, width: 1 } };
    this.#plot = new uPlot({
      width: Math.max(this.root.clientWidth, 200),
      height: this.height,
      scales: { x: { time: false } },
      legend: { live: false },
      series: [
        { label: content.xLabel },
        ...content.curves.map(({ name, colour, dash, points }) => ({
          label: name, stroke: colour, width: 2, ...(dash ? { dash } : {}), points: { show: points ?? false },
        })),
      ],
      axes: [{ ...axis, label: content.xLabel, size: 44, labelSize: 18 }, { ...axis, label: content.yLabel, size: 60, labelSize: 18 }],
      hooks: { drawClear: [(plot) => { this.#fillBands(plot); }], draw: [(plot) => { this.#markPresent(plot); }] },
    }, data, (plot, show) => { this.root.prepend(plot.root); show(); });
  }

  #fillBands(plot: uPlot): void {
    const { top, height } = plot.bbox;
    plot.ctx.save();
    plot.ctx.globalAlpha = 0.4;
    for (const { from, to, colour } of this.#content?.bands ?? []) {
      const [left, right] = [plot.valToPos(from, "x", true), plot.valToPos(to, "x", true)];
      plot.ctx.fillStyle = colour;
      plot.ctx.fillRect(left, top, right - left, height);
    }
    plot.ctx.restore();
  }

  #markPresent(plot: uPlot): void {
    const present = this.#content?.present;
    if (present === undefined) return;
    const { left, top, height, width } = plot.bbox, x = plot.valToPos(present, "x", true);
    if (x < left || x > left + width) return;
    plot.ctx.save();
    plot.ctx.strokeStyle = getComputedStyle(document.body).getPropertyValue("--ink").trim();
    plot.ctx.setLineDash([3, 4]);
    plot.ctx.beginPath();
    plot.ctx.moveTo(x, top);
    plot.ctx.lineTo(x, top + height);
    plot.ctx.stroke();
    plot.ctx.restore();
  }

  /** What is drawn, as comma-separated columns. */
  csv(): string {
    if (!this.#content) return "";
    const { x, xLabel, curves } = this.#content;
    const head = [xLabel, ...curves.map(({ name }) => name)].map((name) => `"${name}"`).join(",");
    return [head, ...x.map((at, i) => [at, ...curves.map(({ values }) => values[i] ?? "")].join(","))].join("\n") + "\n";
  }

  canvas(): HTMLCanvasElement | null { return this.root.querySelector("canvas"); }
}
