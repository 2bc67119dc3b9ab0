// What the tests of the page share: the page in a real browser, opened as a file, and the program beside it.
//   MICROSLIP_PAGE folder of index.html; MICROSLIP the program; PROFILES folder of the examples' profiles; CHROMIUM the browser

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, before } from "node:test";
import { chromium, type Browser, type Download, type Page } from "playwright-core";

export const { MICROSLIP_PAGE: folder = "", MICROSLIP: named = "", PROFILES: profiles = "", CHROMIUM: executablePath = "/usr/bin/chromium" } = process.env;
export const program = path.resolve(named);
export const address = `file://${path.resolve(folder)}/index.html`;
export const scratch = mkdtempSync(path.join(tmpdir(), "explorer-"));
export let browser: Browser;

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

export interface Opened { page: Page; errors: string[]; requests: string[] }

export async function opened(link = "", size = { width: 1400, height: 900 }, script?: string, colorScheme: "light" | "dark" = "light", reducedMotion: "reduce" | "no-preference" = "no-preference"): Promise<Opened> {
  const page = await browser.newPage({ viewport: size, colorScheme, reducedMotion });
  const errors: string[] = [], requests: string[] = [];
  page.on("pageerror", (error) => errors.push(error.message));
  page.on("request", (request) => requests.push(request.url()));
  if (script) await page.addInitScript(script);
  await page.goto(address + link);
  if (link === "") await page.getByRole("tab", { name: "Contact" }).click();
  return { page, errors, requests };
}

/** Numbers of a row of the table that is shown, once all columns are there. */
export async function row(page: Page, name: string, columns = 2): Promise<number[]> {
  const cells = page.locator("section:not([hidden]) .numbers tr", { hasText: name }).locator("td:not(.unit)");
  await page.waitForFunction(([text, count]) => {
    const found = [...document.querySelectorAll("section:not([hidden]) .numbers tr")].find((tr) => tr.textContent?.includes(text as string));
    const values = [...(found?.querySelectorAll("td:not(.unit)") ?? [])].map((cell) => cell.textContent);
    return values.length >= (count as number) && !values.includes("…");
  }, [name, columns] as const, { timeout: 60000 });
  return (await cells.allTextContents()).map(Number);
}

export async function field(page: Page, key: string, text: string): Promise<void> {
  const input = page.locator(`#contact-${key.replaceAll(".", "-")}`);
  await input.fill(text);
  await input.press("Enter");
  await input.blur();
}

export async function railField(page: Page, key: string, text: string): Promise<void> {
  const input = page.locator(`#rail-${key.replaceAll(".", "-")}`);
  await input.fill(text);
  await input.press("Enter");
}

export async function nipField(page: Page, key: string, text: string): Promise<void> {
  const input = page.locator(`#nip-${key.replaceAll(".", "-")}`);
  await input.fill(text);
  await input.press("Enter");
}

/** Nothing is computed, and nothing has been for longer and for more frames than the page puts off what is not urgent. */
export async function settled(page: { evaluate: (run: (given: undefined) => Promise<void>, given: undefined) => Promise<void> }): Promise<void> {
  await page.evaluate(() => new Promise((resolve, reject) => {
    const begun = performance.now();
    let since = begun, frames = 0;
    const frame = () => {
      const now = performance.now();
      ++frames;
      if (document.body.ariaBusy === "true") [since, frames] = [now, 0];
      if (frames > 5 && now - since > 700) resolve();
      else if (now - begun > 120000) reject(new Error("the page is still busy after two minutes"));
      else requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
  }), undefined);
}

/** Waits until a field or a list has this value. */
export async function has(page: Page, selector: string, value: string): Promise<void> {
  await page.waitForFunction(([of, wanted]) => document.querySelector<HTMLInputElement>(of!)?.value === wanted, [selector, value]);
}

/** Waits until a field has a number that is as near to this one. */
export async function hasNumber(page: Page, selector: string, value: number, within: number): Promise<void> {
  await page.waitForFunction(([of, wanted, nearly]) => {
    const input = document.querySelector<HTMLInputElement>(of as string);
    return input && Math.abs(Number(input.value) - (wanted as number)) < (nearly as number);
  }, [selector, value, within] as const);
}

export async function saved(page: Page, name: string): Promise<string> {
  const download = page.waitForEvent("download");
  await page.getByText("Export ▾").click();
  await page.getByRole("button", { name, exact: true }).click();
  const to = path.join(scratch, ((await download) as Download).suggestedFilename());
  await ((await download) as Download).saveAs(to);
  return to;
}

export function near(found: number, wanted: number): void {
  assert.ok(Math.abs(found - wanted) <= 6e-4 * Math.abs(wanted) + 1e-12, `${found} on the page, ${wanted} by the program`);
}

export function solvedByProgram(file: string): Record<string, Record<string, number & number[]>> {
  return JSON.parse(execFileSync(program, ["solve", file, "--json"], { cwd: scratch, encoding: "utf8", stdio: "pipe", maxBuffer: 1e9 })) as Record<string, Record<string, number & number[]>>;
}

export interface Counting { asked: string[]; hiddenNow: boolean }
export const countRequests = `
  window.asked = [];
  const post = Worker.prototype.postMessage;
  Worker.prototype.postMessage = function (message) { window.asked.push(message.request ? JSON.parse(message.request).call : "put"); return post.call(this, message); };`;
