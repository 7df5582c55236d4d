// Pushes of round bodies, and what the text says of the ellipsoid.

import assert from "node:assert/strict";
import { test } from "node:test";
import "../../test/built.mjs";
import { inBrowser, open } from "./browser.mjs";
import { circleContactAt, wrenchAt } from "../src/push.js";
import * as kernel from "../../all.js";

await kernel.init();
const surface = kernel.disk({ radius: 1, mu: 1 }).limitSurface(1);

test("a push along the normal of a puck has no torque and no spin, at any place", () => {
  for (let percent = 0; percent <= 100; percent += 1) {
    const push = wrenchAt(circleContactAt(percent / 100), 0);
    assert.equal(push.torque, 0, `${percent} %`);
    assert.equal(surface.normal(push).spin, 0, `${percent} %`);
  }
});

test("the ellipsoid gives a pushed disk between 9/16 and 3/2 of its spin", () => {
  const ellipsoid = surface.ellipsoid();
  const spinOf = ({ vx, spin }) => spin / vx;
  const ratio = (torque) => {
    const push = { fx: 1, fy: 0, torque };
    return spinOf(ellipsoid.normal(push)) / spinOf(surface.normal(push));
  };
  assert.ok(Math.abs(ratio(1e-4) - 9 / 16) < 1e-6);
  assert.ok(Math.abs(ratio(1e4) - 3 / 2) < 1e-6);
  for (let power = -3.9; power < 4; power += 0.1) {
    assert.ok(ratio(10 ** power) > 9 / 16 && ratio(10 ** power) < 3 / 2, `torque 1e${power}`);
  }
});

inBrowser("the panel shows no torque for a normal push on a puck", async (browser) => {
  const { page, errors } = await open(browser, { hash: "#surface", motion: "reduce" });
  await page.waitForFunction(() => document.querySelector("#surface-exact td").textContent !== "");
  const set = (id, value, event) =>
    page.$eval(
      `#${id}`,
      (input, [wanted, name]) => {
        input.value = wanted;
        input.dispatchEvent(new Event(name));
      },
      [value, event],
    );
  await set("surface-shape", "puck", "change");
  await set("surface-angle", "0", "input");
  for (const part of ["0", "23", "26", "50", "77", "100"]) {
    await set("surface-part", part, "input");
    const cells = await page.$$eval("#surface-exact td", (found) => found.map((cell) => cell.textContent));
    assert.deepEqual(cells, ["1.000", "0.000", "0.000", "∞"], `${part} %`);
  }
  assert.deepEqual(errors, []);
});
