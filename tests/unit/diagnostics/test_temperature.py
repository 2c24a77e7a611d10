"""Temperatures of a run have the same bits however many states are looked at at once: a burst's length is a matter of the clock."""

import numpy as np
import pytest

from hugoniot.diagnostics.temperature import gauge_temperature
from hugoniot.laws.eos.contract import EOS, has_temperature, reference_state


@pytest.mark.parametrize("name", ["mie_gruneisen", "p_alpha"])
def test_a_record_cut_into_bursts_is_the_record(name):
    law = EOS.get(name).example
    if not has_temperature(law):
        law = law._replace(base=EOS.get("mie_gruneisen").example)
    rho0 = reference_state(law)[0]
    rng = np.random.default_rng(1)
    rows = {"density": rho0 * rng.uniform(1.0, 1.3, (300, 2)), "energy": rng.uniform(1e4, 1e6, (300, 2)), "compaction": rng.uniform(0.0, 1.0, (300, 2))}
    rows["compaction"][:20] = 0.0
    whole = gauge_temperature(rows, [law, law])
    assert np.isfinite(whole).all()
    cuts = [0, 1, 8, 20, 290, 300]
    parts = [gauge_temperature({key: value[a:b] for key, value in rows.items()}, [law, law]) for a, b in zip(cuts, cuts[1:])]
    assert np.array_equal(np.concatenate(parts), whole)
