"""Scans, searches and the check of atlases."""

import json

import pytest

import bifdiag


@pytest.mark.parametrize("suffix", ["csv", "jsonl", "parquet"])
def test_scans_write_the_command_lines_file(suffix, command, tmp_path):
    summary = bifdiag.scan(family="general", samples=300, out=tmp_path / f"ours.{suffix}", threads=2)
    command("scan", "--family", "general", "--samples", 300, "--out", tmp_path / f"theirs.{suffix}", "--json")
    assert (tmp_path / f"ours.{suffix}").read_bytes() == (tmp_path / f"theirs.{suffix}").read_bytes()
    assert isinstance(summary, dict)


def test_a_range_is_one_text_or_several(tmp_path, command):
    body = bifdiag.Body.preset("lagrange")
    told = [bifdiag.scan(body=body, vary=vary, out=tmp_path / "x.csv") for vary in ("A1=1:2:3", ["A1=1:2:3"])]
    assert told[0] == told[1] and told[0]["rows"] == 3


def test_wrong_scans_are_told(tmp_path):
    with pytest.raises(bifdiag.InputError, match=r"^--samples is missing"):
        bifdiag.scan(out=tmp_path / "x.csv")
    with pytest.raises(bifdiag.InputError, match=r"a range is written.*\d$"):
        bifdiag.scan(body=bifdiag.Body.preset("lagrange"), vary="A", out=tmp_path / "x.csv")
    with pytest.raises(bifdiag.InputError, match="family"):
        bifdiag.scan(family="nobody", samples=3, out=tmp_path / "x.csv")
    with pytest.raises(bifdiag.InputError, match="samples"):
        bifdiag.scan(samples=-3, out=tmp_path / "x.csv")


def test_what_is_found_shows_what_was_sought():
    witness = bifdiag.find("M4")
    assert witness and witness.body is not None
    found = witness.body.classify(witness.h, witness.l)
    assert found.components == witness.components and "M4" in found.signature
    assert "document" not in repr(witness) and witness.document["found"]
    assert bifdiag.find(signature="T2+S2", samples=2000, seed=3).found


def test_what_theorems_exclude_does_not_exist():
    witness = bifdiag.find("k0n1")
    assert not witness and witness.exists is False and witness.why


def test_wrong_searches_are_told():
    with pytest.raises(bifdiag.InputError, match="say what is sought"):
        bifdiag.find()
    with pytest.raises(bifdiag.InputError, match="X7"):
        bifdiag.find("X7")


def test_atlases_without_certificate_are_not_confirmed(atlas, tmp_path):
    with pytest.raises(bifdiag.VerifyError, match="certificate"):
        bifdiag.verify(atlas)
    with pytest.raises(bifdiag.InputError):
        bifdiag.verify({})
    (tmp_path / "atlas.json").write_text("[]")
    with pytest.raises(bifdiag.InputError):
        bifdiag.verify(tmp_path / "atlas.json")


def test_the_command_line_is_in_the_package(command):
    assert "bifdiag" in command("--version")
    assert json.loads(command("classify", "--body", "paper", "--h", 3.8, "--l", 3.25, "--json"))["status"] == "regular"
    assert "--A" in command("classify", "--A", "1,2", "--r", "1,0,0", "--h", 1, "--l", 1, status=2)
