"""Regions, events and curves by their ids, and as tables."""

import copy
import dataclasses
import json
import pickle

import numpy as np
import pytest

import bifdiag


def test_records_have_names_and_places(atlas):
    assert atlas.regions["R5"] is atlas.regions[4] and atlas.curves["G1.2"].id == "G1.2"
    assert atlas.regions[-1].id == "R9" and atlas.regions[1:3] == (atlas.regions[1], atlas.regions[2])
    assert atlas.regions.ids == tuple(f"R{n}" for n in range(1, 10))
    assert "R5" in atlas.regions and "R12" not in atlas.regions and atlas.regions[3] in atlas.regions
    assert [*reversed(atlas.regions)] == [*atlas.regions][::-1]
    with pytest.raises(bifdiag.InputError, match="'R12'; the ids are R1, R2"):
        atlas.regions["R12"]
    with pytest.raises(bifdiag.InputError, match="no ids; take them by place"):
        atlas.stability_changes["cusp"]
    with pytest.raises(IndexError, match="no record 99 of 9"):
        atlas.regions[99]
    again = pickle.loads(pickle.dumps(atlas.regions))
    assert again == atlas.regions and again["R5"] == atlas.regions["R5"]


def test_a_list_is_printed_a_line_a_record(atlas):
    assert len(repr(atlas.regions).splitlines()) == 10 and max(map(len, repr(atlas.regions).splitlines())) < 60
    assert "<td>S2+T2</td>" in atlas.regions._repr_html_() and "5 events" in repr(atlas.events)
    assert "<svg" in atlas._repr_html_() and "9 regions" in atlas._repr_html_()


@pytest.mark.parametrize("name", ["regions", "events", "curves", "stability_changes"])
@pytest.mark.parametrize("body", ["paper", "euler"])
def test_lists_are_tables(name, body):
    pd, xr, pa = (pytest.importorskip(module) for module in ("pandas", "xarray", "pyarrow"))
    records = getattr(bifdiag.Body.preset(body).atlas(), name)
    frame = records.to_pandas()
    assert isinstance(frame, pd.DataFrame) and len(frame) == len(records) and frame.columns.tolist() == [*records.flat()]
    assert pa.table(records).num_rows == records.to_arrow().num_rows == len(records)
    assert isinstance(records.to_xarray(), xr.Dataset)


def test_tables_say_what_the_records_say(atlas):
    table = atlas.regions.flat()
    assert table["signature"].tolist() == [region.signature for region in atlas.regions]
    assert table["bounded"].dtype == bool and np.isinf(table["h_width"]).any()
    assert (atlas.region(table["h"], table["l"]) == np.arange(9)).all()
    curves = atlas.curves.flat()
    assert np.isnan(curves["index"][-1]) and "stable" in curves["verdict"][0]


def test_polars_reads_lists(atlas):
    pl = pytest.importorskip("polars")
    assert pl.DataFrame(atlas.regions)["signature"].to_list() == [region.signature for region in atlas.regions]
    assert pl.DataFrame(atlas.body.critical([1, 2])).height == len(atlas.body.critical([1, 2]))


def test_events_have_the_ids_of_the_command(atlas, command, tmp_path):
    assert atlas.events.ids == ("E1", "E2", "E3", "E4", "E5") and atlas.events["E2"] is atlas.events[1]
    told = command("--body=paper", cwd=tmp_path)
    for name, event in zip(atlas.events.ids, atlas.events, strict=True):
        (line,) = (line for line in told.splitlines() if line.split()[:1] == [name])
        assert event.kind in line and f"{event.l:.4g}"[:4] in line
        assert name in repr(atlas.events)
    assert atlas.events.flat()["id"].tolist() == list(atlas.events.ids)
    with pytest.raises(bifdiag.InputError, match="the ids are E1, E2"):
        atlas.events["cusp"]
    last = pickle.loads(pickle.dumps(atlas.events[3:]))
    assert last.ids == ("E4", "E5") and last["E5"] == atlas.events[4]


def test_slices_are_lists_too(atlas):
    some = atlas.regions[1:3]
    assert type(some) is type(atlas.regions) and some.ids == ("R2", "R3") and some["R3"] == atlas.regions[2]
    assert some.flat()["id"].tolist() == ["R2", "R3"] and len(atlas.curves[::2]) == -(-len(atlas.curves) // 2)


def test_lists_of_names_are_lists_in_arrow(atlas):
    pa, pl = pytest.importorskip("pyarrow"), pytest.importorskip("polars")
    table = pa.table(atlas.regions)
    assert table["boundary"].to_pylist() == [list(region.boundary) for region in atlas.regions]
    assert table["neighbours"].to_pylist()[0][0] == "forbidden"
    assert pl.DataFrame(atlas.events)["curves"].to_list() == [list(event.curves) for event in atlas.events]
    assert pa.table(atlas.curves)["coincides_with"].type == pa.list_(pa.string())
    empty = pa.table(atlas.events[:0])
    assert empty.num_rows == 0


def test_notebooks_show_every_table(atlas, paper):
    for table in (
        paper.orbit([0.6, 0, 0.8], omega=[1, 0.3, 1], t=3),
        atlas.classify([0, 3.8], 3.25),
        paper.periodic_orbits("2.6", "3.25"),
    ):
        shown = table._repr_html_()
        assert shown.startswith("<table><tr><th>") and shown.count("<tr>") <= 21
    assert "and 181 more rows" in paper.orbit([0.6, 0, 0.8], omega=[1, 0.3, 1], t=3)._repr_html_()
    assert "<td>R5</td>" in atlas.classify([0, 3.8], 3.25)._repr_html_()


def test_records_have_numbers_and_texts_only(atlas):
    for record in (atlas.regions[0], atlas.curves[0]):
        told = dataclasses.asdict(record)
        assert json.dumps(told) and not [name for name in told if name.startswith("_")]
        again = pickle.loads(pickle.dumps(record))
        assert again == record and copy.copy(record) == record
    assert again.points.tolist() == atlas.curves[0].points.tolist()
    region = pickle.loads(pickle.dumps(atlas.regions["R5"]))
    assert region.h_width == atlas.regions["R5"].h_width and len(region.polygon) == len(atlas.regions["R5"].polygon)


def test_lists_print_a_line_for_each(atlas):
    for found in (atlas.regions, atlas.events, atlas.curves, atlas.stability_changes):
        lines = repr(found).splitlines()
        assert len(lines) == 1 + len(found) and all(len(line) < 100 for line in lines)
    assert "G1.2: generic, l from 2.01143 to" in repr(atlas.curves)
