// Pictures of every view beside those of tests/screens, which TAKE names a folder to take anew into.
//   TAKE where to leave new ones, instead of comparing; SCREENS folder of the stored ones; and what browser.ts names

import assert from "node:assert/strict";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { PNG } from "pngjs";
import { browser, opened, settled } from "./browser.ts";
import { block, otherBlocks, shareOfOtherPoints, type Box } from "./screens.ts";
import type { Page } from "playwright-core";

const { TAKE: taken, SCREENS: stored = "" } = process.env;
const views = ["Wheel on rail", "Contact", "Start and stop", "Nip"], sizes = [[1400, "light"], [400, "dark"]] as const;

/** What pictures were taken with, and where their canvases are. */
interface Taken { chromium: string; font: number[]; canvases: Record<string, Box[]> }

const mostPoints = 0.0005, mostBlocks = 0.02; // that may differ

const fileOf = (view: string, width: number) => `${view.toLowerCase().replaceAll(" ", "_")}_${String(width)}.png`;

/** Widths of a text in the page's fonts, which tell fonts apart [px]. */
async function fontOf(page: Page): Promise<number[]> {
  return page.evaluate(() => {
    const context = document.createElement("canvas").getContext("2d")!;
    return ["13px", "650 13px", "650 22px"].map((font) => {
      context.font = `${font} system-ui, sans-serif`;
      return context.measureText("Where wheel and rail touch, 0123456789 µ → ▾").width;
    });
  });
}

async function canvasesOf(page: Page): Promise<Box[]> {
  return page.evaluate(() => [...document.querySelectorAll<HTMLCanvasElement>("section:not([hidden]) canvas")].filter(({ offsetParent }) => offsetParent).map((canvas) => {
    const { left, top, width, height } = canvas.getBoundingClientRect();
    return { left: Math.round(left + scrollX), top: Math.round(top + scrollY), width: Math.round(width), height: Math.round(height) };
  }));
}

/** A file of half the size, whose colours are rounded by less than a comparison notices. */
function small(picture: PNG): Buffer {
  const step = 8;
  for (let i = 0; i < picture.data.length; ++i) if (i % 4 !== 3) picture.data[i] = Math.min(255, Math.round(picture.data[i]! / step) * step);
  return PNG.sync.write(picture, { colorType: 2, deflateLevel: 9, deflateStrategy: 0, filterType: 0 });
}

/** The views in all sizes, with times left out. */
async function take(each: (file: string, picture: Buffer, canvases: Box[]) => void): Promise<Pick<Taken, "chromium" | "font">> {
  let font: number[] = [];
  for (const [width, scheme] of sizes) {
    const { page, errors } = await opened("#", { width, height: 900 }, undefined, scheme, "reduce");
    for (const view of views) {
      await page.getByRole("tab", { name: view }).click();
      await settled(page);
      await page.mouse.move(0, 0);
      const picture = await page.screenshot({ fullPage: true, style: ".time { visibility: hidden; }" });
      each(fileOf(view, width), picture, await canvasesOf(page));
    }
    font = await fontOf(page);
    assert.deepEqual(errors, []);
    await page.close();
  }
  return { chromium: browser.version().split(".")[0]!, font };
}

if (taken)
  test("the pictures of all views are taken anew", async () => {
    const canvases: Taken["canvases"] = {};
    mkdirSync(taken, { recursive: true });
    const by = await take((file, picture, boxes) => {
      writeFileSync(path.join(taken, file), small(PNG.sync.read(picture)));
      canvases[file] = boxes;
    });
    writeFileSync(path.join(taken, "taken.json"), `${JSON.stringify({ ...by, canvases } satisfies Taken, null, 1)}\n`);
  });
else {
  const before = JSON.parse(readFileSync(path.join(stored, "taken.json"), "utf8")) as Taken;
  const read = (file: string) => PNG.sync.read(readFileSync(path.join(stored, file)));

  test("every view looks as in its stored picture", async () => {
    const now = new Map<string, { picture: PNG; boxes: Box[] }>();
    const { chromium, font } = await take((file, picture, boxes) => now.set(file, { picture: PNG.sync.read(picture), boxes }));
    const isSame = chromium === before.chromium && font.every((width, k) => Math.abs(width - before.font[k]!) < 0.01);
    if (!isSame) console.log(`taken with Chromium ${before.chromium} and fonts of widths ${before.font.join(", ")}; here are Chromium ${chromium} and ${font.join(", ")}: canvases are compared by the colours of blocks`);
    for (const [file, { picture, boxes }] of now) {
      const old = read(file), differ = isSame ? shareOfOtherPoints(old, picture) : otherBlocks(old, before.canvases[file]!, picture, boxes);
      console.log(`${file}: ${(100 * differ).toFixed(3)} % of ${isSame ? "points" : "blocks"} differ`);
      assert.ok(differ <= (isSame ? mostPoints : mostBlocks), `${file}: ${(100 * differ).toFixed(2)} % differ; TAKE=folder leaves what is seen now`);
    }
  });

  test("a picture that is missing and a colour that is another one are noticed, by points and by blocks; other letters are not, by blocks", () => {
    for (const view of views)
      for (const [width] of sizes) {
        const file = fileOf(view, width), old = read(file), boxes = before.canvases[file]!, [main] = [...boxes].sort((one, other) => other.width * other.height - one.width * one.height);
        const ground = [...old.data.subarray(4 * (main!.top * old.width + main!.left), 4 * (main!.top * old.width + main!.left) + 3)];
        const changed = (change: (rgb: number[], x: number, y: number) => number[]) => {
          const made = new PNG({ width: old.width, height: old.height });
          old.data.copy(made.data);
          for (let y = main!.top; y < main!.top + main!.height; ++y)
            for (let x = main!.left; x < main!.left + main!.width; ++x) {
              const at = 4 * (y * old.width + x);
              made.data.set(change([...made.data.subarray(at, at + 3)], x, y), at);
            }
          return made;
        };
        const isColoured = (rgb: number[]) => Math.max(...rgb) - Math.min(...rgb) > 22;
        for (const [what, made] of [["no picture", changed(() => ground)], ["another colour", changed((rgb) => (isColoured(rgb) ? [rgb[1]!, rgb[2]!, rgb[0]!] : rgb))]] as const) {
          assert.ok(shareOfOtherPoints(old, made) > mostPoints, `${file}: ${what}`);
          assert.ok(otherBlocks(old, boxes, made, boxes) > mostBlocks, `${file}: ${what}`);
        }
        const noise = changed((rgb, x, y) => (x % block === 0 && y % 3 === 0 ? rgb.map((value) => 255 - value) : rgb));
        assert.ok(otherBlocks(old, boxes, noise, boxes) <= mostBlocks, file);
      }
  });
}
