// How the page looks and is used: what is there at first, keyboard and mouse, small screens, contrasts, the tour.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { copyFileSync, mkdirSync, readFileSync, statSync } from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";
import { test } from "node:test";
import { axisRange } from "../src/axis_range.ts";
import { layOut } from "../src/rail_picture.ts";
import type { Page } from "playwright-core";
import { program, scratch, browser, opened, row, field, railField, nipField, settled, has, hasNumber, saved, near, solvedByProgram, type Counting, countRequests, folder, profiles } from "./browser.ts";

/** Which points of the picture have the colour of a variable of the style sheet: ones and zeros. */
async function pointsOf(page: Page, colour: string): Promise<string> {
  return page.evaluate((name) => {
    const canvas = document.querySelector<HTMLCanvasElement>("section:not([hidden]) canvas.map")!, wanted = getComputedStyle(document.documentElement).getPropertyValue(name).trim();
    const { data } = canvas.getContext("2d")!.getImageData(0, 0, Math.max(canvas.width, 1), Math.max(canvas.height, 1)), of = [1, 3, 5].map((at) => parseInt(wanted.slice(at, at + 2), 16));
    let found = "";
    for (let i = 0; i < data.length; i += 4) found += of.every((value, k) => data[i + k] === value) ? "1" : "0";
    return found;
  }, colour);
}

test("controls, texts and bodies are there before the core has answered, at the place of its answer", async () => {
  const { page, errors } = await opened("#", undefined, "window.Worker = class { postMessage() {} terminate() {} };"); // it never does
  await page.getByText("wheelset stands 3.0 mm to the left").waitFor();
  const colours = ["--wheel", "--rail"], first = [await pointsOf(page, "--wheel"), await pointsOf(page, "--rail")];
  assert.equal(await page.locator("section:not([hidden]) .keys .note", { hasText: "computing" }).count(), 6);
  assert.ok(await page.locator("section:not([hidden]) .field").count() > 10);
  const { page: whole, errors: others } = await opened("#");
  await row(whole, "lateral force");
  for (const [i, colour] of colours.entries()) { // where no arrows and words of the result are
    const drawn = await pointsOf(whole, colour), all = [...drawn].filter((point) => point === "1").length, both = [...drawn].filter((point, k) => point === "1" && first[i]![k] === "1").length;
    assert.ok(all > 0.02 * drawn.length && both > 0.99 * all, `${colour}: ${both} of ${all} points were there before`);
  }
  assert.deepEqual([...errors, ...others], []);
  await page.close();
  await whole.close();
});

test("what the page loads before a table or a picture in three dimensions has less than 3 MB; without a core it says so", async () => {
  const files = ["index.html", "page.css", "page.js", "explorer_core.js"], sizes = files.map((name) => statSync(path.join(folder, name)).size);
  const { page, requests } = await opened("#");
  await row(page, "lateral force");
  assert.deepEqual(requests.filter((url) => url.startsWith("file:")).map((url) => path.basename(url.replace("#", ""))).sort(), [...files].sort());
  assert.ok(sizes.reduce((all, size) => all + size) < 3e6, `${sizes.join(" + ")} bytes`);
  await page.getByText("in three dimensions").click();
  await page.locator(".head canvas").waitFor();
  await page.close();
  const without = path.join(scratch, "without");
  mkdirSync(without);
  for (const name of files.slice(0, 3)) copyFileSync(path.join(folder, name), path.join(without, name));
  const alone = await browser.newPage();
  await alone.goto(`file://${without}/index.html`);
  await alone.getByText("explorer_core.js is missing beside this page").waitFor();
  await alone.close();
});

test("notices of all that the page has of others lie beside it, and it leads to them", async () => {
  const notices = readFileSync(path.join(folder, "licences.txt"), "utf8");
  const { dependencies } = JSON.parse(readFileSync(new URL("../package.json", import.meta.url), "utf8")) as { dependencies: Record<string, string> };
  for (const [name, version] of Object.entries(dependencies)) assert.ok(notices.includes(`\n${name} ${version}\n${"=".repeat(80)}\n\nThe MIT License`), name);
  for (const holder of ["Leon Sorokin", "three.js authors", "Niels Lohmann", "Mark Gillard", "The Emscripten Authors", "Rich Felker"]) assert.match(notices, new RegExp(`Copyright.*${holder}`), holder);
  assert.ok(notices.includes("Apache License"));
  const { page, errors } = await opened("#");
  await page.getByRole("link", { name: "Licences" }).click();
  await page.getByText("What is in this page, and under which licences").waitFor();
  assert.deepEqual(errors, []);
  await page.close();
});

test("a hidden page computes nothing, and what was asked meanwhile once it is seen again", async () => {
  const { page, errors } = await opened("", undefined, `${countRequests}
    window.hiddenNow = false;
    Object.defineProperty(document, "hidden", { get: () => window.hiddenNow });`);
  const first = (await row(page, "longitudinal force fx"))[0]!;
  await settled(page);
  const hide = (hidden: boolean) => page.evaluate((now) => {
    const counting = window as unknown as Counting;
    const asked = counting.asked.splice(0);
    counting.hiddenNow = now;
    document.dispatchEvent(new Event("visibilitychange"));
    return asked;
  }, hidden);
  assert.ok((await hide(true)).length > 0);
  for (const load of ["90", "100", "110"]) await field(page, "load.normal_force", load);
  await page.waitForTimeout(1500); // in which nothing must happen
  assert.deepEqual(await hide(false), []);
  await page.waitForFunction((old) => {
    const cells = document.querySelector("section:not([hidden]) .numbers tbody tr td");
    return cells && Number(cells.textContent) !== old;
  }, first);
  assert.deepEqual(errors, []);
  await page.close();
});

test("without vector instructions and without WebGL all is there", async () => {
  const { page, errors } = await opened("", undefined, `
    WebAssembly.validate = () => false;
    const get = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (kind, ...more) { return kind.startsWith("webgl") ? null : get.call(this, kind, ...more); };`);
  await page.getByText("no vector instructions").waitFor();
  await row(page, "longitudinal force fx");
  await page.getByRole("tab", { name: "Wheel on rail" }).click();
  await row(page, "lateral force");
  await page.getByText("in three dimensions").click();
  await page.getByText("no WebGL").waitFor();
  assert.deepEqual(errors, []);
  await page.close();
});

test("the wheel follows keys and the mouse; times are printed, not checked", async () => {
  const { page, errors } = await opened();
  await page.getByRole("tab", { name: "Wheel on rail" }).click();
  await row(page, "lateral force");
  const wheel = page.locator("section:not([hidden]) canvas.map").first();
  await wheel.focus();
  await page.keyboard.press("ArrowLeft");
  await has(page, "#rail-wheel-lateral", "3.05");
  const box = (await wheel.boundingBox())!;
  await page.evaluate(() => {
    const times: number[] = [];
    (window as unknown as { frameTimes: number[] }).frameTimes = times;
    let last = performance.now();
    const frame = (now: number) => { times.push(now - last); last = now; requestAnimationFrame(frame); };
    requestAnimationFrame(frame);
  });
  const lateral = async () => Number(await page.locator("#rail-wheel-lateral").inputValue());
  const { scale } = layOut(box.width, { y: [0, 0.0735], z: [0, 0] }); // of a rail as wide as 60E1 [px/m]
  await page.mouse.move(box.x + 300, box.y + 150);
  await page.mouse.down();
  for (let i = 0; i <= 60; ++i) await page.mouse.move(box.x + 300 - i / 5, box.y + 150);
  await hasNumber(page, "#rail-wheel-lateral", 3.05 + 12e3 / scale, 0.05); // 12 pixels of the hand and of the wheel
  const before = await lateral();
  await page.keyboard.down("Shift");
  for (let i = 0; i <= 20; ++i) await page.mouse.move(box.x + 288 + i / 2, box.y + 150);
  await page.keyboard.up("Shift");
  await hasNumber(page, "#rail-wheel-lateral", before - 1e3 / scale, 0.03); // 10 pixels with Shift
  await page.mouse.up();
  const times = (await page.evaluate(() => (window as unknown as { frameTimes: number[] }).frameTimes)).sort((one, other) => one - other);
  console.log(`while dragging: ${times.length} frames, median ${times[times.length >> 1]!.toFixed(1)} ms, longest ${times.at(-1)!.toFixed(1)} ms`);
  await row(page, "lateral force");
  for (const shown of await page.locator("section:not([hidden]) .time").allTextContents()) console.log(shown);
  assert.deepEqual(errors, []);
  await page.close();
});

test("every field says what the program says of its key: what it is, its unit and its range", async () => {
  const { page, errors } = await opened();
  await row(page, "longitudinal force fx");
  const fields = await page.locator(".field:has(input[type=text])").evaluateAll((all) => all.map((at) => {
    const text = at.querySelector<HTMLInputElement>("input[type=text]")!, told = text.getAttribute("aria-describedby")!.split(" ").map((id) => document.getElementById(id)!.textContent);
    return { id: text.id, title: (at as HTMLElement).title, told: told.join(""), unit: at.querySelector<HTMLSelectElement>(".unit select")?.value ?? at.querySelector(".unit")!.textContent };
  }));
  assert.equal(fields.length, 71);
  for (const { id, title, told, unit } of fields) {
    const keys = execFileSync(program, ["init", "--keys", id.startsWith("rail-") ? "wheel" : "bodies"], { encoding: "utf8" });
    const listed = keys.slice(id.includes("-layers-") ? keys.indexOf("[[body1.layers]]") : 0).split(/\n(?! {4})/).map((lines) => lines.split("\n    "));
    const [head, text] = listed.find(([line, what]) => line!.startsWith(`${id.replace(/-\d+$/, "").split("-").at(-1)!} `) && title.startsWith(what!)) ?? [];
    assert.ok(head && text, `${id}: ${title}`);
    const [, si = "", range = ""] = /^(?: \[(.*?)\])?(?:, (.*))?$/.exec(title.slice(text.length))!;
    assert.ok(head.includes(si) && head.endsWith(range), `${id}: ${title} and ${head}`);
    assert.equal(unit === "", si === "" || (si === "-" && !id.includes("creepage")), id);
    assert.equal(told, title);
  }
  assert.deepEqual(errors, []);
  await page.close();
});

test("examples set all that they are about; changes are undone and done again; two states are compared", async () => {
  const { page, errors } = await opened();
  await page.getByRole("tab", { name: "Wheel on rail" }).click();
  await settled(page);
  const seen = page.locator("section:not([hidden])"), preset = (name: string) => seen.getByRole("button", { name, exact: true }).click();
  for (const [name, view, says] of [
    ["Flange contact", "Wheel on rail", /\d kN possible/], ["Traction on a wet rail", "Contact", /drives/], ["Ball in a groove", "Contact", /0\.3|300 N/],
    ["Rubber roller", "Nip", /speed ratio/], ["Measured profile", "Wheel on rail", /measured_wheel\.txt/], ["Tread contact", "Wheel on rail", /Wheel s1002\.prw/],
  ] as const) {
    await preset(name);
    await page.getByRole("tab", { name: view, selected: true }).waitFor();
    await settled(page);
    assert.match((await seen.textContent())!, says, name);
    assert.equal(await page.locator("section.old:not([hidden])").count(), 0, name);
  }
  await railField(page, "wheel.lateral", "5");
  await settled(page);
  await railField(page, "wheel.yaw", "-2");
  await settled(page);
  const undo = page.getByRole("button", { name: "undo", exact: true });
  await undo.click();
  await has(page, "#rail-wheel-yaw", "1");
  await has(page, "#rail-wheel-lateral", "5");
  await undo.click();
  await has(page, "#rail-wheel-lateral", "3");
  await page.getByRole("button", { name: "redo", exact: true }).click();
  await has(page, "#rail-wheel-lateral", "5");
  await settled(page);
  const peak = async () => (await seen.locator(".keys > div", { hasText: "Highest pressure" }).locator(".value").textContent())!.replace(/\s+/g, " ");
  const atFive = await peak();
  await page.getByRole("button", { name: "compare A | B" }).click();
  await railField(page, "wheel.lateral", "-2");
  await settled(page);
  await seen.locator(".keys .before", { hasText: `A: ${atFive}` }).waitFor();
  const atMinusTwo = await peak();
  await page.getByRole("button", { name: "Swap A and B" }).click();
  await seen.locator(".keys .before", { hasText: `A: ${atMinusTwo}` }).waitFor();
  await settled(page);
  await has(page, "#rail-wheel-lateral", "5");
  await page.getByRole("button", { name: "End", exact: true }).click();
  await page.waitForFunction(() => [...document.querySelectorAll<HTMLElement>("section:not([hidden]) .keys .before")].every(({ hidden }) => hidden)); // in the next frame
  await page.getByRole("button", { name: "Reset all" }).click();
  await has(page, "#rail-wheel-lateral", "3");
  assert.deepEqual(errors, []);
  await page.close();
});

test("the right wheel of the mirrored state is the mirror image of the left one, and has the program's forces", async () => {
  const { page, errors } = await opened("#"), seen = page.locator("section:not([hidden])");
  const numbers = async () => (await seen.locator(".keys .value, .keys .note").allTextContents()).map((text) => text.trim());
  await settled(page);
  const ofLeft = await numbers(), { width } = (await seen.locator("canvas.map").first().boundingBox())!, { section } = layOut(width, { y: [0, 0.0735], z: [0, 0] });
  const wheelAtLeft = await pointsOf(page, "--wheel");
  await railField(page, "wheel.lateral", "-3");
  await railField(page, "wheel.yaw", "-1");
  await page.getByRole("button", { name: "Right wheel" }).click();
  await seen.getByRole("heading", { name: "Forces on the right wheel" }).waitFor();
  await settled(page);
  assert.deepEqual(await numbers(), ofLeft);
  assert.match((await seen.locator(".lead").textContent())!, /^Cut through the right wheel .* 3\.0 mm to the right .* turned 1\.0 mrad to the right/);
  const wheelAtRight = await pointsOf(page, "--wheel"), [pixels, foot] = [Math.round(width), Math.round(section.top + section.height)], mirror = Math.round(2 * section.left + section.width) - 1;
  let [all, both] = [0, 0];
  for (let y = 0; y < foot; ++y)
    for (let x = Math.ceil(section.left); x < section.left + section.width - 1; ++x) {
      if (wheelAtRight[y * pixels + x] !== "1") continue;
      ++all;
      if (wheelAtLeft[y * pixels + mirror - x] === "1") ++both;
    }
  assert.ok(all > 2e4 && both > 0.95 * all, `${both} of ${all} points of the wheel are mirrored`); // but for words
  const file = await saved(page, "case as TOML"), [lateral] = await row(page, "lateral force");
  for (const name of ["60e1.prr", "s1002.prw"]) copyFileSync(path.join(profiles, name), path.join(scratch, name));
  near(lateral! * 1e3, solvedByProgram(file).wheel!.force_y![0]!);
  assert.match(readFileSync(await saved(page, "case as Python"), "utf8"), /side="right"/);
  await page.getByRole("button", { name: "Left wheel" }).click();
  await settled(page);
  assert.notDeepEqual(await numbers(), ofLeft);
  assert.deepEqual(errors, []);
  await page.close();
});

test("the wheelset runs sideways between the flanges until it is stopped, which is one change to undo", async () => {
  const { page, errors } = await opened("#");
  await settled(page);
  const run = page.getByRole("button", { name: "let it run sideways, or stop it" }), lateral = async () => Number(await page.locator("#rail-wheel-lateral").inputValue());
  await run.click();
  await page.waitForFunction(() => Number(document.querySelector<HTMLInputElement>("#rail-wheel-lateral")!.value) < -6); // the other flange
  await run.click();
  await settled(page);
  const stopped = await lateral();
  assert.ok(Math.abs(stopped) < 7, `${stopped} mm`);
  await page.getByRole("button", { name: "undo", exact: true }).click();
  await has(page, "#rail-wheel-lateral", "3");
  assert.deepEqual(errors, []);
  await page.close();
});

test("sliders are hatched where the flange touches and beyond what friction can bear", async () => {
  const { page, errors } = await opened("#");
  await settled(page);
  const hatched = () => page.locator("section:not([hidden]) .hatched").evaluateAll((all) => all.map((at) => {
    const end = (name: string) => Number(getComputedStyle(at).getPropertyValue(name));
    return [at.closest(".field")!.querySelector("input")!.id, end("--from"), end("--to")] as const;
  }));
  const atFlange = await hatched();
  assert.deepEqual(atFlange.map(([id]) => id), ["rail-wheel-lateral", "rail-wheel-lateral"]);
  const touches = 16 * atFlange[1]![1] - 8; // [mm]
  assert.ok(touches > 6 && touches < 7.5, `${touches} mm`);
  assert.ok(Math.abs(atFlange[0]![2] - (1 - atFlange[1]![1])) < 1e-9, "the same on both sides");
  await page.getByRole("tab", { name: "Nip" }).click();
  await settled(page);
  assert.deepEqual(await hatched(), []); // 2.4 kN can be borne, the slider goes to 2 kN
  await nipField(page, "load.normal_force", "2");
  await settled(page);
  assert.deepEqual(await hatched(), [["nip-motion-force_longitudinal", 0, 0.2], ["nip-motion-force_longitudinal", 0.8, 1]]);
  await nipField(page, "motion.force_longitudinal", "1.21");
  await page.getByText("must be in [-1200, 1200]").first().waitFor();
  assert.deepEqual(errors, []);
  await page.close();
});

test("a field shows its number in any of its units, and takes it so", async () => {
  const { page, errors } = await opened();
  await row(page, "longitudinal force fx");
  const unit = page.getByLabel("unit of Load", { exact: true }).locator("visible=true"), load = "#contact-load-normal_force";
  await unit.selectOption("kip");
  await has(page, load, "17.98");
  await field(page, "load.normal_force", "20");
  await unit.selectOption("kN");
  await has(page, load, "88.96");
  assert.equal(await page.getByRole("slider", { name: "Load, kN" }).locator("visible=true").inputValue(), "89"); // by whole kN
  assert.deepEqual(errors, []);
  await page.close();
});

test("on screens of middle size the controls are a drawer that moves the picture aside", async () => {
  for (const width of [760, 1000]) {
    const { page, errors } = await opened("#", { width, height: 900 });
    for (const view of ["Wheel on rail", "Contact", "Start and stop", "Nip"]) {
      await page.getByRole("tab", { name: view }).click();
      await settled(page);
      const seen = page.locator("section:not([hidden])"), wide = async () => (await seen.locator(".pinned canvas").first().boundingBox())!, first = seen.locator(".controls .field").locator("visible=true").first();
      const alone = await wide();
      assert.equal(await first.count(), 0);
      await seen.getByRole("button", { name: "show or hide controls" }).click();
      await first.waitFor();
      await settled(page);
      const beside = await wide(), controls = (await seen.locator(".controls").boundingBox())!;
      assert.ok(beside.width < alone.width - 150 && beside.x >= controls.x + controls.width && beside.x + beside.width <= width, `${view}: ${JSON.stringify([alone, controls, beside])}`);
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `${view} is wider than ${width}`);
      await seen.getByRole("button", { name: "show or hide controls" }).click();
      await first.waitFor({ state: "detached" });
    }
    assert.deepEqual(errors, []);
    await page.close();
  }
});

test("the view that is opened is computed before the others", async () => {
  const { page, errors } = await opened("#", undefined, `${countRequests}
    addEventListener("DOMContentLoaded", () => { document.querySelector("nav button:nth-child(3)").click(); });`);
  await page.getByText("at rest, forces put on").waitFor();
  await settled(page);
  assert.equal(await page.evaluate(() => (window as unknown as Counting).asked[0]), "transient");
  assert.deepEqual(errors, []);
  await page.close();
});

test("the tour has five steps and can be left at any of them; a ? tells what an input means, as its text and units", async () => {
  const { page, errors } = await opened();
  const tour = page.getByRole("dialog", { name: "tour" }), next = tour.getByRole("button", { name: /Next|Done/ });
  await page.getByRole("button", { name: "take the tour" }).click();
  for (let step = 1; step <= 5; ++step) {
    await tour.getByText(`${step} of 5`).waitFor();
    await page.locator(".lit").waitFor();
    await next.click();
  }
  await tour.waitFor({ state: "hidden" });
  await page.getByRole("button", { name: "take the tour" }).click();
  await page.keyboard.press("Escape");
  await tour.waitFor({ state: "hidden" });
  await page.locator(".lit").waitFor({ state: "detached" });
  const help = page.getByText("A turned wheel rubs sideways");
  assert.ok(await help.isHidden());
  await page.getByRole("button", { name: "what is Turned (yaw)?" }).click();
  await help.waitFor();
  await page.locator("#rail-wheel-yaw-help").getByText("yaw of the wheelset; positive turns to the left [rad], in [-1, 1]").waitFor();
  await page.keyboard.press("Escape");
  await help.waitFor({ state: "hidden" });
  assert.deepEqual(errors, []);
  await page.close();
});

test("what is wrong is said in the picture's words, and the page does what it advises", async () => {
  const { page, errors } = await opened();
  await page.getByRole("tab", { name: "Wheel on rail" }).click();
  await settled(page);
  const advice = page.locator("section:not([hidden]) .remarks"), does = async (name: string) => {
    await settled(page); // the exact theory may say something else
    await advice.getByRole("button", { name }).click();
  };
  await railField(page, "wheel.lateral", "30");
  await advice.getByText("it has derailed").waitFor();
  await does("Back on the rail");
  await has(page, "#rail-wheel-lateral", "3");
  await advice.waitFor({ state: "hidden" });
  await railField(page, "wheel.lateral", "6.3");
  await page.getByLabel("Shape of the patch", { exact: true }).selectOption("flat");
  await advice.getByText("solved as flat").waitFor();
  await does("Use the curved shape");
  await advice.getByText("solved as flat").waitFor({ state: "detached" });
  await has(page, "#choice-shape-of-the-patch", "curved");
  await page.getByLabel("Smooth the wheel", { exact: true }).selectOption("0.004");
  await settled(page);
  assert.match(readFileSync(await saved(page, "case as TOML"), "utf8"), /smoothing_length = "4 mm"/);
  await page.locator("section:not([hidden])").getByRole("button", { name: "Measured profile" }).click();
  await page.getByLabel("Smooth the wheel", { exact: true }).selectOption("0");
  await advice.getByText(/measured_wheel.txt: the points scatter by .* leave smoothing_length out/).waitFor();
  await does("Smooth the wheel");
  await advice.waitFor({ state: "hidden" });
  await has(page, "#choice-smooth-the-wheel", "");
  assert.deepEqual(errors, []);
  await page.close();
});

test("measured points stand in the creep curves; a file without them is refused in words", async () => {
  const { page, errors } = await opened();
  await row(page, "longitudinal force fx");
  const give = (name: string, text: string) => page.locator("#file-points").setInputFiles({ name, mimeType: "text/csv", buffer: Buffer.from(text) });
  await give("curve.csv", readFileSync(path.join(profiles, "../creep_curve.csv"), "utf8"));
  await page.getByText(/curve\.csv: \d+ points up to [\d.]+ % and [\d.]+ kN/).waitFor();
  const legend = page.locator("section:not([hidden]) .panel", { hasText: "Creep curves" }).locator(".u-legend");
  for (const name of ["exact", "FASTSIM2", "measured, morning", "measured, evening"]) await legend.getByText(name, { exact: true }).waitFor();
  await give("two.csv", "creepage_lateral [permille],adhesion_coefficient\n1,0.1\n2,0.15");
  await page.getByText('two.csv line 2: "1,0.1" has no creepage and force.').waitFor(); // permille is no unit of case files
  await give("two.csv", "creepage_lateral [%],adhesion_coefficient\n0.1,0.1\n0.2,0.15");
  await page.getByText("two.csv: 2 points up to 0.2 % and 12 kN").waitFor(); // of the load of 80 kN
  await give("no.csv", "a,b\n1,2");
  await page.getByText("no.csv has no columns creepage_longitudinal or creepage_lateral").waitFor();
  assert.deepEqual(errors, []);
  await page.close();
});

/** On small screens the picture is seen while a control is. */
async function inSight(page: Page, view: string): Promise<void> {
  const box = async (selector: string) => (await page.locator(`section:not([hidden]) ${selector}`).locator("visible=true").first().boundingBox())!;
  const [picture, control] = [await box(".pinned canvas"), await box(".controls .field")], { height } = page.viewportSize()!;
  assert.ok(control.y >= 0 && control.y + control.height <= height, `${view}: a control at ${control.y}`);
  assert.ok(picture.y >= 0 && control.y - picture.y > 200, `${view}: ${control.y - picture.y} pixels of the picture above the controls`);
}

/** Contrast of two colours as WCAG 2 defines it. */
function contrast(one: string, other: string): number {
  const light = (hex: string) => {
    const [r, g, b] = [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16) / 255).map((value) => (value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4));
    return 0.2126 * r! + 0.7152 * g! + 0.0722 * b!;
  };
  const [low, high] = [light(one), light(other)].sort((a, b) => a - b);
  return (high! + 0.05) / (low! + 0.05);
}

test("colours of both themes: texts have a contrast of 4.5 on all that they stand on, lines and marks of 3", () => {
  const themes = [...readFileSync(new URL("../src/page.css", import.meta.url), "utf8").matchAll(/:root[^{]*\{([^}]*)\}/g)].map(([, block]) => new Map([...block!.matchAll(/(--[\w-]+): (#[0-9a-f]{6})/g)].map(([, name, colour]) => [name!, colour!])));
  assert.equal(themes.length, 2);
  const texts: Record<string, string[]> = {
    "--ink": ["--paper", "--panel", "--well", "--ui-soft", "--warn-soft", "--wheel", "--rail", "--stick-soft", "--slide-soft"], "--ink2": ["--paper", "--panel", "--well", "--ui-soft", "--wheel", "--rail"],
    "--ink3": ["--paper", "--panel"], "--ui-ink": ["--ui"], "--bad": ["--paper", "--panel", "--bad-soft"],
  };
  const marks = ["--ui", "--edge", "--stick", "--slide", "--wheel-edge", "--rail-edge", "--exact", "--fastsim2", "--table", "--accent1", "--accent2", "--accent3", "--arrow", "--ink3"];
  for (const [i, theme] of themes.entries()) {
    const check = (one: string, other: string, least: number) => {
      const found = contrast(theme.get(one)!, theme.get(other)!);
      assert.ok(found >= least, `${["light", "dark"][i]!}: ${one} on ${other} has ${found.toFixed(2)}`);
    };
    for (const [text, grounds] of Object.entries(texts)) for (const ground of grounds) check(text, ground, 4.5);
    for (const mark of marks) check(mark, "--panel", 3);
  }
});

test("in another theme all pictures and charts have its colours at once", async () => {
  const { page, errors } = await opened("#"), { page: dark, errors: others } = await opened("#", undefined, undefined, "dark");
  const pictures = (of: Page) => of.locator("section:not([hidden]) canvas").evaluateAll((all) => (all as HTMLCanvasElement[]).filter(({ offsetParent }) => offsetParent).map((canvas) => canvas.toDataURL()));
  const theme = page.getByRole("button", { name: "light or dark" });
  for (const view of ["Wheel on rail", "Contact", "Start and stop", "Nip"]) {
    for (const of of [page, dark]) await of.getByRole("tab", { name: view }).click();
    await Promise.all([settled(page), settled(dark)]);
    const inLight = await pictures(page);
    await theme.click();
    await settled(page);
    const changed = await pictures(page), wanted = await pictures(dark);
    assert.ok(changed.length > 1 && changed.length === wanted.length, view);
    for (const [k, picture] of changed.entries()) {
      assert.ok(picture === wanted[k], `${view}: picture ${k} is not as in a page that is dark from the start`);
      assert.notEqual(picture, inLight[k], `${view}: picture ${k}`);
    }
    await theme.click();
  }
  assert.deepEqual([...errors, ...others], []);
  await page.close();
  await dark.close();
});

test("axe-core finds nothing in any view, wide and light, with its drawer, narrow and dark; each field is one stop of the keyboard", async () => {
  interface Found { violations: { id: string; nodes: { html: string }[] }[] }
  for (const [width, scheme] of [[1400, "light"], [1000, "light"], [400, "dark"]] as const) {
    const { page, errors } = await opened("#", { width, height: 900 }, undefined, scheme);
    await page.addScriptTag({ path: createRequire(import.meta.url).resolve("axe-core/axe.min.js") });
    for (const view of ["Wheel on rail", "Contact", "Start and stop", "Nip"]) {
      await page.getByRole("tab", { name: view }).click();
      if (width === 1000) await page.locator("section:not([hidden]) .drawer").click();
      await settled(page);
      const { violations } = await page.evaluate(() => (window as unknown as { axe: { run: (root: Document, what: unknown) => Promise<Found> } }).axe.run(document, { resultTypes: ["violations"] }));
      assert.deepEqual(violations.map(({ id, nodes }) => [id, nodes.map(({ html }) => html)]), [], view);
      const stops = await page.evaluate(() => [...document.querySelectorAll("section:not([hidden]) .field:has(input[type=text])")].map((at) => [...at.querySelectorAll<HTMLElement>("input")].filter(({ tabIndex }) => tabIndex >= 0).length));
      assert.ok(stops.length > 5 && stops.every((count) => count === 1), `${view}: ${stops.join(" ")}`);
    }
    assert.deepEqual(errors, []);
    await page.close();
  }
});

test("every view has a title, a sentence of its state and six key numbers; A | B is where it compares", async () => {
  const { page, errors } = await opened("#");
  for (const [view, words] of [["Wheel on rail", "3.0 mm to the left"], ["Contact", ""], ["Start and stop", "12 kN backwards, 50 % of what friction can bear"], ["Nip", "4 kN into one with a rubber cover 15 mm thick"]] as const) {
    await page.getByRole("tab", { name: view }).click();
    await settled(page);
    const shown = page.locator("section:not([hidden])");
    assert.equal(await shown.locator("h2").count(), 1);
    assert.ok((await shown.locator(".lead").textContent())!.includes(words) && (await shown.locator(".lead").textContent())!.length > 60, `${view}: ${await shown.locator(".lead").textContent() ?? ""}`);
    assert.equal(await shown.locator(".keys dt").count(), 6);
    for (const text of await shown.locator(".keys .value, .keys .note").allTextContents()) assert.doesNotMatch(text, /NaN|undefined|Infinity/);
    assert.equal(await page.getByRole("button", { name: "compare A | B" }).isVisible(), view === "Wheel on rail" || view === "Contact");
  }
  assert.deepEqual(errors, []);
  await page.close();
});

test("every control has a name; nothing is wider than a narrow screen", async () => {
  for (const view of ["Contact", "Wheel on rail", "Start and stop", "Nip"])
    for (const [width, scheme] of [[400, "dark"], [1400, "light"]] as const) {
      const { page, errors } = await opened("", { width, height: 900 }, undefined, scheme);
      await page.getByRole("tab", { name: view }).click();
      await settled(page);
      const unnamed = await page.evaluate(() => [...document.querySelectorAll<HTMLElement>("input, select, button, canvas[role=img]")].filter((at) =>
        at.offsetParent && !(at.getAttribute("aria-label") ?? at.textContent ?? "").trim() && !document.querySelector(`label[for="${at.id}"]`)).map((at) => at.outerHTML));
      assert.deepEqual(unnamed, []);
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `${view} is wider than ${width}`);
      if (width === 400) await inSight(page, view);
      assert.deepEqual(errors, []);
      await page.close();
    }
});

test("an axis has room for steps that numbers can count, whatever the curve", () => {
  for (const middle of [1, -3e-4, 2e9])
    for (const difference of [0, 1e-16, 1e-12, 1e-6, 0.1].map((share) => share * Math.abs(middle))) {
      const [from, to] = axisRange(middle, middle + difference) as [number, number];
      assert.ok(from <= middle && middle + difference <= to, `${middle} to ${middle + difference} lie in the axis`);
      assert.ok(to - from > 1e-8 * Math.abs(middle), `${middle} to ${middle + difference}: from ${from} to ${to}`);
    }
  assert.deepEqual(axisRange(null, null), [null, null]);
});
