"""Bodies are exact, whatever they are made from."""

import copy
import pickle
import pydoc
import re
import sys
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import bifdiag


@pytest.mark.parametrize(
    ("given", "text"),
    [
        (2, "2"),
        ("11/10", "11/10"),
        (" 1e-3", "1e-3"),
        (Fraction(1, 3), "1/3"),
        (Decimal("0.10"), "0.10"),
        (0.1, "0.1"),
        (1e22, "1e+22"),
        (np.float64(0.1), "0.1"),
        (np.float32(0.1), "0.1"),
        (np.int32(7), "7"),
        (np.array(0.3), "0.3"),
        (10**30, str(10**30)),
    ],
)
def test_numbers_are_taken_as_they_are_meant(given, text):
    assert bifdiag.Body([given, "1e30", "1e30"], [0, 1, 2]).A[0] == text


@pytest.mark.filterwarnings("ignore::bifdiag.BodyWarning")
@given(st.floats(1e-6, 1e6))
def test_a_float_is_its_shortest_decimal(value):
    body = bifdiag.Body([value, 1, 1], [0, 0, 1])
    assert float(body.A[0]) == value
    assert body == bifdiag.Body([Decimal(repr(value)), 1, 1], [0, 0, 1])


def test_equal_numbers_are_equal_bodies():
    first, second = bifdiag.Body([2, 1.1, 1], [1, 0, 0]), bifdiag.Body(["2.0", Fraction(11, 10), "1"], [1, 0, "0.0"])
    assert first == second and hash(first) == hash(second)
    assert first != bifdiag.Body([2, 1.1000001, 1], [1, 0, 0])
    assert first != "Body"


def test_the_repr_makes_the_body_known(paper):
    assert repr(paper) == "Body(A=[2, 11/10, 1], r=[0.94868, 0, 0.61623])"
    assert "11/10" in paper._repr_html_()


def test_bodies_are_pickled_and_copied(paper):
    assert pickle.loads(pickle.dumps(paper)) == paper == copy.deepcopy(paper)


@pytest.mark.parametrize(
    ("moments", "center", "error", "message"),
    [
        ([1, -1, 1], [1, 0, 0], bifdiag.BodyError, "A2"),
        ([1, 1], [1, 0, 0], bifdiag.InputError, "three"),
        ([1, float("nan"), 1], [1, 0, 0], bifdiag.InputError, "A2 = nan"),
        ([1, 1, 1], [1, 0, float("inf")], bifdiag.InputError, "r3 = inf"),
        ([True, 1, 1], [1, 0, 0], bifdiag.InputError, "bool"),
        ([1, 1, None], [1, 0, 0], bifdiag.InputError, "A3 = None is a NoneType"),
        ([1, 1, 1j], [1, 0, 0], bifdiag.InputError, "complex"),
        (["x", 1, 1], [1, 0, 0], ValueError, "`x` is not a number"),
        ("2,1,1", [1, 0, 0], bifdiag.InputError, "three numbers"),
        (5, [1, 0, 0], bifdiag.InputError, "three numbers"),
        ({2, 1, 3}, [1, 0, 0], bifdiag.InputError, "three numbers"),
        ([[1, 2], 1, 1], [1, 0, 0], bifdiag.InputError, "list"),
    ],
)
def test_wrong_bodies_are_told(moments, center, error, message):
    with pytest.raises(error, match=message):
        bifdiag.Body(moments, center)


def test_unknown_presets_name_the_known_ones():
    with pytest.raises(bifdiag.InputError, match="paper"):
        bifdiag.Body.preset("nothing")


def test_the_documentation_names_all_presets():
    with pytest.raises(bifdiag.InputError) as refused:
        bifdiag.Body.preset("nothing")
    names = str(refused.value).partition("named bodies are ")[2].split(", ")
    assert len(names) > 10
    for name in names:
        family, _, number = name.partition(":")
        assert f'``"{name}"``' in bifdiag.Body.preset.__doc__ or (family == "katok" and 1 < int(number) < 7)


def test_errors_have_their_bases():
    assert issubclass(bifdiag.BodyError, bifdiag.InputError)
    assert issubclass(bifdiag.InputError, ValueError)
    assert issubclass(bifdiag.RangeError, ArithmeticError)
    for error in (bifdiag.InputError, bifdiag.RangeError, bifdiag.VerifyError):
        assert issubclass(error, bifdiag.BifdiagError)


def test_bodies_that_cannot_exist_are_told():
    with pytest.warns(bifdiag.BodyWarning, match="no mass distribution"):
        body = bifdiag.Body([5, 1.2, 0.9], [0, 0, 1])
    assert not body.physical and bifdiag.Body([2, 1, 1], [0, 0, 1]).physical
    # Whoever has been told is not told again.
    again = pickle.loads(pickle.dumps(body))
    assert again == body and not again.physical
    part = bifdiag.Body.from_inertia([[1, 0, 0], [0, 1, 0], [0, 0, 3]], [0, 0, 0.1], 1, unphysical=True)
    assert not part.physical and not part.part["physical"]


def test_help_is_short_and_has_no_inner_workings():
    for name in bifdiag.__all__:
        if isinstance(found := getattr(bifdiag, name), type):
            inner = [word for word in vars(found) if word in ("of", "all_of", "compute")]
            assert not inner


def test_bodies_have_floats_beside_their_texts(paper):
    assert paper.moments.tolist() == [2, 1.1, 1] and paper.com.tolist() == [0.94868, 0, 0.61623]
    assert paper.exact == (("2", "11/10", "1"), ("0.94868", "0", "0.61623")) and paper.exact.A == paper.A
    assert paper.weight == 1 and paper.units is None and not paper.measured


def test_all_presets_are_at_hand():
    bodies = bifdiag.bodies()
    assert bodies["paper"] == bifdiag.Body.preset("paper") and len(bodies) >= 16


# Without its cache mypy takes 17 s of CPU time, and at a load of nine two minutes.
@pytest.mark.timeout(600)
def test_type_checkers_find_typing_errors(tmp_path):
    api = pytest.importorskip("mypy.api")
    code = tmp_path / "code.py"
    wrong = [
        'body.atlas("exakt")',
        "body.section(3.8, 3.25).gama",
        'body.section(3.8, 3.25, condition="hight")',
        "body.critical(1).stabel",
        'body.atlas().region([1], 1, invalid="drop")',
        "body.orbit([0, 0, 1], [0, 0, 1]).omga",
        'body.atlas().regions["R5"].signatur',
        'bifdiag.scan(family="generic")',
        'bifdiag.scan(samples=3, invalid="drop")',
        'body.critical_spin("z").rmp',
        "body.critical_spin().ranges.stabel",
        "body.atlas().region([1], 1).shap",
        "body.atlas().classify([1], 1).marginn",
        'body.atlas().plot(view="strait")',
    ]
    right = ["n: int = body.atlas().region(3.8, 3.25)", "x = body.critical([1, 2]).to_pandas()", "y = body.moments + 1"]
    code.write_text("\n".join(["import bifdiag", 'body = bifdiag.Body.preset("paper")', *right, *wrong]))
    told, _, status = api.run([str(code), "--cache-dir", str(tmp_path), "--ignore-missing-imports"])
    lines = {int(line.split(":")[1]) for line in told.splitlines() if ": error:" in line}
    assert status == 1 and lines == set(range(3 + len(right), 3 + len(right) + len(wrong))), told


def test_help_has_two_screens_with_a_line_for_each_question():
    told = pydoc.plain(pydoc.render_doc(bifdiag.Body))
    lines = told.splitlines()
    # Of fifty lines, or of sixty where signatures have a line for each argument; it had 414.
    assert len(lines) <= 2 * (50 if sys.version_info < (3, 13) else 60)
    body = bifdiag.Body.preset("paper")
    names = [name for name in dir(body) if not name.startswith("_")]
    assert {"section", "moments", "from_part"} < set(names) and all(
        re.search(rf"\b{name}\b", "\n".join(lines[:50])) for name in names
    )
    assert max(map(len, lines)) < 330 and not [line for line in lines if re.match(r" \|  _(?!_)", line)]
    # What the class does not list is there, with its own help.
    assert "Parameters" in pydoc.plain(pydoc.render_doc(bifdiag.Body.section))
    assert "from_part" in dir(bifdiag.Body) and "preset" in dir(bifdiag.Body)

    class Mine(bifdiag.Body):
        def spin(self):
            """My own question."""

    assert "My own question" in pydoc.plain(pydoc.render_doc(Mine))


def test_what_is_masked_is_no_number():
    masked = np.ma.masked
    body = bifdiag.Body([2, 1.1, 1], [0.6, 0, 0.8])
    for asked in (
        lambda: bifdiag.Body([2, 1.1, 1], [1, masked, 0]),
        lambda: bifdiag.Body(np.ma.array([2, 1.1, 1], mask=[0, 1, 0]), [1, 0, 0]),
        lambda: body.classify(masked, 1),
        lambda: body.section(masked, 1),
        lambda: body.critical_spin([masked, 0, 1]),
        lambda: body.orbit(gamma=np.ma.array([0.0, 1.0, 1.0], mask=[0, 1, 0]), omega=[0, 0, 1]),
    ):
        with pytest.raises(bifdiag.InputError, match="masked"):
            asked()


def test_both_entries_of_a_product_have_one_tolerance():
    def body(above, below):
        return bifdiag.Body.from_inertia([[3, above, 0], [below, 2, 0], [0, 0, 1.5]], [0, 0, 0.1], 1, 10)

    assert body("0±0.02", "0±0.02").critical_spin("z").bounds is not None
    with pytest.raises(bifdiag.InputError, match=r"entry 1,2 is 0±0\.02, entry 2,1 is 0±0\.01"):
        body("0±0.02", "0±0.01")
