"use strict";
// Materials side by side: curves in one plane, the state under the pointer, a pinned state with its Rayleigh line, what is known.
(() => {
  const view = H.views.materials = {}, MOST = 8;
  let list, chart, chips, planes, options, readout, table, about, hint, order = 0;

  view.open = main => {
    main.className = "split";
    const left = H.h("div", {class: "column"}), right = H.h("div", {class: "column"});
    main.append(left, right);
    list = new H.MaterialList(left, chosen => H.set({sel: chosen.slice(-MOST).join(",")}));
    chips = H.h("div", {class: "bar", "aria-label": "Chosen materials"});
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
    right.append(chips, planes, host, H.h("div", {class: "bar"}, option("measured", "measured states"), option("sources", "other sources"), option("releases", "releases"),
        H.h("span", {class: "bar push"}, H.h("label", {class: "small"}, "state at", by), at, H.h("button", {type: "button", onclick: pin}, "Pin"),
          H.h("button", {type: "button", onclick: () => H.set({at: ""})}, "Unpin"), ...H.saveButtons(() => chart, () => `${H.list("sel").join("-") || "materials"}-${plane()}`))),
      readout, table, hint, about);
    chart = new H.Chart(host, {label: "Curves of the chosen materials", height: 0.6, keep: true, onHover: hover, onPick: hit => {
      const s = chart.spec.series[hit.series];
      if (s.table?.particle_velocity && ["hugoniot", "beyond"].includes(s.id)) H.set({at: `particle_velocity:${s.table.particle_velocity[hit.index]}`});
    }, onZoom: zoom => H.set({zoom: zoom ? [...zoom.x, ...zoom.y].map(v => v.toPrecision(6)).join(",") : ""}, false)});
  };
  view.close = () => { chart.stop(); };
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
    draw(names, known);
    drawAbout(names);
    if (!by) { drawTable(known); return; }
    await Promise.all(known.map(async c => { if (c?.hugoniot) try { c.pinned = await stateAt(c, by, Number(value)); } catch (error) { c.refused = error.message; } }));
    if (mine !== order) return;
    draw(names, known);
    drawTable(known);
  };
  async function stateAt(c, by, value) {
    if (!H.exported()) return H.askOnce("state", {name: c.name, by, value});
    const h = c.hugoniot, column = h[by], k = column.reduce((best, v, i) => Math.abs(v - value) < Math.abs(column[best] - value) ? i : best, 0);
    return {state: Object.fromEntries(Object.entries(h).map(([key, v]) => [key, v[k]])), ahead: c.ahead, release: null};
  }
  function draw(names, known) {
    const [, definition] = H.planes[plane()], shown = {measured: H.get("measured") !== "0", sources: H.get("sources") === "1", releases: H.get("releases") === "1"};
    const series = [], marks = [], silent = [], brief = known.map(c => c?.title.split(/[,(]/)[0].trim());
    known.forEach((c, k) => { if (c) c.short = brief.filter(b => b === brief[k]).length > 1 ? c.title : brief[k]; });
    known.forEach((c, k) => {
      if (!c) return;
      const found = definition.series(c, k, shown);
      if (!found.some(s => s.x.length)) silent.push(c.title);
      series.push(...found);
      marks.push(...definition.marks(c, k));
    });
    const ends = known.filter(c => c?.hugoniot).map(c => c.hugoniot.particle_velocity.at(-1) * 1e-3);
    const all = [Math.max(...ends), 2.5 * Math.min(...ends)];      // a curve that goes much further than the others does not make them small
    const zoom = H.get("zoom").split(",").map(Number), [x, y] = definition.axes;
    const close = ["us-up", "p-up"].includes(plane()) && all[0] > all[1], top = close ? {max: all[1]} : {};
    if (close) cut(series, all[1]);
    chart.show({series, marks, x: {...x, ...top}, y, zoom: zoom.length === 4 && zoom.every(Number.isFinite) ? {x: zoom.slice(0, 2), y: zoom.slice(2)} : null});
    H.clear(chips).append(...names.map((name, k) => H.h("span", {class: "chip"}, H.h("i", {style: {background: H.palette().lines[k % 8]}}), known[k]?.title || name,
      H.h("button", {type: "button", "aria-label": `Remove ${name}`, onclick: () => H.set({sel: names.filter(n => n !== name).join(",")})}, "×"))),
      names.length ? "" : H.h("span", {class: "quiet"}, "Choose materials from the list."));
    const notes = known.flatMap(c => c ? [...c.notes, ...(c.refused ? [c.refused] : [])] : []);
    if (silent.length) notes.push(`Not in this plane: ${silent.join(", ")}.`);
    if (series.some(s => s.id === "beyond")) notes.push("Dashed curve: beyond the range of the data.");
    if (series.some(s => s.id === "release") && plane() !== "expansion") notes.push("Thin: isentropes through states of the Hugoniot.");
    if (["p-up", "p-v"].includes(plane())) notes.push("The dashed straight line to the pointer or to a pinned state is its Rayleigh line.");
    if (plane() === "pop" && series.length) notes.push("Band: one standard deviation of the line's constant, where its source states one.");
    if (plane() === "gurney" && series.length) notes.push("M of the sandwich counts both plates.");
    if (plane() === "isentropes") notes.push("Dashed: isentrope through the state at rest.");
    if (plane() === "detonation") notes.push("Dashed straight line: Rayleigh line to the CJ state; dashed curve: isentrope of the products through it.");
    hint.textContent = notes.join(" ");
    if (!readout.childNodes.length || !names.length) H.clear(readout).append(H.h("span", {class: "quiet"}, names.length ? "Point at a curve, or focus the picture and use the arrow keys. Enter pins a state; + − 0 and dragging zoom." : ""));
    command(names);
  }
  function cut(series, most) {       // what lies outside does not count for the height either
    for (const s of series) {
      const n = s.x.findIndex(v => v > most);
      if (n >= 0 && s.kind !== "points") { s.x = s.x.slice(0, n && n + 1); s.y = s.y.slice(0, n && n + 1); }
    }
  }
  function hover(hit) {
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
      table.append(H.h("div", {class: "scroll wide"}, H.h("table", {"data-table": words}, H.h("thead", {}, H.h("tr", {}, H.h("th", {}, words), heads.map(h => H.h("th", {class: "number"}, h)))),
        H.h("tbody", {}, keys.map(key => {
          const [name, unit, factor] = H.units[key] || [key.replace(/_/g, " "), "", 1], [shown, by] = H.fits(columns.map(c => c[key]), unit, factor);
          return H.h("tr", {"data-field": key}, H.h("td", {}, H.labelled(name, shown)), columns.map(c => H.h("td", {class: "number"}, H.digits(c[key] === null || c[key] === undefined ? null : c[key] * by))));
        })))));
    };
    if (products.length) grid(products.map(c => c.title), products.map(c => ({...c.products.cj})), "CJ state");
    else if (pinned.length) grid(pinned.map(c => c.title), pinned.map(c => c.pinned.state), "state on the Hugoniot");
  }
  async function drawAbout(names) {
    const name = names[names.length - 1];
    if (!name) { H.clear(about); return; }
    try { const known = await H.askOnce("about", {name}); if (H.list("sel").slice(-1)[0] === name) H.clear(about).append(H.aboutMaterial(known)); } catch (error) { H.failed(error); }
  }
  function command(names) {
    const some = names.length ? names : ["copper"], list = some.map(H.shell).join(" "), [by, value] = H.get("at").split(":");
    const state = !by ? "" : by === "pressure" ? `pressure = ${Number((value * 1e-9).toPrecision(15))} GPa` : `${by} = ${Number(value)} m/s`, at = state ? ` --at "${state}"` : "";
    const finds = some.map(n => `find(${H.python(n)})`).join(", ");
    const head = "from hugoniot.materials.library import find\n";
    const shells = {isentropes: `hugoniot eos isentrope ${list}${at || ' --at "particle_velocity = 1000 m/s"'} --plot isentropes.png`, detonation: `hugoniot eos hugoniot ${list} --reaction --axes p-v --plot detonation.png`,
      expansion: `hugoniot eos isentrope ${list} --csv expansion.csv`, gurney: `hugoniot material show ${H.shell(some[0])}`, pop: `hugoniot material show ${H.shell(some[0])}`};
    const pythons = {isentropes: `from hugoniot.theory.hugoniot import shock\nfrom hugoniot.theory.isentrope import release\nfor m in (${finds},):\n    print(release(m, shock(m, ${by || "particle_velocity"}=${Number(value) || 1000}), points=25).table())`,
      detonation: `from hugoniot.theory.chapman_jouguet import cj, detonation_hugoniot\nfor m in (${finds},):\n    print(cj(m).table(), detonation_hugoniot(m).table())`,
      expansion: `from hugoniot.theory.chapman_jouguet import cj\nfrom hugoniot.theory.isentrope import expansion_to\nfor m in (${finds},):\n    print(expansion_to(m, cj(m).state, 1e5, 50).table())`,
      gurney: `from hugoniot.materials.library import entry\nprint(entry(${H.python(some[0])}).detonation)`, pop: `from hugoniot.materials.library import pop_lines\nprint(pop_lines(${H.python(some[0])}))`};
    const shell = shells[plane()] || `hugoniot eos hugoniot ${list}${at} --axes ${plane()} --plot hugoniots.png`;
    const python = pythons[plane()] || `from hugoniot.theory.hugoniot import ${by ? "shock" : "curve"}\nfor m in (${finds},):\n    print(${by ? `shock(m, ${by}=${Number(value)})` : "curve(m)"}.table())`;
    H.command({shell, python: ["gurney", "pop"].includes(plane()) ? python : head + python});
  }
  H.aboutMaterial = known => {
    const sources = [], number = c => { const key = `${c.source}|${c.via}`; if (!sources.includes(key)) sources.push(key); return sources.indexOf(key) + 1; };
    const rows = known.constants.map(c => H.h("tr", {}, H.h("td", {}, c.quantity), H.h("td", {class: "number"}, typeof c.value === "number" ? H.digits(c.value) : String(c.value)), H.h("td", {}, c.unit === "1" || c.unit === "text" ? "" : c.unit),
      H.h("td", {}, c.status === "default" ? "" : `[${number(c)}]`), H.h("td", {class: c.mark ? "bad" : ""}, c.mark)));
    const lines = (head, items) => items.length ? [H.h("h3", {}, head), ...items.map(t => H.h("div", {class: "small"}, t))] : [];
    return H.h("details", {open: false}, H.h("summary", {}, H.h("strong", {}, known.title), H.h("span", {class: "quiet"}, ` ${known.name}: constants, sources, marks`)),
      ...known.warnings.map(w => H.h("p", {class: "bad small"}, w)),
      H.h("div", {class: "scroll wide"}, H.h("table", {class: "small"}, H.h("thead", {}, H.h("tr", {}, ["constant", "value", "unit (SI)", "source", "mark"].map((t, k) => H.h("th", {class: k === 1 ? "number" : ""}, t)))), H.h("tbody", {}, rows))),
      ...lines("derived", Object.entries(known.derived).map(([k, q]) => `${k.replace(/_/g, " ")}: ${H.digits(q.value)} ${q.unit === "1" ? "" : q.unit} (${q.meaning})`)),
      ...lines("choices", Object.entries(known.reasons).map(([k, t]) => `${k}: ${t}`)), ...lines("missing", known.missing), ...lines("notes", known.notes), ...lines("fits of measured states", known.fits),
      ...lines("other sources", known.others.map(o => `${o.row} (${o.family}) ${o.summary}: ${o.source}`)),
      ...lines("sources", sources.map((s, k) => `[${k + 1}] ${s.split("|")[0]}`)));
  };
})();
