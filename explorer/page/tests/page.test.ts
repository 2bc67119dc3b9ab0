// The page in a real browser, opened as a file: every view, its numbers beside the program's, links, refusals.
//   MICROSLIP_PAGE folder of index.html; MICROSLIP the program; PROFILES folder of the examples' profiles; SCREENSHOTS where to leave some

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { copyFileSync, mkdirSync, mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";
import { layOut } from "../src/rail_picture.ts";
import { sheetsOf } from "../src/sheet.ts";
import { chromium, type Browser, type Download, type Page } from "playwright-core";

const { MICROSLIP_PAGE: folder = "", MICROSLIP: named = "", PROFILES: profiles = "", CHROMIUM: executablePath = "/usr/bin/chromium", SCREENSHOTS: shots } = process.env;
const program = path.resolve(named);
const address = `file://${path.resolve(folder)}/index.html`;
const scratch = mkdtempSync(path.join(tmpdir(), "explorer-"));
let browser: Browser;

before(async () => {
  browser = await chromium.launch({
    executablePath,
    args: ["--no-sandbox", "--disable-gpu", "--enable-unsafe-swiftshader", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"],
  });
});
after(async () => {
  await browser.close();
  rmSync(scratch, { recursive: true });
});

interface Opened { page: Page; errors: string[]; requests: string[] }

async function opened(link = "", size = { width: 1400, height: 900 }, script?: string, colorScheme: "light" | "dark" = "light"): Promise<Opened> {
  const page = await browser.newPage({ viewport: size, colorScheme });
  const errors: string[] = [], requests: string[] = [];
  page.on("pageerror", (error) => errors.push(error.message));
  page.on("request", (request) => requests.push(request.url()));
  if (script) await page.addInitScript(script);
  await page.goto(address + link);
  if (link === "") await page.getByRole("tab", { name: "Contact" }).click();
  return { page, errors, requests };
}

/** Numbers of a row of the table that is shown, once all columns are there. */
async function row(page: Page, name: string, columns = 2): Promise<number[]> {
  const cells = page.locator("section:not([hidden]) .numbers tr", { hasText: name }).locator("td:not(.unit)");
  await page.waitForFunction(([text, count]) => {
    const found = [...document.querySelectorAll("section:not([hidden]) .numbers tr")].find((tr) => tr.textContent?.includes(text as string));
    const values = [...(found?.querySelectorAll("td:not(.unit)") ?? [])].map((cell) => cell.textContent);
    return values.length >= (count as number) && !values.includes("…");
  }, [name, columns] as const, { timeout: 60000 });
  return (await cells.allTextContents()).map(Number);
}

async function field(page: Page, key: string, text: string): Promise<void> {
  const input = page.locator(`#contact-${key.replaceAll(".", "-")}`);
  await input.fill(text);
  await input.press("Enter");
  await input.blur();
}

async function railField(page: Page, key: string, text: string): Promise<void> {
  const input = page.locator(`#rail-${key.replaceAll(".", "-")}`);
  await input.fill(text);
  await input.press("Enter");
}

async function nipField(page: Page, key: string, text: string): Promise<void> {
  const input = page.locator(`#nip-${key.replaceAll(".", "-")}`);
  await input.fill(text);
  await input.press("Enter");
}

/** Nothing is computed, and nothing has been for longer than the page puts off what is not urgent. */
async function settled(page: Page): Promise<void> {
  const quiet = await page.evaluateHandle(() => ({ since: performance.now() }));
  await page.waitForFunction((at) => {
    if (document.body.ariaBusy === "true") at.since = performance.now();
    return performance.now() - at.since > 700;
  }, quiet, { polling: 20, timeout: 120000 });
}

async function saved(page: Page, name: string): Promise<string> {
  const download = page.waitForEvent("download");
  await page.getByText("Export ▾").click();
  await page.getByRole("button", { name, exact: true }).click();
  const to = path.join(scratch, ((await download) as Download).suggestedFilename());
  await ((await download) as Download).saveAs(to);
  return to;
}

function near(found: number, wanted: number): void {
  assert.ok(Math.abs(found - wanted) <= 6e-4 * Math.abs(wanted) + 1e-12, `${found} on the page, ${wanted} by the program`);
}

function solvedByProgram(file: string): Record<string, Record<string, number & number[]>> {
  return JSON.parse(execFileSync(program, ["solve", file, "--json"], { cwd: scratch, encoding: "utf8", stdio: "pipe", maxBuffer: 1e9 })) as Record<string, Record<string, number & number[]>>;
}

test("a contact is drawn up to its edge: of Hertz's pressure on rows his ellipse, with his pressure inside", () => {
  const a = 6, b = 4, n = 40, [dx, dy] = [(2 * a) / n, (2 * b) / n];
  for (const [shift, rise] of [[0, 0], [0.3, 0.2], [-0.45, 0.49]] as const) { // of the grid, by shares of an element
    const at = Array.from({ length: (n + 2) ** 2 }, (_, k) => [((k % (n + 2)) - n / 2 - 0.5 + shift) * dx, (Math.floor(k / (n + 2)) - n / 2 - 0.5 + rise) * dy] as const);
    const level = (x: number, y: number) => 1 - (x / a) ** 2 - (y / b) ** 2, half = at.map(([x, y]) => 0.5 * Math.sqrt(Math.max(level(x, y), 0)));
    const pressure = half.map((value) => 2 * value);
    const [sheet, ...others] = sheetsOf({
      x: at.map(([x]) => x), y: at.map(([, y]) => y), width: at.map(() => dx), pressure, px: half, py: half.map(() => 0), bound: pressure.map((p) => 0.75 * p),
      state: at.map(([x, y]) => (level(x, y) <= 0 ? 0 : x < -1 ? 2 : 1)),
    }, dy);
    assert.equal(others.length, 0);
    assert.ok(Math.abs(sheet!.area() / (Math.PI * a * b) - 1) < 5e-3, `${sheet!.area()} of ${Math.PI * a * b}`);
    const outmost = Math.min(...sheet!.outline().map(([x, y]) => level(x, y)));
    assert.ok(outmost > -0.02, `a corner at level ${outmost}`); // of whole elements it is -0.06
    for (const [x, y] of [[0, 0], [3, 1.5], [-4, -2], [5.4, 0.6]] as const) {
      const found = sheet!.at(x, y)!;
      assert.ok(Math.abs(found.pressure - Math.sqrt(level(x, y))) < 0.012, `pressure at ${x}, ${y}: ${found.pressure}`);
      assert.ok(Math.abs(found.px - found.pressure / 2) < 1e-3 && found.mark < 0 === x > -1);
    }
    assert.equal(sheet!.at(5.9, 1.5), undefined);
    for (const [[x]] of sheet!.border().filter(([[, y]]) => Math.abs(y) < 0.9 * b)) assert.ok(Math.abs(x + 1) < dx, `the border of adhesion and slip at ${x}`);
  }
});

test("opens from a file, asks nothing of a network, and its forces are the program's", async () => {
  const { page, errors, requests } = await opened();
  const [fx, fast] = await row(page, "longitudinal force fx"), [mz] = await row(page, "spin moment mz");
  const result = solvedByProgram(await saved(page, "case as TOML"));
  near(fx! * 1e3, result.exact!.fx!);
  near(fast! * 1e3, result.fastsim2!.fx!);
  near(mz!, result.exact!.mz!);
  assert.deepEqual(requests.filter((url) => !/^(file|blob|data):/.test(url)), []);
  assert.deepEqual(errors, []);
  await page.close();
});

test("a wheel on a rail has the program's forces", async () => {
  const { page, errors } = await opened();
  await page.getByRole("tab", { name: "Wheel on rail" }).click();
  const [lateral] = await row(page, "lateral force");
  const file = await saved(page, "case as TOML");
  for (const name of ["60e1.prr", "s1002.prw"]) writeFileSync(path.join(scratch, name), readFileSync(path.join(profiles, name)));
  near(lateral! * 1e3, solvedByProgram(file).wheel!.force_y![0]!);
  assert.deepEqual(errors, []);
  await page.close();
});

test("a nip has the program's numbers, and its free roller no force", async () => {
  const { page, errors } = await opened();
  await page.getByRole("tab", { name: "Nip" }).click();
  const [fx] = await row(page, "longitudinal force fx"), [creepage, free] = await row(page, "longitudinal creepage"), [my] = await row(page, "rolling resistance moment my");
  const exact = solvedByProgram(await saved(page, "case as TOML")).exact!;
  near(fx! * 1e3, exact.fx!);
  near(creepage! / 100, exact.creepage_longitudinal!);
  near(my!, exact.my!);
  near((await row(page, "peak pressure"))[0]! * 1e6, exact.peak_pressure!);
  near((await row(page, "approach"))[0]! / 1e3, exact.approach!);
  near((await row(page, "frictional power"))[0]!, exact.frictional_power!);
  assert.equal((await row(page, "speed ratio"))[1]!.toFixed(3), ((2 - free! / 100) / (2 + free! / 100)).toFixed(3));
  await page.getByLabel("rolling: given is").selectOption("creepage"); // that was found: the same nip
  near(Number(await page.locator("#nip-motion-creepage_longitudinal").inputValue()), creepage!);
  await nipField(page, "motion.creepage_longitudinal", String(free));
  await page.waitForFunction(() => Math.abs(Number(document.querySelector("section:not([hidden]) .numbers td")?.textContent)) < 1e-3); // [kN], of four digits
  const approach = (await row(page, "approach over thickness"))[0]!;
  for (const [stiffness, inputs] of [["young_modulus", "3.605"], ["shear_modulus", "1.202"], ["hardness", "60"]] as const) { // the same cover
    await page.getByLabel("stiffness by").selectOption(stiffness);
    await settled(page);
    assert.equal(await page.locator(`#nip-body2-layers-1-${stiffness}`).inputValue(), inputs);
    near((await row(page, "approach over thickness"))[0]!, approach);
  }
  await page.locator("section:not([hidden]) .panel", { hasText: "Force over creepage" }).locator("canvas").waitFor();
  assert.deepEqual(errors, []);
  await page.close();
});

test("a nip's refusals stand at its fields, and a deep one is warned of", async () => {
  const { page, errors } = await opened();
  await page.getByRole("tab", { name: "Nip" }).click();
  await row(page, "longitudinal force fx");
  const faint = page.locator("section.old:not([hidden])"), at = (key: string) => page.locator(`#nip-${key.replaceAll(".", "-")}-error`);
  for (const [key, bad, why, good] of [
    ["motion.force_longitudinal", "-3", "motion.force_longitudinal = -3000 [N]: must be in [-2400, 2400]", "-0.4"],
    ["friction.coefficient", "0", "friction.coefficient = 0 [-]: must be positive", "0.6"],
    ["body2.layers.1.hardness", "95", "body2.layers.1.hardness = 95 [ShoreA]: must be in [20, 90]", "60"],
    ["body2.layers.1.relaxation_shares.1", "-0.1", "must be positive", "0"],
    ["body2.layers.1.relaxation_times.2", "-3", "", "20"], // of a term without a share
    ["body2.layers.1.relaxation_shares.2", "1.2", "sum of shares = 1.2 [-]: must be below 1", "0.2"],
    ["body2.layers.1.relaxation_times.2", "-3", "must be positive", "20"],
  ] as const) {
    await nipField(page, key, bad);
    if (why === "") await settled(page);
    else await at(key).getByText(why).waitFor();
    assert.equal(await faint.count(), why === "" ? 0 : 1, key);
    await nipField(page, key, good);
    await faint.waitFor({ state: "detached" });
  }
  await nipField(page, "body2.transverse_radius", "-20");
  await page.locator("section:not([hidden]) .message").getByText("must be positive").waitFor();
  await nipField(page, "body2.transverse_radius", "20");
  await faint.waitFor({ state: "detached" });
  const remarks = page.locator("section:not([hidden]) .remarks");
  assert.equal((await remarks.textContent()), "");
  await nipField(page, "load.normal_force", "15");
  await nipField(page, "body2.layers.1.hardness", "35");
  await remarks.getByText(/The cover gives way by [\d.]+ % of its thickness: beyond 15 %/).waitFor();
  assert.deepEqual(errors, []);
  await page.close();
});

test("a nip is dragged: of the loads in between the newest is computed", async () => {
  const { page, errors } = await opened("", undefined, countRequests);
  await page.getByRole("tab", { name: "Nip" }).click();
  await settled(page);
  const slider = page.getByRole("slider", { name: "Load, kN" }).locator("visible=true");
  await page.evaluate(() => { (window as unknown as Counting).asked.length = 0; });
  await slider.focus();
  for (let k = 0; k < 40; ++k) await page.keyboard.press("ArrowRight");
  await settled(page);
  const asked = await page.evaluate(() => (window as unknown as Counting).asked);
  assert.ok(asked.filter((call) => call === "nip").length < 40 && asked.at(-1) === "nip_curve", asked.join(", "));
  assert.equal(await page.locator("#nip-load-normal_force").inputValue(), "6");
  near((await row(page, "peak pressure"))[0]! * 1e6, solvedByProgram(await saved(page, "case as TOML")).exact!.peak_pressure!);
  console.log(await page.locator("section:not([hidden]) .time").textContent());
  assert.deepEqual(errors, []);
  await page.close();
});

test("the transient plays from rest to steady rolling", async () => {
  const { page, errors } = await opened();
  await page.getByRole("tab", { name: "Start and stop" }).click();
  await page.getByText("at rest, forces put on").waitFor({ timeout: 60000 });
  await page.getByRole("button", { name: "play or stop" }).click();
  await page.getByText(/2\.\d* lengths of the contact/).waitFor({ timeout: 60000 });
  assert.deepEqual(errors, []);
  await page.close();
});

test("a link restores the state; others are refused in words", async () => {
  const first = await opened();
  await field(first.page, "load.normal_force", "55,5 kN");
  await first.page.waitForFunction(() => location.hash.length > 10);
  await settled(first.page);
  const link = new URL(first.page.url()).hash;
  const before = await row(first.page, "longitudinal force fx");
  const second = await opened(link);
  assert.deepEqual(await row(second.page, "longitudinal force fx"), before);
  assert.equal(await second.page.locator("#contact-load-normal_force").inputValue(), "55.5");
  for (const [other, why] of [["#7.abc", "version 7"], ["#3.AAAA", "damaged"], ["#2.AAAA", "version 2"], ["#nonsense", "not one of the explorer"]] as const) {
    const { page } = await opened(other);
    await page.getByText(why).waitFor();
    await row(page, "lateral force");
    await page.close();
  }
  await first.page.close();
  await second.page.close();
});

/** Files dropped on the page, where no picture takes them. */
async function dropped(page: Page, files: [string, string][]): Promise<void> {
  await page.evaluate((given) => {
    const dataTransfer = new DataTransfer();
    for (const [name, text] of given) dataTransfer.items.add(new File([text], name));
    document.querySelector("header")!.dispatchEvent(new DragEvent("drop", { dataTransfer, bubbles: true, cancelable: true }));
  }, files);
}

test("case files that are dropped have the program's numbers, or are refused by what the page does not have", async () => {
  const { page, errors } = await opened(), folder = path.join(profiles, "..");
  const example = (name: string) => readFileSync(path.join(folder, name), "utf8");
  const solved = (name: string) => solvedByProgram(path.join(path.resolve(folder), name));
  await row(page, "longitudinal force fx");
  await dropped(page, [["hertzian_contact.toml", example("hertzian_contact.toml")]]);
  await page.getByText("ms on 40 × 40 elements").waitFor();
  await settled(page);
  const contact = solved("hertzian_contact.toml"), [fx, fast] = await row(page, "longitudinal force fx");
  near(fx! * 1e3, contact.exact!.fx!);
  near(fast! * 1e3, contact.fastsim2!.fx!);
  await dropped(page, [["starting_to_roll.toml", example("starting_to_roll.toml")]]);
  await page.getByRole("tab", { name: "Start and stop", selected: true }).waitFor();
  await settled(page);
  assert.equal(await page.locator("#start-motion-creepage_lateral").inputValue(), "0.05");
  assert.ok(await page.locator("#start-motion-force_longitudinal").isHidden());
  const last = readFileSync(await saved(page, "forces as CSV"), "utf8").trim().split("\n").at(-1)!.split(",").map(Number);
  near(last[1]! * 1e3, solved("starting_to_roll.toml").exact!.fx!);
  await dropped(page, [["wheel_on_rail.toml", example("wheel_on_rail.toml")]]);
  await page.getByText("material.hardness = 3000000000").waitFor();
  await settled(page);
  near((await row(page, "lateral force"))[0]! * 1e3, solved("wheel_on_rail.toml").wheel!.force_y![0]!);
  await dropped(page, [["rubber_roller.toml", example("rubber_roller.toml")]]);
  await page.getByText("ms on 80 elements").waitFor({ timeout: 60000 });
  await page.getByText("those of a metre along them").waitFor();
  assert.equal(await page.locator("#nip-body2-layers-1-relaxation_shares-2").inputValue(), "0.1");
  await settled(page);
  near((await row(page, "longitudinal creepage"))[0]! / 100, solved("rubber_roller.toml").exact!.creepage_longitudinal!);
  await dropped(page, [["coated_roller.toml", example("coated_roller.toml")]]);
  await page.getByText(/coated_roller.toml is not taken: the page does not have this of the case: body1.layers.1.poisson_ratio, body1.layers.1.thickness/).waitFor();
  await dropped(page, [["two_rollers.toml", example("two_rollers.toml")]]);
  await page.getByText(/two_rollers.toml is not taken: the page does not have this of the case: .*load.approach/).waitFor();
  await dropped(page, [["worn.toml", example("wheel_on_rail.toml").replace("profiles/s1002.prw", "worn/s1.prw")]]);
  await page.getByText('worn.toml is not taken: wheelset.profile = "worn/s1.prw": not here').waitFor();
  await dropped(page, [["worn.toml", example("wheel_on_rail.toml").replace("profiles/s1002.prw", "worn/s1.prw")], ["s1.prw", example("profiles/s1002.prw")]]);
  await page.getByText("Wheel s1.prw on rail 60e1.prr").waitFor();
  await settled(page);
  near((await row(page, "lateral force"))[0]! * 1e3, solved("wheel_on_rail.toml").wheel!.force_y![0]!);
  assert.deepEqual(errors, []);
  await page.close();
});

test("the program opens the page with a case, and what the page does not have is named", async () => {
  const explore = (file: string) => {
    const to = path.join(scratch, "leads.html");
    execFileSync(program, ["explore", file, "--no-browser", "-o", to], { stdio: "pipe" });
    return `file://${to}`;
  };
  const page = await browser.newPage();
  await page.goto(explore(path.join(profiles, "../wheel_on_rail.toml")));
  await page.waitForFunction(() => document.querySelector<HTMLInputElement>("#rail-wheel-lateral")?.value === "6.04", undefined, { timeout: 60000 });
  await row(page, "lateral force");
  await page.goto(explore(path.join(profiles, "../starting_to_roll.toml")));
  await page.getByRole("tab", { name: "Start and stop", selected: true }).waitFor({ timeout: 60000 });
  const layered = path.join(scratch, "layered.toml");
  writeFileSync(layered, readFileSync(path.join(profiles, "../hertzian_contact.toml"), "utf8").replace("# [layer] ", "[layer] ")
    .replace("# shear_modulus = \"8.2 GPa\"", "shear_modulus = \"8.2 GPa\"").replace('# thickness = "10 um"', 'thickness = "10 um"').replace('"second_order"', '"classical"'));
  await page.goto(explore(layered));
  await page.getByText(/the page does not have this of the case: layer.shear_modulus, layer.thickness.* The page shows its own example instead/).waitFor({ timeout: 60000 });
  await page.close();
});

test("empty, absurd and misread fields are refused where they stand, and results are faint as long as they are", async () => {
  const { page, errors } = await opened();
  const faint = page.locator("section.old:not([hidden])"), inWords = page.locator("section:not([hidden]) .panel .message").first();
  await row(page, "longitudinal force fx");
  assert.equal(await faint.count(), 0);
  await field(page, "load.normal_force", "");
  await inWords.getByText("Load and friction, Load: needs a number. Faint pictures and numbers are those of the last case").waitFor();
  await field(page, "load.normal_force", "55 t");
  await inWords.getByText('Load and friction, Load: "t" is not one of its units: N, kN, MN, kgf, lbf, kip.').waitFor();
  await faint.waitFor();
  await field(page, "motion.spin", "0.5"); // solved with the last load that was read
  await settled(page);
  assert.ok(await inWords.getByText("not one of its units").isVisible(), "a text that is no number stays refused");
  assert.equal(await faint.count(), 1);
  await field(page, "load.normal_force", "abc");
  await inWords.getByText('"abc" is not a number').waitFor();
  assert.ok(await page.locator("#contact-load-normal_force[aria-invalid]").isVisible());
  await field(page, "load.normal_force", "80");
  await faint.waitFor({ state: "detached" });
  await field(page, "motion.creepage_longitudinal", "5000 %");
  await inWords.getByText('How the wheel moves on the rail, Braking: "5000 %" is not between -200 and 200 %').waitFor();
  await faint.waitFor();
  await field(page, "motion.creepage_longitudinal", "0.1 %");
  await faint.waitFor({ state: "detached" });
  await field(page, "friction.coefficient", "-0.3");
  await page.getByText("friction.coefficient = -0.3 [-]: must be in [0, 10]").first().waitFor(); // the reader's message
  await field(page, "friction.coefficient", "0.3");
  await settled(page);
  assert.equal(await page.getByText("must be in").filter({ visible: true }).count(), 0);
  for (const [tab, key, label] of [["Wheel on rail", "rail-wheel-lateral", "Where the wheelset stands, Moved sideways"], ["Start and stop", "start-motion-steps", "Motion, Steps"]] as const) {
    await page.getByRole("tab", { name: tab }).click();
    await settled(page);
    await page.locator(`#${key}`).fill("abc");
    await page.locator(`#${key}`).press("Enter");
    await inWords.getByText(`${label}: "abc" is not a number.`).waitFor();
    await faint.waitFor();
  }
  assert.deepEqual(errors, []);
  await page.close();
});

test("a contact by its ellipse: the program finds that ellipse under any load, links keep it, others are refused", async () => {
  const { page, errors } = await opened();
  await row(page, "longitudinal force fx");
  const [a] = await row(page, "half length a", 1);
  await page.getByLabel("given by").selectOption("ellipse");
  near(Number(await page.locator("#contact-ellipse-a").inputValue()), a!);
  assert.ok(await page.locator("#contact-body1-rolling_radius").isHidden());
  await field(page, "ellipse.a", "7.5");
  await field(page, "ellipse.b", "3 mm");
  await field(page, "load.normal_force", "60");
  await page.waitForFunction(() => [...document.querySelectorAll("section:not([hidden]) .numbers tr")].some((tr) => tr.textContent === "ellipse, half length a7.5mm"));
  await settled(page);
  const [fx] = await row(page, "longitudinal force fx");
  const result = solvedByProgram(await saved(page, "case as TOML"));
  near(result.hertz!.a!, 7.5e-3);
  near(result.hertz!.b!, 3e-3);
  near(result.hertz!.normal_force!, 60e3);
  near(fx! * 1e3, result.exact!.fx!);
  await settled(page);
  const second = await opened(new URL(page.url()).hash);
  assert.equal((await row(second.page, "longitudinal force fx"))[0], fx);
  assert.equal(await second.page.getByLabel("given by").inputValue(), "ellipse");
  assert.equal(await second.page.locator("#contact-ellipse-b").inputValue(), "3");
  await second.page.close();
  await field(page, "ellipse.a", "-1");
  await page.getByText("ellipse.a = -0.001 [m]: must be positive and finite").waitFor();
  await field(page, "ellipse.a", "100 m"); // a/b = 33333, which is a line
  await page.getByText("ellipse.a = -0.001").waitFor({ state: "hidden" });
  await field(page, "ellipse.a", "1000 m");
  await page.getByText(/a\/b = .* must be in/).waitFor();
  await field(page, "ellipse.a", "7.5");
  await page.getByText(/a\/b = .* must be in/).waitFor({ state: "hidden" });
  await page.getByLabel("given by").selectOption("radii");
  assert.equal(await page.locator("#contact-body2-rolling_radius").inputValue(), "inf");
  await settled(page);
  assert.equal((await row(page, "longitudinal force fx"))[0], fx);
  assert.deepEqual(errors, []);
  await page.close();
});

test("warnings of results stand beside them, in all views, as long as they hold", async () => {
  const { page, errors } = await opened();
  const warned = page.locator("section:not([hidden]) .remarks");
  await row(page, "longitudinal force fx");
  assert.equal(await warned.textContent(), "");
  await field(page, "load.normal_force", "800 MN");
  await warned.getByText(/approach .* is too large for a half-space/).waitFor();
  await field(page, "load.normal_force", "80");
  await warned.waitFor({ state: "hidden" });
  await page.getByRole("tab", { name: "Wheel on rail" }).click();
  await railField(page, "wheel.lateral", "12");
  await warned.getByText("beyond a hundredth of Young's modulus").waitFor();
  await page.getByLabel("Shape of the patch", { exact: true }).selectOption("flat");
  await warned.getByText("patches are solved as flat where the surfaces are not").waitFor();
  await page.getByLabel("Shape of the patch", { exact: true }).selectOption("true");
  await warned.getByText("patches are solved as flat").waitFor({ state: "detached" });
  await railField(page, "wheel.lateral", "30");
  await warned.getByText("it has derailed").waitFor();
  await railField(page, "wheel.lateral", "-300");
  await warned.getByText("no contact: wheel and rail do not touch").waitFor();
  await railField(page, "wheel.lateral", "3");
  await warned.waitFor({ state: "hidden" });
  await page.getByRole("tab", { name: "Start and stop" }).click();
  await page.locator("#start-load-normal_force").fill("800 MN");
  await page.locator("#start-load-normal_force").press("Enter");
  await warned.getByText("is too large for a half-space").waitFor({ timeout: 60000 });
  assert.deepEqual(errors, []);
  await page.close();
});

test("what is refused leaves no picture that looks like the answer", async () => {
  const { page, errors } = await opened("", undefined, countRequests);
  const panel = (name: string) => page.locator("section:not([hidden]) .panel", { hasText: name });
  const old = page.locator("section.old:not([hidden])");
  await panel("Creep curves").locator("canvas").waitFor();
  await panel("Stresses").locator("canvas[aria-label*=von_mises]").waitFor();
  await field(page, "friction.coefficient", "-0.3");
  await page.getByText("those of the last case without errors").waitFor();
  await old.waitFor();
  await page.getByLabel("over", { exact: true }).selectOption("spin"); // asks for curves and stresses of the case that is refused
  await panel("Creep curves").getByText(/FASTSIM2: friction.coefficient = -0.3/).waitFor();
  assert.equal(await panel("Creep curves").locator("canvas").count(), 0);
  await panel("Stresses").getByText(/No stresses: friction.coefficient = -0.3/).waitFor();
  await panel("Stresses").locator("canvas[aria-label='no stresses']").waitFor();
  await field(page, "friction.coefficient", "0.3");
  await panel("Creep curves").locator("canvas").waitFor();
  await panel("Stresses").locator("canvas[aria-label*=von_mises]").waitFor();
  assert.equal(await old.count(), 0);
  assert.equal(await page.getByText("No stresses").count(), 0);
  await page.getByRole("button", { name: /add the creep-force table/ }).click();
  await row(page, "longitudinal force fx", 3);
  await field(page, "body2.transverse_radius", "3"); // an ellipse longer than those of the table
  await page.locator("section:not([hidden]) .remarks").getByText(/^table: out of range: a\/b = .* is beyond the creep-force table's range/).waitFor();
  await panel("Creep curves").getByText("table: 41 of 41 points are left out, out of range").waitFor();
  await panel("Creep curves").locator("canvas").waitFor(); // of the other theories
  await page.getByRole("tab", { name: "Wheel on rail" }).click();
  await panel("Equivalent conicity").locator("canvas").waitFor();
  await railField(page, "track.gauge", "1420");
  await panel("Equivalent conicity").getByText("fewer than two values").waitFor();
  assert.equal(await panel("Equivalent conicity").locator("canvas").count(), 0);
  await railField(page, "track.gauge", "1435");
  await panel("Equivalent conicity").locator("canvas").waitFor();
  await page.getByRole("tab", { name: "Start and stop" }).click();
  await page.getByText("at rest, forces put on").waitFor({ timeout: 60000 });
  await page.locator("#start-friction-coefficient").fill("-1");
  await page.locator("#start-friction-coefficient").press("Enter");
  await old.getByText("those of the last case without errors").waitFor();
  assert.deepEqual(errors, []);
  await page.close();
});

test("conicity is asked anew only where what it depends on changes", async () => {
  const { page } = await opened("", undefined, countRequests);
  await page.getByRole("tab", { name: "Wheel on rail" }).click();
  await page.locator("section:not([hidden]) .panel", { hasText: "Equivalent conicity" }).locator("canvas").waitFor();
  const asked = () => page.evaluate(() => (window as unknown as Counting).asked.splice(0));
  await asked();
  for (const [key, text] of [["wheel.vertical_force", "60"], ["wheel.forward_velocity", "200"], ["friction.coefficient", "0.4"], ["wheel.lateral", "1"], ["wheel.yaw", "1"]] as const)
    await railField(page, key, text);
  await settled(page);
  const others = await asked();
  assert.ok(others.includes("solve") && !others.includes("conicity"), others.join(", "));
  await railField(page, "track.gauge", "1433");
  await page.waitForFunction(() => (window as unknown as Counting).asked.includes("conicity"));
  await page.close();
});

test("profiles from files: a good one is taken, others are refused in the reader's words", async () => {
  const { page } = await opened();
  await page.getByRole("tab", { name: "Wheel on rail" }).click();
  await row(page, "lateral force");
  const give = (name: string, content: Buffer) => page.locator("#file-wheel").setInputFiles({ name, mimeType: "text/plain", buffer: content });
  await give("bad.prw", Buffer.from("x y z"));
  await page.getByText(/bad\.prw:1: /).waitFor();
  await give("noise.prw", Buffer.from(Array.from({ length: 4000 }, (_, i) => (i * 7919) % 256)));
  await page.getByText(/noise\.prw/).waitFor();
  await give("huge.prw", Buffer.alloc(21e6, "1 2\n"));
  await page.getByText("huge.prw has 21 MB").waitFor();
  await give("long.prw", Buffer.alloc(10e6, "1.0 2.0\n"));
  await page.getByText(/long\.prw/).waitFor({ timeout: 120000 });
  await give("worn.prw", readFileSync(path.join(profiles, "s1002.prw")));
  await page.getByText("Wheel worn.prw on rail 60e1.prr").waitFor();
  await page.close();
});

/** The y and z of a profile's points [mm], as its file has them. */
function points(name: string): [number, number][] {
  return [...readFileSync(path.join(profiles, name), "utf8").matchAll(/^\s*(-?[\d.]+)\s+(-?[\d.]+)/gm)].map(([, y, z]) => [Number(y), Number(z)]);
}

test("a reversed or mirrored profile is the same one, and the page tells what was done to it", async () => {
  const { page } = await opened();
  await page.getByRole("tab", { name: "Wheel on rail" }).click();
  const lateral = (await row(page, "lateral force"))[0]!;
  const text = (of: [number, number][]) => Buffer.from(of.map((point) => point.join(" ")).join("\n"));
  const wheel = points("s1002.prw");
  for (const [name, of, told] of [
    ["mirrored.txt", wheel.map(([y, z]) => [-y, z] as [number, number]), "mirrored: the file's y runs to the gauge side"],
    ["reversed.txt", [...wheel].reverse(), "y runs to the field side, by the position of the flange"],
  ] as const) {
    await page.locator("#file-wheel").setInputFiles({ name, mimeType: "text/plain", buffer: text(of) });
    await page.getByText(told).waitFor();
    await settled(page);
    near((await row(page, "lateral force"))[0]!, lateral);
  }
  await page.close();
});

test("profiles dropped together are both taken; one of the same name takes the place of the last", async () => {
  const { page } = await opened("", undefined, countRequests);
  await page.getByRole("tab", { name: "Wheel on rail" }).click();
  const first = (await row(page, "lateral force"))[0]!;
  const drop = (files: [string, string][]) => page.evaluate((given) => {
    const dataTransfer = new DataTransfer();
    for (const [name, text] of given) dataTransfer.items.add(new File([text], name));
    const lateral = document.querySelector<HTMLInputElement>("#rail-wheel-lateral")!; // the core is busy meanwhile
    lateral.value = "4";
    lateral.dispatchEvent(new Event("change"));
    document.querySelector("section:not([hidden]) canvas.map")!.dispatchEvent(new DragEvent("drop", { dataTransfer, bubbles: true, cancelable: true }));
  }, files);
  const own = (name: string) => readFileSync(path.join(profiles, name), "utf8");
  await drop([["own.prw", own("s1002.prw")], ["own.prr", own("60e1.prr")]]);
  await page.getByText("Wheel own.prw on rail own.prr").waitFor();
  await settled(page);
  await page.evaluate(() => { (window as unknown as Counting).asked.length = 0; });
  const steeper = own("s1002.prw").replace(/^(\s*)(-?[\d.]+)(\s+)(-?[\d.]+)/gm, (_, before: string, y: string, between: string, z: string) =>
    `${before}${y}${between}${Number(z) + 0.02 * Number(y)}`);
  const give = (name: string) => page.locator("#file-wheel").setInputFiles({ name, mimeType: "text/plain", buffer: Buffer.from(steeper) });
  await give("own.prw");
  await page.waitForFunction(() => (window as unknown as Counting).asked.includes("conicity"), undefined, { timeout: 20000 });
  await give("s1002.prw"); // a user's file with a built-in name, which the button puts away
  await page.getByText("Wheel s1002.prw on rail own.prr").waitFor();
  await page.getByRole("button", { name: "S1002 on 60E1 again" }).click();
  await page.getByText("Wheel s1002.prw on rail 60e1.prr").waitFor();
  await page.locator("#rail-wheel-lateral").fill("3");
  await page.locator("#rail-wheel-lateral").press("Enter");
  await settled(page);
  near((await row(page, "lateral force"))[0]!, first);
  await page.close();
});

interface Counting { asked: string[]; hiddenNow: boolean }
const countRequests = `
  window.asked = [];
  const post = Worker.prototype.postMessage;
  Worker.prototype.postMessage = function (message) { window.asked.push(message.request ? JSON.parse(message.request).call : "put"); return post.call(this, message); };`;

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
  assert.equal(await page.locator("#rail-wheel-lateral").inputValue(), "3.05");
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
  assert.ok(Math.abs((await lateral() - 3.05) - 12e3 / scale) < 0.05, `${await lateral()} mm after 12 pixels`); // of the hand and of the wheel
  const before = await lateral();
  await page.keyboard.down("Shift");
  for (let i = 0; i <= 20; ++i) await page.mouse.move(box.x + 288 + i / 2, box.y + 150);
  await page.keyboard.up("Shift");
  assert.ok(Math.abs((before - await lateral()) - 1e3 / scale) < 0.03, `${await lateral()} mm after 10 pixels with Shift`);
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
    return { id: text.id, title: (at as HTMLElement).title, told: told.join(""), unit: at.querySelector(".unit")!.textContent };
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
  const lateral = page.locator("#rail-wheel-lateral"), seen = page.locator("section:not([hidden])"), preset = (name: string) => seen.getByRole("button", { name, exact: true }).click();
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
  await page.waitForFunction(() => document.querySelector<HTMLInputElement>("#rail-wheel-yaw")!.value === "1");
  assert.equal(await lateral.inputValue(), "5");
  await undo.click();
  await page.waitForFunction(() => document.querySelector<HTMLInputElement>("#rail-wheel-lateral")!.value === "3");
  await page.getByRole("button", { name: "redo", exact: true }).click();
  await page.waitForFunction(() => document.querySelector<HTMLInputElement>("#rail-wheel-lateral")!.value === "5");
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
  assert.equal(await lateral.inputValue(), "5");
  await page.getByRole("button", { name: "End", exact: true }).click();
  assert.equal(await seen.locator(".keys .before").locator("visible=true").count(), 0);
  await page.getByRole("button", { name: "Reset all" }).click();
  assert.equal(await lateral.inputValue(), "3");
  assert.deepEqual(errors, []);
  await page.close();
});

test("the tour has five steps and can be left at any of them; a ? tells what an input means, as its text and units", async () => {
  const { page, errors } = await opened();
  const tour = page.getByRole("dialog", { name: "tour" }), next = tour.getByRole("button", { name: /Next|Done/ });
  await page.getByRole("button", { name: "take the tour" }).click();
  for (let step = 1; step <= 5; ++step) {
    await tour.getByText(`${step} of 5`).waitFor();
    assert.ok(await page.locator(".lit").isVisible());
    await next.click();
  }
  assert.ok(await tour.isHidden());
  await page.getByRole("button", { name: "take the tour" }).click();
  await page.keyboard.press("Escape");
  assert.ok(await tour.isHidden());
  assert.equal(await page.locator(".lit").count(), 0);
  const help = page.getByText("A turned wheel rubs sideways");
  assert.ok(await help.isHidden());
  await page.getByRole("button", { name: "what is Turned (yaw)?" }).click();
  assert.ok(await help.isVisible());
  await page.locator("#rail-wheel-yaw-help").getByText("yaw of the wheelset; positive turns to the left [rad], in [-1, 1]").waitFor();
  await page.keyboard.press("Escape");
  assert.ok(await help.isHidden());
  assert.deepEqual(errors, []);
  await page.close();
});

test("what is wrong is said in the picture's words, and the page does what it advises", async () => {
  const { page, errors } = await opened();
  await page.getByRole("tab", { name: "Wheel on rail" }).click();
  await settled(page);
  const advice = page.locator("section:not([hidden]) .remarks"), does = (name: string) => advice.getByRole("button", { name }).click();
  await railField(page, "wheel.lateral", "30");
  await advice.getByText("it has derailed").waitFor();
  await does("Back on the rail");
  assert.equal(await page.locator("#rail-wheel-lateral").inputValue(), "3");
  await advice.waitFor({ state: "hidden" });
  await railField(page, "wheel.lateral", "6.3");
  await page.getByLabel("Shape of the patch", { exact: true }).selectOption("flat");
  await advice.getByText("solved as flat").waitFor();
  await does("Use the curved shape");
  await advice.getByText("solved as flat").waitFor({ state: "detached" });
  assert.equal(await page.getByLabel("Shape of the patch", { exact: true }).inputValue(), "curved");
  await page.getByLabel("Smooth the wheel", { exact: true }).selectOption("0.004");
  await settled(page);
  assert.match(readFileSync(await saved(page, "case as TOML"), "utf8"), /smoothing_length = "4 mm"/);
  await page.locator("section:not([hidden])").getByRole("button", { name: "Measured profile" }).click();
  await page.getByLabel("Smooth the wheel", { exact: true }).selectOption("0");
  await advice.getByText(/measured_wheel.txt: the points scatter by .* leave smoothing_length out/).waitFor();
  await does("Smooth the wheel");
  await advice.waitFor({ state: "hidden" });
  assert.equal(await page.getByLabel("Smooth the wheel", { exact: true }).inputValue(), "");
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

test("axe-core finds nothing in any view, wide and light, narrow and dark; each field is one stop of the keyboard", async () => {
  interface Found { violations: { id: string; nodes: { html: string }[] }[] }
  for (const [width, scheme] of [[1400, "light"], [400, "dark"]] as const) {
    const { page, errors } = await opened("#", { width, height: 900 }, undefined, scheme);
    await page.addScriptTag({ path: createRequire(import.meta.url).resolve("axe-core/axe.min.js") });
    for (const view of ["Wheel on rail", "Contact", "Start and stop", "Nip"]) {
      await page.getByRole("tab", { name: view }).click();
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
      if (shots) await page.waitForTimeout(4000); // for what moves until it rests
      const unnamed = await page.evaluate(() => [...document.querySelectorAll<HTMLElement>("input, select, button, canvas[role=img]")].filter((at) =>
        at.offsetParent && !(at.getAttribute("aria-label") ?? at.textContent ?? "").trim() && !document.querySelector(`label[for="${at.id}"]`)).map((at) => at.outerHTML));
      assert.deepEqual(unnamed, []);
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `${view} is wider than ${width}`);
      if (width === 400) await inSight(page, view);
      if (shots) await page.screenshot({ path: path.join(shots, `${view.replaceAll(" ", "_")}_${width}.png`), fullPage: true });
      assert.deepEqual(errors, []);
      await page.close();
    }
});
