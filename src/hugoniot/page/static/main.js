"use strict";
// Which view is shown, light or dark, the command of a view, keys that work everywhere.
(() => {
  let current = null, form = "shell", chosen = "";
  const all = {report: "Report", materials: "Materials", match: "Impedance match", runs: "Runs", decks: "Deck", sweeps: "Sweeps", fits: "Fits"}, names = Object.fromEntries(Object.entries(all).filter(([view]) => H.views[view]));
  if (H.views.report) names.runs = "Run";
  const preferred = matchMedia("(prefers-color-scheme: dark)");

  H.remember = (view, query) => { const link = document.querySelector(`#views a[data-view=${view}]`); if (link) link.href = H.address(view, query); };      // a view is found as it was left

  H.command = commands => {       // {shell, python} of what is shown
    H.commands = commands;
    document.getElementById("command").textContent = commands[form];
  };
  function setForm(name, chosen = true) {
    form = name;
    if (chosen) H.set({as: name === "python" ? "python" : ""}, false);
    for (const id of ["shell", "python"]) document.getElementById(`as-${id}`).setAttribute("aria-pressed", String(id === name));
    document.getElementById("command").textContent = H.commands ? H.commands[form] : "";
  }
  H.copy = async (text, what) => {
    try { await navigator.clipboard.writeText(text); H.say(`${what} copied`); }
    catch { H.say("The browser does not allow copying; select the text instead."); }
  };
  function setTheme() {
    chosen = H.get("theme") || chosen;
    const wanted = chosen || (preferred.matches ? "dark" : "light");
    document.documentElement.dataset.theme = wanted;
    document.getElementById("theme").textContent = wanted === "dark" ? "Light" : "Dark";
  }
  function show() {
    const {view, query} = H.read(), main = document.getElementById("main");
    setTheme();
    if (H.get("as") === "python") setForm("python", false);
    for (const link of document.querySelectorAll("#views a")) {
      if (link.dataset.view === view) link.setAttribute("aria-current", "page"); else link.removeAttribute("aria-current");
    }
    H.remember(view, query);
    document.title = `${names[view]} · hugoniot`;
    if (current !== view) {
      if (current) H.views[current].close?.(); else if (view !== "report") H.views.report?.close();       // a report is dressed for reading
      main.className = "";
      H.clear(main);
      H.say("");
      current = view;
      H.views[view].open(main);
    }
    H.views[view].update();
  }
  function start() {
    const nav = document.getElementById("views");
    for (const [view, name] of Object.entries(names)) nav.append(H.h("a", {href: `#/${view}`, "data-view": view}, name));
    document.getElementById("as-shell").onclick = () => setForm("shell");
    document.getElementById("as-python").onclick = () => setForm("python");
    document.getElementById("copy-command").onclick = () => H.copy(document.getElementById("command").textContent, form === "shell" ? "command" : "Python");
    document.getElementById("theme").onclick = () => { H.set({theme: H.theme() === "dark" ? "light" : "dark"}, false); show(); H.views[current].repaint?.(); };
    preferred.addEventListener("change", () => { setTheme(); H.views[current].repaint?.(); });
    addEventListener("hashchange", show);
    addEventListener("keydown", event => {
      if (event.altKey && /^[1-6]$/.test(event.key)) { document.querySelectorAll("#views a")[event.key - 1]?.click(); event.preventDefault(); }
    });
    H.opened = H.askOnce("start");
    H.opened.then(opened => {
      H.files = opened.files || {};
      H.remember("materials", new URLSearchParams({sel: (opened.materials.length ? opened.materials : ["copper", "aluminum_6061", "iron", "pmma"]).join(",")}));
      if (!location.hash && H.views.report) location.hash = "#/report";
      else if (!location.hash && opened.runs.length) location.hash = "#/runs?run=0";
      else if (!location.hash && opened.sweeps.length) location.hash = "#/sweeps?sweep=0";
      else if (!location.hash && opened.fits.length) location.hash = "#/fits?fit=0";
      else if (!location.hash && opened.decks.length) location.hash = "#/decks?deck=0";
      else if (!location.hash) location.hash = document.querySelector("#views a").hash;
      else show();
    }).catch(error => { show(); H.failed(error); });
  }
  addEventListener("DOMContentLoaded", start);
})();
