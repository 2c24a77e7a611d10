"use strict";
// Everything known about one material: constants with sources and marks, derived numbers, choices, notes.
H.aboutMaterial = known => {
  const sources = [], number = c => { const key = `${c.source}|${c.via}`; if (!sources.includes(key)) sources.push(key); return sources.indexOf(key) + 1; };
  const rows = known.constants.map(c => H.h("tr", {}, H.h("td", {}, c.quantity), H.h("td", {class: "number"}, typeof c.value === "number" ? H.digits(c.value) : String(c.value)), H.h("td", {}, c.unit === "1" || c.unit === "text" ? "" : c.unit),
    H.h("td", {}, c.status === "default" ? "" : `[${number(c)}]`), H.h("td", {class: c.mark ? "bad" : ""}, c.mark)));
  const lines = (head, items) => items.length ? [H.h("h3", {}, head), ...items.map(t => H.h("div", {class: "small"}, t))] : [];
  return H.h("details", {open: false}, H.h("summary", {}, H.h("strong", {}, known.title), H.h("span", {class: "quiet"}, ` ${known.name}: constants, sources, remarks`)),
    ...known.warnings.map(w => H.h("p", {class: "bad small"}, w)),
    H.h("div", {class: "scroll wide", tabindex: 0, role: "group", "aria-label": "Table"}, H.h("table", {class: "small"}, H.h("thead", {}, H.h("tr", {}, ["constant", "value", "unit (SI)", "source", "remark"].map((t, k) => H.h("th", {class: k === 1 ? "number" : ""}, t)))), H.h("tbody", {}, rows))),
    ...lines("range of the data", known.reach ? [known.reach] : []),
    ...lines("derived quantities", Object.entries(known.derived).map(([k, q]) => `${k.replace(/_/g, " ").replace(/^(cj|hel) /, t => t.toUpperCase())}: ${H.digits(q.value)} ${q.unit === "1" ? "" : q.unit} (${q.meaning})`)),
    ...lines("why these constants", Object.entries(known.reasons).map(([k, t]) => `${k}: ${t}`)), ...lines("limitations", known.missing), ...lines("remarks", known.notes), ...lines("fits made by hugoniot to measured states", known.fits),
    ...lines("other rows of the library", known.others.map(o => `${o.row} (${o.family}) ${o.summary}: ${o.source}`)),
    ...lines("sources", sources.map((s, k) => `[${k + 1}] ${s.split("|")[0]}`)));
};
