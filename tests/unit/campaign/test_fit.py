"""Fits: truth recovered with honest intervals, shifts and scales, priors, outliers, wrong minima, and models that cannot match."""

import json
import math
import pathlib
import random

import numpy as np
import pytest
from faults import flip
from fit_problems import FREE, TIMES, bump, line, problem, record, written

import hugoniot
from hugoniot.campaign.fit_files import claimed
from hugoniot.campaign.fit_results import weighed
from hugoniot.campaign.memory_run import MemoryRun
from hugoniot.campaign.questions import Deck
from hugoniot.campaign.run_fit import POINTS, FitWishes, look_at, run_fit
from hugoniot.campaign.targets import Target, noise_of
from hugoniot.errors import DeckError, FileTrouble, NoSolution
from hugoniot.explorer import fits
from hugoniot.output.verify import verify


def test_a_straight_line_has_the_intervals_of_the_textbook():
    data = line(TIMES, 0.3, 0.6) + 0.01 * np.random.default_rng(1).standard_normal(TIMES.size)
    p = problem(line, data, 0.01, ["a = 0..1", "b = 0..1"])
    fit = weighed(p, [p.search(p.starts(None, 1, 0)[0])], profiles=True)
    design = np.column_stack([np.ones_like(TIMES), TIMES])
    normal = np.linalg.inv(design.T @ design / 0.01**2)
    exact = normal @ design.T @ data / 0.01**2
    chi = float(np.sum(((design @ exact - data) / 0.01) ** 2))
    factor = math.sqrt(max(1.0, chi / (TIMES.size - 2)))
    for k, found in enumerate(fit.parameters):
        assert found.value == pytest.approx(exact[k], abs=0.02 * math.sqrt(normal[k, k]))
        assert found.sigma == pytest.approx(factor * math.sqrt(normal[k, k]), rel=1e-3)
        assert found.high - found.value == pytest.approx(1.972 * found.sigma, rel=0.02)
        assert found.profile_high - found.value == pytest.approx(1.960 * found.sigma, rel=0.05)     # quadratic: profile and interval agree
        assert found.value - found.profile_low == pytest.approx(1.960 * found.sigma, rel=0.05)
    assert fit.correlation[0, 1] == pytest.approx(normal[0, 1] / math.sqrt(normal[0, 0] * normal[1, 1]), abs=2e-3)
    assert fit.matches and fit.reduced == pytest.approx(chi / (TIMES.size - 2), rel=1e-3)


def test_small_jumps_of_the_runs_are_part_of_the_interval():
    def stairs(t, a, b):
        return line(t, round(a * 300) / 300, b)     # a run that knows its parameter to 0.0033 only: more than its sigma of 0.0014

    away = []
    for seed in range(16):
        data = line(TIMES, 0.3 + 0.0002 * seed, 0.6) + 0.01 * np.random.default_rng(seed).standard_normal(TIMES.size)
        p = problem(stairs, data, 0.01, ["a = 0..1", "b = 0..1"])
        found = weighed(p, [p.search(p.starts(None, 1, 0)[0])]).parameters[0]
        away.append((found.value - 0.3 - 0.0002 * seed) / found.sigma)
    assert 0.3 < np.sqrt(np.mean(np.square(away))) < 1.5 and np.mean(np.abs(away) < 1.97) > 0.85


def test_a_step_wider_than_the_noise_belongs_to_the_interval():
    """A run that knows its parameter to 0.01 only, the truth near the end of a step: the noise alone would tell it to 0.0014."""
    def stairs(t, a, b):
        return line(t, round(a * 100) / 100, b)

    truth, covered, widths = 0.3045, [], []
    for seed in range(24):
        data = stairs(TIMES, truth, 0.6) + 0.01 * np.random.default_rng(seed).standard_normal(TIMES.size)
        p = problem(stairs, data, 0.01, ["a = 0..1", "b = 0..1"])
        found = weighed(p, [p.search(p.starts(None, 1, 0)[0])]).parameters[0]
        covered.append(found.low <= truth <= found.high)
        widths.append(found.high - found.low)
    assert np.mean(covered) >= 0.9 and 0.006 < np.median(widths) < 0.03


def test_shift_and_scale_are_found_without_runs_of_their_own():
    data = 1.03 * bump(TIMES - 0.04, 1.0, 0.1) + 0.005 * np.random.default_rng(3).standard_normal(TIMES.size)
    p = problem(bump, data, 0.005, ["h = 1 +- 0.001", "w = 0.05..0.3"], shift=0.1, scale=0.1)
    fit = weighed(p, [p.search(p.starts(None, 1, 0)[0])])
    names = {q.name: q for q in fit.parameters}
    assert list(names) == ["h", "w", "shift", "scale"]
    for name, truth in (("h", 1.0), ("w", 0.1), ("shift", 0.04), ("scale", 0.03)):
        assert abs(names[name].value - truth) < 3.5 * names[name].sigma
    assert names["h"].sigma == pytest.approx(0.001, rel=0.05)      # the prior is all that is known of it


def test_outliers_count_little_with_a_robust_loss():
    data = line(TIMES, 0.3, 0.6) + 0.01 * np.random.default_rng(4).standard_normal(TIMES.size)
    data[20:32] += 0.5
    errors = {}
    for loss in ("linear", "soft_l1", "huber", "cauchy"):
        p = problem(line, data, 0.01, ["a = 0..1", "b = 0..1"], loss=loss)
        errors[loss] = abs(p.search(p.starts(None, 1, 0)[0]).x[0] - 0.3)
    assert errors["linear"] > 0.05 and max(errors[loss] for loss in ("soft_l1", "huber", "cauchy")) < 0.01


def wave(t, f):
    return np.sin(2.0 * np.pi * f * t)


@pytest.mark.parametrize("loss", ["soft_l1", "huber", "cauchy"])
def test_a_robust_loss_keeps_the_meaning_of_chi_square(loss):
    """One per degree of freedom for normal noise of the deviation given, and no match for a wrong model, whose sum of squares it bounds."""
    noise = 0.01 * np.random.default_rng(4).standard_normal(TIMES.size)
    p = problem(line, line(TIMES, 0.3, 0.6) + noise, 0.01, ["a = 0..1", "b = 0..1"], loss=loss)
    fit = weighed(p, [p.search(p.starts(None, 1, 0)[0])])
    assert fit.matches and fit.reduced == pytest.approx(1.0, abs=0.25)      # four standard deviations of the mean of 200 squares
    p = problem(line, bump(TIMES, 1.0, 0.1) + noise, 0.01, ["a = 0..1", "b = 0..1"], loss=loss)
    fit = weighed(p, [p.search(p.starts(None, 1, 0)[0])])
    assert not fit.matches and fit.doubts[0].startswith("the model does not match the data")


def level(t, a, b):
    return a + 0.0 * b * t


def test_no_loss_softens_a_prior_and_what_it_alone_holds_is_reported():
    data = level(TIMES, 0.3, 0.0) + 0.01 * np.random.default_rng(6).standard_normal(TIMES.size)
    for loss in ("linear", "cauchy"):
        p = problem(level, data, 0.01, ["a = 0..1", "b = 0.9 +- 0.001"], loss=loss)
        assert p.cost(np.array([0.3, 2.0])) - p.cost(np.array([0.3, 0.0])) == pytest.approx(4.0, rel=1e-9)
    assert any("say little about b" in doubt for doubt in weighed(p, [p.search(p.starts(None, 1, 0)[0])]).doubts)


@pytest.mark.parametrize("count", [1, 3])
def test_intervals_from_a_few_data_are_as_wide_as_their_uncertainty_says(count):
    """One parameter from one datum: 1.96 standard deviations of it. From three: covered, and not much wider than needed."""
    times, widths, covered = TIMES[:count], [], []
    for seed in range(20):
        data = 0.3 + 0.01 * np.random.default_rng(seed).standard_normal(count)
        p = problem(lambda t, a: a + 0.0 * t, data, 0.01, ["a = 0..1"], times=times)
        found = weighed(p, [p.search(np.array([0.5]))]).parameters[0]
        covered.append(found.low <= 0.3 <= found.high)
        widths.append(0.5 * (found.high - found.low) * math.sqrt(count) / 0.01)
    assert np.mean(covered) >= 0.85 and np.min(widths) == pytest.approx(1.96, rel=0.02) and np.quantile(widths, 0.5) < 2.5


def test_a_datum_that_the_range_cannot_reach_is_no_match():
    p = problem(lambda t, a: a + 0.0 * t, np.array([2.0]), 0.01, ["a = 0..1"], times=TIMES[:1])
    fit = weighed(p, [p.search(np.array([0.5]))])
    assert not fit.matches and fit.doubts[0].startswith("the model does not match the data")


def test_correlated_noise_is_reported_with_what_it_does_to_the_intervals():
    """A moving average over ten points: the scatter of the fitted value over its standard deviation, and the factor of the note."""
    ratios, factors = [], []
    for seed in range(24):
        noise = np.convolve(np.random.default_rng(seed).standard_normal(TIMES.size + 9), np.full(10, 0.1**0.5), "valid")
        p = problem(line, line(TIMES, 0.3, 0.6) + 0.01 * noise, 0.01, ["a = 0..1", "b = 0..1"])
        fit = weighed(p, [p.search(np.array([0.3, 0.6]))])
        ratios.append((fit.parameters[0].value - 0.3) / fit.parameters[0].sigma)
        factors += [float(doubt.rpartition(" ")[2]) for doubt in fit.doubts if "neighbouring points are correlated" in doubt]
    assert len(factors) == 24 and 0.6 < np.mean(factors) / np.sqrt(np.mean(np.square(ratios))) < 1.7


def test_a_wrong_minimum_is_noticed():
    data = wave(TIMES, 7.3) + 0.05 * np.random.default_rng(5).standard_normal(TIMES.size)
    p = problem(wave, data, 0.05, ["f = 1..12"])
    stuck = p.search(np.array([(5.6 - 1.0) / 11.0]))
    assert stuck.cost > 1000.0
    best = p.search(p.widely([stuck.x], 0))
    assert p.value(0, best.x[0]) == pytest.approx(7.3, abs=0.02)
    fit = weighed(p, sorted([stuck, best], key=lambda m: m.cost))
    assert fit.matches and len(fit.others) == 1 and fit.others[0][1] == stuck.cost


def test_a_model_that_cannot_match_is_reported():
    data = bump(TIMES, 1.0, 0.1)
    p = problem(line, data, 0.01, ["a = 0..1", "b = -1..1"])
    fit = weighed(p, [p.search(p.starts(None, 1, 0)[0])])
    assert not fit.matches and fit.reduced > 100.0 and fit.doubts[0].startswith("the model does not match the data")


def test_what_the_data_do_not_determine_is_reported():
    def same(t, a, b):
        return np.full_like(t, a + 1e-9 * b)

    data = same(TIMES, 0.3, 0.0) + 0.01 * np.random.default_rng(6).standard_normal(TIMES.size)
    p = problem(same, data, 0.01, ["a = 0..1", "b = 0..1"])
    assert any(doubt.startswith("b ") for doubt in weighed(p, [p.search(p.starts(None, 1, 0)[0])]).doubts)
    p = problem(line, line(TIMES, 1.2, 0.5), 0.01, ["a = 0..1", "b = 0.49..0.51"])
    assert any("a lies at a limit of its range" in doubt for doubt in weighed(p, [p.search(np.array([0.5, 0.5]))]).doubts)


def test_no_run_that_succeeds_is_an_error():
    p = problem(line, line(TIMES, 0.3, 0.6), 0.01, ["a = 0..1", "b = 0..1"])
    p.ask = lambda changes: [{"reason": "negative density"} for _ in changes]
    with pytest.raises(NoSolution, match="negative density"):
        p.starts(None, 1, 0)


def test_the_noise_of_a_record_is_found_in_it():
    values = 700.0 / (1.0 + np.exp(-(TIMES - 0.5) / 0.02)) + 5.0 * np.random.default_rng(7).standard_normal(TIMES.size)
    assert noise_of(values) == pytest.approx(5.0, rel=0.25)
    assert noise_of(700.0 * TIMES) == pytest.approx(1.4)


# -- with runs -----------------------------------------------------------------------------------------------------------
def test_a_record_gives_its_constants_back(deck, tmp_path, inline):
    data = written(tmp_path / "visar.csv", *record(deck))
    found = run_fit(deck, FitWishes([data], FREE, gauge="free surface", sigma="5 m/s", shift="20 ns"), tmp_path / "f", engine=inline)
    by_name = {p.name: p for p in found.fit.parameters}
    for name, truth in (("region.flyer.velocity", 720.0), ("material.al.fracture.strength", 0.9e9), ("shift", 8e-9)):
        assert abs(by_name[name].value - truth) < 4.0 * by_name[name].sigma, name
    assert by_name["region.flyer.velocity"].sigma < 2.0 and by_name["shift"].sigma < 2e-9
    assert found.fit.matches and 0.7 < found.fit.reduced < 1.4
    folder = tmp_path / "f"
    again = hugoniot.run(folder / "fitted.toml", tmp_path / "again.run", report=False)     # the fitted deck is ready to run
    model = np.interp(found.targets[0].time - by_name["shift"].value, *again.gauge("velocity", "free surface"))
    assert np.allclose(model, found.models[0], atol=2.0)
    document = json.loads((folder / "fit.json").read_text())
    assert document["matches"] is True and len(document["parameters"]) == 3
    assert (folder / "residuals.csv").read_text().count("\n") == 201 and "<svg" in (folder / "report.html").read_text()
    check_flips(folder)
    (folder / "fitted.toml").write_text((folder / "fitted.toml").read_text() + "# my own remarks\n")
    with pytest.raises(FileTrouble, match="fitted.toml: changed since the fit, and the changes would be lost"):
        claimed(folder)


def check_flips(folder):
    """Each is found, and a page does not show what it changed."""
    names, chance = ["fit.json", "fitted.toml", "report.html", "residuals.csv"], random.Random(3)
    assert sorted(path.name for path in folder.iterdir()) == names and not any(f.bad for f in verify(folder))
    assert fits.fit(folder)["fit"]["matches"] is True
    for k in range(80):
        path = folder / names[k % len(names)]
        data = path.read_bytes()
        flip(path, chance)
        assert [f.file for f in verify(folder) if f.bad] == [path.name], k
        if path.suffix != ".html":
            with pytest.raises(FileTrouble, match="changed since it was written"):
                fits.fit(folder)
        path.write_bytes(data)


@pytest.mark.parametrize("name", ["fitted.toml", "fit.json", "posterior.csv", "residuals.csv", "report.html", ".fit.json.part", "thesis.tex"])
def test_a_file_that_no_fit_wrote_is_not_replaced(tmp_path, name):
    (tmp_path / name).write_text('{"mine": 1}')
    with pytest.raises(FileTrouble, match="as the folder of a fit|not a file of a fit|not written by a fit"):
        claimed(tmp_path)
    assert (tmp_path / name).read_text() == '{"mine": 1}'


def test_a_record_of_something_else_is_not_fitted_silently(deck, tmp_path, inline):
    at, values = record(deck)
    data = written(tmp_path / "visar.csv", at, 1.5 * values * (at < 1.0e-6))
    wishes = FitWishes([data], FREE, gauge="free surface", sigma="5 m/s", local=True, starts=1)
    found = run_fit(deck, wishes, False, engine=inline)
    assert not found.fit.matches and "does not match the data" in found.fit.doubts[0] and found.folder is None


def test_a_long_run_is_kept_as_finely_as_the_data_are(deck):
    """20 us of a deck whose precursor takes 30 ns: at the times of the data the kept record is the run's own."""
    at = np.linspace(0.6e-6, 0.75e-6, 151)
    question = Deck(deck.read_text(), deck.name, records=("free surface.velocity",), until=20e-6, points=POINTS)
    look_at(question, [Target("record", "free surface.velocity", "m/s", at, at, at, 0)], 20e-9)
    changes = {"stop_time": "20 us"}
    kept = np.interp(at, question.times(), question.answer(changes)["records"]["free surface.velocity"])
    assert kept == pytest.approx(np.interp(at, *MemoryRun(question.read(changes).problem).gauge("velocity", "free surface")), abs=0.5)


def test_numbers_and_windows_and_uncertainties_of_the_file(deck, tmp_path, inline, monkeypatch):
    at, values = record(deck)
    path = tmp_path / "visar.csv"
    path.write_text("time [us], free surface velocity [km/s], free surface velocity sigma [m/s]\n"
                    + "".join(f"{t * 1e6!r}, {v * 1e-3!r}, 5\n" for t, v in zip(at.tolist(), values.tolist())))
    monkeypatch.setattr("hugoniot.campaign.run_fit.local", lambda workers: inline)
    found = hugoniot.fit(deck, [path, "free surface.peak_velocity = 720 +- 20 m/s"], {"region.flyer.velocity": "600..850 m/s"}, out=False,
                         window=["0.39..0.9 us"], starts=1, shift="20 ns")
    assert found["value"].sel(parameter="region.flyer.velocity") == pytest.approx(720.0, abs=6.0)
    assert found.attrs["matches"] == 1 and found.attrs["degrees_of_freedom"] == 100 + 1 - 2 and "stop_time" in found.attrs["deck"]


@pytest.mark.slow
def test_a_wall_seen_by_a_streak_camera_gives_the_tube_back(tmp_path, inline):
    """A record of two dimensions: a short cylinder test, and the density of its tube from the place of the wall."""
    text = (pathlib.Path(__file__).parents[3] / "examples" / "cylinder-test.toml").read_text()
    for old, new in (("220 mm", "40 mm"), ("[8, 140]", "[4, 20]"), ("[3, 140]", "[2, 20]"), ("27.5 us", "10 us"), ("100 mm", "20 mm")):
        text = text.replace(old, new)
    deck = tmp_path / "cylinder.toml"
    deck.write_text(text)
    run = MemoryRun(Deck(text, deck.name).read({"material.tube.eos.rho0": "9200 kg/m^3"}).problem)
    time, place = run.gauge("line_position", "streak at 20 mm")
    late = time > 2e-6
    seen = place[late] + 2e-5 * np.random.default_rng(0).standard_normal(int(late.sum()))
    data = written(tmp_path / "streak.csv", time[late], 1e3 * seen, "time [us], streak at 20 mm line_position [mm]")
    fit = run_fit(deck, FitWishes([data], ["material.tube.eos.rho0 = 8.5..9.8 g/cm^3"], sigma="0.02 mm", starts=1, local=True), False,
                  engine=inline).fit
    assert abs(fit.parameters[0].value - 9200.0) < 4.0 * fit.parameters[0].sigma < 60.0 and fit.matches


@pytest.mark.parametrize("wishes, words", [
    ({"to": []}, "nothing to fit to"),
    ({"free": []}, "no parameter is free"),
    ({"free": ["region.flyer.velocity = 1, 2 km/s"]}, "needs a range, or a mean"),
    ({"free": ["region.flyer.velocity = 1..2 mm"]}, "expected a velocity"),
    ({"free": ["region.flyer.velocty = 1..2 km/s"]}, "unknown key"),
    ({"sigma": "5 mm"}, "--sigma: expected a velocity"),
    ({"sigma": "0 m/s"}, "above 0"),
    ({"shift": "20 mm"}, "--shift '20 mm': expected a time"),
    ({"scale": "-1 %"}, "--scale '-1 %': not above 0"),
    ({"window": ["2..3 us"]}, "csv: velocity: fewer than 3 of its points"),
    ({"window": ["3 us"]}, "not a range of times"),
    ({"window": ["other.csv = 0..1 us"]}, "no such file is given"),
    ({"gauge": "surface"}, "no such gauge in the deck; did you mean 'free surface'"),
    ({"loss": "quadratic"}, "unknown loss"),
    ({"starts": 0}, "not a valid number of searches"),
    ({"to": ["free surface.arival = 1 +- 0.1 us"]}, "did you mean 'free surface.arrival'"),
    ({"to": ["free surface.arrival = 1 +- 0 us"]}, "must be above 0"),
    ({"to": ["free surface.arrival = 1 +- 0.1 mm"]}, "expected a time"),
])
def test_what_cannot_be_fitted_is_refused_in_one_message(deck, tmp_path, inline, wishes, words):
    data = written(tmp_path / "visar.csv", TIMES * 1.4e-6, 700.0 * TIMES)
    asked = {"to": [data], "free": FREE[:1], "gauge": "free surface", **wishes}
    with pytest.raises(DeckError, match=words) as found:
        run_fit(deck, FitWishes(**asked), False, engine=inline)
    assert len(found.value.problems) == 1


def test_data_without_units_or_without_a_gauge_are_refused(deck, tmp_path, inline):
    data = written(tmp_path / "visar.csv", TIMES * 1.4e-6, 700.0 * TIMES, "time, velocity")
    with pytest.raises(DeckError, match="has no unit"):
        run_fit(deck, FitWishes([data], FREE), False, engine=inline)
    data = written(tmp_path / "visar.csv", TIMES * 1.4e-6, 300.0 + TIMES, "time [us], temperature [K]")
    with pytest.raises(DeckError, match="no gauge of the deck records this; gauges: .*free surface.*; each records: .*velocity"):
        run_fit(deck, FitWishes([data], FREE), False, engine=inline)
    with pytest.raises(FileTrouble):
        run_fit(deck, FitWishes([str(tmp_path / "none.csv")], FREE), False, engine=inline)


@pytest.mark.slow
def test_intervals_of_four_parameters_cover_the_truth(deck, tmp_path, inline):
    """Fifty records with noise: the mean lies within one standard deviation of the truth, 95 % intervals cover it 90 to 99 times in 100."""
    deck.write_text(deck.read_text().replace("zones = 8", "zones = 50").replace("zones = 16", "zones = 100").replace('"0.5 us"', '"1.5 us"'))
    truth = {"region.flyer.velocity": 720.0, "material.al.strength.yield_stress": 0.3e9, "material.al.fracture.strength": 1.0e9}
    free = ["region.flyer.velocity = 650..800 m/s", "material.al.strength.yield_stress = 0.1..0.6 GPa",
            "material.al.fracture.strength = 0.6..2.5 GPa"]
    run = MemoryRun(Deck(deck.read_text(), deck.name).read(truth).problem)
    at = np.linspace(0.5e-6, 1.45e-6, 300)
    clean = np.interp(at - 7e-9, *run.gauge("velocity", "free surface"))
    wanted, rows = np.array([*truth.values(), 7e-9]), []
    for seed in range(50):
        data = written(tmp_path / "visar.csv", at, clean + 5.0 * np.random.default_rng(seed).standard_normal(at.size))
        wishes = FitWishes([data], free, gauge="free surface", sigma="5 m/s", shift="20 ns")
        parameters = run_fit(deck, wishes, False, engine=inline).fit.parameters
        rows.append([(p.value, p.sigma, p.low <= w <= p.high) for p, w in zip(parameters, wanted)])
    values, sigmas, covered = np.moveaxis(np.array(rows), 2, 0)
    assert np.all(np.abs(values.mean(axis=0) - wanted) < sigmas.mean(axis=0))
    assert 0.90 <= covered.mean() <= 0.99
    assert covered[:, 2].mean() >= 0.90       # the spall strength, in whose steps of 27 to 44 MPa the record answers
