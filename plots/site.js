"use strict";

// Filtering: a row is shown when it has every word that is typed, in any column and any case.

for (const input of document.querySelectorAll(".filter input")) {
  const rows = [...document.querySelectorAll(`#${CSS.escape(input.dataset.table)} tbody tr`)];
  const texts = rows.map((row) => [...row.cells].map((cell) => cell.textContent.toLowerCase()).join("\n"));
  const paragraph = input.closest(".filter");
  const filter = () => {
    const words = input.value.toLowerCase().split(/\s+/).filter(Boolean);
    rows.forEach((row, i) => { row.hidden = !words.every((word) => texts[i].includes(word)); });
    const shown = rows.filter((row) => !row.hidden).length;
    paragraph.querySelector("output").textContent = words.length ? `${shown} of ${rows.length}` : "";
  };
  input.addEventListener("input", filter);
  paragraph.hidden = false;
  filter();  // the browser may have restored the words of an earlier visit
}
