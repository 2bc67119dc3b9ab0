// Frames of the explorer's page while each of its controls is dragged, in Chromium without WebGL:
// node bench/explorer_frames.js build/explorer/page [VIEW...]
// `median` and `longest` are times between frames, which other programs lengthen; `task` is the longest piece of work of the
// page's thread by its processor time, which they hardly do, or by the clock if that is shorter.
"use strict";
const { createRequire } = require("module");
const path = require("path");

const [built, ...wanted] = process.argv.slice(2);
const { chromium } = createRequire(path.join(__dirname, "../explorer/page/package.json"))("playwright-core");
const executablePath = process.env.CHROMIUM || "/usr/bin/chromium";
const steps = 90; // of the pointer, one a frame
const views = ["Wheel on rail", "Contact", "Start and stop", "Nip"];

const median = (values) => values.slice().sort((a, b) => a - b)[values.length >> 1];
const row = (name, { times, task }) => console.log(`${name.padEnd(44)}${[median(times), Math.max(...times), task].map((of) => of.toFixed(1).padStart(9)).join("")}${String(times.length).padStart(8)}`);

/** The longest task [ms] of the page's thread in a trace. */
function longestTask({ traceEvents }) {
  const threads = traceEvents.filter(({ name, args }) => name === "thread_name" && args.name === "CrRendererMain").map(({ pid, tid }) => `${pid} ${tid}`);
  const tasks = traceEvents.filter(({ name, ph, pid, tid }) => ph === "X" && name.endsWith("RunTask") && threads.includes(`${pid} ${tid}`));
  if (tasks.length < steps) throw new Error(`${tasks.length} tasks in the trace`);
  return tasks.reduce((most, { dur, tdur = 0 }) => Math.max(most, Math.min(dur, tdur)), 0) / 1e3; // a virtual machine's clock of a thread may jump
}

/** Times of frames and the longest task [ms] while the pointer goes from one place to another and back. */
async function dragged(page, [fromX, fromY], [toX, toY]) {
  const browser = page.context().browser();
  await page.mouse.move(fromX, fromY);
  await page.mouse.down();
  await browser.startTracing(page, { categories: ["toplevel", "__metadata"] });
  await page.evaluate(() => {
    const times = (window.times = []);
    let last = 0;
    const frame = (now) => { if (last) times.push(now - last); last = now; if (window.times === times) requestAnimationFrame(frame); };
    requestAnimationFrame(frame);
  });
  for (let i = 1; i <= steps; ++i) {
    const share = Math.sin((Math.PI * i) / steps);
    await page.mouse.move(fromX + share * (toX - fromX), fromY + share * (toY - fromY));
    await page.evaluate(() => new Promise(requestAnimationFrame));
  }
  const times = await page.evaluate(() => { const all = window.times; window.times = undefined; return all; });
  const task = longestTask(JSON.parse((await browser.stopTracing()).toString()));
  await page.mouse.up();
  return { times: times.slice(1), task };
}

async function settle(page) {
  await page.waitForFunction(() => document.body.ariaBusy !== "true");
  await page.waitForTimeout(600);
  await page.waitForFunction(() => document.body.ariaBusy !== "true", undefined, { timeout: 60000 });
}

/** What can be dragged in a view: sliders, by the names of their fields, pictures and charts. */
async function placesOf(page) {
  return page.evaluate(() => {
    const places = [], section = document.querySelector("section:not([hidden])");
    for (const before of document.querySelectorAll("[data-place]")) delete before.dataset.place;
    const seen = (at) => at.getClientRects().length > 0;
    [...section.querySelectorAll("input[type=range], canvas.map[tabindex], .u-over")].filter(seen).forEach((at, k) => {
      at.dataset.place = String(k);
      const isSlider = at.type === "range", isChart = at.className === "u-over";
      if (isChart && at.style.cursor !== "ew-resize") return;
      const title = isSlider ? at.ariaLabel : isChart ? `chart: ${at.closest(".panel").querySelector("h3")?.textContent}` : "picture";
      places.push({ title, selector: `[data-place="${k}"]`, isSlider });
    });
    return places;
  });
}

async function main() {
  const browser = await chromium.launch({ executablePath, args: ["--no-sandbox", "--disable-gpu", "--disable-3d-apis", "--no-first-run"] });
  const page = await browser.newPage({ viewport: { width: 1400, height: 900 } });
  page.on("pageerror", (error) => { throw error; });
  await page.goto(`file://${path.resolve(built)}/index.html`);
  console.log(`${"ms while dragging".padEnd(44)}   median  longest     task  frames`);
  for (const view of views.filter((name) => !wanted.length || wanted.includes(name))) {
    await page.getByRole("tab", { name: view }).click();
    await settle(page);
    console.log(view);
    const count = (await placesOf(page)).length;
    for (let k = 0; k < count; ++k) {
      const { title, selector, isSlider } = (await placesOf(page))[k]; // charts are made anew by some results
      const at = page.locator(`section:not([hidden]) ${selector}`);
      await at.scrollIntoViewIfNeeded();
      const box = await at.boundingBox();
      const share = isSlider ? await at.evaluate((slider) => (Number(slider.value) - Number(slider.min)) / (Number(slider.max) - Number(slider.min))) : 0.4;
      const from = isSlider ? [box.x + 8 + share * (box.width - 16), box.y + box.height / 2] : [box.x + 0.4 * box.width, box.y + Math.min(150, box.height / 2)];
      const far = isSlider ? (share < 0.5 ? 1 : -1) * 0.45 * box.width : 40;
      row(`  ${title}`, await dragged(page, from, [from[0] + far, from[1]]));
      await page.getByRole("button", { name: "Reset all" }).click();
      await settle(page);
    }
  }
  await browser.close();
}
main();
