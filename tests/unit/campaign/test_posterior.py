"""Posteriors: a straight line's exactly, over the runs and over a surrogate; a Gaussian process and its leave-one-out error; a spall record."""

import json

import numpy as np
import pytest
from fit_problems import FREE, TIMES, bump, line, problem, record, written

import hugoniot
from hugoniot.campaign.gaussian_process import _surprise, process_through
from hugoniot.campaign.posterior import posterior_of
from hugoniot.campaign.run_fit import FitWishes, run_fit
from hugoniot.campaign.surrogate import surrogate_of
from hugoniot.errors import DeckError, NoSolution

pytest.importorskip("emcee")


# -- the process ---------------------------------------------------------------------------------------------------------
def sample(count, dimension, seed=0):
    return 2.0 * np.random.default_rng(seed).random((count, dimension)) - 1.0


def smooth(x):
    return np.sin(2.0 * x[:, 0]) + 0.5 * x[:, 1] ** 2


def test_a_process_goes_through_smooth_answers():
    x, new = sample(40, 2), sample(200, 2, seed=1)
    process = process_through(x, 1e9 * smooth(x))
    miss = process.mean(new) - 1e9 * smooth(new)
    assert np.sqrt(np.mean(miss**2)) < 0.01e9
    assert np.mean(np.abs(miss) < 3.0 * process.deviation(new)) > 0.95


def test_leaving_one_out_in_closed_form_is_leaving_one_out():
    x = sample(24, 2)
    y = smooth(x) + 0.1 * np.random.default_rng(2).standard_normal(24)
    process = process_through(x, y)
    for k in (0, 7, 23):
        others = np.arange(24) != k
        alone = process_through(x[others], y[others])
        fixed = type(process)(x[others], process.middle, process.scale, process.theta, *_solved(process, x[others], y[others]))
        assert process.left_out()[k] == pytest.approx(y[k] - fixed.mean(x[k:k + 1])[0], rel=1e-6, abs=1e-9)
        assert alone.mean(x[k:k + 1])[0] == pytest.approx(fixed.mean(x[k:k + 1])[0], abs=0.2)


def _solved(process, x, y):
    from scipy import linalg

    from hugoniot.campaign.gaussian_process import _covariance

    lower = linalg.cholesky(_covariance(process.theta, x)[0], lower=True)
    return lower, linalg.cho_solve((lower, True), (y - process.middle) / process.scale)


def test_the_gradient_of_the_likelihood():
    x = sample(12, 2)
    y, theta = smooth(x), np.array([0.3, -0.4, 0.1, -2.0])
    value, gradient = _surprise(theta, x, y)
    for k in range(4):
        step = 1e-6 * np.eye(4)[k]
        assert (_surprise(theta + step, x, y)[0] - _surprise(theta - step, x, y)[0]) / 2e-6 == pytest.approx(gradient[k], rel=1e-5, abs=1e-6)
    assert np.isfinite(value)


def test_noise_is_not_taken_for_a_signal():
    x = sample(60, 1)
    noise = np.random.default_rng(3).standard_normal(60)
    process = process_through(x, x[:, 0] + 0.3 * noise)
    assert np.sqrt(np.mean(process.left_out() ** 2)) == pytest.approx(0.3, rel=0.25)
    assert np.sqrt(np.mean((process.mean(x) - x[:, 0]) ** 2)) < 0.12


# -- a straight line -----------------------------------------------------------------------------------------------------
@pytest.fixture(scope="module")
def straight():
    data = line(TIMES, 0.3, 0.6) + 0.01 * np.random.default_rng(1).standard_normal(TIMES.size)
    design = np.column_stack([np.ones_like(TIMES), TIMES])
    covariance = np.linalg.inv(design.T @ design / 0.01**2)
    return data, covariance @ design.T @ data / 0.01**2, covariance


def found(data, kind, runs=None):
    p = problem(line, data, 0.01, ["a = 0..1", "b = 0..1"], points=7)
    return posterior_of(p, p.search(p.starts(None, 1, 0)[0]), kind, runs, seed=2)


@pytest.fixture(scope="module")
def small(straight):
    return found(straight[0], "surrogate", 24)


@pytest.mark.parametrize("kind, runs", [("surrogate", None), ("runs", 24_000)])
def test_a_straight_line_has_the_posterior_of_the_textbook(straight, kind, runs):
    data, mean, covariance = straight
    p = found(data, kind, runs)
    sigma, effective = np.sqrt(np.diag(covariance)), p.effective
    assert effective > 500.0
    assert np.all(np.abs(p.mean - mean) < 4.0 * sigma / np.sqrt(effective))
    assert p.deviation == pytest.approx(sigma, rel=4.0 / np.sqrt(2.0 * effective))
    exact = covariance[0, 1] / (sigma[0] * sigma[1])
    assert p.correlation[0, 1] == pytest.approx(exact, abs=4.0 * (1.0 - exact**2) / np.sqrt(effective))
    assert p.quantiles[[0, -1]] == pytest.approx(np.array([mean - 1.96 * sigma, mean + 1.96 * sigma]), abs=0.35 * sigma.max())
    assert not p.doubts and (kind == "runs" or p.surrogate.log_error < 1e-3)
    assert 1.0 < p.autocorrelation.max() < 100.0
    # a priori the line may lie anywhere, a posteriori within the error of the mean
    width = [np.ptp(band[0][[0, 2]], axis=0).mean() for band in (p.prior, p.predicted)]
    assert width[0] > 0.8 and width[1] < 6.0 * 0.01 / np.sqrt(TIMES.size) * np.sqrt(2.0)


def test_every_pair_is_drawn_and_what_runs_predict(straight, small, tmp_path):
    from hugoniot.plotting.eos import save
    from hugoniot.plotting.posterior import corner_figure, draw_predictive
    from hugoniot.plotting.style import new_panels

    p = small
    figure = corner_figure(p)
    assert [ax.get_visible() for ax in figure.axes] == [True, False, True, True]
    save(figure, tmp_path / "corner.png")
    axes = new_panels(1, 1, 4.0, 3.0)
    sigma = np.full(TIMES.size, 0.01)
    draw_predictive(axes[0, 0], ("record", "g.velocity", "m/s", TIMES, straight[0], sigma, straight[0]), p.prior[0], p.predicted[0])
    assert (tmp_path / "corner.png").stat().st_size > 5000 and axes[0, 0].get_ylabel() == "particle velocity (m/s)"


def test_draws_come_again_with_their_seed(straight, small):
    assert np.array_equal(found(straight[0], "surrogate", 24).draws, small.draws)


def test_a_shift_of_the_clock_is_drawn_too():
    data = bump(TIMES - 0.04, 1.0, 0.1) + 0.01 * np.random.default_rng(3).standard_normal(TIMES.size)
    p = problem(bump, data, 0.01, ["h = 1 +- 0.1", "w = 0.05..0.3"], shift=0.1)
    best = p.search(p.starts(None, 1, 0)[0])
    drawn = posterior_of(p, best, "surrogate", 40)
    assert drawn.names == ("h", "w", "shift") and drawn.units[2] == "s"
    for k, truth in enumerate((1.0, 0.1, 0.04)):
        assert abs(drawn.mean[k] - truth) < 4.0 * drawn.deviation[k]
    normal = np.linalg.inv(best.slopes.T @ best.slopes)
    scale = [p.value(k, 1.0) - p.value(k, 0.0) for k in range(3)]
    assert drawn.deviation == pytest.approx(np.sqrt(np.diag(normal)) * scale, rel=0.12)     # nearly straight near the minimum


def test_a_surrogate_that_is_not_good_enough_is_refused():
    def jumpy(t, a, b):
        return line(t, a + 0.01 * np.sign(np.sin(4000.0 * a)), b)

    data = line(TIMES, 0.3, 0.6) + 0.01 * np.random.default_rng(1).standard_normal(TIMES.size)
    p = problem(jumpy, data, 0.01, ["a = 0..1", "b = 0..1"])
    best = p.search(p.starts(None, 1, 0)[0])
    with pytest.raises(NoSolution, match="surrogate is not good enough.*--posterior runs"):
        posterior_of(p, best, "surrogate")


def test_too_few_sound_runs_are_refused(straight):
    p = problem(line, straight[0], 0.01, ["a = 0..1", "b = 0..1"])
    best = p.search(p.starts(None, 1, 0)[0])
    p.seen.clear()
    p.ask = lambda changes: [{"reason": "no"} for _ in changes]
    with pytest.raises(NoSolution, match="only 0 of 48 runs"):
        surrogate_of(p, best.x, np.diag([1e-6, 1e-6]))


def test_a_short_walk_and_a_cut_range_are_reported(straight):
    data = straight[0]
    doubts = " ".join(found(data, "runs", 200).doubts)
    assert "the chains were short" in doubts
    p = problem(line, data, 0.01, ["a = 0.3..1", "b = 0..1"])
    best = p.search(p.starts(None, 1, 0)[0])
    assert any(doubt.startswith("the posterior of a is cut off") for doubt in posterior_of(p, best, "surrogate").doubts)


# -- with runs -----------------------------------------------------------------------------------------------------------
@pytest.mark.slow
def test_a_record_over_a_surrogate(deck, tmp_path, inline, monkeypatch):
    """On twice the zones: the coarser deck answers in jumps as large as what a surrogate may miss."""
    deck.write_text(deck.read_text().replace("zones = 16", "zones = 32").replace("zones = 8", "zones = 16").replace('"0.5 us"', '"1.5 us"'))
    data = written(tmp_path / "visar.csv", *record(deck, sigma=25.0))
    free = {"region.flyer.velocity": "600..850 m/s", "material.al.strength.yield_stress": "0.1..0.6 GPa"}
    monkeypatch.setattr("hugoniot.campaign.run_fit.local", lambda workers: inline)
    out = tmp_path / "f"
    got = hugoniot.fit(deck, data, free, gauge="free surface", sigma="25 m/s", shift="20 ns", out=out, starts=1, posterior="surrogate",
                       window=["0.4..1.1 us"])
    names = list(got["parameter"].values)
    middle, spread = got["draws"].mean("draw").values, got["draws"].std("draw").values
    for name, truth in (("region.flyer.velocity", 720.0), ("material.al.strength.yield_stress", 0.3e9), ("shift", 8e-9)):
        k = names.index(name)
        assert abs(middle[k] - truth) < 4.0 * spread[k]
        assert 0.5 < spread[k] / float(got["sigma"][k]) < 2.0
    assert got.attrs["surrogate_log_error"] < 0.5 and got.attrs["effective_draws"] > 200.0
    band = got["posterior_predictive"].values
    assert np.mean(band[2] - band[0]) < 0.3 * np.mean(np.ptp(got["prior_predictive"].values[[0, 2]], axis=0))
    document = json.loads((out / "fit.json").read_text())["posterior"]
    assert document["kind"] == "surrogate" and document["surrogate"]["errors"]
    assert (out / "posterior.csv").read_text().startswith("region.flyer.velocity [m/s],")
    assert (out / "predictive.csv").read_text().count("\n") == got.sizes["point"] + 1
    page = (out / "report.html").read_text()
    assert "<h2>Posterior</h2>" in page and "predictive-0" in page


@pytest.mark.slow
def test_a_spall_strength_over_the_runs(deck, tmp_path, inline):
    """A sharp criterion answers in jumps: a surrogate would smooth them, and refuses; the runs themselves do not."""
    deck.write_text(deck.read_text().replace('"0.5 us"', '"1.5 us"'))
    data = written(tmp_path / "visar.csv", *record(deck, sigma=25.0))
    wishes = FitWishes([data], FREE, gauge="free surface", sigma="25 m/s", starts=1, window=["0.4..1.4 us"], local=True,
                       shift="20 ns", posterior="runs", posterior_runs=600)
    found = run_fit(deck, wishes, False, engine=inline)
    p = found.posterior
    for k, truth in enumerate((720.0, 0.9e9, 8e-9)):
        assert abs(p.mean[k] - truth) < 4.0 * p.deviation[k]
        assert 0.2 < p.deviation[k] / found.fit.parameters[k].sigma < 3.0
    assert p.surrogate is None and any("chains were short" in doubt for doubt in p.doubts)
    wishes.posterior, wishes.posterior_runs = "surrogate", 32
    with pytest.raises(NoSolution, match="not good enough"):
        run_fit(deck, wishes, False, engine=inline)


@pytest.mark.parametrize("wishes, words", [
    ({"posterior": "mcmc"}, "unknown kind of posterior 'mcmc'.*known: surrogate, runs"),
    ({"posterior": "runs", "posterior_runs": 3}, "too few runs for a posterior"),
    ({"posterior_runs": 300}, "no posterior is requested"),
])
def test_posteriors_that_are_refused(deck, tmp_path, inline, wishes, words):
    data = written(tmp_path / "visar.csv", TIMES * 1.4e-6, 700.0 * TIMES)
    with pytest.raises(DeckError, match=words):
        run_fit(deck, FitWishes([data], ["region.flyer.velocity = 600..850 m/s"], gauge="free surface", **wishes), False, engine=inline)


def test_a_missing_emcee_is_named(monkeypatch):
    import sys

    from hugoniot.campaign.posterior import checked

    monkeypatch.setitem(sys.modules, "emcee", None)
    with pytest.raises(DeckError, match="pip install 'hugoniot.posterior.'"):
        checked("runs")
