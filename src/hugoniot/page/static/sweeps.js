"use strict";
// A table of cases: parallel coordinates and a scatter, brushed together; a case opens its run.
(() => {
  const view = H.views.sweeps = {};
  let select, host, parallel, scatter, xSelect, ySelect, cSelect, table, count, data, readout, said, order = 0, columnsBox;

  view.open = main => {
    select = H.h("select", {"aria-label": "Table", onchange: () => H.set({sweep: select.value, x: "", y: "", c: "", brush: "", cols: "", sz: ""})});
    count = H.h("span", {class: "quiet small", "aria-live": "polite"});
    host = H.h("div", {class: "chart", style: {height: "300px"}});
    parallel = H.s("svg", {role: "group", "aria-label": "Parallel coordinates"});
    host.append(parallel);
    const pick = (label, key) => H.h("select", {"aria-label": label, onchange: event => H.set({[key]: event.target.value, sz: ""})});
    xSelect = pick("x axis", "x"); ySelect = pick("y axis", "y"); cSelect = pick("Colour", "c");
    columnsBox = H.h("details", {class: "small"});
    const scatterHost = H.h("div");
    table = H.h("div", {class: "scroll wide", tabindex: 0, role: "group", "aria-label": "Table"});
    readout = H.h("div", {class: "readout", "aria-live": "polite"});
    said = H.h("div");
    main.append(H.h("div", {class: "column"}, H.h("div", {class: "bar"}, select, count, H.h("span", {class: "push"}, H.h("button", {type: "button", onclick: () => H.set({brush: ""})}, "Clear the brushes"))), columnsBox, host,
      H.h("div", {class: "bar small"}, H.h("label", {}, "x axis", xSelect), H.h("label", {}, "y axis", ySelect), H.h("label", {}, "colour", cSelect), H.h("span", {class: "bar push"}, ...H.saveButtons(() => scatter, () => "sweep"))), scatterHost, readout, said, table));
    scatter = new H.Chart(scatterHost, {label: "Cases", height: 0.42, most: 430, keep: true, zoomKey: "sz", onHover: hit => read(scatter.spec.series[hit.series].rows[hit.index]), onPick: hit => openRun(scatter.spec.series[hit.series].rows[hit.index])});
    new ResizeObserver(() => { if (data) drawParallel(); }).observe(host);
  };
  view.close = () => { order++; scatter.stop(); data = null; };
  view.repaint = () => view.update();
  view.update = async () => {
    const mine = ++order;
    try {
      const opened = await H.opened;
      if (!select.options.length) select.append(...opened.sweeps.map((s, k) => H.h("option", {value: String(k)}, s.name)));
      if (!opened.sweeps.length) { H.clear(readout).append("No table is open. Open one with: hugoniot explore SWEEP (a folder with cases.csv, or any CSV table with a header line)"); H.command({shell: "hugoniot explore sweep/", python: 'import csv\nrows = list(csv.DictReader(open("sweep/cases.csv")))'}); return; }
      const found = await H.askOnce("sweep", {sweep: H.get("sweep", "0")});
      if (mine !== order) return;
      data = inWords(found);
      select.value = H.get("sweep", "0");
      drawSaid(found);
      draw(opened);
    } catch (error) { H.failed(error); H.clear(readout).append(H.h("span", {class: "bad"}, error.message)); }
  };
  // SI columns in the units people use
  function inWords(found) {
    if (found.inWords) return found.inWords;
    const columns = found.columns.map(c => {
      const name = c.name.replace(/_/g, " "), top = c.numeric ? c.cells.reduce((m, v) => Math.max(m, Math.abs(v) || 0), 0) : 0;
      const [unit, factor] = !top ? [c.unit, 1] : c.unit === "Pa" ? H.fits([top], "GPa", 1e-9) : c.unit === "s" ? H.timeUnit(top) : c.unit === "m" ? H.lengthUnit(top) : [c.unit, 1];
      return {...c, name, unit, factor, cells: factor === 1 ? c.cells : c.cells.map(v => v === null ? null : v * factor)};
    });
    return found.inWords = {...found, columns};
  }
  const ASIDE = /(^case$| error$|^cycles$|^end time$|^voids |^interfaces |acted$)/, GIVEN = /^(region|material|block|solver|boundary|gauge|output|stop time|velocity$|flyer|target)/;
  const numeric = () => data.columns.map((c, k) => ({...c, k})).filter(c => c.numeric);
  const varying = () => numeric().filter(c => new Set(c.cells.filter(v => v !== null)).size > 1);
  const shownColumns = () => { const own = H.get("cols"); return own ? numeric().filter(c => own.split(".").includes(String(c.k))) : varying().filter(c => !ASIDE.test(c.name)).slice(0, Math.min(10, Math.max(3, Math.floor(host.clientWidth / 100)))); };
  const brushes = () => Object.fromEntries(H.get("brush").split(";").filter(Boolean).map(b => { const [k, low, high] = b.split(":").map(Number); return [k, [low, high]]; }));
  const kept = () => { const b = Object.entries(brushes()); return Array.from({length: data.rows}, (_, r) => b.every(([k, [low, high]]) => { const v = data.columns[k]?.cells[r]; return v !== null && v >= low && v <= high; })); };
  const named = c => H.labelled(c.name, c.unit);

  function draw(opened) {
    const able = varying().length > 1 ? varying() : numeric(), first = able.filter(c => !ASIDE.test(c.name)), result = first.slice(1).find(c => !GIVEN.test(c.name)) || first[1] || able.at(-1), fill = (s, wanted, fallback, none) => {
      H.clear(s).append(...(none ? [H.h("option", {value: "none"}, none)] : []), ...able.map(c => H.h("option", {value: String(c.k)}, named(c))));
      s.value = [...s.options].some(o => o.value === wanted) ? wanted : fallback;
    };
    if (!able.length) { H.clear(readout).append("This table has no numbers to plot."); drawTable(kept()); return; }
    const third = first.find(c => c !== first[0] && c !== result);
    fill(xSelect, H.get("x"), String((first[0] || able[0]).k)); fill(ySelect, H.get("y"), String(result.k)); fill(cSelect, H.get("c"), third ? String(third.k) : "none", "no colour");
    const own = shownColumns().map(c => c.k);
    const isOpen = columnsBox.open;
    H.clear(columnsBox).append(H.h("summary", {}, `${own.length} of ${numeric().length} numeric columns are shown`), H.h("div", {class: "bar"}, numeric().map(c => H.h("label", {}, H.h("input", {type: "checkbox", checked: own.includes(c.k),
      onchange: event => H.set({cols: (event.target.checked ? [...own, c.k] : own.filter(k => k !== c.k)).join(".")})}), named(c)))));
    columnsBox.open = isOpen;
    const keep = kept();
    count.textContent = `${keep.filter(Boolean).length} of ${data.rows} cases, ${data.runs.length} with a run ${H.exported() ? "(hugoniot explore opens it)" : "to open"}`;
    drawParallel();
    drawScatter(keep);
    drawTable(keep);
    if (!readout.childNodes.length) H.clear(readout).append(H.h("span", {class: "quiet"}, "Point at a case. Drag along an axis above to select a range, or focus it and use the arrow keys (Shift: its upper end, Delete: all); click a case to open its run."));
    const name = opened.sweeps[Number(select.value)].typed;
    H.command({shell: `hugoniot explore ${H.shell(name)} --view ${H.shell(H.address("sweeps", withoutNumber()))}`, python: inPython(name.endsWith(".csv") ? name : `${name}/cases.csv`)});
  }
  const withoutNumber = () => { const {query} = H.read(); query.delete("sweep"); return query; };      // of the one table that the command opens
  function inPython(file) {       // the cases within the brushes: their number, and the scatter
    const value = (c, row) => `value(${row}, ${H.python(c.head)})${c.factor === 1 ? "" : ` * ${c.factor}`}`;
    const within = Object.entries(brushes()).map(([k, [low, high]]) => `${low} <= ${value(data.columns[k], "r")} <= ${high}`).join(" and ");
    return `import csv\n\ndef value(row, head):\n    try:\n        return float(row[head])\n    except ValueError:\n        return float("nan")\n\nwith open(${H.python(file)}, newline="") as file:\n` +
      `    rows = list(csv.DictReader((line for line in file if not line.startswith("#")), skipinitialspace=True))\nkept = [r for r in rows${within && ` if ${within}`}]\n` +
      `print(len(kept), [(${value(data.columns[xSelect.value], "r")}, ${value(data.columns[ySelect.value], "r")}) for r in kept])`;
  }
  const rampOf = cells => { const known = cells.filter(v => v !== null), low = Math.min(...known), high = Math.max(...known), scale = {ramp: H.ramps.rising, low, high: high > low ? high : low + 1}; return {scale, colour: v => v === null ? H.palette().quiet : H.css(scale.ramp[Math.round(235 * (v - scale.low) / (scale.high - scale.low))])}; };
  function drawScatter(keep) {
    const x = data.columns[xSelect.value], y = data.columns[ySelect.value], c = cSelect.value === "none" ? null : data.columns[cSelect.value], rows = [...keep.keys()].filter(r => x.cells[r] !== null && y.cells[r] !== null), ramp = c && rampOf(c.cells);
    const series = [];
    const faint = rows.filter(r => !keep[r]);
    if (faint.length) series.push({kind: "points", colour: "faint", x: faint.map(r => x.cells[r]), y: faint.map(r => y.cells[r]), rows: faint, size: 3});
    const groups = new Map();
    for (const r of rows.filter(r => keep[r])) { const colour = ramp ? ramp.colour(c.cells[r]) : 0; if (!groups.has(colour)) groups.set(colour, []); groups.get(colour).push(r); }
    for (const [colour, some] of groups) series.push({kind: "points", filled: true, hover: true, colour, x: some.map(r => x.cells[r]), y: some.map(r => y.cells[r]), rows: some, size: 4});
    scatter.show({series, x: {label: named(x)}, y: {label: named(y)}, ...(ramp ? {bar: {scale: {...ramp.scale, ramp: ramp.scale.ramp}, factor: 1, label: named(c)}} : {})});
  }
  // -- parallel coordinates ------------------------------------------------------------------------------------------------
  function drawParallel() {
    const columns = shownColumns(), width = host.clientWidth, height = width < 560 ? 240 : 300, p = H.palette(), keep = kept(), b = brushes(), left = 50, right = 50, top = 40, bottom = 14;
    const focused = parallel.contains(document.activeElement) ? document.activeElement.getAttribute("data-brush") : null;
    host.style.height = `${height}px`;
    H.clear(parallel).setAttribute("viewBox", `0 0 ${width} ${height}`);
    if (columns.length < 2) return;
    const xs = columns.map((_, k) => left + (width - left - right) * k / (columns.length - 1)), ranges = columns.map(c => { const known = c.cells.filter(v => v !== null); const low = Math.min(...known), high = Math.max(...known); return [low, high > low ? high : low + 1]; });
    const at = (k, v) => height - bottom - (v - ranges[k][0]) / (ranges[k][1] - ranges[k][0]) * (height - top - bottom), c = cSelect.value === "none" ? null : data.columns[cSelect.value], ramp = c && rampOf(c.cells);
    const many = Math.max(1, Math.ceil(data.rows / 1500)), draw = (r, colour, opacity) => {
      let d = "", pen = false;
      columns.forEach((col, k) => { const v = col.cells[r]; if (v === null) { pen = false; return; } d += `${pen ? "L" : "M"}${xs[k].toFixed(1)} ${at(k, v).toFixed(1)}`; pen = true; });
      parallel.append(H.s("path", {d, fill: "none", stroke: colour, "stroke-width": 1.2, opacity, "data-row": r}));
    };
    for (let r = 0; r < data.rows; r += many) if (!keep[r]) draw(r, p.faint, 0.7);
    for (let r = 0; r < data.rows; r += many) if (keep[r]) draw(r, ramp ? ramp.colour(c.cells[r]) : p.lines[0], data.rows > 300 ? 0.4 : 0.8);
    const words = (x, y, t, anchor, size = 11) => H.s("text", {x, y, fill: p.text, "font-size": size, "font-family": FONT, "text-anchor": anchor, stroke: p.paper, "stroke-width": 3, "paint-order": "stroke"}, t);
    columns.forEach((col, k) => {
      const room = (width - left - right) / (columns.length - 1), most = Math.max(Math.floor(2 * room / 6.4) - 1, 8), name = named(col), anchor = k === 0 ? "start" : k === columns.length - 1 ? "end" : "middle", at0 = k === 0 ? 4 : k === columns.length - 1 ? width - 4 : xs[k];
      parallel.append(H.s("line", {x1: xs[k], x2: xs[k], y1: top, y2: height - bottom, stroke: p.ink, "stroke-width": 1}), words(at0, k % 2 ? 12 : 26, name.length > most ? `${name.slice(0, most - 1)}…` : name, anchor),
        words(xs[k] - 5, top + 4, H.digits(ranges[k][1], 4), "end", 10), words(xs[k] - 5, height - bottom, H.digits(ranges[k][0], 4), "end", 10));
      const brush = b[col.k];
      if (brush) parallel.append(H.s("rect", {x: xs[k] - 6, width: 12, y: Math.min(at(k, brush[1]), height), height: Math.max(Math.abs(at(k, brush[0]) - at(k, brush[1])), 2), fill: p.lines[1], opacity: 0.35, stroke: p.lines[1]}));
      const [least, greatest] = ranges[k], span = greatest - least, between = brush || [least, greatest];
      const grip = H.s("rect", {x: xs[k] - 12, width: 24, y: top - 6, height: height - top - bottom + 12, fill: "transparent", cursor: "ns-resize", tabindex: 0, role: "slider", "data-brush": col.k, "aria-label": `Range of ${name}`,
        "aria-valuemin": least, "aria-valuemax": greatest, "aria-valuenow": 0.5 * (between[0] + between[1]), "aria-valuetext": brush ? `${H.digits(brush[0], 4)} to ${H.digits(brush[1], 4)}` : "all"});
      grip.addEventListener("keydown", event => {      // a first press keeps the middle half, further ones move it, with Shift its upper end
        const step = {ArrowUp: 0.05, ArrowDown: -0.05}[event.key] * span;
        if (["Delete", "Backspace", "Escape"].includes(event.key)) setBrush(col.k, null);
        else if (!step) return;
        else if (!brush) setBrush(col.k, [least + 0.25 * span, greatest - 0.25 * span]);
        else setBrush(col.k, event.shiftKey ? [brush[0], Math.max(brush[1] + step, brush[0])] : brush.map(v => v + step));
        event.preventDefault();
      });
      let from = null;
      const value = event => { const box = parallel.getBoundingClientRect(), y = (event.clientY - box.top) * height / box.height; return ranges[k][0] + (height - bottom - y) / (height - top - bottom) * (ranges[k][1] - ranges[k][0]); };
      grip.addEventListener("pointerdown", event => { from = value(event); grip.setPointerCapture(event.pointerId); });
      grip.addEventListener("pointerup", event => {
        const to = value(event);
        setBrush(col.k, Math.abs(to - from) < 0.01 * span ? null : [Math.min(from, to), Math.max(from, to)]);
      });
      parallel.append(grip);
      if (focused === String(col.k)) grip.focus();
    });
  }
  function setBrush(column, range) {
    const all = {...brushes(), [column]: range};
    H.set({brush: Object.entries(all).filter(([, r]) => r).map(([n, [l, h]]) => `${n}:${l.toPrecision(6)}:${h.toPrecision(6)}`).join(";")});
  }
  function read(r) {
    H.clear(readout).append(H.h("strong", {}, `case ${r + 1}`), H.numbers(data.columns.map(c => [c.name, c.numeric ? `${H.digits(c.cells[r])} ${c.unit}` : c.cells[r] || "–"])));
  }
  // what the sweep says of all cases: warnings, sensitivities, spreads, constants, in SI as its files have them
  function drawSaid(found) {
    const grid = columns => H.h("table", {class: "small"}, H.h("thead", {}, H.h("tr", {}, columns.map(c => H.h("th", {class: c.numeric ? "number" : ""}, c.head)))),
      H.h("tbody", {}, columns[0].cells.map((_, r) => H.h("tr", {}, columns.map(c => H.h("td", {class: c.numeric ? "number" : ""}, c.numeric ? H.digits(c.cells[r]) : c.cells[r]))))));
    H.clear(said).append(...found.warnings.map(w => H.h("p", {class: "bad small"}, w)),
      ...found.tables.map(t => H.h("details", {class: "small"}, H.h("summary", {}, t.title), H.h("div", {class: "scroll wide", tabindex: 0, role: "group", "aria-label": t.title}, grid(t.columns)), H.h("p", {class: "quiet"}, "Numbers in SI units."))));
  }
  async function openRun(r) {
    read(r);
    if (!data.runs.includes(r) || H.exported()) return;
    try { const found = await H.send("case", "", {sweep: select.value, row: r}); H.go("runs", {run: String(found.run)}); } catch (error) { H.failed(error); }
  }
  function drawTable(keep) {
    const columns = data.columns.filter(c => !(c.name === "case" && c.cells.every((v, r) => v === r + 1)));      // the first column says it
    const rows = [...keep.keys()].filter(r => keep[r]).slice(0, 500);
    H.clear(table).append(H.h("table", {class: "small", "data-table": "cases"}, H.h("thead", {}, H.h("tr", {}, H.h("th", {class: "number"}, "case"), columns.map(c => H.h("th", {class: c.numeric ? "number" : ""}, named(c))))),
      H.h("tbody", {}, rows.map(r => H.h("tr", {class: "pick", onpointerenter: () => read(r)}, H.h("td", {class: "number"}, data.runs.includes(r) && !H.exported() ? H.h("button", {type: "button", title: "Open the run", onclick: () => openRun(r)}, String(r + 1)) : String(r + 1)),
        columns.map(c => H.h("td", {class: c.numeric ? "number" : ""}, c.numeric ? H.digits(c.cells[r]) : c.cells[r])))))));
    if (keep.filter(Boolean).length > rows.length) table.append(H.h("p", {class: "quiet small"}, "Only the first 500 are listed."));
  }
})();
