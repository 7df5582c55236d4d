// Frames a second of the player in headless Chromium, rendered in software.
//
//   node benches/player.mjs PAGE [WIDTH HEIGHT]
//
// PAGE is a view.html of a powder. Every frame is shown in turn, as scrubbing does, and a pixel read
// back, so that the drawing is over when the clock stops. Prints frames a second for each way to
// look: the median of the sweeps with the lowest and the highest, and the slowest single frame.

import { spawn } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

const [page, width = "1000", height = "690"] = process.argv.slice(2);
if (!page || !(width > 0 && height > 0)) {
  console.error("usage: node benches/player.mjs PAGE [WIDTH HEIGHT]");
  process.exit(2);
}
const SWEEPS = 5;
const OPTIONS = ["--headless=new", "--no-sandbox", "--disable-gpu-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-background-networking", "--no-first-run", "--hide-scrollbars", "--remote-debugging-pipe"];

/** A browser with one page, asked over a pipe. */
class Browser {
  constructor(home) {
    this.child = spawn("chromium", [...OPTIONS, `--user-data-dir=${home}`], { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] });
    this.child.on("error", (error) => { throw error; });
    [this.asked, this.waiting, this.rest] = [0, new Map(), ""];
    this.child.stdio[4].setEncoding("utf8").on("data", (text) => this.hear(text));
  }

  hear(text) {
    const messages = (this.rest + text).split("\0");
    this.rest = messages.pop();
    for (const message of messages.map((each) => JSON.parse(each))) {
      this.waiting.get(message.id)?.(message);
      this.waiting.delete(message.id);
    }
  }

  async call(method, params = {}) {
    const id = ++this.asked;
    const answer = new Promise((done) => this.waiting.set(id, done));
    this.child.stdio[3].write(`${JSON.stringify({ id, method, params, sessionId: this.session })}\0`);
    const { error, result } = await answer;
    if (error) throw new Error(`${method}: ${error.message}`);
    return result;
  }

  async value(expression) {
    const { result, exceptionDetails } = await this.call("Runtime.evaluate", { expression, awaitPromise: true, returnByValue: true });
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }
}

/** Runs in the page: shows every frame, and tells the milliseconds that each took. */
async function sweep(look, width, height) {
  const { player } = document.querySelector(".tribos-player");
  Object.assign(player.stage.style, { width: `${width}px`, height: `${height}px`, aspectRatio: "auto" });
  player.choose(look);
  await new Promise((done) => setTimeout(done, 500));
  const { gl } = player.view;
  const pixel = new Uint8Array(4);
  const times = player.meta.frames.map((_, frame) => {
    const start = performance.now();
    player.show(frame);
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    return performance.now() - start;
  });
  return { times, size: [player.canvas.width, player.canvas.height] };
}

const home = mkdtempSync(join(tmpdir(), "player-"));
const browser = new Browser(home);
try {
  const { product } = await browser.call("Browser.getVersion");
  const { targetId } = await browser.call("Target.createTarget", { url: "about:blank" });
  browser.session = (await browser.call("Target.attachToTarget", { targetId, flatten: true })).sessionId;
  await browser.call("Emulation.setDeviceMetricsOverride", { width: 2 * width, height: 2 * height, deviceScaleFactor: 1, mobile: false });
  const opened = performance.now();
  await browser.call("Page.navigate", { url: pathToFileURL(resolve(page)).href });
  while ((await browser.value("document.querySelector('.tribos-player')?.dataset.state ?? ''").catch(() => "")) !== "ready") {
    if (performance.now() - opened > 60e3) throw new Error(`${page}: no player is ready after a minute`);
    await new Promise((done) => setTimeout(done, 20));
  }
  const ready = (performance.now() - opened) / 1000;
  const looks = await browser.value("document.querySelector('.tribos-player').player.view.presets()");
  const [frames, particles] = await browser.value("(({ frames, n }) => [frames, n])(document.querySelector('.tribos-player').player.view.film)");
  const rows = [];
  let size;
  for (const [name, look] of Object.entries(looks)) {
    const rates = [];
    let slowest = 0;
    for (let k = 0; k < SWEEPS; k += 1) {
      const seen = await browser.value(`(${sweep})(${JSON.stringify(look)}, ${Number(width)}, ${Number(height)})`);
      size = seen.size;
      rates.push((1000 * frames) / seen.times.reduce((sum, time) => sum + time, 0));
      slowest = Math.max(slowest, ...seen.times);
    }
    rates.sort((a, b) => a - b);
    const [low, middle, high] = [0, SWEEPS >> 1, SWEEPS - 1].map((k) => rates[k].toFixed(0));
    rows.push(`| ${name} | ${middle} (${low} to ${high}) | ${slowest.toFixed(0)} |`);
  }
  console.log(`${product}, SwiftShader: ${particles} particles, ${frames} frames, ${size.join(" × ")}; ready after ${ready.toFixed(1)} s\n`);
  console.log(["| view | frames/s | slowest frame, ms |", "|---|---|---|", ...rows].join("\n"));
} finally {
  browser.child.kill();
  await new Promise((done) => browser.child.once("exit", done));
  rmSync(home, { recursive: true, force: true, maxRetries: 5 });
}
