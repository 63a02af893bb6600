"use strict";

// Sorting: a click on a header sorts upwards, the next downwards, the third restores the order.
// Rows without a number in a column of numbers stay last either way.

function key(row, column) {
  const cell = row.cells[column];
  const text = cell.dataset.value ?? cell.textContent.trim();
  return { text, number: cell.dataset.value === undefined ? NaN : Number(text) };
}

function compare(a, b, direction) {
  const numbers = Number(!Number.isNaN(b.number)) - Number(!Number.isNaN(a.number));
  if (numbers !== 0) return numbers;
  if (!Number.isNaN(a.number)) return direction * (a.number - b.number);
  return direction * a.text.localeCompare(b.text, "en", { numeric: true });
}

function sortBy(table, header) {
  const column = header.cellIndex;
  const state = { none: "ascending", ascending: "descending", descending: "none" }[header.ariaSort];
  for (const other of header.parentElement.cells) other.ariaSort = "none";
  header.ariaSort = state;
  table.classList.toggle("sorted", state !== "none");
  const direction = state === "descending" ? -1 : 1;
  const rows = [...table.originalRows];
  if (state !== "none") {
    const keys = new Map(rows.map((row) => [row, key(row, column)]));
    rows.sort((a, b) => compare(keys.get(a), keys.get(b), direction));
  }
  table.tBodies[0].append(...rows);
}

for (const table of document.querySelectorAll("table")) {
  table.originalRows = [...table.tBodies[0].rows];
  for (const header of table.tHead.rows[0].cells) {
    header.querySelector("button").addEventListener("click", () => sortBy(table, header));
  }
}

// Figures at full size. Escape closes a dialog by itself, and so does its button.

const dialog = document.querySelector("dialog");
for (const button of document.querySelectorAll("figure button")) {
  button.addEventListener("click", () => {
    const small = button.querySelector("img");
    const large = dialog.querySelector("img");
    large.src = small.src;
    large.alt = small.alt;
    dialog.querySelector("p").textContent = button.dataset.title;
    dialog.showModal();
  });
}
dialog?.addEventListener("click", (event) => {
  if (event.target === dialog) dialog.close();
});
