"use strict";
// Impedance match: flyer and layers picked, the velocity dragged on the axis; the states are computed here, by H.impact.
(() => {
  const view = H.views.match = {};
  let chart, rows, slider, speed, sigma, bands, table, warnings, deckBox, deckText, editorLink, runButton, options, order = 0, shown = null, dragging = false;
  const layers = () => H.list("layers").length > 1 ? H.list("layers") : ["copper", "aluminum"];
  const setLayers = names => H.set({layers: names.join(","), mz: ""});
  const velocity = () => Number(H.get("v")) > 0 ? Number(H.get("v")) : 1000;
  const most = () => Number(H.get("vmax")) > 0 ? Number(H.get("vmax")) : 4000;

  view.open = main => {
    main.className = "split";
    const left = H.h("div", {class: "column"}), right = H.h("div", {class: "column"}), host = H.h("div");
    main.append(left, right);
    options = H.h("datalist", {id: "match-materials"});
    rows = H.h("div", {class: "column", style: {gap: "6px"}});
    slider = H.h("input", {type: "range", min: 0, max: 4000, step: 1, "aria-label": "Impact velocity, m/s", style: {flex: "1", minWidth: "120px"}, oninput: () => drag(Number(slider.value)), onchange: drop});
    speed = H.h("input", {type: "number", min: 1, step: "any", "aria-label": "Impact velocity in m/s", onchange: () => H.set({v: speed.value, vmax: Number(speed.value) > most() ? Math.ceil(speed.value / 500) * 500 : H.get("vmax")})});
    sigma = H.h("input", {type: "number", min: 0, step: "any", "aria-label": "Standard deviation of the velocity in m/s", style: {width: "5.5em"}, onchange: () => H.set({sigma: Number(sigma.value) > 0 ? sigma.value : ""})});
    bands = H.h("input", {type: "checkbox", onchange: () => H.set({bands: bands.checked ? "1" : ""})});
    table = H.h("div");
    warnings = H.h("div", {class: "small"});
    deckText = H.h("pre", {class: "small scroll", tabindex: 0, style: {margin: 0, padding: "8px", maxHeight: "40vh"}});
    runButton = H.h("button", {type: "button", hidden: true, onclick: runDeck}, "Run");
    editorLink = H.h("button", {type: "button", onclick: async () => H.go("decks", {from: "match", text: await H.intoAddress(deckText.textContent)})}, "Open in the deck editor");
    deckBox = H.h("details", {ontoggle: () => { H.set({deck: deckBox.open ? "1" : ""}, false); if (deckBox.open) loadDeck(); }}, H.h("summary", {}, "The deck for this impact"),
      H.h("div", {class: "bar", style: {margin: "6px 0"}}, H.h("button", {type: "button", onclick: () => H.copy(deckText.textContent, "deck")}, "Copy"), runButton, editorLink), deckText);
    left.append(H.h("h2", {}, "Flyer and layers"), rows, options,
      H.h("div", {class: "bar"}, H.h("button", {type: "button", onclick: () => setLayers([...layers(), "pmma"].slice(0, 8))}, "Add a layer"),
        H.h("button", {type: "button", onclick: () => setLayers([layers()[1], layers()[0], ...layers().slice(2)])}, "Swap flyer and target")),
      H.h("h3", {}, "impact velocity"), H.h("div", {class: "bar"}, slider, H.h("label", {}, speed, "m/s")),
      H.h("h3", {}, "error bands, one standard deviation"), H.h("div", {class: "bar small"}, H.h("label", {}, "velocity ±", sigma, "m/s"), H.h("label", {}, bands, "library fits")), deckBox);
    right.append(host, H.h("div", {class: "bar"}, H.h("span", {class: "quiet small"}, "Drag the impact velocity along the axis. Dashed: release and reshock of the layer behind; solid: Hugoniot of the layer ahead."), H.h("span", {class: "bar push"}, ...H.saveButtons(() => chart, () => `match-${layers().join("-")}`))), table, warnings);
    chart = new H.Chart(host, {label: "Impedance match: pressure against particle velocity", height: 0.56, zoomKey: "mz", onHover: () => {}, onDrag: (id, x) => drag(Math.max(1, Math.round(x * 1000))), onDrop: drop});
    chart.svg.addEventListener("keydown", event => {     // the handle with the keyboard
      const step = {"[": -10, "]": 10, "{": -100, "}": 100}[event.key];
      if (step) { drag(Math.max(1, velocity() + step)); drop(); event.preventDefault(); }
    });
    H.opened.then(opened => { runButton.hidden = !opened.may_run || H.exported(); }).catch(H.failed);
    H.askOnce("materials").then(all => options.append(...all.materials.filter(m => m.alone).map(m => H.h("option", {value: m.name}, m.title)))).catch(H.failed);
  };
  view.close = () => { order++; chart.stop(); };
  view.repaint = () => draw(shown);
  view.update = () => {
    fillRows();
    sync();
    bands.checked = H.get("bands") === "1";
    if (document.activeElement !== sigma) sigma.value = H.get("sigma");
    if (!deckBox.open && H.get("deck")) deckBox.open = true;
    solve();
  };
  function sync() {
    slider.max = Math.max(most(), velocity());
    slider.value = velocity();
    if (document.activeElement !== speed) speed.value = velocity();
    command();
  }
  function fillRows() {
    const names = layers();
    if (rows.dataset.names === names.join()) return;
    rows.dataset.names = names.join();
    H.clear(rows).append(...names.map((name, k) => {
      const word = k === 0 ? "flyer" : k === 1 ? "target" : k === names.length - 1 ? "backing" : `layer ${k}`;
      return H.h("div", {class: "bar"}, H.h("i", {style: {width: "12px", height: "12px", borderRadius: "3px", background: H.palette().lines[k % 8]}}), H.h("label", {style: {flex: 1}}, H.h("span", {style: {width: "4em"}}, word),
        H.h("input", {list: "match-materials", value: name, "aria-label": `Material of the ${word}`, style: {flex: 1, minWidth: 0}, onchange: event => { const next = [...names]; next[k] = event.target.value.trim().replace(/,/g, " "); if (next[k]) setLayers(next); }})),
        names.length > 2 && k > 0 ? H.h("button", {type: "button", "aria-label": `Remove ${word}`, onclick: () => setLayers(names.filter((_, i) => i !== k))}, "×") : "");
    }));
  }
  function drag(v) { dragging = true; H.set({v: String(v)}, false); sync(); solve(); }
  function drop() { dragging = false; solve(); }
  async function solve() {      // computed here, at once; error bands when the drag pauses
    const mine = ++order, names = layers(), v = velocity(), begun = performance.now();
    try {
      const found = await H.impact.impact(names, v, dragging ? {} : {sigma: Number(H.get("sigma")) || 0, bands: H.get("bands") === "1"});
      if (mine !== order) return;
      found.took = performance.now() - begun;
      shown = found;
      draw(found);
      if (!dragging) H.say("");
    } catch (error) { if (mine !== order) return; H.clear(warnings).append(H.h("div", {class: "bad"}, error.message)); H.clear(table); shown = null; chart.show({series: [], marks: [], x: {label: "particle velocity (km/s)", min: 0, max: v * 1e-3}, y: {label: "pressure (GPa)", min: 0, max: 1}, handles: [{id: "velocity", x: v * 1e-3, y: 0, colour: 0}]}); H.failed(error); }
    if (deckBox.open && !dragging) loadDeck();
  }
  function draw(found) {
    if (!found) return;
    const crowded = found.states.length > 3 && chart.box.clientWidth < 560, names = found.shown, series = [], marks = [], times = (values, factor) => values.map(v => v * factor);
    found.curves.forEach((c, k) => {
      series.push({kind: "line", colour: k, dash: "6 3", width: 1.4, x: times(c.behind.particle_velocity, 1e-3), y: times(c.behind.pressure, 1e-9), label: k === 0 ? `${names[0]}, ${H.digits(found.velocity, 5)} m/s` : "", named: "start"});
      series.push({kind: "line", colour: k + 1, x: times(c.ahead.particle_velocity, 1e-3), y: times(c.ahead.pressure, 1e-9), label: names[k + 1]});
    });
    found.states.forEach((s, k) => {
      const x = s.particle_velocity * 1e-3, y = s.pressure * 1e-9, u = s.uncertainty;
      if (u) marks.push({kind: "error", x, y, sx: u.particle_velocity * 1e-3, sy: u.pressure * 1e-9, colour: "ink", width: 1.3});
      marks.push({kind: "dot", x, y, colour: "ink", label: `${H.digits(s.pressure * 1e-9, crowded ? 3 : 4)} GPa${crowded ? "" : `, ${H.digits(s.particle_velocity, 4)} m/s`}`, below: k > 0});
    });
    const top = 1.28 * Math.max(...found.states.map(s => s.pressure)) * 1e-9, wide = 1.12 * Math.max(found.velocity, ...found.states.map(s => s.particle_velocity)) * 1e-3;
    if (!dragging || !chart.held) chart.held = {x: {min: 0, max: wide}, y: {min: 0, max: top}};
    const held = chart.held, grown = {x: {min: 0, max: Math.max(held.x.max, found.velocity * 1.02e-3)}, y: {min: 0, max: Math.max(held.y.max, top / 1.1)}};
    chart.show({series, marks, x: {label: "particle velocity (km/s)", ...(dragging ? grown.x : held.x)}, y: {label: "pressure (GPa)", ...(dragging ? grown.y : held.y)}, handles: [{id: "velocity", x: found.velocity * 1e-3, y: 0, colour: 0}]});
    const fields = ["pressure", "particle_velocity", "shock_velocity", "density", "temperature", "specific_internal_energy", "sound_speed"];
    H.clear(table).append(H.h("div", {class: "scroll whole", tabindex: 0, role: "group", "aria-label": "Table"}, H.h("table", {"data-table": "match"}, H.h("thead", {}, H.h("tr", {}, H.h("th", {}, "state to the right of"), found.states.map(s => H.h("th", {class: "number"}, s.interface)))),
      H.h("tbody", {}, fields.filter(f => found.states.some(s => s[f] !== null && s[f] !== undefined)).map(f => {
        const [words, unit, factor] = H.units[f], [name, by] = H.fits(found.states.map(s => s[f]), unit, factor);
        return H.h("tr", {"data-field": f}, H.h("td", {}, H.labelled(words, name)), found.states.map(s => H.h("td", {class: "number"}, H.digits(s[f] === null || s[f] === undefined ? null : s[f] * by),
          s.uncertainty?.[f] ? H.h("span", {class: "quiet"}, ` ± ${H.digits(s.uncertainty[f] * by, 2)}`) : "")));
      }), H.h("tr", {}, H.h("td", {}, "reflected, transmitted wave"), found.states.map(s => H.h("td", {class: "number"}, `${word(s.reflected)}, ${word(s.transmitted)}`)))))));
    const notes = found.warnings.map(w => H.h("div", {class: "bad"}, w));
    if (found.uncertain?.length) notes.push(H.h("div", {class: "quiet"}, `Uncertain inputs: ${found.uncertain.join(", ")}; linear propagation${found.uncertain.length > 1 || found.uncertain[0] !== "velocity" ? ", with the covariance of each fit" : ""}.`));
    else if (H.get("bands") && !dragging) notes.push(H.h("div", {class: "quiet"}, "No error band: the package has fitted none of these Hugoniots itself."));
    H.clear(warnings).append(...notes);
    command();
    chart.box.dataset.took = found.took ?? "";
  }
  const word = kind => ({fan: "release"}[kind] || kind);
  async function loadDeck() {
    try { deckText.textContent = await H.impact.deck(layers(), velocity()); editorLink.disabled = runButton.disabled = false; }
    catch (error) { deckText.textContent = error.message; editorLink.disabled = runButton.disabled = true; }
  }
  async function runDeck() {       // the editor shows the deck and the progress of the run
    try {
      const text = deckText.textContent, started = await H.send("job", text);
      H.go("decks", {from: "match", text: await H.intoAddress(text), job: String(started.job)});
    } catch (error) { H.failed(error); }
  }
  function command() {
    const names = layers(), v = velocity(), s = Number(H.get("sigma"));
    const extra = (s > 0 ? ` --error "velocity = ${s} m/s"` : "") + (H.get("bands") && shown?.uncertain.some(u => u !== "velocity") ? " --error library" : "");
    const files = [...new Set(names.map(n => H.files[n]).filter(Boolean))], read = files.length ? `from pathlib import Path\nfrom hugoniot.explorer.subjects import admit\n${files.map(f => `admit(Path(${H.python(f)}))\n`).join("")}` : "";
    H.command({shell: `hugoniot eos match ${names.map(H.subject).join(" ")} --velocity "${v} m/s"${extra} --plot match.png`,
      python: `from hugoniot.explorer.impact import impact\n${read}print(impact([${names.map(H.python).join(", ")}], ${v}.0, sigma=${s > 0 ? s : 0}, bands=${H.get("bands") ? "True" : "False"})["states"])`.replace(`${v}.0`, Number.isInteger(v) ? `${v}.0` : `${v}`)});
  }
})();
