"use strict";
// What may stand where the cursor is: keys of the table, choices and laws, names of materials. From the schema of decks.
H.deckOffers = (words, materials, text, at) => {
  const before = text.slice(0, at), line = before.slice(before.lastIndexOf("\n") + 1);
  if (/^\s*#/.test(line)) return null;
  const header = line.match(/^\s*\[\[?([\w.*-]*)$/);
  if (header) return offer(header[1], Object.entries(words.tables).filter(([path]) => path).map(([path]) => {
    const [parent, key] = [path.split(".").slice(0, -1).join("."), path.split(".").at(-1)], many = words.tables[parent]?.[key]?.many;
    return {insert: path.replace("*", "NAME"), show: many ? `[[${path}]]` : `[${path.replace("*", "NAME")}]`, about: words.tables[parent]?.[key]?.text || ""};
  }));
  const table = tableAt(before), value = line.match(/^\s*([\w-]+)\s*=\s*(?:"([^"]*)|([\w.]*))$/), keys = keysOf(words, table, text, at);
  if (value) {
    const [, key, quoted, bare] = value, typed = quoted ?? bare, close = quoted === undefined ? v => `"${v}"` : v => v + (text[at] === '"' ? "" : '"');
    if (key === "material") return offer(typed, [...ownMaterials(text), ...materials].map(([name, title]) => ({insert: close(name), show: name, about: title})));
    if (key === "law") return offer(typed, Object.entries(words.laws[familyOf(table)] || {}).map(([name, law]) => ({insert: close(name), show: name, about: law.text})));
    if (key === "kind" && table === "solver") return offer(typed, words.solvers.map(name => ({insert: close(name), show: name, about: ""})));
    const choices = (keys[key]?.choices || []).filter(c => typeof c === "string");
    return choices.length ? offer(typed, choices.map(c => ({insert: close(c), show: c, about: keys[key].text}))) : null;
  }
  const key = line.match(/^\s*([\w-]*)$/);
  if (!key) return null;
  const known = Object.entries(keys).filter(([, k]) => !k.table);
  return offer(key[1], known.map(([name, k]) => ({insert: `${name} = `, show: name, about: [k.text, k.unit && k.unit !== "1" && k.unit !== "text" ? `(${k.unit})` : ""].join(" ")})));
};
function offer(typed, items) {
  const low = typed.toLowerCase(), bare = t => t.show.replace(/^\[+/, "").toLowerCase();
  const fit = items.filter(t => bare(t).startsWith(low)), more = items.filter(t => !fit.includes(t) && low && bare(t).includes(low));
  const found = [...fit, ...more].slice(0, 40);
  return found.length && !(found.length === 1 && bare(found[0]) === low) ? {typed, items: found} : null;
}
const tableAt = before => { const found = [...before.matchAll(/^\s*\[\[?\s*([^\]\n]+?)\s*\]\]?/gm)]; return found.length ? found.at(-1)[1].replace(/"/g, "") : ""; };
const ownMaterials = text => [...new Set([...text.matchAll(/^\s*\[material\.("?)([^\].]+)\1[\].]/gm)].map(m => m[2]))].map(name => [name, "of this deck"]);
const familyOf = table => table.startsWith("material.") ? (table.split(".").at(-1) === "unreacted" ? "eos" : table.split(".").at(-1)) : table.split(".").at(-1);
function keysOf(words, table, text, at) {
  const general = table.startsWith("material.") ? ["material", "*", ...table.split(".").slice(2)].join(".") : table, laws = words.laws[familyOf(table)];
  if (laws && table.includes(".")) {
    const start = text.lastIndexOf("[", at), end = text.indexOf("\n[", at), law = text.slice(start, end < 0 ? undefined : end).match(/^\s*law\s*=\s*"([^"]+)"/m);
    return {law: {text: "which law", unit: "", choices: Object.keys(laws)}, ...(law && laws[law[1]] ? laws[law[1]].keys : {})};
  }
  return words.tables[general] || {};
}
