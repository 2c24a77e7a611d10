"""The report: one file, no network, everything a reader needs, and nothing from a deck that could act in a browser."""

import base64
import hashlib
import json
import pathlib
import re
import sys
import xml.etree.ElementTree as ElementTree
from dataclasses import replace
from html.parser import HTMLParser

import pytest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "output"))

import acoustic_flyer

from hugoniot.errors import FileTrouble
from hugoniot.output.seal import MARK, sealed_json
from hugoniot.output.setup_record import setup_record
from hugoniot.problem.deck import read_deck_text
from hugoniot.report import write_report
from hugoniot.report.sections import materials


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("report") / "run"
    acoustic_flyer.run(folder)
    return folder


@pytest.fixture(scope="module")
def page(folder):
    path = write_report(folder)
    assert path == folder / "report.html"
    return path.read_text(encoding="utf-8")


class Checker(HTMLParser):
    """Counts open and closed elements and notes what would be fetched."""

    void = {"meta", "link", "br", "img"}

    def __init__(self):
        super().__init__()
        self.open, self.fetched, self.headings = [], [], []

    def handle_starttag(self, tag, attrs):
        if tag not in self.void:
            self.open.append(tag)
        self.fetched += [value for key, value in attrs if key in ("src", "href", "xlink:href") and not value.startswith(("data:", "#"))]

    def handle_startendtag(self, tag, attrs):
        self.handle_starttag(tag, attrs)
        if tag not in self.void:
            self.open.pop()

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        if self.open and self.open[-1] == "h2":
            self.headings.append(data)


def without_scripts(page):
    """The page as it is read without scripts; the two it may hold are its data, and one that its policy names by its SHA-256."""
    found = re.findall(r"<script[^>]*>(.*?)</script>", page, flags=re.S)
    assert page.count("<script") == len(found) == 2 and "<" not in found[0] and json.loads(found[0])
    allowed = base64.b64encode(hashlib.sha256(found[1].encode()).digest()).decode()
    assert f"script-src 'sha256-{allowed}'; style-src" in page and "default-src 'none'" in page
    return re.sub(r"<script[^>]*>.*?</script>", "", page, flags=re.S)


def test_one_file_without_network_below_two_megabytes(page):
    checker = Checker()
    checker.feed(page)
    assert not checker.open and not checker.fetched
    assert "<script" not in without_scripts(page) and "@import" not in page and "url(http" not in page
    assert len(page.encode()) < 2_000_000


def test_every_part_is_there(page):
    checker = Checker()
    checker.feed(page)
    assert checker.headings == ["At the gauges", "Set-up", "Wave diagram", "Gauge records", "Free surface", "Energy and momentum", "Events", "Materials",
                                "Numerics", "Sources", "Deck with every default written out"]


def test_numbers_and_sources_are_told(page):
    for words in ("Acoustic flyer", "pull-back", "70 m/s", "1.404 GPa", "spall plane at", "A table of the tests", "not checked against the printed source",
                  "a stand-in material", "Starkenberg", "d&#x27;Alembert 1747", "prefers-color-scheme: dark", "@media print"):
        assert words in page, words


def test_pictures_are_sound_svg_with_ids_of_their_own(page):
    pictures = re.findall(r"<svg .*?</svg>", page, flags=re.S)
    assert len(pictures) == 14      # each for wide and for narrow screens
    ids = []
    for picture in pictures:
        root = ElementTree.fromstring(picture)
        mine = {element.get("id") for element in root.iter() if element.get("id")}
        used = set(re.findall(r"url\(#([^)]+)\)|href=\"#([^\"]+)\"", picture))
        assert {a or b for a, b in used} <= mine
        ids += mine
    assert len(ids) == len(set(ids))


def test_figures_are_read_on_a_narrow_screen(page):
    """Of every figure one drawing is shown; on a screen of 420 pixels its text is 9 pixels high or more."""
    narrow = page[page.index("@media (max-width: 36rem)"):]
    assert "svg.narrow { display: none; }" in page and "svg.broad { display: none; } svg.narrow { display: block; }" in narrow
    kinds = re.findall(r'<svg [^>]*class="picture (\w+)"', page)
    assert kinds.count("broad") == kinds.count("narrow") == 7
    assert "p, li, h1, figcaption { overflow-wrap: anywhere; }" in page     # a checksum must not widen the page
    for picture in re.findall(r'<svg [^>]*class="picture narrow".*?</svg>', page, flags=re.S):
        width = float(re.search(r'viewBox="0 0 ([\d.]+) ', picture)[1])
        sizes = [float(size) for size in re.findall(r"font(?:-size)?: ?([\d.]+)px", picture)]
        assert sizes and min(sizes) * (420 - 2 * 0.75 * 16) / width >= 9.0, picture[:200]


def test_the_gauges_come_first(page):
    """No cards, nor pictures, before the table of the gauges; on a narrow screen every number has its head beside it."""
    table = page.index("<h2>At the gauges</h2>")
    assert table < page.index('<dl class="numbers">') and table < page.index("<svg")
    section = page[table:page.index("</section>", table)]
    heads, rows = re.findall(r"<th>(.*?)</th>", section), re.findall(r"<tr>(<td>.*?)</tr>", section)
    assert rows and all(re.findall(r'data-head="(.*?)"', row) == heads[1:] for row in rows)


def test_the_same_run_gives_the_same_page(folder, page):
    assert write_report(folder).read_text(encoding="utf-8") == page


def test_a_hostile_deck_cannot_act(tmp_path, monkeypatch):
    evil = "<script>alert(1)</script>"
    real = acoustic_flyer.problem

    def problem(*args):
        plain = real(*args)
        regions = tuple(replace(region, name=evil + str(k)) for k, region in enumerate(plain.regions))
        gauges = tuple(replace(gauge, name=f"{gauge.name}\"'><img src=x>") for gauge in plain.gauges)
        return replace(plain, title=evil, regions=regions, gauges=gauges)

    monkeypatch.setattr(acoustic_flyer, "problem", problem)
    monkeypatch.setattr(acoustic_flyer, "DECK", f'title = "{evil}"')
    acoustic_flyer.run(tmp_path / "run", flyer=20, target=40, cycles=160)
    page = write_report(tmp_path / "run").read_text()
    assert "<img" not in page
    assert "<script" not in without_scripts(page) and "&lt;script&gt;" in page


def test_text_that_matplotlib_reads_as_formulas_is_kept(tmp_path, monkeypatch):
    """A dollar sign in a name is a dollar sign, not the start of a formula that may not parse."""
    real = acoustic_flyer.problem
    monkeypatch.setattr(acoustic_flyer, "problem", lambda *args: replace(real(*args), regions=tuple(
        replace(region, name=f"$\\frac{k}$") for k, region in enumerate(real(*args).regions))))
    acoustic_flyer.run(tmp_path / "run", flyer=20, target=40, cycles=160)
    assert "$\\frac0$" in write_report(tmp_path / "run").read_text()


def test_an_unfinished_status_comes_first(folder, tmp_path):
    import shutil

    shutil.copytree(folder, tmp_path / "run")
    summary = json.loads((tmp_path / "run" / "summary.json").read_text())
    summary.pop(MARK)
    (tmp_path / "run" / "summary.json").write_text(sealed_json({**summary, "status": "stopped at max_cycles"}))
    assert "The run did not reach its end: stopped at max_cycles" in write_report(tmp_path / "run").read_text()


def test_no_run_no_report(tmp_path):
    with pytest.raises(FileTrouble):
        write_report(tmp_path)


def test_a_run_without_gauges_or_events_or_with_one_record_has_a_page(tmp_path, monkeypatch, recwarn):
    real = acoustic_flyer.AcousticFlyer.meta
    monkeypatch.setattr(acoustic_flyer.AcousticFlyer, "meta", lambda self: {**real(self), "gauges": []})
    monkeypatch.setattr(acoustic_flyer.RunFolder, "gauges", lambda *args: None)
    for cycles in (1, 160):
        folder = tmp_path / str(cycles)
        acoustic_flyer.run(folder, flyer=20, target=40, cycles=cycles, snapshot_every=1)
        page = write_report(folder).read_text()
        assert "Set-up" in page and ("the snapshots only; a gauge at" in page) == (cycles > 1)
        assert (folder / "gauges.csv").read_text() == "time [s]\n"
    assert not [w for w in recwarn if "identical" in str(w.message)]


def test_the_bulk_viscosity_of_a_material_stands_beside_its_shear_viscosity():
    deck = '[[region]]\nname = "a"\nmaterial = "gas"\nfrom = 0\nto = 1\nzones = 2\ndensity = 1.2\npressure = 1e5\n'
    deck += '[material.gas.eos]\nlaw = "ideal_gas"\ngamma = 1.4\n[transport.gas]\nviscosity = {law = "constant", shear_viscosity = 2e-5}\n'
    for extra, words in (("", "ζ = 0 μ + 0 Pa s"), ("bulk_ratio = 0.6\nbulk_viscosity = 3e-6\n", "ζ = 0.6 μ + 3e-06 Pa s")):
        problem = read_deck_text("stop_time = 1e-6\n" + deck + extra).problem
        assert words in materials(setup_record(problem, {}))
