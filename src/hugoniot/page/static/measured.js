"use strict";
// Measured histories from a CSV file dropped onto the page: read here, sent nowhere. Heads name quantity and unit: time [us], velocity (m/s).
(() => {
  const UNITS = {s: ["s", 1], ms: ["s", 1e-3], us: ["s", 1e-6], "µs": ["s", 1e-6], "μs": ["s", 1e-6], ns: ["s", 1e-9], ps: ["s", 1e-12], "m/s": ["m/s", 1], "km/s": ["m/s", 1e3], "mm/us": ["m/s", 1e3], "mm/µs": ["m/s", 1e3], "cm/s": ["m/s", 1e-2],
    Pa: ["Pa", 1], kPa: ["Pa", 1e3], MPa: ["Pa", 1e6], GPa: ["Pa", 1e9], kbar: ["Pa", 1e8], bar: ["Pa", 1e5], Mbar: ["Pa", 1e11], m: ["m", 1], mm: ["m", 1e-3], um: ["m", 1e-6], "µm": ["m", 1e-6], K: ["K", 1], "kg/m^3": ["kg/m^3", 1], "g/cm^3": ["kg/m^3", 1e3]};
  const SI = {time: "s", velocity: "m/s", particle_velocity: "m/s", stress: "Pa", pressure: "Pa", temperature: "K", density: "kg/m^3", position: "m"};
  const cells = line => { const found = []; let cell = "", quoted = false; for (const c of line) { if (c === '"') quoted = !quoted; else if ((c === "," || c === ";" || c === "\t") && !quoted) { found.push(cell); cell = ""; } else cell += c; } return [...found, cell].map(t => t.trim()); };
  H.readMeasured = (name, text) => {
    const lines = text.split(/\r?\n/).map((line, k) => [line, k + 1]).filter(([l]) => l.trim() && !l.startsWith("#")), heads = cells(lines[0]?.[0] || "").map(head => {
      const match = head.match(/^(.*?)\s*(?:[[(]\s*([^\])]*)\s*[\])])?\s*$/), word = match[1].trim().toLowerCase().replace(/\s+/g, "_"), unit = (match[2] || "").trim();
      if (unit && !UNITS[unit]) throw new H.Refused(`${name}: unknown unit '${unit}'; known: ${Object.keys(UNITS).join(", ")}`);
      return {word, unit: unit ? UNITS[unit][0] : SI[word] || "", factor: unit ? UNITS[unit][1] : 1};
    });
    if (lines.length < 3) throw new H.Refused(`${name}: needs a header line, such as time [us], velocity [m/s], and at least two lines of numbers`);
    const at = heads.findIndex(h => h.unit === "s" || h.word === "t");
    if (at < 0) throw new H.Refused(`${name}: no time column; use a header such as time [us]`);
    const rows = lines.slice(1).map(([line, number]) => {
      const found = cells(line);
      if (found.length !== heads.length) throw new H.Refused(`${name}:${number}: values: ${found.length}, column headers: ${heads.length}; numbers need a decimal point, since commas separate columns`);
      return found.map((c, j) => { const v = Number(c); if (c === "" || !Number.isFinite(v)) throw new H.Refused(`${name}:${number}: '${c.slice(0, 30)}' is not a number`); return v * heads[j].factor; });
    });
    const time = rows.map(r => r[at]);
    return heads.map((h, j) => ({...h, j})).filter(h => h.j !== at && h.word).map(h => ({label: `${name}: ${h.word.replace(/_/g, " ")}`, unit: h.unit, time, values: rows.map(r => r[h.j] ?? NaN)}));
  };
  // files: [{name, text}], in the address as JSON; what is too long for one is only on the page, which says so
  H.Measured = class {
    constructor(host, onChange, before) {
      Object.assign(this, {files: [], found: [], held: "", lacking: false, onChange, list: H.h("div", {class: "column small", style: {gap: "2px"}, "aria-live": "polite"})});
      const input = H.h("input", {type: "file", accept: ".csv,.txt,.dat", multiple: true, "aria-label": "Measured data, CSV", onchange: async () => { await this.take([...input.files]); input.value = ""; }});
      host.append(H.h("span", {class: "small"}, "Measured data: drop a CSV file here (time [us], velocity [m/s]) or choose one: "), input, this.list);
      if (before?.lacking) Object.assign(this, {files: before.files, lacking: true}).show();
      host.addEventListener("dragover", event => { event.preventDefault(); host.classList.add("over"); });
      host.addEventListener("dragleave", () => host.classList.remove("over"));
      host.addEventListener("drop", event => { event.preventDefault(); host.classList.remove("over"); this.take(event.dataTransfer.files); });
    }
    async take(files) {
      for (const file of files) {
        if (file.size > 20e6) { H.say(`${file.name}: more than 20 MB`); continue; }
        try { const text = await file.text(), read = H.readMeasured(file.name, text); await this.keep([...this.files.filter(f => f.name !== file.name), {name: file.name, text, read}]); H.say(`${file.name}: loaded`); } catch (error) { H.failed(error); }
      }
    }
    async keep(files) {
      this.files = files;
      const letters = files.length ? await H.intoAddress(JSON.stringify(files.map(({name, text}) => ({name, text})))) : "";
      this.held = letters ?? "";
      this.lacking = letters === null;
      if (this.list.isConnected) H.set({csv: letters}, false);
      this.show();
      this.onChange();
    }
    async fromAddress() {         // as the address says
      const letters = H.get("csv");
      if (letters === this.held) return;
      this.held = letters;
      this.files = letters ? JSON.parse(await H.fromAddress(letters)).map(({name, text}) => ({name: String(name), text: String(text), read: H.readMeasured(String(name), String(text))})) : [];
      this.lacking = false;
      this.show();
    }
    show() {
      this.found = this.files.flatMap(f => f.read);
      H.clear(this.list).append(...this.files.map(f => H.h("span", {class: "bar"}, f.name, H.h("button", {type: "button", "aria-label": `Remove ${f.name}`, onclick: () => this.keep(this.files.filter(o => o !== f))}, "×"))),
        this.lacking ? H.h("span", {class: "bad"}, "Too long for a link: a link to this page would not contain these data.") : "");
    }
  };
})();
