"use strict";
// What every view shares: elements, the state in the address, questions to the server or to the exported data, numbers for people.
const H = {views: {}, viewOrder: []};

// -- elements: text is always text, whatever a deck or a file says -----------------------------------------------------
const SVG_NS = "http://www.w3.org/2000/svg";
function put(element, properties, children) {
  for (const [key, value] of Object.entries(properties || {})) {
    if (value === null || value === undefined || value === false) continue;
    if (key.startsWith("on")) element.addEventListener(key.slice(2), value);
    else if (key === "style") Object.assign(element.style, value);
    else if (key === "value" || key === "checked" || key === "disabled" || key === "selected") element[key] = value;
    else element.setAttribute(key, value === true ? "" : value);
  }
  for (const child of children.flat(3)) if (child !== null && child !== undefined && child !== false) element.append(child);
  return element;
}
H.h = (tag, properties, ...children) => put(document.createElement(tag), properties, children);
H.s = (tag, properties, ...children) => put(document.createElementNS(SVG_NS, tag), properties, children);
H.clear = element => { element.replaceChildren(); return element; };
H.say = text => { document.getElementById("said").textContent = text; };

// -- the state of a view is the part of the address behind the # --------------------------------------------------------
let unwritten = null, written = 0, writing = 0;      // browsers refuse an address that changes more than a few times a second
const write = () => {
  clearTimeout(writing);
  if (unwritten !== null) history.replaceState(null, "", unwritten);
  unwritten = null;
  written = performance.now();
};
const writeSoon = address => {
  unwritten = address;
  clearTimeout(writing);
  const rest = 320 - (performance.now() - written);
  if (rest <= 0) write(); else writing = setTimeout(write, rest);
};
addEventListener("pagehide", write);
addEventListener("hashchange", () => { unwritten = null; });      // what the reader typed goes before what was not written yet
let lately = {};        // an address may hold a whole deck, and is read at every turn
H.read = () => {
  const address = unwritten ?? location.hash;
  if (lately.address !== address) {
    const [view, query] = address.replace(/^#\/?/, "").split("?");
    lately = {address, view: H.views[view] ? view : H.views.report ? "report" : "materials", query: new URLSearchParams(query || "")};
  }
  return lately;
};
H.get = (key, otherwise = "") => H.read().query.get(key) ?? otherwise;
H.list = key => H.get(key).split(",").filter(Boolean);
H.address = (view, query) => {
  const text = query.toString().replace(/%2C/g, ",").replace(/%3A/g, ":").replace(/%2F/g, "/");
  return `#/${view}${text ? "?" + text : ""}`;
};
H.set = (changes, draw = true) => {
  const {view} = H.read(), query = new URLSearchParams(H.read().query);
  for (const [key, value] of Object.entries(changes)) {
    if (value === null || value === "" || value === undefined) query.delete(key); else query.set(key, value);
  }
  writeSoon(H.address(view, query));
  H.remember?.(view, query);
  if (draw) H.views[view].update();
};
H.go = (view, values = {}) => { write(); location.hash = H.address(view, new URLSearchParams(Object.entries(values).filter(([, v]) => v !== ""))); };
// what is written or dropped by the reader goes into the address too: deflated, in letters an address may hold; null where it is too long for one
const LONGEST = 500_000;
const piped = async (bytes, stream) => new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());
H.intoAddress = async text => {
  const bytes = await piped(new TextEncoder().encode(text), new CompressionStream("deflate"));
  if (bytes.length * 4 / 3 > LONGEST) return null;
  let letters = "";
  for (let k = 0; k < bytes.length; k += 30_000) letters += String.fromCharCode(...bytes.subarray(k, k + 30_000));
  return btoa(letters).replace(/\+/g, "-").replace(/\//g, "_").replace(/=+$/, "");
};
H.fromAddress = async letters => {
  try { return new TextDecoder().decode(await piped(Uint8Array.from(atob(letters.replace(/-/g, "+").replace(/_/g, "/")), c => c.charCodeAt(0)), new DecompressionStream("deflate"))); }
  catch { throw new Refused("This link is damaged: part of it is missing or was changed in transit."); }
};

// -- questions ----------------------------------------------------------------------------------------------------------
H.exported = () => window.hugoniotFiles !== undefined;
const waiting = {}, answers = {};
window.hugoniotData = (key, data) => { (waiting[key] || []).forEach(done => done(data)); delete waiting[key]; };
const keyOf = (question, query) => question + Object.keys(query).sort().map(k => `&${k}=${query[k]}`).join("");
class Refused extends Error {}
H.Refused = Refused;

const inlined = document.getElementById("answers");        // of a report, whose data stand in the page itself
const inlineAnswers = inlined ? JSON.parse(inlined.textContent) : {};
if (inlined) window.hugoniotFiles = Object.fromEntries(Object.keys(inlineAnswers).map(key => [key, true]));

function fromExport(key) {
  if (inlineAnswers[key] !== undefined) return Promise.resolve(inlineAnswers[key]);
  const file = window.hugoniotFiles[key];
  if (!file) return Promise.reject(new Refused(inlined ? "Not included in this report; open the run itself with: hugoniot explore RUN" : "Not included in this exported page; start the explorer with: hugoniot explore"));
  return new Promise((done, failed) => {
    (waiting[key] ||= []).push(done);
    document.head.append(H.h("script", {src: file, onerror: () => failed(new Refused(`${file} is missing from the folder of this page`))}));
  });
}
async function fromServer(question, query, options) {
  const words = new URLSearchParams(query).toString();
  let answer;
  try { answer = await fetch(`api/${question}${words ? "?" + words : ""}`, options); } catch (error) {
    if (error.name === "AbortError") throw error;
    throw new Refused("No answer from the server. Has hugoniot explore been stopped?");
  }
  if (answer.headers.get("content-type") === "application/octet-stream") {
    const shape = answer.headers.get("x-shape").split(",").map(Number);
    return {shape, data: new Float64Array(await answer.arrayBuffer())};
  }
  if (!(answer.headers.get("content-type") || "").startsWith("application/json")) throw new Refused(`The server refused the request (status ${answer.status})`);
  const value = await answer.json();
  if (value && value.error) throw new Refused(value.error.join("\n"));
  return value;
}
function unpacked(value) {
  if (value && value.error) throw new Refused(value.error);
  if (value?.deflated) return inflated(value);
  if (!value || value.doubles === undefined) return value;
  const bytes = Uint8Array.from(atob(value.doubles), c => c.charCodeAt(0));
  return {shape: value.shape, data: new Float64Array(bytes.buffer)};
}
H.inflated = inflated;
async function inflated({shape, deflated}) {       // doubles, sorted by the places of their bytes
  const packed = Uint8Array.from(atob(deflated), c => c.charCodeAt(0)), stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  const places = new Uint8Array(await new Response(stream).arrayBuffer()), n = places.length / 8, bytes = new Uint8Array(places.length);
  for (let k = 0; k < 8; k++) for (let i = 0; i < n; i++) bytes[8 * i + k] = places[k * n + i];
  return {shape, data: new Float64Array(bytes.buffer)};
}
let unanswered = 0;      // questions that wait for their answer: screen readers announce that the view is not complete yet
const counted = asked => {
  const main = document.getElementById("main"), change = by => { unanswered += by; if (unanswered) main.setAttribute("aria-busy", "true"); else main.removeAttribute("aria-busy"); };
  change(1);
  return asked.finally(() => setTimeout(() => change(-1)));
};
H.ask = (question, query = {}, options) => counted(H.exported() ? fromExport(keyOf(question, query)).then(unpacked) : fromServer(question, query, options));
H.askOnce = (question, query = {}) => {        // answers that do not change
  const key = keyOf(question, query);
  answers[key] ||= H.ask(question, query).catch(error => { delete answers[key]; throw error; });
  return answers[key];
};
H.send = (question, body = "", query = {}) => counted(fromServer(question, query, {method: "POST", body, headers: {"content-type": "text/plain"}}));
// only the last of many questions is of interest, and one at a time is asked
H.latest = () => {
  let busy = false, next = null;
  return async function asking(work) {
    if (busy) { next = work; return; }
    busy = true;
    try { await work(); } finally { busy = false; }
    if (next) { const again = next; next = null; asking(again); }
  };
};

// the library's own name for any accepted spelling of a material
const spelling = text => text.toLowerCase().replace(/[\s_-]+/g, "");
H.resolved = async name => {
  const {materials, rows} = await H.askOnce("materials"), wanted = spelling(name);
  if ([...materials, ...rows].some(m => m.name === name)) return name;
  return materials.find(m => [m.name, m.title, ...m.also].some(t => spelling(t) === wanted))?.name || name;
};

// -- numbers ------------------------------------------------------------------------------------------------------------
H.digits = (value, digits = 6) => {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const text = value.toPrecision(digits), plain = Number(text);
  const size = Math.abs(plain);
  return size >= 1e-4 && size < 1e9 ? String(plain).replace(/^-/, "−") : plain.toExponential().replace("e+", "e").replace(/-/g, "−");
};
H.units = {           // field -> [words, unit shown, factor]
  pressure: ["pressure", "GPa", 1e-9], density: ["density", "kg/m³", 1], particle_velocity: ["particle velocity", "m/s", 1],
  shock_velocity: ["shock velocity", "m/s", 1], specific_internal_energy: ["internal energy", "kJ/kg", 1e-3],
  temperature: ["temperature", "K", 1], sound_speed: ["sound speed", "m/s", 1], entropy: ["entropy", "J/kg/K", 1],
  gruneisen: ["Grüneisen parameter", "", 1], adiabatic_exponent: ["adiabatic exponent", "", 1], specific_volume: ["specific volume", "cm³/g", 1e3],
};
H.fits = (values, unit, factor) => {     // a unit in which the largest of the values reads well
  if (unit !== "GPa") return [unit, factor];
  const top = values.reduce((m, v) => Math.max(m, Math.abs(v) || 0), 0);
  return top === 0 || top >= 1e8 ? ["GPa", 1e-9] : top >= 1e6 ? ["MPa", 1e-6] : top >= 1e3 ? ["kPa", 1e-3] : ["Pa", 1];
};
H.timeUnit = span => span >= 2e-3 ? ["ms", 1e3] : span >= 2e-7 ? ["µs", 1e6] : span >= 1e-9 ? ["ns", 1e9] : ["ps", 1e12];
H.lengthUnit = span => span >= 2 ? ["m", 1] : span >= 2e-4 ? ["mm", 1e3] : span >= 2e-7 ? ["µm", 1e6] : ["nm", 1e9];
H.labelled = (words, unit) => unit ? `${words} (${unit})` : words;
H.shell = text => /^[\w@%+=:,./-]+$/.test(text) ? text : `'${text.replace(/'/g, `'\\''`)}'`;
H.python = text => JSON.stringify(text);
// materials of the user's own files are called by the file
H.files = {};
H.subject = name => H.shell(H.files[name] ? (H.files[name].split("/").at(-1).replace(/\.toml$/, "") === name ? H.files[name] : `${H.files[name]}:${name}`) : name);
H.find = name => H.files[name] ? `read_materials(${H.python(H.files[name])})[${H.python(name)}].material` : `find(${H.python(name)})`;
H.finder = names => [names.some(n => H.files[n]) ? "from hugoniot.materials.users import read_materials\n" : "", names.some(n => !H.files[n]) ? "from hugoniot.materials.library import find\n" : ""].join("");
H.numbers = pairs => H.h("dl", {}, pairs.map(([word, value]) => H.h("div", {}, H.h("dt", {}, word), H.h("dd", {}, value))));
H.failed = error => {
  if (error.name === "AbortError") return;
  H.say(error.message);
  if (!(error instanceof Refused)) throw error;
};
