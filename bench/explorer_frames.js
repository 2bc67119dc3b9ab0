// Frames of the explorer's page while each of its controls is dragged, in Chromium without WebGL:
// node bench/explorer_frames.js build/explorer/page [VIEW...]
"use strict";
const { createRequire } = require("module");
const path = require("path");

const [built, ...wanted] = process.argv.slice(2);
const { chromium } = createRequire(path.join(__dirname, "../explorer/page/package.json"))("playwright-core");
const executablePath = process.env.CHROMIUM || "/usr/bin/chromium";
const steps = 90; // of the pointer, one a frame
const views = ["Wheel on rail", "Contact", "Start and stop", "Nip"];

const median = (values) => values.slice().sort((a, b) => a - b)[values.length >> 1];
const row = (name, times) => console.log(`${name.padEnd(44)}${median(times).toFixed(1).padStart(8)}${Math.max(...times).toFixed(1).padStart(9)}${String(times.length).padStart(8)}`);

/** Times of frames [ms] while the pointer goes from one place to another and back. */
async function dragged(page, [fromX, fromY], [toX, toY]) {
  await page.mouse.move(fromX, fromY);
  await page.mouse.down();
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
  await page.mouse.up();
  return times.slice(1);
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
  await page.goto(`file://${path.resolve(built)}/index.html`);
  console.log(`${"ms between frames while dragging".padEnd(44)}  median  longest  frames`);
  for (const view of views.filter((name) => !wanted.length || wanted.includes(name))) {
    await page.getByRole("tab", { name: view }).click();
    await settle(page);
    console.log(view);
    for (const { title, selector, isSlider } of await placesOf(page)) {
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
