// The page in Firefox beside the page in Chromium: the same steps through views, examples and controls, the same numbers.
//   FIREFOX the browser, and what browser.ts names

import assert from "node:assert/strict";
import { existsSync, mkdirSync } from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { setTimeout as after } from "node:timers/promises";
import puppeteer from "puppeteer-core";
import { layOut } from "../src/rail_picture.ts";
import { address, browser, near, scratch, settled, solvedByProgram } from "./browser.ts";

const { FIREFOX: executablePath = "/usr/bin/firefox-esr" } = process.env;
const size = { width: 1400, height: 900 };

/** What pages of Playwright and of Puppeteer have in common. */
interface Driven {
  goto: (url: string) => Promise<unknown>;
  click: (selector: string) => Promise<void>;
  focus: (selector: string) => Promise<void>;
  evaluate: <Given, Found>(run: (given: Given) => Found | Promise<Found>, given: Given) => Promise<Found>;
  keyboard: { press: (key: "ArrowUp" | "Enter") => Promise<void>; type: (text: string) => Promise<void> };
  mouse: { move: (x: number, y: number) => Promise<void>; down: () => Promise<void>; up: () => Promise<void> };
}

const tab = (place: number) => (page: Driven) => page.click(`nav [role=tab]:nth-child(${String(place)})`);
const preset = (place: number) => (page: Driven) => page.click(`section:not([hidden]) .presets button:nth-child(${String(place)})`);
const typed = (field: string, text: string) => async (page: Driven) => {
  await page.evaluate((selector) => { document.querySelector<HTMLInputElement>(selector)!.select(); }, field);
  await page.keyboard.type(text);
  await page.keyboard.press("Enter");
};
const stepped = (field: string) => async (page: Driven) => {
  await page.focus(field);
  await page.keyboard.press("ArrowUp");
};
const chosen = (list: string, value: string) => (page: Driven) => page.evaluate(([selector, word]) => {
  const select = document.querySelector<HTMLSelectElement>(selector!)!;
  select.value = word!;
  select.dispatchEvent(new Event("change"));
}, [list, value]);

const steps: readonly (readonly [name: string, run: (page: Driven) => Promise<unknown>])[] = [
  ["Contact", tab(2)], ["Start and stop", tab(3)], ["Nip", tab(4)], ["Wheel on rail", tab(1)],
  ["another position", stepped("#rail-wheel-lateral")], ["another shape", chosen("#choice-shape-of-the-patch", "curved")],
  ["Flange contact", preset(2)], ["Traction on a wet rail", preset(3)], ["another load", typed("#contact-load-normal_force", "12 kip")], ["another law", chosen("#choice-friction-law", "linear")],
  ["Rubber roller", preset(4)], ["Ball in a groove", preset(5)], ["Measured profile", preset(6)], ["Tread contact", preset(1)],
];

/** Key numbers, fields and refusals that are shown, and pictures that have next to nothing on them. */
function shown(): { numbers: string[]; empty: string[] } {
  const section = document.querySelector("section:not([hidden])")!, texts = (selector: string) => [...section.querySelectorAll(selector)].map(({ textContent }) => textContent ?? "");
  const fields = [...section.querySelectorAll<HTMLInputElement>(".field input[type=text]")].map(({ id, value }) => `${id} ${value}`);
  const isEmpty = (canvas: HTMLCanvasElement) => {
    const { data } = canvas.getContext("2d")!.getImageData(0, 0, canvas.width, canvas.height);
    return new Set(new Uint32Array(data.buffer)).size < 10;
  };
  const seen = [...section.querySelectorAll<HTMLCanvasElement>("canvas")].filter(({ offsetParent }) => offsetParent);
  return { numbers: [...texts("h2, .keys .value, .keys .note, .message"), ...fields], empty: [...seen.filter(isEmpty).map(({ ariaLabel }) => ariaLabel ?? "a chart"), ...(seen.length ? [] : ["no picture"])] };
}

async function found(page: Driven): Promise<Map<string, string[]>> {
  const all = new Map<string, string[]>();
  await page.goto(address);
  for (const [name, run] of steps) {
    await run(page);
    await settled(page);
    const { numbers, empty } = await page.evaluate(shown, undefined);
    assert.deepEqual(empty, [], name);
    all.set(name, numbers);
  }
  return all;
}

/** One pixel of the hand is one pixel of the wheel. */
async function dragsTheWheel(page: Driven): Promise<void> {
  const at = () => page.evaluate(() => {
    scrollTo(0, 0);
    const { x, y, width } = document.querySelector("section:not([hidden]) canvas.map")!.getBoundingClientRect();
    return { x, y, width, lateral: Number(document.querySelector<HTMLInputElement>("#rail-wheel-lateral")!.value) };
  }, undefined);
  const { x, y, width, lateral } = await at(), { scale } = layOut(width, { y: [0, 0.0735], z: [0, 0] });
  await page.mouse.move(x + 300, y + 150);
  await page.mouse.down();
  for (let i = 1; i <= 10; ++i) await page.mouse.move(x + 300 - i, y + 150);
  await page.mouse.up();
  await settled(page);
  const moved = (await at()).lateral - lateral;
  assert.ok(Math.abs(moved - 10e3 / scale) < 0.05, `${String(moved)} mm after 10 pixels`);
}

/** The case of a contact that Firefox saves has the force that the page shows. */
async function exportsItsCase(page: Driven, downloads: string): Promise<void> {
  await tab(2)(page);
  await settled(page);
  const fx = Number(await page.evaluate(() => document.querySelector("section:not([hidden]) .numbers tbody td")!.textContent, undefined)), file = path.join(downloads, "contact.toml");
  await page.click(".menu summary");
  await page.click(".menu button:nth-child(1)");
  for (let i = 0; i < 200 && (!existsSync(file) || existsSync(`${file}.part`)); ++i) await after(50);
  near(fx * 1e3, solvedByProgram(file).exact!.fx!);
}

test("in Firefox every view, example and control has the numbers of Chromium, pictures, and no error", async () => {
  const downloads = path.join(scratch, "downloads");
  mkdirSync(downloads);
  const firefox = await puppeteer.launch({
    browser: "firefox", executablePath, headless: true,
    extraPrefsFirefox: { "browser.download.folderList": 2, "browser.download.dir": downloads, "browser.download.always_ask_before_handling_new_types": false },
  });
  try {
    const page = await firefox.newPage(), errors: string[] = [];
    page.on("pageerror", (error) => errors.push(String(error)));
    page.on("console", (message) => { if (message.type() === "error") errors.push(message.text()); });
    await page.setViewport(size);
    const driven = page as unknown as Driven, inFirefox = await found(driven);
    await dragsTheWheel(driven);
    await exportsItsCase(driven, downloads);
    assert.deepEqual(errors, []);
    const other = await browser.newPage({ viewport: size }), inChromium = await found(other as unknown as Driven);
    for (const [name] of steps) assert.deepEqual(inFirefox.get(name), inChromium.get(name), name);
  } finally {
    await firefox.close();
  }
});
