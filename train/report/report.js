"use strict";
(() => {
  const root = document.documentElement;
  const dark = () => (root.dataset.theme || (matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light")) === "dark";
  document.getElementById("theme").onclick = () => { root.dataset.theme = dark() ? "light" : "dark"; };

  const value = (row, at) => row.cells[at].textContent.trim();
  const order = (a, b) => {
    const [x, y] = [parseFloat(a.replaceAll(",", "")), parseFloat(b.replaceAll(",", ""))];
    return Number.isNaN(x) || Number.isNaN(y) ? a.localeCompare(b, "en", { numeric: true }) : x - y;
  };
  const sort = (table, head, at) => {
    const down = head.ariaSort === "ascending";
    for (const other of table.tHead.rows[0].cells) other.removeAttribute("aria-sort");
    head.ariaSort = down ? "descending" : "ascending";
    const rows = [...table.tBodies[0].rows].sort((a, b) => (down ? -1 : 1) * order(value(a, at), value(b, at)));
    table.tBodies[0].append(...rows);
  };
  for (const table of document.querySelectorAll("table.sorts")) {
    [...table.tHead.rows[0].cells].forEach((head, at) => {
      head.tabIndex = 0;
      head.onclick = () => sort(table, head, at);
      head.onkeydown = (event) => { if (event.key === "Enter") sort(table, head, at); };
    });
  }
  root.dataset.ready = "yes";
})();
