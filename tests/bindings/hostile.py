# SPDX-License-Identifier: LGPL-2.1-or-later
"""What nobody should hand to the kernel, drawn by hypothesis, and what may come back."""

import math

import numpy as np
from hypothesis import strategies as st

from sheetmorph import _core

HUGE = 1.7e308
NUMBERS = [0.0, 1.0, -1.0, 0.5, 1e-300, 1e6, 1e30, 1e200]
NUMBERS += [HUGE, -HUGE, math.nan, math.inf, -math.inf]
INTEGERS = [
    0,
    1,
    2,
    3,
    5,
    8,
    -1,
    -7,
    10**6,
    2**31 - 1,
    -(2**31),
    2**31,
    2**32 + 1,
    -(2**63),
]
# Words of the standard library and of Eigen: an error that holds one was not written for people.
MACHINE_WORDS = ("vector::", "std::", "basic_string", "Eigen", "Assertion", "bad_", "_M_")

numbers = st.sampled_from(NUMBERS)
integers = st.sampled_from(INTEGERS)


@st.composite
def points(draw):
    """A few places: mostly (n, 3) float64, some with values or a form that no mesh has."""
    count = draw(st.integers(0, 9))
    values = np.array(draw(st.lists(st.integers(0, 4), min_size=3 * count, max_size=3 * count)))
    array = values.reshape(count, 3).astype(float)
    for _ in range(draw(st.integers(0, 2)) if count else 0):
        array[draw(st.integers(0, count - 1)), draw(st.integers(0, 2))] = draw(numbers)
    return draw(st.sampled_from(FORMS))(array)


def other_type(dtype):
    """The same values in another type, whatever that does to them."""

    def changed(array):
        with np.errstate(all="ignore"):
            return array.astype(dtype)

    return changed


def unchanged(array):
    return array


FORMS = [unchanged] * 8 + [
    np.asfortranarray,
    lambda array: array[::-1],
    lambda array: array[:, :2],
    lambda array: array.ravel(),
    lambda array: array[None],
    lambda array: array.tolist(),
    lambda array: None,
    other_type(np.float32),
    other_type(np.int64),
    other_type(complex),
    other_type(object),
]


@st.composite
def triangles(draw):
    """A few triples: corners may be doubled, negative, or not there at all."""
    count = draw(st.integers(0, 8))
    corner = st.one_of(st.integers(0, 3), st.integers(0, 8), st.integers(0, 8))
    values = draw(st.lists(corner, min_size=3 * count, max_size=3 * count))
    array = np.array(values, dtype=np.int64).reshape(count, 3)
    if count and draw(st.booleans()):
        array[draw(st.integers(0, count - 1)), draw(st.integers(0, 2))] = draw(integers)
    narrow = [other_type(np.int32)] * 4 if array.size == 0 or abs(array).max() < 2**31 else []
    return draw(st.sampled_from(FORMS + narrow))(array)


@st.composite
def ids(draw):
    """Vertex or triangle numbers, doubled and out of range; as a list or an array."""
    values = draw(st.lists(st.one_of(st.integers(0, 8), integers), max_size=6))
    form = draw(st.sampled_from(["list", "int64", "float", "text", "two rows", "nothing"]))
    if form == "list":
        return values
    if form == "text":
        return [str(value) for value in values]
    if form == "nothing":
        return None
    array = np.array(values, dtype=float if form == "float" else np.int64)
    return np.stack([array, array]) if form == "two rows" else array


vectors = st.one_of(
    st.lists(numbers, min_size=3, max_size=3),
    st.sampled_from([[], [1.0], "abc", None, np.zeros((3, 3)), ["x", "y", "z"]]),
)


@st.composite
def meshes(draw):
    """A mesh that its constructor took: unused and doubled vertices, doubled and flat triangles."""
    count = draw(st.integers(0, 9))
    places = draw(st.lists(st.integers(0, 3), min_size=3 * count, max_size=3 * count))
    corners = draw(st.lists(st.integers(0, max(count - 1, 0)), max_size=24)) if count else []
    used = len(corners) // 3 * 3
    return _core.TriangleMesh(
        np.array(places, dtype=float).reshape(count, 3),
        np.array(corners[:used], dtype=np.int32).reshape(-1, 3),
    )


def assert_sound(call):
    """The finite answer of a call, or None where it refused in words; anything else fails."""
    try:
        result = call()
    except (ValueError, RuntimeError, TypeError) as error:
        text = str(error)
        assert text.strip() and not any(word in text for word in MACHINE_WORDS), text
        return None
    assert_finite(result)
    return result


def assert_finite(value, depth=0):
    """Every number that can be read from an answer is one."""
    if isinstance(value, float):
        assert math.isfinite(value)
    elif isinstance(value, np.ndarray):
        assert np.isfinite(value).all()
    elif isinstance(value, (list, tuple)):
        for item in value:
            assert_finite(item, depth + 1)
    elif type(value).__module__ == "sheetmorph._core" and depth < 4:
        for name in dir(type(value)):
            # NaN is the documented thickness of a wall.
            if isinstance(getattr(type(value), name), property) and name != "thicknesses":
                assert_finite(getattr(value, name), depth + 1)
