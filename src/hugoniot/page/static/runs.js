"use strict";
// Runs: x-t map or plane, histories and profiles linked to it; other runs and measured data over them; a run in progress.
(() => {
  const view = H.views.runs = {}, state = {}, DASHES = ["7 3", "2 3", "9 3 2 3"];
  let list, field, gaugeField, gauges, slider, when, mapHost, map, lines, readout, facts, historyHost, profileHost, planeBar, liveBox, order = 0, timer = 0, measured, last = {};

  view.open = main => {
    main.className = "split";
    const left = H.h("div", {class: "column"}), right = H.h("div", {class: "column"});
    main.append(left, right);
    list = H.h("div", {class: "column", style: {gap: "2px"}});
    facts = H.h("div");
    const drop = H.h("div", {class: "drop"});
    measured = new H.Measured(drop, () => view.update(), measured);
    left.append(H.h("h2", {}, "Runs"), list, drop, facts);
    field = H.h("select", {"aria-label": "Field of the map", onchange: () => H.set({f: field.value, pz: ""})});
    slider = H.h("input", {type: "range", min: 0, value: 0, step: 1, "aria-label": "Record", style: {flex: 1, minWidth: "140px"}, oninput: () => H.set({k: slider.value})});
    when = H.h("span", {class: "small", style: {minWidth: "8.5em"}});
    planeBar = H.h("span", {class: "bar small"}, ["mesh", "mirror"].map(key => H.h("label", {}, H.h("input", {type: "checkbox", "data-key": key, onchange: event => H.set({[key]: key === "mesh" ? event.target.checked ? "1" : "" : event.target.checked ? "" : "0"})}), key)));
    mapHost = H.h("div"); historyHost = H.h("div"); profileHost = H.h("div");
    liveBox = H.h("div");
    readout = H.h("div", {class: "readout", "aria-live": "polite", "data-readout": "pointer"});
    gaugeField = H.h("select", {"aria-label": "Field of the histories", onchange: () => H.set({gf: gaugeField.value, hz: ""})});
    gauges = H.h("span", {class: "bar small"});
    state.profileTitle = H.h("h3", {}, "profile at the selected time");
    right.append(liveBox, H.h("div", {class: "bar"}, field, slider, when, planeBar, H.h("span", {class: "bar push"}, ...H.saveButtons(() => map.chart, () => `run-${H.get("f") || "map"}`))), mapHost, readout,
      state.historyBox = H.h("div", {class: "column"}, H.h("h3", {}, "histories"), H.h("div", {class: "bar"}, gaugeField, gauges, H.h("span", {class: "bar push"}, ...H.saveButtons(() => lines.histories, () => "histories"))), historyHost), state.profileTitle, profileHost);
    lines = new H.RunLines(historyHost, profileHost, {onTime: hit => timeRead(hit), onPickTime: hit => setTime(hit.x / lines.ft), onPlace: hit => placeRead(hit)});
    map = null;
  };
  view.close = () => { order++; clearTimeout(timer); if (map) map.chart.stop(); map = null; lines.stop(); last = {}; };
  view.repaint = () => { map?.chart.draw(); lines.histories.draw(); lines.profile.draw(); };
  const chosen = () => Number(H.get("run", "0")) || 0;

  view.update = async () => {
    clearTimeout(timer);
    const mine = ++order;
    try {
      await measured.fromAddress();
      const fresh = !last.run || last.run.live || last.number !== chosen(), opened = fresh ? await H.ask("start") : last.opened;
      if (mine !== order) return;
      drawList(opened);
      if (!opened.runs.length) { H.clear(readout).append("No run is open. Open one with: hugoniot explore flyer.run, or run a deck in the deck editor."); H.command({shell: "hugoniot explore flyer.run", python: 'import hugoniot\nrun = hugoniot.load("flyer.run")'}); return; }
      const run = fresh ? await H.ask("run", {run: chosen()}) : last.run;
      if (mine !== order) return;
      const stamp = run.live ? `live ${run.times.length}` : `done ${run.status} ${run.times.length} ${run.summary?.deck_sha256}`;
      if (last.key !== `${chosen()} ${stamp}`) last = {key: `${chosen()} ${stamp}`, run: await prepared(run), arrays: {}};
      Object.assign(last, {number: chosen(), opened});
      await draw(last.run, mine);
      if (run.live && mine === order) timer = setTimeout(view.update, 1500);
    } catch (error) { H.failed(error); H.clear(readout).append(H.h("span", {class: "bad"}, error.message)); }
  };
  async function prepared(run) {
    const whole = async list => Int32Array.from(list.deflated ? (await H.inflated(list)).data : list.flat());
    if (run.plane && run.zone_nodes) { run.corners = await whole(run.zone_nodes); run.blocks = await whole(run.block_of); }
    return run;
  }
  function drawList(opened) {
    const over = H.list("over").map(Number);
    H.clear(list).append(...opened.runs.map((r, k) => H.h("div", {class: "bar"}, H.h("label", {style: {flex: 1}}, H.h("input", {type: "radio", name: "run", checked: k === chosen(), onchange: () => H.set({run: String(k), k: "", z: "", xt: "", map: "", hz: "", pz: "", g: "", over: over.filter(o => o !== k).join(",")})}),
      H.h("span", {}, r.title, H.h("small", {class: "quiet", style: {display: "block"}}, `${r.name}, ${r.status}`))),
      k === chosen() || opened.runs.length < 2 ? "" : H.h("label", {class: "small"}, H.h("input", {type: "checkbox", checked: over.includes(k), onchange: event => H.set({over: (event.target.checked ? [...over, k] : over.filter(o => o !== k)).join(",")})}), "overlay"))));
  }
  const array = (group, name, more = {}, number = chosen()) => {       // of one description, each column once
    const key = [number, group, name, JSON.stringify(more)].join();
    const known = last.arrays;
    return known[key] ||= H.ask("array", {run: number, group, name, ...more}).catch(error => { delete known[key]; throw error; });
  };
  function fillSelect(select, fields, wanted, favourite) {
    const names = fields.map(f => f.name).join();
    if (select.dataset.names !== names) { select.dataset.names = names; H.clear(select).append(...fields.map(f => H.h("option", {value: f.name}, f.words))); }
    const found = fields.find(f => f.name === wanted) || favourite.map(n => fields.find(f => f.name === n)).find(Boolean) || fields[0];
    if (found) select.value = found.name;
    select.hidden = !found;
    return found;
  }
  async function draw(run, mine) {
    const shown = fillSelect(field, run.fields, H.get("f"), run.plane ? ["pressure"] : ["stress", "pressure"]), many = run.times.length;
    planeBar.hidden = !run.plane;
    for (const input of planeBar.querySelectorAll("input")) { input.checked = input.dataset.key === "mesh" ? H.get("mesh") === "1" : H.get("mirror") !== "0"; input.parentElement.hidden = input.dataset.key === "mirror" && run.geometry !== "axisymmetric"; }
    slider.max = Math.max(many - 1, 0);
    const k = Math.min(H.get("k") === "" ? many - 1 : Number(H.get("k")) || 0, many - 1), [tUnit, ft] = H.timeUnit(run.times[many - 1] || run.stop_time || 1e-6);
    slider.value = k;
    when.textContent = many ? `t = ${H.digits(run.times[k] * ft, 5)} ${tUnit}` : "";
    drawLive(run, tUnit, ft);
    drawFacts(run);
    state.run = run; state.k = k; state.shown = shown;
    const kind = run.plane ? "plane" : "xt";
    if (state.kind !== kind || !map) { if (map) map.chart.stop(); H.clear(mapHost); map = run.plane ? new H.PlaneMap(mapHost, {onHover: planeRead, onPick: pickZone}) : new H.XtMap(mapHost, {onHover: xtRead, onPick: hit => { setTime(hit.t, hit.zone); }}); state.kind = kind; }
    command(run, shown, k);
    if (shown && many) await (run.plane ? drawPlane(run, shown, k, mine) : drawXt(run, shown, k, mine));
    if (mine !== order) return;
    await drawHistories(run, mine, many ? run.times[k] : null);
    if (!readout.childNodes.length) H.clear(readout).append(H.h("span", {class: "quiet"}, "Point at the plot, or focus it and use the arrow keys. A click or Enter picks a zone and a time; drag to pan, + and − zoom, 0 shows everything."));
  }
  async function drawXt(run, shown, k, mine) {
    const [left, right, values] = await Promise.all([array("snapshots", "position_left"), array("snapshots", "position_right"), array("snapshots", shown.name)]);
    const paths = run.gauge_times ? await gaugePaths(run).catch(() => []) : [];
    if (mine !== order) return;
    const n = values.shape[1], [, ft] = H.timeUnit(run.times.at(-1) || run.stop_time || 1e-6), z = H.get("z") === "" ? -1 : Number(H.get("z"));
    run.zones = n;
    const regions = run.regions.length && run.regions.at(-1).last === n - 1 ? run.regions : [{name: "", first: 0, last: n - 1}];
    state.regions = regions;
    const [, fx] = H.lengthUnit(1e-2), marks = [{kind: "hline", y: run.times[k] * ft, colour: "quiet", dash: "4 3"}];
    map.show({...run, regions}, {times: run.times, left, right, values, field: shown, gauges: paths, marks});
    if (z >= 0 && z < n) map.chart.spec.series.push({kind: "line", colour: 4, width: 1.6, hover: false, x: Array.from(run.times, (_, r) => 0.5 * (left.data[r * n + z] + right.data[r * n + z]) * map.fx), y: Array.from(run.times, t => t * map.ft)}), map.chart.draw();
    const centre = Array.from({length: n}, (_, i) => 0.5 * (left.data[k * n + i] + right.data[k * n + i]));
    profileHost.hidden = state.profileTitle.hidden = false;
    const others = await otherProfiles(shown, run.times[k]);
    if (mine !== order) return;
    lines.showProfile(centre, Array.from(values.data.slice(k * n, (k + 1) * n)), shown, regions, run.times[k], run.geometry === "planar" ? "position" : "radius", others);
  }
  async function otherProfiles(shown, time) {       // of the runs that lie over this one, each at its record nearest in time
    const found = [];
    for (const [i, other] of H.list("over").map(Number).filter(o => o !== chosen()).entries()) try {
      const run = await H.ask("run", {run: other});
      if (run.plane || !run.times.length || !run.fields.some(f => f.name === shown.name)) continue;
      const [left, right, values] = await Promise.all(["position_left", "position_right", shown.name].map(name => array("snapshots", name, {}, other))), n = values.shape[1], k = nearest(run.times, time);
      const x = Float64Array.from({length: n}, (_, z) => 0.5 * (left.data[k * n + z] + right.data[k * n + z])), regions = run.regions.length && run.regions.at(-1).last === n - 1 ? run.regions : [{name: "", first: 0, last: n - 1}];
      found.push({x, values: values.data.slice(k * n, (k + 1) * n), regions, suffix: ` · ${last.opened.runs[other]?.name}`, dash: DASHES[i % 3]});
    } catch (error) { H.failed(error); }
    return found;
  }
  const nearest = (times, t) => times.reduce((best, v, i) => Math.abs(v - t) < Math.abs(times[best] - t) ? i : best, 0);
  async function gaugePaths(run) {
    const [time, position] = await Promise.all([array("gauges", "time"), array("gauges", "position")]), n = position.shape[1], every = Math.max(1, Math.floor(time.data.length / 300));
    return Array.from({length: Math.min(n, 8)}, (_, g) => { const t = [], x = []; for (let i = 0; i < time.data.length; i += every) { t.push(time.data[i]); x.push(position.data[i * n + g]); } return {time: t, position: x}; });
  }
  async function drawPlane(run, shown, k, mine) {
    if (!run.corners) return;
    const record = {record: H.exported() ? nearestExported(run, shown, k) : k}, [x, y, values] = await Promise.all(["position_x", "position_y", shown.name].map(name => array("snapshots", name, record)));
    if (mine !== order) return;
    profileHost.hidden = state.profileTitle.hidden = true;
    if (H.exported()) when.textContent += record.record === k ? "" : ` (shown: record ${record.record}, the nearest exported)`;
    map.show({...run, block_of: run.blocks}, {x: x.data, y: y.data, values: values.data, field: shown, record: record.record});
  }
  const nearestExported = (run, shown, k) => { for (let d = 0; d < run.times.length; d++) for (const r of [k - d, k + d]) if (window.hugoniotFiles[`array&group=snapshots&name=${shown.name}&record=${r}&run=${chosen()}`]) return r; return k; };
  // -- histories ---------------------------------------------------------------------------------------------------------
  async function drawHistories(run, mine, at) {
    const fields = run.gauge_fields || [], shown = fillSelect(gaugeField, fields, H.get("gf"), ["velocity", "line_velocity", "normal_velocity", "stress", "pressure"]), lineList = [];
    const picked = H.get("g") === "" ? run.gauges.map((_, k) => k).slice(0, 8) : H.get("g") === "none" ? [] : H.list("g").map(Number);
    H.clear(gauges).append(...run.gauges.slice(0, 24).map((name, k) => H.h("label", {}, H.h("input", {type: "checkbox", checked: picked.includes(k), onchange: event => { const next = event.target.checked ? [...picked, k].sort((a, b) => a - b) : picked.filter(p => p !== k); H.set({g: next.join(",") || "none"}); }}), name)));
    if (shown && run.gauge_times) lineList.push(...await gaugeLines(run, chosen(), shown.name, picked, "", null));
    const others = H.list("over").map(Number).filter(o => o !== chosen());
    for (const [i, other] of others.entries()) try {
      const second = await H.ask("run", {run: other});
      const same = picked.map(k => second.gauges.indexOf(run.gauges[k])).filter(k => k >= 0);
      if (shown) lineList.push(...await gaugeLines(second, other, shown.name, same, ` · ${last.opened.runs[other]?.name}`, DASHES[i % 3]));
    } catch (error) { H.failed(error); }
    const z = H.get("z") === "" ? -1 : Number(H.get("z")), mapped = shown ? run.fields.find(f => f.name === shown.name) : state.shown;
    if (z >= 0 && mapped) try { const v = await zoneHistory(run, mapped.name, z); lineList.push({label: `zone ${z}`, time: run.times, values: v, colour: 4, dash: "5 2"}); } catch (error) { H.failed(error); }
    for (const m of measured.found) if (!shown || !m.unit || m.unit === shown.unit) lineList.push({label: m.label, time: m.time, values: m.values, colour: 7, points: m.time.length < 200});
    if (mine !== order) return;
    state.historyBox.hidden = !lineList.length;
    if (lineList.length) lines.showHistories(lineList, shown || mapped || {unit: "", words: "value", shown: "", factor: 1}, at);
  }
  async function gaugeLines(run, number, name, picked, suffix, dash) {
    if (!run.gauge_times || !run.gauge_fields.some(f => f.name === name)) return [];
    const [time, values] = await Promise.all([array("gauges", "time", {}, number), array("gauges", name, {}, number)]), n = values.shape[1] || 1;
    return picked.filter(k => k < n).map(k => ({label: run.gauges[k] + suffix, colour: k, dash, time: time.data, values: Float64Array.from({length: time.data.length}, (_, i) => values.data[i * n + k])}));
  }
  async function zoneHistory(run, name, z) {
    if (run.plane && H.exported()) {       // from the records that are there
      const values = new Float64Array(run.times.length).fill(NaN);
      for (const k of run.times.keys()) if (window.hugoniotFiles[`array&group=snapshots&name=${name}&record=${k}&run=${chosen()}`]) values[k] = (await array("snapshots", name, {record: k})).data[z];
      return values;
    }
    if (run.plane) return (await H.ask("array", {run: chosen(), group: "snapshots", name, zone: z})).data;
    const values = await array("snapshots", name), n = values.shape[1];
    return Array.from(run.times, (_, k) => values.data[k * n + z]);
  }
  // -- the pointer -------------------------------------------------------------------------------------------------------
  function setTime(t, zone) {
    H.set({k: String(nearest(state.run.times, t)), ...(zone !== undefined && zone >= 0 ? {z: String(zone)} : {})});
  }
  const pickZone = hit => { if (hit.zone >= 0) H.set({z: String(hit.zone)}); };
  const regionOf = z => state.regions?.find(r => z >= r.first && z <= r.last)?.name || "";
  function xtRead(hit) {
    if (!hit || hit.record === undefined) return;
    H.clear(readout).append(H.numbers([["position", `${H.digits(hit.x * map.fx, 5)} ${map.xUnit}`], ["record, time", `${hit.record}, ${H.digits(hit.t * map.ft, 6)} ${map.tUnit}`], ["zone", hit.zone < 0 ? "no material" : `${hit.zone} ${regionOf(hit.zone)}`],
      [map.field.words, hit.value === null ? "–" : `${H.digits(hit.value * map.factor)} ${map.unit}`]]));
    readout.dataset.zone = hit.zone; readout.dataset.record = hit.record;
    const f = lines.histories.frame;      // the same moment among the histories
    if (f && lines.ft) { H.clear(lines.histories.top).append(H.s("line", {x1: f.x.at(hit.t * lines.ft), x2: f.x.at(hit.t * lines.ft), y1: f.top, y2: f.height - f.bottom, stroke: H.palette().quiet})); }
  }
  function planeRead(hit) {
    if (!hit || hit.zone === undefined) return;
    H.clear(readout).append(H.numbers([[state.run.axes[0], `${H.digits(hit.x * map.f, 5)} ${map.lengthUnit}`], [state.run.axes[1], `${H.digits(hit.y * map.f, 5)} ${map.lengthUnit}`], ["zone", hit.zone < 0 ? "no material" : String(hit.zone)],
      [state.shown.words, hit.value === null ? "–" : `${H.digits(hit.value * map.factor)} ${map.unit}`]]));
    readout.dataset.zone = hit.zone; readout.dataset.record = hit.record;
  }
  function timeRead(hit) {
    const s = lines.histories.spec.series[hit.series];
    H.clear(readout).append(H.h("strong", {}, s.id), H.numbers([["time", `${H.digits(hit.x)} ${lines.tUnit}`], [gaugeField.selectedOptions[0]?.textContent || "value", `${H.digits(hit.y)} ${lines.unit}`]]));
    if (state.kind === "xt" && map.ft && map.chart.top) { const f = map.chart.frame, y = f.y.at(hit.x / lines.ft * map.ft); H.clear(map.chart.top).append(H.s("line", {x1: f.left, x2: f.width - f.right, y1: y, y2: y, stroke: H.palette().ink, "stroke-width": 0.9})); }
  }
  function placeRead(hit) {
    const s = lines.profile.spec.series[hit.series];
    H.clear(readout).append(H.h("strong", {}, s.id), H.numbers([["position", `${H.digits(hit.x)} ${lines.xUnit}`], ["zone", String(s.first + hit.index)], [state.shown.words, `${H.digits(hit.y)} ${lines.pUnit}`]]));
  }
  // -- words -------------------------------------------------------------------------------------------------------------
  function drawLive(run, tUnit, ft) {
    H.clear(liveBox);
    if (!run.live) return;
    const at = run.times.at(-1) || 0;
    liveBox.append(H.h("div", {class: "bar"}, H.h("strong", {}, `This run is ${run.status}.`), run.stop_time ? H.h("progress", {max: run.stop_time, value: at, "aria-label": "Time recorded so far"}) : "",
      H.h("span", {class: "small"}, run.times.length ? `recorded to ${H.digits(at * ft, 4)} ${tUnit}` : "nothing recorded yet: the first checkpoint is written after 30 s, or as set in the deck")),
      H.h("details", {}, H.h("summary", {class: "small"}, "run.log"), H.h("pre", {class: "small scroll", tabindex: 0, style: {padding: "6px"}}, (run.log || []).join("\n"))));
  }
  function drawFacts(run) {
    const n = run.numbers || {}, rows = n.gauges || [], units = {arrival: ["arrival", "µs", 1e6], second_arrival: ["second arrival", "µs", 1e6], peak_stress: ["peak stress", "GPa", 1e-9], plateau_stress: ["plateau stress", "GPa", 1e-9], peak_pressure: ["peak pressure", "GPa", 1e-9], plateau_pressure: ["plateau pressure", "GPa", 1e-9], peak_velocity: ["peak velocity", "m/s", 1], plateau_velocity: ["plateau velocity", "m/s", 1]};
    const heads = Object.keys(units).filter(key => rows.some(r => r[key] !== undefined && r[key] !== null)), spall = n.spall || {}, s = run.summary || {};
    H.clear(facts).append(H.h("h2", {}, run.title), H.h("p", {class: "small quiet", style: {margin: "0 0 6px"}}, [run.geometry, s.solver, run.zones ? `${run.zones} zones` : "", s.cycles ? `${s.cycles} cycles` : "", run.every > 1 ? `1 record in ${run.every} is shown` : ""].filter(Boolean).join(", ")),
      s.energy_error === undefined ? "" : H.h("p", {class: "small quiet", style: {margin: "0 0 6px"}}, `relative errors: ${["mass", "momentum", "energy"].map(w => `${w} ${s[`${w}_error`] === null ? "–" : Number(s[`${w}_error`]).toExponential(1)}`).join(", ")}`),
      rows.length ? H.h("div", {class: "scroll wide", tabindex: 0, role: "group", "aria-label": "Table"}, H.h("table", {class: "small"}, H.h("thead", {}, H.h("tr", {}, H.h("th", {}, "gauge"), heads.map(k => H.h("th", {class: "number"}, H.labelled(units[k][0], units[k][1]))))), H.h("tbody", {}, rows.map(r => H.h("tr", {}, H.h("td", {}, r.gauge), heads.map(k => H.h("td", {class: "number"}, H.digits(r[k] === null ? null : r[k] * units[k][2], 5)))))))) : "",
      spall.region ? H.h("div", {class: "small"}, `spall of ${spall.region} (${spall.gauge ? `gauge ${spall.gauge}` : "right face of the snapshots"}${spall.window ? `, towards ${spall.window}` : ""}):`) : "",
      ...[["pull_back", "pull-back", "m/s", 1], ["spall_strength_acoustic", "spall strength, acoustic", "GPa", 1e-9], ["spall_strength_kanel", "with Kanel's correction", "GPa", 1e-9]].filter(([k]) => spall[k]).map(([k, w, u, f]) => H.h("div", {class: "small"}, `${w}: ${k === "spall_strength_acoustic" && spall.note ? "at least " : ""}${H.digits(spall[k] * f, 4)} ${u}`)),
      spall.reason ? H.h("div", {class: "small"}, `spall strength not given: ${spall.reason}`) : "", spall.note ? H.h("div", {class: "small"}, spall.note) : "",
      ...(n.warnings || []).map(w => H.h("div", {class: "small bad"}, `warning: ${w}`)),
      run.events.length ? H.h("details", {}, H.h("summary", {class: "small"}, `${run.event_count > run.events.length ? `the first ${run.events.length} of ${run.event_count}` : run.events.length} events`), H.h("div", {class: "scroll wide small", tabindex: 0, role: "group", "aria-label": "Events"}, run.events.map(e => H.h("div", {style: {padding: "2px 8px"}}, `${H.digits(e.time * 1e6, 5)} µs: ${e.text}`)))) : "");
  }
  function command(run, shown, k) {
    const place = last.opened.runs[chosen()], name = place.typed || place.name, time = run.times[k];
    const f = shown?.name || "stress", [unit, factor] = H.timeUnit(run.times.at(-1) || 1e-6), ascii = unit.replace("µ", "u");
    if (run.live) { H.command({shell: `hugoniot explore ${H.shell(name)}`, python: "# a run in progress is loaded once it has ended:\nimport hugoniot\nrun = hugoniot.load(" + H.python(name) + ")"}); return; }
    H.command(run.plane ? {shell: `hugoniot plot ${H.shell(name)} map ${f} --time "${H.digits(time * factor, 6)} ${ascii}"`, python: `import hugoniot\nrun = hugoniot.load(${H.python(name)})\nrun.plot.map(${H.python(f)}, time=${time})`}
      : {shell: `hugoniot plot ${H.shell(name)} xt ${f}\nhugoniot plot ${H.shell(name)} profile ${f} --time "${H.digits(time * factor, 6)} ${ascii}"`, python: `import hugoniot\nrun = hugoniot.load(${H.python(name)})\nrun.plot.xt(${H.python(f)}).figure.savefig("xt.png")\nrun.snapshots[${H.python(f)}].isel(time=${k * run.every})`});
  }
})();
