// Boxes with the command and the Python program of a panel, to be copied.

import { fill, keepWords, t } from "./language.js";

const KINDS = ["shell", "python"];

/** Fills the boxes of a panel; returns a function that shows a command and a program in them. */
export function programBox(panel) {
  const box = document.querySelector(`#panel-${panel} .programs`);
  const boxOf = (kind) => `<button type="button" data-t="copy_${kind}"></button> <span role="status"></span>
<pre><code class="${kind}"></code></pre>`;
  box.innerHTML = KINDS.map(boxOf).join("");
  fill(box.querySelectorAll("button"));
  const codes = box.querySelectorAll("code");
  const said = box.querySelectorAll("span");
  box.querySelectorAll("button").forEach((button, index) =>
    button.addEventListener("click", async () => {
      said[index].textContent = t((await copied(codes[index])) ? "copied" : "selected");
    }),
  );
  return (programs) =>
    KINDS.forEach((kind, index) => {
      if (codes[index].textContent === programs[kind]) return;
      codes[index].textContent = programs[kind];
      keepWords(codes[index]);
      said[index].textContent = "";
    });
}

/** Copies a text, or selects it where nothing lets us. */
async function copied(code) {
  const text = code.textContent;
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    // A page from the disk may have no clipboard.
    getSelection().selectAllChildren(code);
    const write = (event) => {
      event.clipboardData.setData("text/plain", text);
      event.preventDefault();
    };
    document.addEventListener("copy", write, { once: true });
    return document.execCommand("copy");
  }
}
