"""The module gives the kept bits of every motion that doubles decide, in Node and in Chromium."""

from bits_kernels import run_node, run_page
from bits_tools import differing, kept_scenarios
from module.module_tools import needs_node


@needs_node
def test_the_module_gives_the_kept_bits_in_node():
    kept = kept_scenarios()
    assert len(kept) > 900
    assert differing(run_node(kept)) == []


def test_the_page_gives_the_kept_bits_in_chromium(browser):
    kept = kept_scenarios(every=4)
    assert {"compliant", "massless"} < {each.kind for each in kept}
    assert differing(run_page(browser, kept)) == []
