"""Real parts keep every digit, and say the same as the command line."""

import json
import pickle
from fractions import Fraction

import numpy as np
import pytest

import bifdiag

TENSOR = [["2.1", "0.3", "-0.1"], ["0.3", "1.8", "0.2"], ["-0.1", "0.2", "1.2"]]
OPTIONS = ["--products=tensor", "--units=kg,mm,s", "--g=9.81"]

TETRAHEDRON = """v 0 0 0
v 3 0 0
v 0 2 0
v 0 0 1
f 1 3 2
f 1 2 4
f 1 4 3
f 2 3 4
"""

LINK = """<robot name="top"><link name="body"><inertial><origin xyz="0 0 0.1"/><mass value="2"/>
<inertia ixx="0.02" iyy="0.03" izz="0.04" ixy="0" ixz="0" iyz="0"/></inertial></link></robot>"""


def test_a_part_is_told_so_that_it_can_be_read():
    part = bifdiag.Body.from_inertia(TENSOR, [0, "0.1", "0.2"], "0.5", units="kg,mm,s")
    assert len(part.A[0]) > 100 and len(repr(part)) < 200 and "kg,mm,s" in repr(part)
    assert all(repr(moment) in repr(part) for moment in part.part["principal"]["moments"])
    assert "kg,mm,s" in part._repr_html_() and part.A[0] not in part._repr_html_()


def test_a_tensor_about_either_point_is_the_command_lines(command):
    for about, option in (("centre of mass", "--inertia-com"), ("fixed point", "--inertia")):
        part = bifdiag.Body.from_inertia(TENSOR, [0, "0.1", "0.2"], "0.5", "9.81", about, units="kg,mm,s")
        line = ["--json", f"{option}=2.1,1.8,1.2,0.3,-0.1,0.2", "--com=0,0.1,0.2", "--mass=0.5", *OPTIONS]
        assert part.atlas().to_json() == command(*line)
        assert part.critical(1).size == len(json.loads(command("critical", *line, "--l=1"))["critical"])


def part_of(document: str) -> dict:
    """What `bifdiag body --json` says of a part, without the head of every document."""
    part = json.loads(document)
    for field in ("schema_version", "version", "command"):
        del part[field]
    return part


def test_meshes_and_inertial_blocks_are_the_command_lines(command, tmp_path):
    mesh, link = tmp_path / "part.obj", tmp_path / "top.urdf"
    mesh.write_text(TETRAHEDRON)
    link.write_text(LINK)
    body = bifdiag.Body.from_part(mesh, density="0.5", pivot=[0, 0, -1], units="g,mm,s")
    line = ["body", "--json", f"--part={mesh}", "--density=0.5", "--pivot=0,0,-1", "--units=g,mm,s"]
    assert body.part == part_of(command(*line))
    body = bifdiag.Body.from_part(link, link="body", units="kg,mm,s")
    assert body.part == part_of(command("body", "--json", f"--part={link}", "--units=kg,mm,s"))


def test_a_part_is_pickled_saved_and_loaded_with_every_digit(tmp_path):
    third = Fraction(1, 3)
    part = bifdiag.Body.from_inertia([[2, third, 0], [third, 2, 0], [0, 0, 1]], [0, 0, third], 1)
    assert part.part["exact"] and part.part["inertia"][0][1] == "1/3"
    again = pickle.loads(pickle.dumps(part))
    assert again == part and again.part == part.part and hash(again) == hash(part)
    part.atlas().save(tmp_path / "atlas.json")
    assert bifdiag.Atlas.load(tmp_path / "atlas.json").body == part
    assert bifdiag.Body(part.A, part.r) != part and bifdiag.Body(part.A, part.r).part is None


@pytest.mark.parametrize(
    ("change", "error", "words"),
    [
        ({"tensor": [[1, 0, 0], [0, 1, 0], [0, 0, 3]]}, bifdiag.BodyError, "cannot exist"),
        ({"tensor": [[1, 0.1, 0], [0.2, 1, 0], [0, 0, 1]]}, bifdiag.InputError, "1,2 is 0.1, entry 2,1 is 0.2"),
        ({"tensor": [[1, 0, 0], [0, 1, 0]]}, bifdiag.InputError, "three rows, 2 given"),
        ({"mass": 0}, bifdiag.BodyError, "not positive"),
        ({"mass": float("nan")}, bifdiag.InputError, "mass"),
        ({"units": "kg,mm"}, bifdiag.InputError, "2 units given"),
        ({"about": "pivot"}, bifdiag.InputError, "centre of mass"),
    ],
)
def test_what_is_no_part_is_told(change, error, words):
    given = {"tensor": [[2, 0, 0], [0, 2, 0], [0, 0, 1]], "com": [0, 0, 1], "mass": 1, "about": "centre of mass"}
    with pytest.raises(error, match=words):
        bifdiag.Body.from_inertia(**{**given, **change})


def test_a_file_that_gives_no_part_is_told(tmp_path):
    mesh = tmp_path / "part.obj"
    mesh.write_text(TETRAHEDRON)
    with pytest.raises(bifdiag.InputError, match="density"):
        bifdiag.Body.from_part(mesh)
    mesh.write_text(TETRAHEDRON.replace("f 2 3 4\n", ""))
    with pytest.raises(bifdiag.InputError, match="open"):
        bifdiag.Body.from_part(mesh, mass=1)
    with pytest.raises(FileNotFoundError, match="nothing"):
        bifdiag.Body.from_part(tmp_path / "nothing.stl", mass=1)
    with pytest.raises(bifdiag.BodyError, match="cannot exist"):
        bifdiag.Body.from_inertia([[1, 0, 0], [0, 1, 0], [0, 0, 3]], [0, 0, 1], 1, about="centre of mass")
    assert bifdiag.Body.from_inertia([[1, 0, 0], [0, 1, 0], [0, 0, 3]], [0, 0, 0.1], 1, unphysical=True).part


def test_parts_have_floats_beside_their_texts():
    part = bifdiag.Body.from_inertia(TENSOR, [0, "0.1", "0.2"], "0.5", "9.81", "centre of mass", units="kg,mm,s")
    assert part.moments.tolist() == [float(Fraction(text)) for text in part.exact.A] == [*map(float, part.moments)]
    # m g com in the part's units: 9810 mm/s².
    assert np.allclose(part.weight, 0.5 * 9810) and np.allclose(
        part.weight * part.com, [float(Fraction(t)) for t in part.r]
    )
    axes = np.array(part.part["principal"]["axes"], dtype=float)
    assert np.allclose(axes @ [0, 0.1, 0.2], part.com)
    assert part.units == bifdiag.Units("kg,mm,s", 1.0, 1e-3, 1.0) and part.units.energy == 1e-6
    assert pickle.loads(pickle.dumps(part.units)) == part.units


def test_numbers_may_carry_their_units():
    one = bifdiag.Body.from_inertia([["240000 kg mm2", 0, 0], [0, 0.24, 0], [0, 0, 0.17]], [0, 0, "8 cm"], "2000 g", 9.81)
    other = bifdiag.Body.from_inertia([[0.24, 0, 0], [0, 0.24, 0], [0, 0, 0.17]], [0, 0, 0.08], 2, 9.81)
    assert one == other and not one.measured
    with pytest.raises(bifdiag.InputError, match="unit of something else"):
        bifdiag.Body.from_inertia([[2, 0, 0], [0, 2, 0], [0, 0, 1]], [0, 0, "1 kg"], 1)


def test_tolerances_are_the_command_lines(command, tmp_path):
    tensor = [["0.24±1%", "0.001±0.0005", 0], ["0.001", "0.25", 0], [0, 0, "0.17+-0.002"]]
    part = bifdiag.Body.from_inertia(tensor, [0, 0, "80±0.5 mm"], "2±0.01 kg", "9.81", "centre of mass")
    line = ["--inertia-com=0.24±1%,0.25,0.17+-0.002,0.001±0.0005,0,0", "--products=tensor", "--com=0,0,80±0.5 mm"]
    line += ["--mass=2±0.01 kg", "--g=9.81", "--units=kg,m,s"]
    assert part.measured and part.critical_spin("z").meta == json.loads(
        command("critical-spin", "--json", *line, "--axis=z")
    )
    mesh = tmp_path / "part.obj"
    mesh.write_text(TETRAHEDRON)
    body = bifdiag.Body.from_part(mesh, density="0.5±1%", pivot=[0, 0, "-1±0.01"], g="9.81±0.01", units="g,mm,s")
    line = [f"--part={mesh}", "--density=0.5±1%", "--pivot=0,0,-1±0.01", "--g=9.81±0.01", "--units=g,mm,s"]
    assert body.critical_spin("x").meta == json.loads(command("critical-spin", "--json", *line, "--axis=x"))
    for measured in (part, body):
        again = pickle.loads(pickle.dumps(measured))
        assert again == measured and again.measured and hash(again) == hash(measured)
        assert "±" in repr(measured)
    plain = bifdiag.Body.from_part(mesh, density="0.5", pivot=[0, 0, -1], g="9.81", units="g,mm,s")
    assert plain != body and plain.part == body.part and not plain.measured
    assert plain.critical_spin("x", tolerance="1%").meta["tolerance"]


def test_a_part_with_tolerances_has_no_single_diagram():
    part = bifdiag.Body.from_inertia([["2±1%", 0, 0], [0, 2, 0], [0, 0, 1]], [0, 0, 0.1], 1)
    for ask in (part.atlas, lambda: part.classify(1, 1), lambda: part.critical(1), lambda: part.section(1, 1)):
        with pytest.raises(bifdiag.InputError, match="only critical_spin answers"):
            ask()
    with pytest.raises(bifdiag.InputError, match="negative"):
        bifdiag.Body.from_inertia([["2±-1", 0, 0], [0, 2, 0], [0, 0, 1]], [0, 0, 0.1], 1)


def test_an_empty_entry_of_a_tensor_is_named():
    with pytest.raises(bifdiag.InputError, match=r"^tensor\[0\]2 is an empty text"):
        bifdiag.Body.from_inertia(np.diag(["2", "2", "1"]), com=[0, 0, 1], mass=1)
