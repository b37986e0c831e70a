"""Scenario files that nobody means well with: the scenario, or one sentence, at once."""

import io
import sys
import time

import pytest

import hophoop as hh
from damage import REFUSED, SAME, tally
from strategies import said

TOML = b'duration = 3.0\n[plane]\nmu = 0.5\nimpact_law = "newton"\n'
JSON = b'{"duration": 3.0,\n"plane": {"mu": 0.5, "impact_law": "newton"}}\n'
ONE = hh.Scenario(duration=3.0, plane=hh.Plane(mu=0.5, impact_law="newton"))


@pytest.fixture(autouse=True)
def limit_of_digits():
    """Python's own limit; mpmath 1.4 lifts it for good where it is given what is no number."""
    sys.set_int_max_str_digits(sys.int_info.default_max_str_digits)


def refusal(path):
    began = time.monotonic()
    text = said(lambda: hh.Scenario.load(path))
    assert time.monotonic() - began < 5.0
    assert text.isprintable()
    assert len(text) < 400
    return text


def written(folder, ending, content):
    path = folder / f"hop.{ending}"
    path.write_bytes(content)
    return path


@pytest.mark.parametrize(("ending", "text"), [("toml", TOML), ("json", JSON), ("txt", TOML), ("txt", JSON)])
def test_byte_order_marks_and_line_ends_say_nothing(tmp_path, monkeypatch, ending, text):
    for content in (text, b"\xef\xbb\xbf" + text.replace(b"\n", b"\r\n"), text.replace(b"\n", b"\r")):
        assert hh.Scenario.load(written(tmp_path, ending, content)) == ONE
        monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(content), encoding="ascii"))
        assert hh.Scenario.load("-") == ONE


@pytest.mark.parametrize(
    ("ending", "content", "expected"),
    [
        ("toml", TOML.replace(b"3.0", b"3.\x000"), "is not valid TOML: "),
        ("json", JSON.replace(b"3.0", b"3.\x000"), "is not valid JSON: "),
        ("json", JSON.replace(b"newton", b"new\\u0000ton"), r"plane.impact_law = 'new\x00ton' must be"),
        ("toml", TOML.replace(b"newton", b"\xff\xfe"), "is not a text file in UTF-8."),
        ("json", JSON.decode().encode("utf-16"), "is not a text file in UTF-8."),
        ("toml", TOML + b"mu = 0.6\n", "is not valid TOML: "),
        ("json", b'{"plane": {"mu": 1, "mu": 2}}', "The key 'mu' is given twice."),
        ("json", b'{"a\\nb": 1}', r"a\nb is not a known key; known are duration, "),
        ("json", b'{"plane": {"\\ud800": 1}}', r"plane.\ud800 is not a known key; "),
        ("json", b'{"plane": {"impact_law": "\\ud800"}}', "plane.impact_law = '\\ud800': "),
        ("json", b'{"' + b"k" * 100_000 + b'": 1}', "kkk... is not a known key; "),
        ("toml", b"duration = " + b"9" * 5000, "is not valid TOML: a number has too many digits."),
        ("json", b'{"duration": ' + b"9" * 5000 + b"}", "is not valid JSON: a number has too many digits."),
        ("toml", b"duration = " + b"9" * 400, "999... must be a finite number."),
        ("toml", b"duration = 0x" + b"f" * 5000, "duration = (a number of too many digits) must be a finite number."),
        ("json", b"[" + b"1," * 400_000 + b"1]", "must hold a table of keys, not a list."),
        ("json", b"[" * 200_000 + b"]" * 200_000, "is not valid JSON: nested too deeply."),
        ("toml", b"a = " + b"[" * 200_000 + b"]" * 200_000, "is not valid TOML: nested too deeply."),
        ("toml", b"a" + b".a" * 400_000 + b" = 1", "is not valid TOML: nested too deeply."),
        ("toml", b"[a" + b' . "a"' * 20_000 + b"]\nb = 1", "is not valid TOML: nested too deeply."),
        ("json", b"{" + b",".join(b'"%d":1' % k for k in range(90_000)) + b',"89999":2}', "is given twice."),
        ("toml", b"k" * 900_000, "is not valid TOML: "),
        ("json", b'{"duration": ' + b" " * 50_000_000 + b"3.0}", "is longer than 1,000,000 bytes, which no scenario is."),
    ],
)  # fmt: skip
def test_a_hostile_file_is_refused_by_one_sentence(tmp_path, ending, content, expected):
    assert expected in refusal(written(tmp_path, ending, content))


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="needs /dev/zero")
def test_a_stream_without_end_is_refused():
    assert "is longer than 1,000,000 bytes" in refusal("/dev/zero")


def test_standard_input_is_read_as_bytes(monkeypatch):
    for content, expected in ((b"\xff", "standard input is not a text in UTF-8."), (b" " * 1_000_001, "is longer than")):
        monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(content), encoding="utf-8"))
        assert expected in refusal("-")
    monkeypatch.setattr(sys, "stdin", io.StringIO(TOML.decode()))  # as in a notebook, without bytes
    assert hh.Scenario.load("-") == ONE


@pytest.mark.parametrize("ending", ["toml", "json"])
def test_a_damaged_scenario_is_a_scenario_or_one_sentence(tmp_path, ending):
    # written by hand and meant to be changed, it has no checksum: what is read may be another
    ONE.save(tmp_path / f"hop.{ending}")
    came = tally(hh.Scenario.load, lambda _: True, tmp_path / f"hop.{ending}", tmp_path / f"damaged.{ending}", 300)
    assert set(came) <= {SAME, REFUSED}
    assert came[REFUSED] > 60
