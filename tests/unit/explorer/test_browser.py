"""Every view in a browser: drawn, readable at both widths, light and dark, quiet, named for readers of the screen, reached by keys.

Chromium is looked for on PATH; only where there is none these tests are skipped. Screenshots stay in the folder of the test run.
"""

import re
import time
import xml.etree.ElementTree as ET

import pytest
from browsing import findings, until
from pace import PATIENCE

pytestmark = pytest.mark.slow
VIEWS = ["#/materials?sel=copper,aluminum&plane=us-up&at=particle_velocity:1500", "#/materials?sel=copper,aluminum&plane=p-up&releases=1&sources=1",
         "#/materials?sel=copper,my_steel&plane=p-v", "#/materials?sel=copper,aluminum&plane=t-p", "#/materials?sel=copper&plane=isentropes",
         "#/materials?sel=copper,aluminum&plane=isotherms", "#/materials?sel=copper&plane=surface", "#/materials?sel=comp_b,tnt&plane=detonation",
         "#/materials?sel=comp_b,tnt&plane=expansion", "#/materials?sel=comp_b&plane=gurney", "#/materials?sel=comp_b,pbx_9501&plane=pop",
         "#/match?layers=tungsten,copper,pmma&v=800&sigma=5", "#/runs?run=0&f=pressure&z=12&k=9", "#/runs?run=1&f=pressure&z=12&mesh=1", "#/decks?deck=0",
         "#/sweeps?sweep=0", "#/fits?fit=0"]
NAMES = ("materials", "match", "runs", "decks", "sweeps", "fits")

# What a reader needs of every view: names for all controls, text that stands out from its ground, nothing wider than the window.
ACCESSIBLE = """() => {
  const wrong = [], light = c => { const [r, g, b] = c.map(v => { v /= 255; return v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4; }); return 0.2126 * r + 0.7152 * g + 0.0722 * b; };
  const parts = t => t.match(/[\\d.]+/g).map(Number), ground = e => { for (; e; e = e.parentElement) { const c = parts(getComputedStyle(e).backgroundColor); if (c.length < 4 || c[3] > 0.99) return c.slice(0, 3); } return [255, 255, 255]; };
  if (document.documentElement.scrollWidth > innerWidth) wrong.push(`wider than the window: ${document.documentElement.scrollWidth}`);
  for (const e of document.querySelectorAll('button, a, input, select, textarea, [role=listbox], svg[tabindex]')) {
    if (!e.checkVisibility()) continue;
    const name = e.getAttribute('aria-label') || e.textContent.trim() || e.labels?.[0]?.textContent.trim() || e.title;
    if (!name) wrong.push('no name: ' + e.outerHTML.slice(0, 80));
  }
  for (const e of document.querySelectorAll('body *')) {
    if (!e.checkVisibility() || e.closest('svg') || e.disabled || ![...e.childNodes].some(n => n.nodeType === 3 && n.textContent.trim())) continue;
    const style = getComputedStyle(e), a = light(parts(style.color).slice(0, 3)), b = light(ground(e)), ratio = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
    if (ratio < 4.5) wrong.push(`contrast ${ratio.toFixed(2)}: ${e.textContent.trim().slice(0, 40)}`);
  }
  if (new Set([...document.querySelectorAll('[id]')].map(e => e.id)).size !== document.querySelectorAll('[id]').length) wrong.push('an id twice');
  return wrong;
}"""


@pytest.fixture(scope="module")
def window(browser, address):
    """One window for all views."""
    from browsing import Visit

    found = Visit(browser, address, reduced_motion="reduce")
    yield found
    found.context.close()


@pytest.mark.parametrize("number", range(len(VIEWS)))
def test_every_view_is_drawn_readable_and_quiet(window, number, tmp_path):
    view = VIEWS[number]
    for width, scheme in ((1280, "light"), (1280, "dark"), (420, "light"), (420, "dark")):
        window.page.set_viewport_size({"width": width, "height": 900})
        window.page.emulate_media(color_scheme=scheme)
        page = window.go(view) if (width, scheme) == (1280, "light") else window.page
        end = time.monotonic() + PATIENCE
        while (wrong := page.evaluate(ACCESSIBLE)) and time.monotonic() < end:      # pictures follow the window
            page.wait_for_timeout(50)
        assert wrong == [], (view, width, scheme)
        if (width, scheme) in ((1280, "light"), (420, "dark")):
            assert findings(page) == [], (view, width, scheme)
        page.screenshot(path=tmp_path / f"{number:02d}-{width}-{scheme}.png", full_page=True)
    labels = page.eval_on_selector_all(".chart text[data-axis]", "t => t.map(e => e.textContent).filter(Boolean)")
    assert all(re.search(r"\(.+\)|M/C|seed", words) for words in labels), view
    assert not page.query_selector("main img, main [onload], main [onclick], main [onerror]")
    assert window.wrong == []


def test_everything_is_reached_by_keys(visit):
    here = visit()
    page = here.go("")
    for number, view in enumerate(NAMES, 1):
        page.keyboard.press(f"Alt+{number}")
        until(page, f"location.hash.startsWith('#/{view}')")
        here.settled()
        page.evaluate("document.activeElement.blur()")
        seen = set()
        for _ in range(60):
            page.keyboard.press("Tab")
            seen.add(page.evaluate("(e => e.id || e.getAttribute('aria-label') || e.getAttribute('data-view') || e.textContent.slice(0, 30))(document.activeElement)"))
            if "theme" in seen and "command" in seen:
                break
        assert {*NAMES, "theme"} <= seen, (view, seen)
    here.go("#/materials?sel=copper")
    page.locator("ul[role=listbox]").focus()
    for press in ("ArrowDown", "ArrowDown", "Enter", "ArrowDown", "Enter"):
        page.keyboard.press(press)
    until(page, "(location.hash.split('sel=')[1] || '').split(',').length === 3")
    until(page, "document.querySelector('.chart').chart.spec.series.length >= 2")
    page.locator(".chart svg").first.focus()
    page.keyboard.press("ArrowRight")
    page.keyboard.press("Enter")
    until(page, "location.hash.includes('at=particle_velocity')")
    page.keyboard.press("+")
    until(page, "location.hash.includes('zoom=')")
    page.keyboard.press("0")
    until(page, "!location.hash.includes('zoom=')")


def test_pictures_are_saved(visit, tmp_path):
    here = visit(color_scheme="dark")
    for view in ("#/materials?sel=copper&plane=us-up", "#/runs?run=0&f=pressure"):
        page = here.go(view)
        for kind in ("SVG", "PNG"):
            with page.expect_download() as waiting:
                page.locator(f"button:has-text('{kind}')").first.click()
            waiting.value.save_as(tmp_path / f"picture.{kind.lower()}")
        root = ET.parse(tmp_path / "picture.svg").getroot()
        texts = ["".join(e.itertext()) for e in root.iter("{http://www.w3.org/2000/svg}text")]
        assert any("(km/s)" in t or "(mm)" in t for t in texts) and root.find("{http://www.w3.org/2000/svg}rect").get("fill") == "#ffffff"
        assert (tmp_path / "picture.png").read_bytes()[:8] == b"\x89PNG\r\n\x1a\n" and (tmp_path / "picture.png").stat().st_size > 10_000


def test_the_address_is_the_state_of_a_view(visit):
    """What is chosen by hand stands in the address, and another window with that address shows the same."""
    here = visit()
    page = here.go("#/materials?sel=copper")
    page.click("button[data-plane=surface]")
    until(page, "location.hash.includes('plane=surface')")
    here.settled()
    page.select_option("select[aria-label='Quantity of the surface']", "specific_internal_energy")
    page.fill("label:has-text('temperatures, K') input", "100, 3000")
    page.keyboard.press("Enter")
    until(page, "location.hash.includes('quantity=specific_internal_energy') && location.hash.includes('hot=100,3000')")
    here.settled()
    page.locator(".chart svg").first.focus()
    page.keyboard.press("+")
    until(page, "location.hash.includes('zoom=')")
    page.wait_for_timeout(400)      # an address is written at most three times a second
    again, state = visit(), "(c => [c.chart.spec.zoom, c.chart.frame.x.low, c.chart.frame.y.high, c.chart.spec.bar.label])(document.querySelector('.chart'))"
    other = again.go(page.url[page.url.index("#"):])
    until(other, "document.querySelector('.chart')?.chart.spec.bar")
    assert other.evaluate(state) == page.evaluate(state)


@pytest.mark.parametrize(("view", "key"), [("#/runs?run=0&f=pressure", "xt"), ("#/runs?run=0&f=pressure", "hz"), ("#/runs?run=0&f=pressure", "pz"),
                                           ("#/runs?run=1&f=pressure", "map"), ("#/match?layers=copper,aluminum&v=900", "mz"), ("#/sweeps?sweep=0", "sz"),
                                           ("#/fits?fit=0", "d0"), ("#/fits?fit=0", "r0"), ("#/fits?fit=0", "pz"), ("#/fits?fit=0", "oz")])
def test_the_zoom_of_every_plot_stands_in_the_address(visit, view, key):
    """Another window with the address shows the same part, and the same form of the command."""
    here = visit()
    page, zoom = here.go(view), f"[...document.querySelectorAll('.chart')].map(c => c.chart).find(c => c?.options.zoomKey === '{key}').spec.zoom"
    page.evaluate(zoom.replace(".spec.zoom", ".svg.focus()"))
    page.keyboard.press("+")
    until(page, f"/[?&]{key}=/.test(location.hash)")
    page.click("#as-python")
    until(page, "location.hash.includes('as=python')")
    other = visit().go(page.url[page.url.index("#"):])
    until(other, f"document.querySelector('.chart') && {zoom}")
    mine, theirs = page.evaluate(zoom), other.evaluate(zoom)
    assert all(theirs[axis] == pytest.approx(mine[axis], rel=1e-5) for axis in "xy") and other.text_content("#command") == page.text_content("#command")
    page.evaluate(zoom.replace(".spec.zoom", ".svg.focus()"))
    page.keyboard.press("0")
    until(page, f"!/[?&]{key}=/.test(location.hash)")
