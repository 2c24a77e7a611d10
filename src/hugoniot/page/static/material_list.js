"use strict";
// The library as a list: filter by words and kind, sort by any number, choose several.
H.MaterialList = class {
  constructor(host, onChoose) {
    this.onChoose = onChoose;
    this.keys = {name: ["name", "", 1], density: ["density", "kg/m³", 1], bulk_sound_speed: ["bulk sound speed", "m/s", 1], gruneisen: ["Grüneisen parameter", "", 1],
                 hugoniot_elastic_limit: ["Hugoniot elastic limit", "GPa", 1e-9], cj_velocity: ["CJ velocity", "m/s", 1], cj_pressure: ["CJ pressure", "GPa", 1e-9], valid_up_to: ["highest particle velocity of the data", "m/s", 1]};
    this.search = H.h("input", {type: "search", placeholder: "copper, al, U007 …", "aria-label": "Filter materials", style: {flex: "1", minWidth: "8em"},
                                oninput: () => H.set({q: this.search.value})});
    this.kind = H.h("select", {"aria-label": "Kind of material", onchange: () => H.set({kind: this.kind.value})});
    this.sort = H.h("select", {"aria-label": "Sort by", onchange: () => H.set({sort: this.sort.value === "name" ? "" : this.sort.value})},
      Object.entries(this.keys).map(([key, [words]]) => H.h("option", {value: key}, words)));
    this.down = H.h("button", {type: "button", "aria-label": "Reverse the order", title: "Reverse the order", onclick: () => H.set({down: H.get("down") ? "" : "1"})}, "↑");
    this.list = H.h("ul", {class: "list", role: "listbox", tabindex: 0, "aria-label": "Materials", "aria-multiselectable": "true", onkeydown: event => this._key(event),
                           onclick: event => { const li = event.target.closest("li"); if (li) this._toggle(li.dataset.name); }});
    this.count = H.h("span", {class: "quiet small"});
    host.append(H.h("div", {class: "bar"}, this.search), H.h("div", {class: "bar"}, this.kind, H.h("label", {class: "small"}, "sort", this.sort), this.down),
                H.h("div", {class: "scroll"}, this.list), this.count);
  }
  async update() {
    this.all ||= await H.askOnce("materials");
    if (!this.kind.options.length) this._kinds();
    for (const [input, key] of [[this.search, "q"], [this.kind, "kind"]]) if (input.value !== H.get(key)) input.value = H.get(key);
    this.sort.value = this.keys[H.get("sort")] ? H.get("sort") : "name";
    this.down.textContent = H.get("down") ? "↓" : "↑";
    const shape = ["q", "kind", "sort", "down"].map(k => H.get(k)).join("|");
    if (shape !== this.shape) { this.shape = shape; this._fill(); }
    const chosen = H.list("sel");
    for (const li of this.list.children) li.setAttribute("aria-selected", String(chosen.includes(li.dataset.name)));
  }
  _kinds() {
    const kinds = [...new Set(this.all.materials.map(m => m.category))].sort();
    this.kind.append(H.h("option", {value: ""}, "all materials"), H.h("option", {value: "curated"}, "curated only"), ...kinds.map(k => H.h("option", {value: k}, k)),
                     H.h("option", {value: "rows"}, "other table rows"));
  }
  _shown() {
    const kind = H.get("kind"), words = H.get("q").toLowerCase().split(/\s+/).filter(Boolean), key = H.get("sort") || "name", sign = H.get("down") ? -1 : 1;
    const from = kind === "rows" ? this.all.rows : this.all.materials;
    const fits = m => (!kind || kind === "rows" || (kind === "curated" ? m.curated : m.category === kind)) &&
      words.every(w => [m.name, m.title, m.category, ...m.also, m.source || ""].join(" ").toLowerCase().includes(w));
    const found = from.filter(fits);
    if (key === "name") return sign > 0 ? found : found.reverse();
    return found.filter(m => m[key] !== null && m[key] !== undefined).sort((a, b) => sign * (a[key] - b[key]));
  }
  _fill() {
    const found = this._shown(), key = H.get("sort") || "name", [, unit, factor] = this.keys[key] || this.keys.name, shown = key === "name" ? "density" : key;
    H.clear(this.list).append(...found.map(m => H.h("li", {role: "option", "data-name": m.name, "aria-selected": "false", title: [m.source, m.mark].filter(Boolean).join("\n")},
      H.h("span", {class: "what"}, m.title, m.mark ? H.h("span", {class: "bad", title: m.mark, "aria-label": "with a caveat"}, " ⚑") : null,
        H.h("small", {}, `${m.name} · ${m.category}${m.curated || H.files[m.name] ? "" : m.alone ? " · a single table row" : " · data only, no complete material"}`)),
      H.h("span", {class: "number"}, m[shown] ? `${H.digits(m[shown] * (key === "name" ? 1 : factor), 4)} ${key === "name" ? "kg/m³" : unit}` : ""))));
    this.count.textContent = `${found.length} of ${this.all.materials.length} materials, ${this.all.rows.length} further rows, ${this.all.points} measured states`;
    this.at = -1;
  }
  _toggle(name) {
    const chosen = H.list("sel");
    this.onChoose(chosen.includes(name) ? chosen.filter(n => n !== name) : [...chosen, name]);
  }
  _key(event) {
    const rows = this.list.children, move = {ArrowDown: 1, ArrowUp: -1, PageDown: 10, PageUp: -10}[event.key];
    if (move && rows.length) {
      if (this.at >= 0) rows[this.at].style.outline = "";
      this.at = Math.min(Math.max(this.at + move, 0), rows.length - 1);
      rows[this.at].style.outline = "2px solid var(--accent)"; rows[this.at].style.outlineOffset = "-2px";
      rows[this.at].scrollIntoView({block: "nearest"});
      this.list.setAttribute("aria-label", `Materials: ${rows[this.at].dataset.name}`);
    } else if ((event.key === "Enter" || event.key === " ") && this.at >= 0) this._toggle(rows[this.at].dataset.name);
    else return;
    event.preventDefault();
  }
};
