"""The module gives the kept bits of every motion that doubles decide, in wasmtime and in Chromium."""

import pytest

pytest.importorskip("wasmtime")

from bits_kernels import run_module, run_page
from bits_tools import differing, kept_scenarios, of_kinds
from hophoop.lab.wasm.stamp import HERE, MODULE
from module.host import Host

RIGID = ("rigid", "border", "paradox", "resisted", "massless", "doubt")


def test_the_module_gives_the_kept_bits_in_wasmtime():
    kept = of_kinds(kept_scenarios(), *RIGID)
    assert len(kept) > 900
    assert differing(run_module(Host(HERE / MODULE), kept)) == []


def test_the_page_gives_the_kept_bits_in_chromium(browser):
    kept = kept_scenarios(every=4)
    assert {each.kind for each in kept} == {*RIGID, "compliant"}
    assert differing(run_page(browser, kept)) == []
