"""Relative equilibria as structured arrays."""

import json

import numpy as np
import pytest

import bifdiag


@pytest.mark.parametrize(("name", "l"), [("paper", "3.25"), ("lagrange", "1.9"), ("katok:3", "0"), ("euler", "1/3")])
def test_rows_say_what_the_command_line_says(name, l, command):
    found = bifdiag.Body.preset(name).critical(l)
    told = json.loads(command("critical", "--body", name, "--l", l, "--json"))["critical"]
    assert len(found) == len(told)
    for row, entry in zip(found, told, strict=True):
        assert (row["h"], row["omega"], row["index"]) == (entry["h"], entry["omega"], entry["index"])
        assert row["gamma"].tolist() == entry["gamma"]
        assert row["multiplicity"] == str(entry["multiplicity"])
        assert row["stability"] == entry["stability"]
        nonlinear = entry["nonlinear"]
        assert (row["verdict"], row["stable_by"]) == (nonlinear["verdict"], nonlinear["why"])
        assert row["stable"] == (nonlinear["verdict"] == "stable")
        assert row["survives_friction"] == (entry["friction"]["conserving_l"] == "survives")
        assert [[value.real, value.imag] for value in row["eigenvalues"]] == entry["eigenvalues"]
        assert (row["branch"], row["branch_name"]) == (entry["branch"], entry["branch_name"])


def test_many_momenta_are_one_array(paper):
    l = np.linspace(0.1, 5, 40).round(3).reshape(8, 5)
    found = paper.critical(l)
    assert np.array_equal(found["l"], l.ravel()[found["l_index"]])
    for place, momentum in enumerate(l.flat):
        rows = found[found["l_index"] == place]
        one = paper.critical(momentum)
        assert all(np.array_equal(rows[name], one[name]) for name in one.dtype.names)
    assert len(paper.critical([])) == 0


def test_wrong_momenta_are_told(paper):
    with pytest.raises(bifdiag.InputError, match="finite"):
        paper.critical([1, float("nan")])
    with pytest.raises(bifdiag.InputError, match="str"):
        paper.critical(None)
