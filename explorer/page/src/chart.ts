// Curves, by uPlot.

import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { axisRange } from "./axis_range.ts";
import { dot, label } from "./canvas.ts";
import { token } from "./colours.ts";
import { element } from "./elements.ts";

/** `colour`: a variable of the style sheet. `isNamed`: in the legend. */
export interface Curve { name: string; colour: string; values: (number | null)[]; dash?: number[]; points?: boolean; isNamed?: boolean }
/** A part of the x-axis with a colour of its own, behind the curves. */
export interface Band { from: number; to: number; colour: string }
/** Points that are no curve, at places of their own. */
export interface Scatter { name: string; colour: string; x: number[]; y: number[] }
export interface ChartContent { x: number[]; xLabel: string; yLabel: string; curves: Curve[]; present?: number; bands?: Band[]; scatter?: Scatter[]; drag?: (x: number) => void }

/** Curves and points on the places of all of them. */
function alignedData({ x, curves, scatter }: ChartContent): uPlot.AlignedData {
  if (!scatter?.length) return [x, ...curves.map(({ values }) => values)];
  const rows = [...x.map((at, k) => ({ at, values: [...curves.map(({ values }) => values[k] ?? null), ...scatter.map(() => null)] })),
    ...scatter.flatMap((of, s) => of.x.map((at, k) => ({ at, values: [...curves.map(() => null), ...scatter.map((_, other) => (other === s ? of.y[k]! : null))] })))];
  rows.sort((one, other) => one.at - other.at);
  return [rows.map(({ at }) => at), ...[...curves, ...scatter].map((_, i) => rows.map(({ values }) => values[i] ?? null))];
}

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
    new MutationObserver(() => { this.#recolour(); }).observe(document.documentElement, { attributeFilter: ["data-theme"] });
  }

  get content(): ChartContent | undefined { return this.#content; }

  /** The remark stands below the curves: what of them is not there. */
  draw(content: ChartContent, remark = ""): void {
    this.#content = content;
    this.#remark.textContent = remark;
    const data = alignedData(content);
    const drawn = JSON.stringify([content.xLabel, content.yLabel, [...content.curves, ...(content.scatter ?? [])].map(({ name, colour }) => [name, token(colour)])]);
    if (this.#plot && drawn === this.#drawn) this.#plot.setData(data);
    else this.#make(content, data);
    this.#drawn = drawn;
  }

  /** In the colours of another theme. */
  #recolour(): void {
    if (this.#content) this.draw(this.#content, this.#remark.textContent);
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
    const faint = token("--line"), values = (_: uPlot, splits: number[]) => splits.map(label), named = content.curves.filter(({ isNamed }) => isNamed ?? true).length + (content.scatter?.length ?? 0);
    const axis = { values, stroke: token("--ink2"), font: "11px system-ui, sans-serif", labelFont: "12px system-ui, sans-serif", grid: { stroke: faint, width: 1 }, ticks: { stroke: faint, width: 1 } };
    this.#plot = new uPlot({
      width: Math.max(this.root.clientWidth, 200),
      height: this.height,
      scales: { x: { time: false }, y: { range: (_, low, high) => axisRange(low, high) } },
      legend: { live: false, show: named > 1, markers: { dash: (plot, i) => (plot.series[i]!.dash ? "dashed" : "solid") } },
      cursor: { show: false },
      series: [
        { label: content.xLabel },
        ...content.curves.map(({ name, colour, dash, points, isNamed }) => ({
          label: name, stroke: token(colour), width: 2.2, ...(dash ? { dash } : {}), points: { show: points ?? false }, spanGaps: content.scatter !== undefined, ...(isNamed === false ? { class: "unnamed" } : {}),
        })),
        ...(content.scatter ?? []).map(({ name, colour }) => ({ label: name, stroke: token(colour), width: 0, paths: () => null, points: { show: true, size: 7, width: 1.4, fill: token("--panel") } })),
      ],
      axes: [{ ...axis, label: content.xLabel, size: 30, labelSize: 18 }, { ...axis, label: content.yLabel, size: 46, labelSize: 18 }],
      hooks: { drawClear: [(plot) => { this.#fillBands(plot); }], draw: [(plot) => { this.#markPresent(plot); }] },
    }, data, (plot, show) => { this.root.prepend(plot.root); show(); });
    if (content.drag) this.#listen(this.#plot);
  }

  /** The present point follows the hand. */
  #listen(plot: uPlot): void {
    const { over } = plot, move = (event: PointerEvent) => {
      const x = plot.posToVal(event.clientX - over.getBoundingClientRect().left, "x"), xs = this.#content!.x;
      this.#content?.drag?.(Math.min(Math.max(x, xs[0]!), xs.at(-1)!));
    };
    over.style.cursor = "ew-resize";
    over.style.touchAction = "pan-y";
    over.addEventListener("pointerdown", (event) => { over.setPointerCapture(event.pointerId); move(event); });
    over.addEventListener("pointermove", (event) => { if (event.buttons) move(event); });
  }

  #fillBands(plot: uPlot): void {
    const { top, height } = plot.bbox;
    plot.ctx.save();
    for (const { from, to, colour } of this.#content?.bands ?? []) {
      const [left, right] = [plot.valToPos(from, "x", true), plot.valToPos(to, "x", true)];
      plot.ctx.fillStyle = token(colour);
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
    plot.ctx.strokeStyle = token("--ui");
    plot.ctx.lineWidth = 1.5 * devicePixelRatio;
    plot.ctx.setLineDash([4, 4]);
    plot.ctx.beginPath();
    plot.ctx.moveTo(x, top);
    plot.ctx.lineTo(x, top + height);
    plot.ctx.stroke();
    plot.ctx.setLineDash([]);
    this.#markPoint(plot, present, x);
    plot.ctx.restore();
  }

  /** The present point of the first curve, with its value. */
  #markPoint(plot: uPlot, present: number, x: number): void {
    const { x: xs, curves } = this.#content!, values = curves[0]?.values ?? [], i = xs.findIndex((at) => at >= present), { left, width } = plot.bbox;
    const [low, high] = [values[i - 1], values[i]];
    if (typeof low !== "number" || typeof high !== "number") return;
    const value = low + ((present - xs[i - 1]!) / (xs[i]! - xs[i - 1]!)) * (high - low), y = plot.valToPos(value, "y", true), { ctx } = plot;
    dot(ctx, [x, y], 5 * devicePixelRatio, "--ui", 2.4 * devicePixelRatio);
    ctx.font = `650 ${String(12 * devicePixelRatio)}px system-ui, sans-serif`;
    ctx.textAlign = x > left + 0.6 * width ? "right" : "left";
    ctx.fillStyle = token("--ink");
    ctx.strokeStyle = token("--panel");
    ctx.lineWidth = 4 * devicePixelRatio;
    const words = `now: ${String(Number(value.toPrecision(3))).replace("-", "−")}`, beside = x + (ctx.textAlign === "right" ? -10 : 10) * devicePixelRatio;
    ctx.strokeText(words, beside, y - 9 * devicePixelRatio);
    ctx.fillText(words, beside, y - 9 * devicePixelRatio);
  }

  /** What is drawn, as comma-separated columns. */
  csv(): string {
    if (!this.#content) return "";
    const { x, xLabel, yLabel, curves } = this.#content;
    const head = [xLabel, ...curves.map(({ name }) => `${name}: ${yLabel}`)].map((name) => `"${name}"`).join(",");
    return [head, ...x.map((at, i) => [at, ...curves.map(({ values }) => values[i] ?? "")].join(","))].join("\n") + "\n";
  }

  canvas(): HTMLCanvasElement | null { return this.root.querySelector("canvas"); }
}
