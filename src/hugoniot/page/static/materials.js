"use strict";
// Materials side by side: curves in one plane, the state under the pointer, a pinned state with its Rayleigh line, what is known.
(() => {
  const view = H.views.materials = {}, MOST = 8;
  let list, chart, chips, planes, options, readout, table, about, hint, surfaceBar, isothermBar, densityBar, extras = {}, order = 0;

  view.open = main => {
    main.className = "split";
    const left = H.h("div", {class: "column"}), right = H.h("div", {class: "column"});
    main.append(left, right);
    list = new H.MaterialList(left, chosen => H.set({sel: chosen.slice(-MOST).join(",")}));
    chips = H.h("div", {class: "bar", "aria-label": "Selected materials"});
    planes = H.h("div", {class: "bar", role: "group", "aria-label": "Plane"}, Object.entries(H.planes).map(([key, [name]]) =>
      H.h("button", {type: "button", "data-plane": key, onclick: () => H.set({plane: key, zoom: ""})}, name)));
    options = {};
    const option = (key, words) => H.h("label", {class: "small"}, options[key] = H.h("input", {type: "checkbox", onchange: () => H.set({[key]: options[key].checked === (key === "measured") ? "" : options[key].checked ? "1" : "0"})}), words);
    const by = H.h("select", {"aria-label": "Quantity of the state"}, [["particle_velocity", "up, m/s"], ["pressure", "p, GPa"], ["shock_velocity", "Us, m/s"]].map(([k, w]) => H.h("option", {value: k}, w)));
    const at = H.h("input", {type: "number", step: "any", "aria-label": "Value of the state", style: {width: "7em"}});
    const pin = () => { if (at.value !== "") H.set({at: `${by.value}:${Number(at.value) * (by.value === "pressure" ? 1e9 : 1)}`}); };
    at.addEventListener("keydown", event => { if (event.key === "Enter") pin(); });
    const host = H.h("div");
    readout = H.h("div", {class: "readout", "aria-live": "polite", "data-readout": "pointer"});
    table = H.h("div");
    about = H.h("div");
    hint = H.h("p", {class: "quiet small"});
    const field = (key, words, wide, placeholder) => H.h("label", {class: "small"}, words, extras[key] = H.h("input", {placeholder, style: {width: wide}, onchange: () => H.set({[key]: extras[key].value.replace(/[^0-9.,eE+-]/g, "")})}));
    surfaceBar = H.h("div", {class: "bar"}, extras.quantity = H.h("select", {"aria-label": "Quantity of the surface", onchange: () => H.set({quantity: extras.quantity.value})}, Object.entries(H.surfaceFields).map(([k, [w]]) => H.h("option", {value: k}, w))),
      H.h("label", {class: "small"}, extras.walk = H.h("input", {type: "checkbox", onchange: () => H.set({walk: extras.walk.checked ? "" : "0"})}), "pointer follows the curves"), field("hot", "temperatures, K", "8em", "from, to"));
    isothermBar = H.h("div", {class: "bar"}, field("iso", "isotherms, K (0: cold curve)", "14em", "0, 300, 1000, 2000"));
    densityBar = H.h("div", {class: "bar"}, field("rho", "densities, kg/m³", "10em", "from, to"));
    right.append(chips, planes, H.h("div", {class: "bar"}, surfaceBar, isothermBar, densityBar), host, H.h("div", {class: "bar"}, option("measured", "measured states"), option("sources", "other sources"), option("releases", "releases"),
        H.h("span", {class: "bar push"}, H.h("label", {class: "small"}, "state at", by), at, H.h("button", {type: "button", onclick: pin}, "Pin"),
          H.h("button", {type: "button", onclick: () => H.set({at: ""})}, "Unpin"), ...H.saveButtons(() => chart, () => `${H.list("sel").join("-") || "materials"}-${plane()}`))),
      readout, table, hint, about);
    chart = new H.Chart(host, {label: "Curves of the selected materials", height: 0.6, keep: true, zoomKey: "zoom", onHover: hover, onPick: hit => {
      const s = chart.spec.series[hit.series];
      if (s.table?.particle_velocity && ["hugoniot", "beyond"].includes(s.id)) H.set({at: `particle_velocity:${s.table.particle_velocity[hit.index]}`});
    }});
  };
  view.close = () => { order++; chart.stop(); };
  view.repaint = () => view.update();
  const plane = () => H.planes[H.get("plane")] ? H.get("plane") : "us-up";

  view.update = async () => {
    const mine = ++order;
    for (const button of planes.children) button.setAttribute("aria-pressed", String(button.dataset.plane === plane()));
    for (const key of Object.keys(options)) options[key].checked = key === "measured" ? H.get(key) !== "0" : H.get(key) === "1";
    list.update().catch(H.failed);
    const [by, value] = H.get("at").split(":"), names = await Promise.all(H.list("sel").map(H.resolved)).catch(() => H.list("sel"));
    if (mine !== order) return;
    if (names.join() !== H.list("sel").join()) H.set({sel: names.join(",")}, false);
    const results = await Promise.allSettled(names.map(name => H.askOnce("material", {name})));
    if (mine !== order) return;
    const known = results.map((r, k) => r.status === "fulfilled" ? {...r.value, name: names[k]} : null);
    results.filter(r => r.status === "rejected").forEach(r => H.failed(r.reason));
    addSurfaces(known);
    draw(names, known);
    drawAbout(names);
    if (!by) { drawTable(known); return; }
    await Promise.all(known.map(async c => { if (c?.hugoniot) try { c.pinned = await stateAt(c, by, Number(value)); } catch (error) { c.refused = error.message; } }));
    if (mine !== order) return;
    draw(names, known);
    drawTable(known);
  };
  function addSurfaces(known) {
    for (const bar of [surfaceBar, isothermBar, densityBar]) bar.hidden = true;
    for (const c of known) if (c) delete c.refused;
    const isotherms = plane() === "isotherms";
    if (!isotherms && plane() !== "surface") return;
    (isotherms ? isothermBar : surfaceBar).hidden = densityBar.hidden = false;
    for (const key of ["iso", "rho", "hot"]) if (document.activeElement !== extras[key]) extras[key].value = H.get(key);
    extras.quantity.value = H.surfaceFields[H.get("quantity")] ? H.get("quantity") : "pressure";
    extras.walk.checked = H.get("walk") !== "0";
    if (H.get("iso") && H.list("iso").length < 3) { H.say("Give three temperatures or more."); return; }
    const some = isotherms ? known : known.filter(c => c).slice(0, 1), key = isotherms ? "isotherms" : "surface";
    for (const c of some) if (c) { delete c[key]; try { c[key] = H.surface(c, isotherms); } catch (error) { if (!(error instanceof H.Refused)) throw error; c.refused = error.message; } }
  }
  const stateAt = (c, by, value) => H.exported() ? H.impact.state(c.name, by, value) : H.askOnce("state", {name: c.name, by, value});
  function draw(names, known) {
    const [, definition] = H.planes[plane()], shown = {measured: H.get("measured") !== "0", sources: H.get("sources") === "1", releases: H.get("releases") === "1"};
    const series = [], marks = [], silent = [], brief = known.map(c => c && (/\b(porous|liquid|gas|vapour|pressure|phase|transition|rho|row)\b/.test(c.title) ? c.title : c.title.split(/[,(]/)[0].trim()));
    known.forEach((c, k) => { if (c) c.short = brief.filter(b => b === brief[k]).length > 1 ? c.title : brief[k]; });
    known.forEach((c, k) => {
      if (!c) return;
      const found = definition.series(c, k, shown, known.filter(Boolean).length > 1);
      if (plane() !== "surface" && !found.some(s => s.x.length)) silent.push(c.title);
      series.push(...found);
      marks.push(...definition.marks(c, k));
    });
    const ends = known.filter(c => c?.hugoniot).map(c => c.hugoniot.particle_velocity.at(-1) * 1e-3);
    const all = [Math.max(...ends), 2.5 * Math.min(...ends)];      // a curve that goes much further than the others does not make them small
    const [x, y] = definition.axes;
    const close = ["us-up", "p-up"].includes(plane()) && all[0] > all[1], top = close ? {max: all[1]} : {};
    if (close) cut(series, all[1]);
    const surface = plane() === "surface" && known.find(c => c?.surface);
    chart.show({...(surface ? H.surfaceSpec(surface, chart) : {series, marks, x: {...x, ...top}, y})});
    H.clear(chips).append(...names.map((name, k) => H.h("span", {class: "chip"}, H.h("i", {style: {background: H.palette().lines[k % 8]}}), known[k]?.title || name,
      H.h("button", {type: "button", "aria-label": `Remove ${name}`, onclick: () => H.set({sel: names.filter(n => n !== name).join(",")})}, "×"))),
      names.length ? "" : H.h("span", {class: "quiet"}, "Select materials in the list."));
    const notes = known.flatMap(c => c ? [...c.notes, ...(c.refused ? [c.refused] : [])] : []);
    if (silent.length) notes.push(`No curve in this plane: ${silent.join(", ")}.`);
    if (series.some(s => s.id === "beyond")) notes.push("Dashed curve: beyond the range of the data.");
    if (series.some(s => s.id === "release") && plane() !== "expansion") notes.push("Thin lines: release isentropes from states on the Hugoniot.");
    if (["p-up", "p-v"].includes(plane())) notes.push("Dashed straight line: Rayleigh line to the pointer or to a pinned state.");
    if (plane() === "pop" && series.length) notes.push("Band: one standard deviation of the line's constant, where its source states one.");
    if (plane() === "gurney" && series.length) notes.push("For the sandwich, M is the mass of both plates.");
    if (surface) notes.push(`${surface.title}: computed at ${surface.surface.density.length} densities and as many temperatures; colours in between are interpolated, the pointer reads computed states only.${names.length > 1 ? " Only the first selected material is shown." : ""}`);
    if (plane() === "isentropes") notes.push("Dashed: isentrope through the state at rest.");
    if (plane() === "detonation") notes.push("Dashed straight line: Rayleigh line to the CJ state; dashed curve: isentrope of the products through it.");
    H.clear(hint).append(notes.map(n => /[.!?]$/.test(n) ? n : `${n}.`).join(" "), ...(H.get("at") ? known.flatMap(c => c?.pinned?.warnings || []) : []).map(w => H.h("span", {class: "bad", style: {display: "block"}}, w)));
    if (!readout.childNodes.length || !names.length) H.clear(readout).append(H.h("span", {class: "quiet"}, names.length ? "Point at a curve, or focus the plot and use the arrow keys. Enter pins a state; + and − zoom, 0 shows everything, dragging pans." : ""));
    const asked = plane() === "surface" ? known.find(c => c?.surface)?.surface : plane() === "isotherms" ? known.find(c => c?.isotherms)?.isotherms : null;
    H.command(H.materialCommands(names, plane(), asked));
  }
  function cut(series, most) {       // what lies outside does not count for the height either
    for (const s of series) {
      const n = s.x.findIndex(v => v > most);
      if (n >= 0 && s.kind !== "points") { s.x = s.x.slice(0, n && n + 1); s.y = s.y.slice(0, n && n + 1); }
    }
  }
  function hover(hit) {
    if (hit.node) { H.clear(readout).append(H.h("strong", {}, "state of the surface"), H.numbers(Object.entries(hit.node).map(([key, v]) => v === null ? [key.replace(/_/g, " "), "no such state"] : reading(key, v)))); return; }
    const s = chart.spec.series[hit.series], t = s.table;
    if (!t) return;
    const rows = Object.entries(t).filter(([, v]) => v && v[hit.index] !== null && v[hit.index] !== undefined).map(([key, v]) => reading(key, v[hit.index]));
    H.clear(readout).append(H.h("strong", {}, s.name), ` ${H.curveWords[s.id] || s.id}`, H.numbers(rows));
  }
  const extra = {mass_ratio: ["M/C", "", 1], gurney_velocity: ["metal velocity", "m/s", 1], run_distance: ["run distance", "mm", 1e3]};
  function reading(key, value) {
    const [words, unit, factor] = H.units[key] || extra[key] || [key.replace(/_/g, " "), "", 1], [shown, by] = H.fits([value], unit, factor);
    return [words, `${H.digits(value * by)} ${shown}`];
  }
  function drawTable(known) {
    const pinned = known.filter(c => c?.pinned), products = known.filter(c => c?.products && H.ofExplosives.includes(plane()));
    H.clear(table);
    const grid = (heads, columns, words) => {
      const keys = [...new Set(columns.flatMap(c => Object.keys(c)))].filter(k => columns.some(c => c[k] !== null && c[k] !== undefined));
      table.append(H.h("div", {class: "scroll whole", tabindex: 0, role: "group", "aria-label": "Table"}, H.h("table", {"data-table": words}, H.h("thead", {}, H.h("tr", {}, H.h("th", {}, words), heads.map(h => H.h("th", {class: "number"}, h)))),
        H.h("tbody", {}, keys.map(key => {
          const [name, unit, factor] = H.units[key] || [key.replace(/_/g, " "), "", 1], [shown, by] = H.fits(columns.map(c => c[key]), unit, factor);
          return H.h("tr", {"data-field": key}, H.h("td", {}, H.labelled(name, shown)), columns.map(c => H.h("td", {class: "number"}, H.digits(c[key] === null || c[key] === undefined ? null : c[key] * by))));
        })))));
    };
    if (products.length) grid(products.map(c => c.title), products.map(c => ({...c.products.cj})), "CJ state");
    else if (pinned.length) grid(pinned.map(c => c.products ? `${c.title}, unreacted` : c.title), pinned.map(c => c.pinned.state), "state on the Hugoniot");
  }
  async function drawAbout(names) {
    const name = names[names.length - 1];
    if (!name) { H.clear(about); return; }
    try { const known = await H.askOnce("about", {name}); if (H.list("sel").slice(-1)[0] === name) H.clear(about).append(H.aboutMaterial(known)); } catch (error) { H.failed(error); }
  }
})();
