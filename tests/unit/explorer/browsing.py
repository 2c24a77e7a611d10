"""A page of the explorer in Chromium that remembers everything it should not have done; numbers as the page prints them; axe-core."""

import re
import shutil
import time
from functools import cache
from pathlib import Path

from pace import PATIENCE

CHROMIUM = next((found for name in ("chromium", "chromium-browser", "google-chrome", "chrome") if (found := shutil.which(name))), None)
FLAGS = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update",
         "--disable-sync", "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1"]
QUIET = "document.readyState === 'complete' && !document.querySelector('#main').hasAttribute('aria-busy')"
DRAWN = "!document.querySelector('.chart') || [...document.querySelectorAll('.chart')].some(c => c.querySelectorAll('svg path, svg polygon').length > 1 || c.querySelector('canvas')?.width > 10)"
LOOPBACK = re.compile(r"http://127\.0\.0\.1:\d+/|file:|blob:|data:")


def until(page, expression, seconds=PATIENCE):
    """Wait for an expression of the page to hold; asked from outside, as the page's policy lets no text be evaluated inside it."""
    end = time.monotonic() + seconds
    while not page.evaluate(expression):
        assert time.monotonic() < end, f"never came true: {expression}"
        page.wait_for_timeout(25)


def shown(value, digits=6):
    """A number as the page prints it."""
    return f"{float(f'{value:.{digits}g}'):.15g}".replace("-", "−")


class Visit:
    """A window of the browser on the page at `start`: `wrong` holds messages of the console, errors, dialogs and questions to other hosts."""

    def __init__(self, browser, start, width=1280, **options):
        self.context = browser.new_context(viewport={"width": width, "height": 900}, accept_downloads=True, **options)
        self.context.set_default_timeout(1000 * PATIENCE)
        self.page, self.start, self.wrong = self.context.new_page(), start, []
        self.context.route(lambda address: not LOOPBACK.match(address), self._refuse)
        self.page.on("console", lambda message: self.wrong.append(f"console: {message.text}"))
        self.page.on("pageerror", lambda error: self.wrong.append(f"error: {error}"))
        self.page.on("dialog", lambda dialog: (self.wrong.append(f"dialog: {dialog.message}"), dialog.dismiss()))

    def _refuse(self, route):
        self.wrong.append(f"asked {route.request.url}")
        route.abort()

    def go(self, view, ready=None):
        """The page with a view that is drawn whole; in an open page by its address alone."""
        if self.page.url.startswith(self.start):
            self.page.evaluate(f"location.hash = {view!r}")
        else:
            self.page.goto(self.start + view)
        return self.settled(ready)

    def settled(self, ready=None):
        """The page, once nothing is asked any more and something is drawn."""
        until(self.page, "document.querySelector('#command')?.textContent.length > 3")
        if ready:
            self.page.wait_for_selector(ready)
        for _ in range(2):      # an answer may lead to the next question
            self.page.wait_for_timeout(30)
            until(self.page, QUIET)
        until(self.page, DRAWN)
        return self.page

    def readout(self):
        """What the pointer reads, by its words."""
        rows = self.page.eval_on_selector_all("[data-readout] dl > div", "rows => rows.map(r => [r.children[0].textContent, r.children[1].textContent])")
        return dict(rows)

    def point(self, across, up, chart=0):
        """The pointer at shares of a picture's width and height."""
        box = self.page.locator(".chart svg").nth(chart).bounding_box()
        self.page.mouse.move(box["x"] + across * box["width"], box["y"] + up * box["height"])
        return box


@cache
def _axe():
    import axe_playwright_python

    return (Path(axe_playwright_python.__file__).parent / "axe.min.js").read_text(encoding="utf-8")


def findings(page):
    """Serious and critical findings of axe-core."""
    page.evaluate(_axe())
    found = page.evaluate("axe.run(document, {resultTypes: ['violations']})")["violations"]
    return [(f["id"], f["impact"], f["nodes"][0]["html"][:120]) for f in found if f["impact"] in ("serious", "critical")]
