// The table under an input of class "filter" is sorted by a click on a heading and shows the rows that hold every word typed.
document.addEventListener("DOMContentLoaded", () => {
  const input = document.querySelector("input.filter");
  const table = input && [...document.querySelectorAll("article table")].find(t => input.compareDocumentPosition(t) & Node.DOCUMENT_POSITION_FOLLOWING);
  if (!table) return;
  const rows = [...table.tBodies[0].rows];
  input.addEventListener("input", () => {
    const words = input.value.toLowerCase().split(/\s+/);
    rows.forEach(row => { row.hidden = !words.every(word => row.textContent.toLowerCase().includes(word)); });
  });
  [...table.tHead.rows[0].cells].forEach((head, k) => {
    const button = document.createElement("button");
    button.append(...head.childNodes);
    head.append(button);
    button.addEventListener("click", () => {
      const way = head.getAttribute("aria-sort") === "ascending" ? -1 : 1;
      [...table.tHead.rows[0].cells].forEach(other => other.removeAttribute("aria-sort"));
      head.setAttribute("aria-sort", way > 0 ? "ascending" : "descending");
      const value = row => row.cells[k].textContent.trim();
      const compare = (a, b) => {
        if (!value(a) || !value(b)) return !value(a) - !value(b);     // empty cells stay below
        const difference = parseFloat(value(a)) - parseFloat(value(b));
        return way * (Number.isNaN(difference) ? value(a).localeCompare(value(b)) : difference);
      };
      rows.sort(compare).forEach(row => table.tBodies[0].append(row));
    });
  });
});
