"""How fast the explorer answers: first paint, a dragged match, panning a long run, drawing a fine mesh, many requests at once.

    python benchmarks/explorer_speed.py            # needs chromium on PATH and hugoniot[test]

Numbers are of this machine as it is: quote ratios, or the medians of a quiet one.
"""

import asyncio
import contextlib
import re
import shutil
import socket
import statistics
import subprocess
import sys
import time

import httpx
import numpy as np
from playwright.sync_api import sync_playwright

FLAGS = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
  "--disable-component-update",
         "--disable-sync"]
DRAG = """async () => {
  const times = [], chart = document.querySelector('.chart').chart, show = chart.show;
  let drawn = () => {};
  chart.show = spec => { show.call(chart, spec); drawn(); };
  for (let v = 500; v < 1500; v += 20) {
    const begun = performance.now(), shown = new Promise(done => { drawn = () => { if (chart.spec.handles[0].x === v * 1e-3) done(); }; });
    chart.options.onDrag('velocity', v / 1000);
    await shown;
    document.body.getBoundingClientRect();
    times.push(performance.now() - begun);
    await new Promise(requestAnimationFrame);
  }
  chart.show = show;
  chart.options.onDrop();
  return times;
}"""
COMPUTED = """async names => {      // without the drawing, as two metals and the stack take turns
  const times = {pair: [], stack: []};
  for (let k = -10; k < 50; k++) for (const [key, layers] of [['pair', ['copper', 'aluminum']], ['stack', names]]) {
    const begun = performance.now();
    await H.impact.impact(layers, 1000 + 10 * k);
    if (k >= 0) times[key].push(performance.now() - begun);
  }
  return times;
}"""
# the view's own map, of 600 zones at 5000 times
WAVES = """() => {
  const nt = 5000, n = 600, [left, right, values] = [0, 1, 2].map(() => new Float64Array(nt * n)),
    times = Float64Array.from({length: nt}, (_, k) => k * 1e-9);
  for (let k = 0; k < nt; k++) for (let z = 0; z < n; z++) {
    left[k * n + z] = z * 1e-5 + k * 2e-7;
    right[k * n + z] = (z + 1) * 1e-5 + k * 2e-7;
    values[k * n + z] = 1e9 * Math.exp(-(((z - k / 8) / 20) ** 2));
  }
  const shape = [nt, n], host = H.h('div'), map = new H.XtMap(host, {onHover: () => {}, onPick: () => {}});
  H.clear(document.querySelector('main')).append(host);
  map.show({regions: [{name: 'a', first: 0, last: 299}, {name: 'b', first: 300, last: 599}]},
    {times, left: {shape, data: left}, right: {shape, data: right}, values: {shape, data: values}, field: {unit: 'Pa',
      words: 'pressure', shown: 'GPa', factor: 1e-9}, gauges: []});
  for (let k = 0; k < 6; k++) map.chart.zoomBy(0.8);
}"""
MESH = """() => {
  const ni = 250, nj = 400, x = new Float64Array((ni + 1) * (nj + 1)), y = x.slice(), corners = new Int32Array(4 * ni * nj), times = [];
  const values = Float64Array.from({length: ni * nj}, (_, z) => Math.sin(z / 8000) * Math.cos(z % nj / 30));
  for (let i = 0; i <= ni; i++) for (let j = 0; j <= nj; j++) {
    const k = i * (nj + 1) + j;
    x[k] = (i + 0.3 * Math.sin(j / 9)) * 1e-4;
    y[k] = (j + 0.3 * Math.cos(i / 7)) * 1e-4;
    if (i < ni && j < nj) corners.set([k, k + nj + 1, k + nj + 2, k + 1], 4 * (i * nj + j));
  }
  const host = H.h('div'), map = new H.PlaneMap(host, {onHover: () => {}, onPick: () => {}});
  H.clear(document.querySelector('main')).append(host);
  history.replaceState(null, '', '#/runs?mesh=1');
  for (let k = 0; k < 11; k++) {
    const begun = performance.now();
    map.show({corners, block_of: new Int32Array(ni * nj), axes: ['x', 'y'], geometry: 'plane'}, {x, y, values, field: {unit: 'Pa',
      words: 'pressure', shown: 'GPa', factor: 1e-9}});
    document.body.getBoundingClientRect();
    times.push(performance.now() - begun);
  }
  return times.slice(1);
}"""
DRAGGED = (("two metals", "copper,aluminum"), ("three layers", "tungsten,copper,pmma"),
           ("eight layers", "copper,aluminum,lif,pmma,tungsten,water,iron,pmma"))
FRAMES = """() => { window.frames_ = []; let last = performance.now();
  const tick = () => { const now = performance.now(); window.frames_.push(now - last); last = now;
    if (window.frames_.length < 4000) requestAnimationFrame(tick); }; requestAnimationFrame(tick); }"""


def report(words, milliseconds):
    """One line: median and worst."""
    print(f"{words:58s} median {statistics.median(milliseconds):8.1f} ms, worst {max(milliseconds):8.1f} ms")


def in_browser(address):
    with sync_playwright() as driver:
        browser = driver.chromium.launch(executable_path=shutil.which("chromium") or shutil.which("google-chrome"), args=FLAGS)
        paints = []
        for _ in range(5):
            page = browser.new_page()
            page.goto(address + "#/materials?sel=copper,aluminum,iron")
            page.wait_for_selector("ul[role=listbox] li")
            paints.append(page.evaluate("performance.getEntriesByName('first-contentful-paint')[0].startTime"))
        report("first paint, whole library", paints)
        clock = page.context.new_cdp_session(page)
        clock.send("Performance.enable", {"timeDomain": "threadTicks"})
        for words, layers in DRAGGED:
            page.goto(f"{address}#/match?layers={layers}&v=1000")
            page.wait_for_selector("[data-table=match]")
            page.wait_for_load_state("networkidle")
            page.wait_for_timeout(500)
            page.evaluate(DRAG)
            begun = worked(clock)
            times = page.evaluate(DRAG)
            spent = 1e3 * (worked(clock) - begun) / len(times)
            report(f"dragged match, {words}, until it is drawn", times)
            print(f"{'    processor time of a step, drawing included':58s} {spent:15.1f} ms")
        times = page.evaluate(COMPUTED, DRAGGED[-1][1].split(","))
        report("match of two metals, computed in the page", times["pair"])
        report("match of eight layers, computed in the page", times["stack"])
        print(f"{'eight layers over two metals, medians':58s} {statistics.median(times['stack']) / statistics.median(times['pair']):.1f}")
        page.evaluate(WAVES)
        panned(page, "x-t map, 600 zones x 5000 records")
        report("plane of 100 000 zones with mesh, drawn", page.evaluate(MESH))
        panned(page, "plane of 100 000 zones")
        browser.close()


def worked(clock):
    """Processor time that the page's thread has spent, s."""
    return next(m["value"] for m in clock.send("Performance.getMetrics")["metrics"] if m["name"] == "TaskDuration")


def panned(page, words, seconds=4.0):
    """Frames a second while the first picture is dragged to and fro."""
    box = page.locator(".chart svg").first.bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    page.evaluate(FRAMES)
    begun, k = time.monotonic(), 0
    while time.monotonic() - begun < seconds:
        k += 1
        page.mouse.move(x + 100 * ((k % 40) / 20 - 1), y + 60 * ((k % 60) / 30 - 1))
    frames = page.evaluate("window.frames_")
    page.mouse.up()
    print(f"{words + ', panned':58s} {1e3 * len(frames) / sum(frames):.0f} frames/s, longest {max(frames):.0f} ms")


async def many(address):
    """A thousand requests at once while two clients ask for much and never read."""
    host, port = re.match(r"http://([^:/]+):(\d+)/", address).groups()
    deaf = []
    for _ in range(2):
        deaf.append(socket.create_connection((host, int(port))))
        deaf[-1].sendall(f"GET /{address.split('/')[3]}/api/materials HTTP/1.1\r\nHost: {host}:{port}\r\n\r\n".encode() * 20)
    async with httpx.AsyncClient(timeout=120, limits=httpx.Limits(max_connections=1000)) as client:
        begun = time.perf_counter()
        asked = [f"{address}api/state?name=copper&by=particle_velocity&value={500 + k}" for k in range(1000)]
        answers = await asyncio.gather(*map(client.get, asked))
        spent = time.perf_counter() - begun
    assert {a.status_code for a in answers} == {200} and len({a.json()["state"]["pressure"] for a in answers}) == 1000
    print(f"1000 states asked at once, two clients never reading: {spent:.1f} s, all answered")
    for client in deaf:
        client.close()


def main():
    command = [sys.executable, "-m", "hugoniot.cli.main", "explore", "--no-browser", "--no-runs"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as server, contextlib.ExitStack() as last:
        last.callback(server.terminate)
        address = re.search(r"http://\S+", server.stdout.readline()).group(0)
        plain, least = [], []
        with httpx.Client(timeout=120) as client:
            client.get(f"{address}api/materials")
            for _ in range(60):
                begun = time.perf_counter()
                client.get(f"{address}icon.svg")
                least.append(1e3 * (time.perf_counter() - begun))
            for velocity in np.linspace(500, 1500, 60):
                begun = time.perf_counter()
                client.get(f"{address}api/state?name=copper&by=particle_velocity&value={velocity}")
                plain.append(1e3 * (time.perf_counter() - begun))
        report("a file of 500 bytes, asked and answered", least)
        report("state of copper with its release, asked and answered", plain)
        asyncio.run(many(address))
        in_browser(address)


if __name__ == "__main__":
    main()
