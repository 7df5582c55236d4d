// The worksheet: experiments with questions, and their answers.

import { find } from "./controls.js";
import { onLanguage, t } from "./language.js";

const COUNT = 5;

const numbers = Array.from({ length: COUNT }, (_, index) => index + 1);

/** On the screen answers unfold; on paper they are in an appendix. */
function fillSheet() {
  find("sheet").innerHTML = numbers
    .map(
      (number) => `<article>
<h3>${number}. ${t(`sheet${number}Title`)}</h3>
${t(`sheet${number}Do`)}
<ol class="questions">${t(`sheet${number}Ask`)}</ol>
<details class="answer"><summary>${t("answers")}<span class="hidden"> ${number}</span></summary><ol class="questions">${t(`sheet${number}Answer`)}</ol></details>
</article>`,
    )
    .join("\n");
  const answers = numbers.map(
    (number) =>
      `<h3>${number}. ${t(`sheet${number}Title`)}</h3><ol class="questions">${t(`sheet${number}Answer`)}</ol>`,
  );
  find("sheet-answers").innerHTML = `<h2>${t("answers")}</h2>${answers.join("")}`;
}

export function startWorksheet() {
  onLanguage(fillSheet);
  find("sheet-print").addEventListener("click", () => print());
}
