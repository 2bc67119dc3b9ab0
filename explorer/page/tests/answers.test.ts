// The page's numbers beside the program's: every view, links, case files and profiles, refusals.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { sheetsOf } from "../src/sheet.ts";
import type { Page } from "playwright-core";
import { program, scratch, browser, opened, row, field, railField, nipField, settled, has, saved, near, solvedByProgram, type Counting, countRequests, profiles } from "./browser.ts";

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
  await page.waitForFunction(() => Math.abs(Number(document.querySelector("section:not([hidden]) .numbers tbody td")?.textContent)) < 1e-3); // [kN], of four digits
  const approach = (await row(page, "approach over thickness"))[0]!;
  for (const [stiffness, inputs] of [["young_modulus", "3.605"], ["shear_modulus", "1.202"], ["hardness", "60"]] as const) { // the same cover
    await page.getByLabel("stiffness by").selectOption(stiffness);
    await settled(page);
    await has(page, `#nip-body2-layers-1-${stiffness}`, inputs);
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
  await has(page, "#nip-load-normal_force", "6");
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
  await has(second.page, "#contact-load-normal_force", "55.5");
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
  await has(page, "#start-motion-creepage_lateral", "0.05");
  await page.locator("#start-motion-force_longitudinal").waitFor({ state: "hidden" });
  const last = readFileSync(await saved(page, "forces as CSV"), "utf8").trim().split("\n").at(-1)!.split(",").map(Number);
  near(last[1]! * 1e3, solved("starting_to_roll.toml").exact!.fx!);
  await dropped(page, [["wheel_on_rail.toml", example("wheel_on_rail.toml")]]);
  await page.getByText("material.hardness = 3000000000").waitFor();
  await settled(page);
  near((await row(page, "lateral force"))[0]! * 1e3, solved("wheel_on_rail.toml").wheel!.force_y![0]!);
  await dropped(page, [["rubber_roller.toml", example("rubber_roller.toml")]]);
  await page.getByText("ms on 80 elements").waitFor({ timeout: 60000 });
  await page.getByText("those of a metre along them").waitFor();
  await has(page, "#nip-body2-layers-1-relaxation_shares-2", "0.1");
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
  await page.locator("#contact-load-normal_force[aria-invalid]").waitFor();
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
  await page.locator("#contact-body1-rolling_radius").waitFor({ state: "hidden" });
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
  await has(second.page, "#choice-given-by", "ellipse");
  await has(second.page, "#contact-ellipse-b", "3");
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
  await has(page, "#contact-body2-rolling_radius", "inf");
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
  await panel("Creep curves").locator("canvas").waitFor({ state: "detached" });
  await panel("Stresses").getByText(/No stresses: friction.coefficient = -0.3/).waitFor();
  await panel("Stresses").locator("canvas[aria-label='no stresses']").waitFor();
  await field(page, "friction.coefficient", "0.3");
  await panel("Creep curves").locator("canvas").waitFor();
  await panel("Stresses").locator("canvas[aria-label*=von_mises]").waitFor();
  await old.waitFor({ state: "detached" });
  await page.getByText("No stresses").waitFor({ state: "detached" });
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
  await panel("Equivalent conicity").locator("canvas").waitFor({ state: "detached" });
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
