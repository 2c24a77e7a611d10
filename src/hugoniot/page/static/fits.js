"use strict";
// A fit: parameters with intervals, data under the model, residuals, and what the data leave open: the posterior near its maximum.
(() => {
  const view = H.views.fits = {};
  let select, facts, table, charts = [], host, pairHost, pair, one, xSelect, ySelect, readout, order = 0, shownKey = "";
  const ELLIPSES = [[0.683, 2.2957], [0.954, 6.1582]];      // of two parameters: probability and the chi-square that encloses it

  view.open = main => {
    select = H.h("select", {"aria-label": "Fit", onchange: () => H.go("fits", {fit: select.value})});
    facts = H.h("div", {class: "readout"}); table = H.h("div"); host = H.h("div", {class: "column"});
    const pick = (label, key) => H.h("select", {"aria-label": label, onchange: event => H.set({[key]: event.target.value, pz: "", oz: ""})});
    xSelect = pick("Parameter on the x axis", "x"); ySelect = pick("Parameter on the y axis", "y");
    pairHost = H.h("div", {class: "fits"});
    readout = H.h("div", {class: "readout", "aria-live": "polite", "data-readout": "pointer"});
    main.append(H.h("div", {class: "column"}, H.h("div", {class: "bar"}, select), facts, table, H.h("h2", {}, "Data and model"), host, readout, H.h("h2", {}, "Uncertainty of the parameters"),
      H.h("div", {class: "bar small"}, H.h("label", {}, "x axis", xSelect), H.h("label", {}, "y axis", ySelect), H.h("span", {class: "bar push"}, ...H.saveButtons(() => pair, () => "posterior"))), pairHost,
      H.h("p", {class: "small quiet"}, "Curves: normal distribution with the values, standard deviations and correlations of the fit. Dots, if any: draws of the sampled posterior distribution.")));
    const left = H.h("div"), right = H.h("div");
    pairHost.append(left, right);
    pair = new H.Chart(left, {label: "Uncertainty of two parameters", height: 0.7, most: 460, keep: true, zoomKey: "pz", onHover: hit => say(pair, hit)});
    one = new H.Chart(right, {label: "Uncertainty of one parameter", height: 0.7, most: 460, keep: true, zoomKey: "oz", onHover: hit => say(one, hit)});
    shownKey = "";
  };
  view.close = () => { order++; for (const c of [...charts, pair, one]) c.stop(); charts = []; };
  view.repaint = () => { for (const c of [...charts, pair, one]) c.draw(); };
  view.update = async () => {
    const mine = ++order;
    try {
      const opened = await H.opened;
      if (!select.options.length) select.append(...opened.fits.map((f, k) => H.h("option", {value: String(k)}, f.name)));
      if (!opened.fits.length) { H.clear(readout).append("No fit is open. Open one with: hugoniot explore DECK.fit (the folder that hugoniot fit writes)"); H.command({shell: "hugoniot explore spall.fit", python: 'import json\nfit = json.load(open("spall.fit/fit.json"))'}); return; }
      const number = H.get("fit", "0"), found = await H.askOnce("fit", {fit: number});
      if (mine !== order) return;
      select.value = number;
      const name = opened.fits[Number(number)].typed;
      H.command({shell: `python -m json.tool ${H.shell(`${name}/fit.json`)}\nhugoniot run ${H.shell(`${name}/fitted.toml`)}`, python: `import json\nfit = json.load(open(${H.python(`${name}/fit.json`)}))\nfor p in fit["parameters"]:\n    print(p["name"], p["value"], p["sigma"], p["unit"])` });
      if (shownKey !== number) { shownKey = number; drawFacts(found.fit); drawTargets(found.targets); }
      drawPosterior(found.fit, found.draws || []);
      if (!readout.childNodes.length) H.clear(readout).append(H.h("span", {class: "quiet"}, "Point at the data, the model or a residual, or focus a plot and use the arrow keys."));
    } catch (error) { H.failed(error); H.clear(readout).append(H.h("span", {class: "bad"}, error.message)); }
  };
  const known = v => v !== null && v !== undefined && Number.isFinite(v);
  const shown = p => { const top = Math.max(...[p.value, p.low, p.high].filter(known).map(Math.abs), 0); return p.unit === "Pa" ? H.fits([top], "GPa", 1e-9) : p.unit === "s" ? H.timeUnit(top) : p.unit === "m" ? H.lengthUnit(top) : [p.unit === "1" ? "" : p.unit, 1]; };
  const inUnit = (t, top) => t.unit === "s" ? H.timeUnit(top) : t.unit === "Pa" ? H.fits([top], "GPa", 1e-9) : t.unit === "m" ? H.lengthUnit(top) : [t.shown, t.factor];
  const words = p => H.labelled(p.name.replace(/_/g, " "), shown(p)[0]);

  function drawFacts(fit) {
    H.clear(facts).append(H.numbers([["reduced χ²", H.digits(fit.reduced_chi_square, 4)], ["degrees of freedom", String(fit.degrees_of_freedom)], ["runs", String(fit.runs)], ["model consistent with the data", fit.matches ? "yes" : "no"]]),
      ...fit.doubts.map(t => H.h("p", {class: "bad small"}, t)), ...fit.notes.map(t => H.h("p", {class: "small quiet"}, t)));
    const rows = fit.parameters.map(p => { const [unit, f] = shown(p), n = (v, d = 5) => known(v) ? H.digits(v * f, d) : "–"; return [p.name, unit, n(p.value, 6), n(p.sigma, 3), `${n(p.low)} to ${n(p.high)}`, known(p.profile_low) || known(p.profile_high) ? `${n(p.profile_low)} to ${n(p.profile_high)}` : "–"]; });
    H.clear(table).append(H.h("div", {class: "scroll wide", tabindex: 0, role: "group", "aria-label": "Parameters"}, H.h("table", {"data-table": "parameters"}, H.h("thead", {}, H.h("tr", {}, ["parameter", "unit", "value", "standard deviation", "95 % interval", "95 % profile-likelihood interval"].map((t, k) => H.h("th", {class: k > 1 ? "number" : ""}, t)))),
      H.h("tbody", {}, rows.map((r, j) => H.h("tr", {"data-parameter": fit.parameters[j].name}, r.map((t, k) => H.h("td", {class: k > 1 ? "number" : ""}, t))))))));
  }
  function drawTargets(targets) {
    for (const c of charts) c.stop();
    charts = [];
    H.clear(host);
    const single = targets.filter(t => t.time.length === 1);
    if (single.length) host.append(H.h("div", {class: "scroll wide", tabindex: 0, role: "group", "aria-label": "Numbers"}, H.h("table", {}, H.h("thead", {}, H.h("tr", {}, ["quantity", "measured", "± σ", "model", "(model − data) / σ"].map((t, k) => H.h("th", {class: k ? "number" : ""}, t)))),
      H.h("tbody", {}, single.map(t => { const [unit, f] = inUnit(t, Math.abs(t.data[0])); return H.h("tr", {}, H.h("td", {}, t.label), [t.data[0], t.sigma[0], t.model[0]].map(v => H.h("td", {class: "number"}, `${H.digits(known(v) ? v * f : v)} ${unit}`)), H.h("td", {class: "number"}, H.digits(t.residual[0], 3))); })))));
    for (const t of targets.filter(t => t.time.length > 1)) {
      const box = H.h("div"), above = H.h("div"), below = H.h("div"), [tUnit, ft] = t.pop_plot ? ["GPa", 1e-9] : H.timeUnit(t.time.at(-1) || 1e-6), along = H.labelled(t.pop_plot ? "input pressure" : "time", tUnit), top = t.data.reduce((m, v) => Math.max(m, Math.abs(v) || 0), 0), [unit, factor] = inUnit(t, top), words = t.pop_plot ? "run distance" : t.words;
      host.append(H.h("h3", {}, t.label), box);
      box.append(above, below);
      const x = t.time.map(v => v * ft), y = v => v.map(n => n === null ? null : n * factor), sides = [-2, 2].map(k => t.data.map((v, i) => known(v) && known(t.sigma[i]) ? (v + k * t.sigma[i]) * factor : null));
      const data = new H.Chart(above, {label: `Data and model: ${t.label}`, height: 0.3, most: 320, least: 220, keep: true, zoomKey: `d${charts.length / 2}`, onHover: hit => say(data, hit)}), rest = new H.Chart(below, {label: `Residuals: ${t.label}`, height: 0.16, most: 180, least: 150, keep: true, zoomKey: `r${charts.length / 2}`, onHover: hit => say(rest, hit)});
      charts.push(data, rest);
      data.show({series: [{kind: "band", colour: "quiet", x, y: sides[0], y2: sides[1]}, {kind: "points", id: "data", colour: "ink", size: 1.8, x, y: y(t.data), hover: true}, {kind: "line", id: "model", label: "model", colour: 1, x, y: y(t.model), hover: true}], x: {label: along, log: t.pop_plot}, y: {label: H.labelled(words, unit), log: t.pop_plot}, right: 70});
      rest.show({series: [{kind: "band", colour: "quiet", x: [x[0], x.at(-1)], y: [-2, -2], y2: [2, 2]}, {kind: "line", id: "residual", colour: 1, x, y: t.residual, hover: true, width: 1.1}], marks: [{kind: "hline", y: 0, colour: "quiet"}], x: {label: along, log: t.pop_plot}, y: {label: "(model − data) / σ"}, right: 70});
      host.append(H.h("p", {class: "small quiet", style: {margin: 0}}, "Dots: data. Band: two standard deviations of the data. Line: model with the fitted values."));
    }
  }
  function drawPosterior(fit, draws) {
    const usable = fit.parameters.map((p, k) => ({...p, k})).filter(p => known(p.value) && p.sigma > 0), fill = (s, wanted, otherwise) => { H.clear(s).append(...usable.map(p => H.h("option", {value: String(p.k)}, p.name))); s.value = usable.some(p => String(p.k) === wanted) ? wanted : otherwise; };
    pairHost.hidden = !usable.length;
    if (!usable.length) return;
    fill(xSelect, H.get("x"), String(usable[0].k));
    const other = usable.find(p => String(p.k) !== xSelect.value);
    fill(ySelect, H.get("y") === xSelect.value ? "" : H.get("y"), String((other || usable[0]).k));
    ySelect.parentElement.hidden = pair.box.hidden = !other;
    const a = fit.parameters[xSelect.value], [ua, fa] = shown(a);
    if (other) {
      const b = fit.parameters[ySelect.value], [, fb] = shown(b), r = fit.correlation[xSelect.value][ySelect.value], turn = Array.from({length: 121}, (_, k) => 2 * Math.PI * k / 120);
      const series = ELLIPSES.map(([share, square], k) => { const s = Math.sqrt(square), x = turn.map(t => (a.value + s * a.sigma * Math.cos(t)) * fa), y = turn.map(t => (b.value + s * b.sigma * (r * Math.cos(t) + Math.sqrt(Math.max(1 - r * r, 0)) * Math.sin(t))) * fb); return {kind: "line", id: `${(100 * share).toFixed(1)} %`, label: `${(100 * share).toFixed(1)} %`, colour: k, hover: true, x, y}; });
      if (draws.length) series.unshift({kind: "points", id: "draw", colour: "quiet", size: 1.4, filled: true, faint: true, x: draws[xSelect.value].map(v => v * fa), y: draws[ySelect.value].map(v => v * fb)});
      const others = (fit.others || []).map(o => [o.values[xSelect.value] * fa, o.values[ySelect.value] * fb]);
      if (others.length) series.push({kind: "points", id: "other minimum", colour: 3, filled: true, outside: true, x: others.map(o => o[0]), y: others.map(o => o[1]), hover: true});
      pair.show({series, marks: [{kind: "dot", x: a.value * fa, y: b.value * fb, colour: "ink", label: `correlation ${r.toFixed(2)}`}], x: {label: words(a)}, y: {label: words(b)}});
    }
    const x = Array.from({length: 161}, (_, k) => a.value + (k - 80) / 20 * a.sigma), y = x.map(v => Math.exp(-0.5 * ((v - a.value) / a.sigma) ** 2) / (a.sigma * fa * Math.sqrt(2 * Math.PI)));
    const lines = [[a.low, "95 %"], [a.high, "95 %"], [a.profile_low, "profile"], [a.profile_high, "profile"]].filter(([v]) => known(v));
    one.show({series: [{kind: "line", id: "density", colour: 0, x: x.map(v => v * fa), y, hover: true}], marks: lines.map(([v, label], k) => ({kind: "vline", x: v * fa, y: y[80] * (label === "95 %" ? 0.95 : 0.85), colour: label === "95 %" ? 1 : 2, dash: "5 3", label, side: k % 2 ? "right" : "left"})), x: {label: words(a)}, y: {label: `probability density (1/${ua || "unit"})`, min: 0}});
  }
  function say(chart, hit) {
    const s = chart.spec.series[hit.series], {x, y} = chart.spec;
    H.clear(readout).append(H.h("strong", {}, s.id), H.numbers([[x.label, H.digits(hit.x)], [y.label, H.digits(hit.y)]]));
  }
})();
