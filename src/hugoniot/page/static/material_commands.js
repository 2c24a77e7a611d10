"use strict";
// The command and the Python that give the numbers of a plane without the page.
H.materialCommands = (names, plane, surface) => {
  const some = names.length ? names : ["copper"], list = some.map(H.subject).join(" "), [by, value] = H.get("at").split(":"), first = surface?.name || some[0];
  const state = !by ? "" : by === "pressure" ? `pressure = ${Number((value * 1e-9).toPrecision(15))} GPa` : `${by} = ${Number(value)} m/s`, at = state ? ` --at "${state}"` : "";
  const each = some.map(H.find).join(", "), head = H.finder(some), ends = v => [v[0], v.at(-1)], range = (v, unit) => ends(v).map(x => `${x} ${unit}`).join(", "), spaced = v => `np.linspace(${ends(v).join(", ")}, ${v.length})`;
  const grid = s => `import numpy as np\n${H.finder([first])}from hugoniot.theory.isentrope import grid\nrho, t = ${spaced(s.density)}, ${plane === "isotherms" ? `np.array([${s.temperature.join(", ")}])` : spaced(s.temperature)}\np, e = grid(${H.find(first)}, rho, t)\nprint(p, e)`;
  const table = (s, file, hot) => `hugoniot eos table ${H.subject(first)} --densities "${range(s.density, "kg/m^3")}" --temperatures "${hot}" --points ${s.density.length} --csv ${file}`;
  const shells = {isentropes: () => `hugoniot eos isentrope ${list}${at || ' --at "particle_velocity = 1000 m/s"'} --plot isentropes.png`, detonation: () => `hugoniot eos hugoniot ${list} --reaction --axes p-v --plot detonation.png`,
    expansion: () => `hugoniot eos isentrope ${list} --csv expansion.csv`, gurney: () => `hugoniot material show ${H.subject(some[0])}`, pop: () => `hugoniot material show ${H.subject(some[0])}`,
    surface: () => surface ? table(surface, "surface.csv", range(surface.temperature, "K")) : `hugoniot eos table ${H.subject(first)}`,
    isotherms: () => surface ? table(surface, "isotherms.csv", surface.temperature.map(t => `${t} K`).join(", ")) : `hugoniot eos table ${H.subject(first)}`};
  const pythons = {isentropes: () => `${head}from hugoniot.theory.hugoniot import shock\nfrom hugoniot.theory.isentrope import release\nfor m in (${each},):\n    print(release(m, shock(m, ${by || "particle_velocity"}=${Number(value) || 1000}), points=25).table())`,
    detonation: () => `${head}from hugoniot.theory.chapman_jouguet import cj, detonation_hugoniot\nfor m in (${each},):\n    print(cj(m).state.table(), detonation_hugoniot(m).table())`,
    expansion: () => `${head}from hugoniot.theory.chapman_jouguet import cj\nfrom hugoniot.theory.isentrope import expansion_to\nfor m in (${each},):\n    print(expansion_to(m, cj(m).state, 1e5, 50).table())`,
    gurney: () => `from hugoniot.materials.library import entry\nprint(entry(${H.python(some[0])}).detonation)`, pop: () => `from hugoniot.materials.library import pop_lines\nprint(pop_lines(${H.python(some[0])}))`,
    surface: () => surface ? grid(surface) : `${head}print(${H.find(first)})`, isotherms: () => surface ? grid(surface) : `${head}print(${H.find(first)})`};
  return {shell: shells[plane]?.() || `hugoniot eos hugoniot ${list}${at} --axes ${plane} --plot hugoniots.png`,
    python: pythons[plane]?.() || `${head}from hugoniot.theory.hugoniot import ${by ? "shock" : "curve"}\nfor m in (${each},):\n    print(${by ? `shock(m, ${by}=${Number(value)})` : "curve(m)"}.table())`};
};
