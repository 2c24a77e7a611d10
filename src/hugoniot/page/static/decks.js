"use strict";
// The deck editor: completion from the schema, errors at their lines as the command gives them, the set-up to scale, runs.
(() => {
  const view = H.views.decks = {}, checking = H.latest(), START = `title = "Copper on aluminium"
geometry = "planar"
stop_time = "2 us"

[[region]]
name = "flyer"
material = "copper"
from = "0 mm"
to = "2 mm"
zones = 100
velocity = "500 m/s"

[[region]]
name = "target"
material = "aluminum"
from = "2 mm"
to = "6 mm"
zones = 200

[[gauge]]
name = "interface"
at = "flyer/target"

[[gauge]]
name = "free surface"
at = "free surface right"
`;
  let area, numbers, offers, problems, drawing, chart, jobBox, runButton, words, materials = [], timer = 0, poll = 0, open = null, chosen = 0, wrong = [], source, kind = "lagrange1d", tooLong, kept = null, mayRun = false, current, known = null, file = "deck.toml";

  view.open = main => {
    const left = H.h("div", {class: "column"}), right = H.h("div", {class: "column"});
    main.className = "split decks";
    main.append(left, right);
    numbers = H.h("pre", {"aria-hidden": "true"});
    area = H.h("textarea", {spellcheck: "false", autocapitalize: "off", autocomplete: "off", "aria-label": "Deck", wrap: "off", "aria-describedby": "deck-keys",
      oninput: () => { changed(); complete(); }, onkeydown: key, onscroll: () => { numbers.scrollTop = area.scrollTop; place(); }, onblur: () => setTimeout(close, 150), onclick: close});
    offers = H.h("ul", {class: "offers", role: "listbox", "aria-label": "Completions", hidden: true});
    const box = H.h("div", {class: "editor"}, numbers, area, offers);
    source = H.h("span", {class: "quiet small"});
    tooLong = H.h("p", {class: "bad small", "aria-live": "polite", style: {margin: 0}});
    problems = H.h("div", {"aria-live": "polite"});
    runButton = H.h("button", {type: "button", onclick: run}, "Run");
    jobBox = H.h("div", {class: "column", style: {gap: "6px"}});
    drawing = H.h("div");
    left.append(H.h("div", {class: "bar"}, H.h("h2", {style: {margin: 0}}, "Deck"), source, H.h("span", {class: "bar push"}, runButton, H.h("button", {type: "button", onclick: () => H.copy(area.value, "deck")}, "Copy"), H.h("button", {type: "button", onclick: () => H.saveText(area.value, file.split("/").at(-1))}, "Save"))), box,
      H.h("p", {class: "quiet small", id: "deck-keys", style: {margin: 0}}, "Ctrl+Space lists keys and values; Enter accepts, Escape closes. Tab leaves the editor."), tooLong);
    right.append(problems, drawing, jobBox);
    chart = new H.Chart(drawing, {label: "The set-up to scale", height: 0.34, least: 220, most: 420});
    H.askOnce("materials").then(all => { materials = all.materials.filter(m => m.alone).map(m => [m.name, m.title]); }).catch(H.failed);
    current = null;
  };
  view.close = () => { clearTimeout(timer); clearTimeout(poll); chart.stop(); };
  view.repaint = () => chart.draw();
  view.update = async () => {
    const key = `${H.get("deck")}|${H.get("from")}|${H.get("text")}`;
    try { const opened = await H.opened; mayRun = opened.may_run && !H.exported(); runButton.hidden = !mayRun; if (key !== current) { current = key; await load(opened); } } catch (error) { H.failed(error); }
    if (H.get("job") !== "") watch();
  };
  async function load(opened) {
    const number = H.get("deck");
    file = "deck.toml";
    if (H.get("text")) { area.value = await H.fromAddress(H.get("text")); source.textContent = H.get("from") === "match" ? "from the impedance match" : "from the link"; }
    else if (number !== "" && opened.decks.length) { const deck = await H.ask("deck", {deck: number}); area.value = deck.text; source.textContent = deck.name; file = opened.decks[number].typed; known = deck; }
    else if (kept !== null) { area.value = kept; source.textContent = "too long for a link"; }
    else { area.value = START; source.textContent = "an example"; }
    changed(false);
  }
  function changed(own = true) {
    lineNumbers();
    clearTimeout(timer);
    if (own && !source.textContent.includes("edited")) { source.textContent += ", edited; save it to run it from the command line"; file = file.split("/").at(-1); }
    timer = setTimeout(async () => {
      if (own) await intoAddress();
      check();
    }, own ? 250 : 0);
  }
  async function intoAddress() {      // the text itself is the state of this view
    const text = area.value, letters = await H.intoAddress(text);
    if (text !== area.value || !area.isConnected) return;
    kept = letters === null ? text : null;
    H.set({text: letters, deck: "", from: ""}, false);
    current = `||${letters || ""}`;
    tooLong.textContent = letters === null ? "This deck is too long for a link: a link to this page would not contain it; save it instead." : "";
  }
  function lineNumbers() {
    const count = area.value.split("\n").length, bad = new Set(wrong.map(p => p.line)), key = `${count}|${wrong.map(p => p.line + p.text)}`;
    if (numbers.dataset.key === key) return;
    numbers.dataset.key = key;
    H.clear(numbers).append(...Array.from({length: count}, (_, k) => bad.has(k + 1) ? H.h("b", {title: wrong.filter(p => p.line === k + 1).map(p => p.text).join("\n")}, `▸${k + 1}\n`) : `${k + 1}\n`));
    numbers.scrollTop = area.scrollTop;
  }
  function check() {
    if (H.exported() && known && known.text === area.value) { show(known.checked); return; }
    if (H.exported()) { H.clear(problems).append(H.h("p", {class: "quiet"}, "An exported page only shows decks; hugoniot explore checks and runs them.")); command(); return; }
    checking(async () => {
      const text = area.value;
      try { const found = await H.send("check", text); if (text === area.value) show(found); } catch (error) { H.failed(error); }
    });
  }
  async function show(found) {
    wrong = found.problems;
    runButton.disabled = !found.ok;
    lineNumbers();
    const cost = found.estimate;
    H.clear(problems).append(found.ok ? H.h("p", {class: "good", style: {margin: 0}}, `The deck is valid: ${found.title}, ${cost.zones} zones, ${cost.snapshots} snapshots.`) : H.h("p", {class: "bad", style: {margin: 0}}, `${found.count || "1 problem"}${chart.spec.marks ? "; the drawing is that of the last valid deck" : ""}`),
      found.ok ? "" : H.h("ol", {class: "problems"}, wrong.map(p => H.h("li", {}, H.h("button", {type: "button", onclick: () => goTo(p.line)}, p.text)))),
      ...(found.warnings || []).map(w => H.h("div", {class: "small quiet"}, `warning: ${w}`)));
    if (found.ok) { if (found.kind !== kind) { kind = found.kind; words = null; } drawSetup(found.drawing); }
    drawing.style.opacity = found.ok ? 1 : 0.45;
    command();
  }
  function goTo(line) {
    if (!line) return;
    const lines = area.value.split("\n"), from = lines.slice(0, line - 1).reduce((n, l) => n + l.length + 1, 0);
    area.focus();
    area.setSelectionRange(from, from + lines[line - 1].length);
    area.scrollTop = Math.max(0, (line - 6) * 20);
  }
  // -- the set-up --------------------------------------------------------------------------------------------------------
  function drawSetup(d) {
    const marks = [], names = [...new Set((d.plane ? d.blocks : d.regions).map(r => r.material))], tint = r => names.indexOf(r.material);
    if (d.plane) {
      const xs = d.blocks.flatMap(b => b.x), ys = d.blocks.flatMap(b => b.y), span = Math.max(...[xs, ys].map(v => extreme(v, 1) - extreme(v, -1))), [unit, f] = H.lengthUnit(span), room = 0.05 * span * f;
      for (const b of d.blocks) { marks.push({kind: "polygon", xs: b.x.map(v => v * f), ys: b.y.map(v => v * f), colour: tint(b)}); marks.push({kind: "label", x: mean(b.x) * f, y: mean(b.y) * f, label: `${b.name}, ${b.material}`, ink: "ink", centre: true}); }
      chart.options.height = 0.6;
      chart.show({series: [], marks, equal: true, plain: true, x: {label: H.labelled(d.axes[0], unit), min: extreme(xs, -1) * f - room, max: extreme(xs, 1) * f + room}, y: {label: H.labelled(d.axes[1], unit), min: extreme(ys, -1) * f - room, max: extreme(ys, 1) * f + room}});
      return;
    }
    const low = d.regions[0].start, high = d.regions.at(-1).end, start = d.geometry === "planar" || low === 0 ? low : Math.max(0, low - 0.5 * (high - low)), [unit, f] = H.lengthUnit(high - start), room = 0.05 * (high - start) * f;
    d.regions.forEach((r, k) => {
      const a = r.start * f, b = r.end * f, v = [].concat(r.velocity), thin = (b - a) / ((high - start) * f) < 0.12;
      marks.push({kind: "polygon", xs: [a, b, b, a], ys: [0, 0, 1, 1], colour: tint(r)});
      marks.push({kind: "label", x: (a + b) / 2, y: thin ? 0.25 + 0.25 * (k % 3) : 0.62, label: r.name, ink: "text", centre: true});
      if (!thin) marks.push({kind: "label", x: (a + b) / 2, y: 0.4, label: `${r.material}, ${H.digits(b - a, 4)} ${unit}`, ink: "text", centre: true});
      if (v.some(s => s)) marks.push({kind: "label", x: (a + b) / 2, y: 1.14, label: `${v[0] < 0 ? "← " : ""}${v.map(s => H.digits(s, 5)).join(" to ")} m/s${v[0] > 0 ? " →" : ""}`, ink: "ink", centre: true});
    });
    const at = g => typeof g.at === "number" ? g.at : g.at.startsWith("free surface") ? (g.at.endsWith("left") ? low : high) : d.regions.find(r => r.name === g.at.split(/[/:]/)[0])?.[g.at.endsWith(":left") ? "start" : "end"];
    d.gauges.map(g => [g.name, at(g)]).filter(([, x]) => x !== undefined).slice(0, 24).forEach(([name, x], k) => {
      marks.push({kind: "line", x1: x * f, y1: -0.1 - 0.16 * (k % 3), x2: x * f, y2: 0, colour: "ink"}, {kind: "label", x: x * f, y: -0.17 - 0.16 * (k % 3), label: name, ink: "quiet", centre: true});
    });
    d.ends.forEach((end, side) => { if (end) marks.push({kind: "label", x: side ? high * f : start * f, y: 1.14, label: end, ink: "quiet", centre: true}); });
    chart.options.height = 0.4;
    chart.show({series: [], marks, plain: true, x: {label: H.labelled(d.geometry === "planar" ? "position at t = 0" : "radius at t = 0", unit), min: start * f - room, max: high * f + room}, y: {label: "", min: -0.66, max: 1.3, bare: true}});
  }
  const mean = v => v.reduce((a, b) => a + b, 0) / v.length, extreme = (v, sign) => v.reduce((m, x) => sign * x > sign * m ? x : m, v[0]);
  // -- completion --------------------------------------------------------------------------------------------------------
  async function complete(asked = false) {
    try { words ||= await H.askOnce("words", {kind}); } catch { return; }
    const at = area.selectionStart, line = area.value.slice(area.value.lastIndexOf("\n", at - 1) + 1, at);
    open = !asked && (!line.trim() || /=\s*$/.test(line)) ? null : H.deckOffers(words, materials, area.value, at);
    chosen = 0;
    if (!open) { close(); return; }
    H.clear(offers).append(...open.items.map((t, k) => H.h("li", {role: "option", "aria-selected": String(k === 0), onpointerdown: event => { event.preventDefault(); chosen = k; take(); }}, t.show, H.h("small", {}, t.about))));
    offers.hidden = false;
    place();
  }
  function place() {
    if (offers.hidden) return;
    const at = area.selectionStart, above = area.value.slice(0, at).split("\n"), column = above.at(-1).length;
    offers.style.top = `${Math.min(above.length * 20 + 10 - area.scrollTop, area.clientHeight - 120)}px`;
    offers.style.left = `${Math.min(numbers.offsetWidth + 10 + column * 8.1 - area.scrollLeft, Math.max(area.clientWidth - 180, 20))}px`;
  }
  function close() { open = null; offers.hidden = true; }
  function take() {
    const item = open.items[chosen], at = area.selectionStart, from = at - open.typed.length;
    area.setRangeText(item.insert, from, at, "end");
    close();
    changed();
    area.focus();
  }
  function key(event) {
    if (event.key === " " && event.ctrlKey) { event.preventDefault(); complete(true); return; }
    if (!open) return;
    const move = {ArrowDown: 1, ArrowUp: -1}[event.key];
    if (move) {
      chosen = (chosen + move + open.items.length) % open.items.length;
      [...offers.children].forEach((li, k) => li.setAttribute("aria-selected", String(k === chosen)));
      offers.children[chosen].scrollIntoView({block: "nearest"});
    } else if (event.key === "Enter") take();
    else if (event.key === "Escape") close();
    else return;
    event.preventDefault();
  }
  // -- runs --------------------------------------------------------------------------------------------------------------
  async function run() {
    try { const started = await H.send("job", area.value); H.set({job: String(started.job)}); } catch (error) { H.failed(error); }
  }
  // made anew only where the run has come to another state: a button that went away between press and release would not be clicked
  function buttons(job, number, means) {
    const stop = async () => { try { await H.send(`job/${Number(number)}/stop`); watch(); } catch (error) { H.failed(error); } };
    H.clear(jobBox).append(H.h("div", {class: "bar", "data-state": job.state}, H.h("strong", {}, job.name),
      H.h("span", {class: job.state === "failed" ? "bad" : job.state === "done" ? "good" : ""}, job.state),
      H.h("progress", {max: 1, "aria-label": "Progress of the run"}), H.h("span", {class: "small quiet", "data-progress": ""}),
      job.state === "running" ? H.h("button", {type: "button", onclick: stop}, "Stop") : "",
      job.run !== null ? H.h("button", {type: "button", onclick: () => H.go("runs", {run: String(job.run)})}, job.state === "running" ? "Watch" : "Open the result") : ""),
      H.h("pre", {class: "small scroll", tabindex: 0, style: {padding: "6px", margin: 0, whiteSpace: "pre-wrap", overflowWrap: "anywhere"}}));
    jobBox.dataset.means = means;
  }
  function write(element, words) { if (element.textContent !== words) element.textContent = words; }
  async function watch() {
    clearTimeout(poll);
    const number = H.get("job");
    try {
      const job = await H.ask(`job/${Number(number)}`), p = job.progress, share = p.stop_time ? p.time / p.stop_time : 0;
      const means = `${number} ${job.state} ${job.run}`;
      if (jobBox.dataset.means !== means || !jobBox.firstChild) buttons(job, number, means);
      jobBox.querySelector("progress").value = job.state === "done" ? 1 : share;
      write(jobBox.querySelector("[data-progress]"), p.cycle ? `${(100 * share).toFixed(0)} %, cycle ${p.cycle}, energy error ${Number(p.energy_error).toExponential(1)}` : "");
      const said = jobBox.querySelector("pre");
      said.hidden = !job.lines.length;
      write(said, job.lines.join("\n"));
      if (job.state === "running") poll = setTimeout(watch, 400);
    } catch (error) { H.failed(error); }
  }
  function command() {
    H.command({shell: `hugoniot check ${H.shell(file)}\nhugoniot run ${H.shell(file)}`, python: `import hugoniot\nrun = hugoniot.run(${H.python(file)})\nprint(run.summary)`});
  }
})();
