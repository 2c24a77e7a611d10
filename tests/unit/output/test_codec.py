"""Payloads go to bytes and back without the change of a bit."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from hugoniot.errors import FileTrouble
from hugoniot.output.codec import decode, encode

leaves = st.none() | st.booleans() | st.integers(-(2**80), 2**80) | st.floats(allow_nan=False) | st.text(max_size=5)
payloads = st.dictionaries(st.text(min_size=1, max_size=4).filter(lambda key: key != "__array__"),
                           st.recursive(leaves, lambda inner: st.lists(inner, max_size=3), max_leaves=6), max_size=4)


@given(payloads)
def test_words_and_numbers_come_back(payload):
    assert decode(encode(payload)) == payload


def test_arrays_keep_bits_types_and_shapes():
    rng = np.random.default_rng(1)
    arrays = {"f": rng.standard_normal((3, 4)), "odd": np.array([np.nan, -0.0, np.inf, 5e-324]), "i": np.arange(5), "b": np.array([True, False]),
              "none": np.empty((0, 3)), "f4": np.float32([1.5]), "point": np.array(2.5)}
    back = decode(encode({"deep": {"er": arrays}, "list": [arrays["f"], 1]}))
    for name, array in arrays.items():
        other = back["deep"]["er"][name]
        assert np.asarray(other).dtype == array.dtype and np.asarray(other).tobytes() == array.tobytes(), name
    assert np.array_equal(back["list"][0], arrays["f"])


def test_same_payload_same_bytes():
    assert encode({"a": np.arange(3.0), "b": {"c": 1.5}}) == encode({"a": np.arange(3.0), "b": {"c": 1.5}})


def test_numpy_numbers_become_numbers_and_the_rest_is_refused():
    assert decode(encode({"x": np.float64(0.1), "n": np.int32(3)})) == {"x": 0.1, "n": 3}
    with pytest.raises(TypeError, match="cannot hold object"):
        encode({"x": object()})


def test_bytes_that_are_no_payload_are_refused():
    with pytest.raises(FileTrouble, match="cannot be read"):
        decode(b"not an HDF5 file")
