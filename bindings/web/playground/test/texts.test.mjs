// Every language has the same texts, and the page has a text for everything that asks for one.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import de from "../text/de.js";
import en from "../text/en.js";

const keys = (texts) => Object.keys(texts).sort();

test("German and English have the same keys, and none is empty", () => {
  assert.deepEqual(keys(de), keys(en));
  for (const texts of [de, en]) {
    for (const [key, text] of Object.entries(texts)) assert.ok(text.trim().length > 0, key);
  }
});

test("both languages fill in the same values", () => {
  const values = (text) => [...new Set(text.match(/\{\w+\}/g))].sort();
  for (const key of Object.keys(en)) assert.deepEqual(values(de[key]), values(en[key]), key);
});

test("the page asks for texts that there are", () => {
  const template = readFileSync(new URL("../page.html", import.meta.url), "utf8");
  const wanted = [...template.matchAll(/data-(?:t|label)="(\w+)"/g)].map(([, key]) => key);
  assert.ok(wanted.length > 50);
  for (const key of wanted) assert.ok(key in en, key);
});

test("docs/playground.html is made from these texts", () => {
  const made = readFileSync(new URL("../../../../docs/playground.html", import.meta.url), "utf8");
  // Letters beyond ASCII are written as \xE4 or \u03BC.
  const page = made.replace(/\\(?:x|u)((?<=x)[\dA-F]{2}|[\dA-F]{4})/gi, (_, code) =>
    String.fromCharCode(parseInt(code, 16)),
  );
  for (const texts of [de, en]) {
    for (const [key, text] of Object.entries(texts)) {
      // Quotation marks and line ends are written in several ways.
      const parts = text.split(/["'`\n\\]|<\/script/);
      for (const part of parts)
        assert.ok(page.includes(part), `${key}: node bindings/web/playground/build.mjs`);
    }
  }
});
