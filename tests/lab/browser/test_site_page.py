"""The exported lab, served by Python's plain web server: everything is computed in the browser, also without a network."""

import time

import pytest

from browser_tools import served
from hophoop.lab import export as site
from lab_page_tools import PATIENCE, until

TAG = """<!doctype html><html lang="en"><meta charset="utf-8"><title>Blog</title><link rel="icon" href="data:,"><h1>Blog</h1>
%s<hophoop-motion %s></hophoop-motion><script type="module" src="static/hophoop-motion.js"></script>"""
ELEMENT = "document.querySelector('hophoop-motion')"


@pytest.fixture(scope="module")
def address(site_address):
    return site_address


@pytest.fixture
def tagged(visit, site_folder):
    """A page of somebody else with the tag; `before`: what stands above it."""

    def tagged(attributes, before="", **options):
        (site_folder / "blog.html").write_text(TAG % (before, attributes), encoding="utf-8")
        return visit("blog.html", **options)

    return tagged


def test_it_opens_without_a_network_after_the_first_visit(visit, address):
    page = visit(own=True)
    page.evaluate("navigator.serviceWorker.ready.then(() => true)")
    page.wait_for_function("() => navigator.serviceWorker.controller !== null")
    page.context.set_offline(True)
    page.goto(f"{address}?plane.mu=0.5&start.speed=2.8")
    page.wait_for_selector("[data-ready]")
    assert page.evaluate("hophoopLab.film().scenario.plane.mu") == 0.5


@pytest.fixture
def hosted(tmp_path, new_page):
    """A folder, a page and an address, as static hosts serve it: browsers may keep files for ten minutes."""
    page = new_page()
    page.set_default_timeout(PATIENCE)
    with served(tmp_path, 600) as address:
        yield tmp_path, page, address


def open_kept(page, address):
    """Open a lab, and wait until the browser keeps its files."""
    page.goto(address)
    page.wait_for_selector("[data-ready]")
    page.evaluate("navigator.serviceWorker.ready.then(() => true)")
    page.wait_for_function("() => navigator.serviceWorker.controller?.state === 'activated'")


@pytest.mark.long
def test_a_hosted_page_is_replaced_by_its_new_version(hosted):
    folder, page, address = hosted
    site.export(folder)
    open_kept(page, address)
    before = page.evaluate("caches.keys()")
    time.sleep(1.1)  # servers compare whole seconds
    site.export(folder, docs="https://example.org/new/")
    page.goto(address)  # still the old one, while the new one comes
    until(page, lambda: (names := page.evaluate("caches.keys()")) != before and len(names) == 1)
    page.reload()
    page.wait_for_selector("[data-ready]")
    assert page.locator("meta[name=hophoop-docs]").get_attribute("content") == "https://example.org/new/"


@pytest.mark.long
def test_two_labs_of_one_address_keep_their_own_files(hosted):
    folder, page, address = hosted
    places = ("", "one/", "other/")
    for place in places:
        site.export(folder / place, docs=f"https://example.org/{place}")
        open_kept(page, address + place)
    page.context.set_offline(True)
    for place in places:
        page.goto(f"{address}{place}?start.speed=2")
        page.wait_for_selector("[data-ready]")
        assert page.locator("meta[name=hophoop-docs]").get_attribute("content") == f"https://example.org/{place}"


def test_one_tag_and_one_script_show_a_hoop(tagged):
    page = tagged('scenario="start.speed=2.8" panels="theory"')
    assert page.evaluate(f"{ELEMENT}.lab.film().scenario.start.speed") == 2.8
    page.evaluate(f"{ELEMENT}.setAttribute('scenario', 'start.speed=3.1')")
    page.wait_for_function(f"() => {ELEMENT}.lab.film().sequence.includes('H')")
    assert page.evaluate(f"{ELEMENT}.shadowRoot.querySelector('canvas').width") > 100
    page.get_by_role("button", name="Arrows").click()
    page.wait_for_function(f"() => {ELEMENT}.lab.extras.more.changes")
    assert "The hop: " in page.locator(".more-said").inner_text()


def test_a_hoop_in_another_page_says_what_is_wrong_in_the_visitors_language(tagged):
    page = tagged('scenario="plane.mu=-1" panels="controls"', ready=False, locale="de-DE")
    sentence = "plane.mu = -1 muss von 0 bis 1e+6 oder unendlich sein."
    page.wait_for_function(f"() => {ELEMENT}.root?.innerText === '{sentence}'")
    page.evaluate(f"{ELEMENT}.setAttribute('scenario', 'plane.mu=0.4')")
    page.wait_for_function(f"() => {ELEMENT}.lab?.film()")
    page.evaluate(f"{ELEMENT}.setAttribute('scenario', 'plane.mu=-2')")
    message = page.locator("hophoop-motion .message")
    message.wait_for()
    assert page.evaluate(f"{ELEMENT}.lab.film().scenario.plane.mu") == 0.4  # the last that was right
    assert message.inner_text() == sentence.replace("-1", "-2")
    page.evaluate(f"{ELEMENT}.setAttribute('scenario', 'plane.mu=0.5')")
    message.wait_for(state="hidden")


def test_in_a_text_it_starts_where_a_reader_comes_near_and_shows_the_player_alone(tagged):
    page = tagged('loading="lazy" panels="player"', before='<p style="height: 300vh">Text</p>', ready=False)
    page.wait_for_function("() => customElements.get('hophoop-motion')")
    page.wait_for_timeout(300)
    asked = page.evaluate("performance.getEntriesByType('resource').map((entry) => entry.name)")
    assert not any(url.endswith((".wasm", "lab.js")) for url in asked)
    page.locator("hophoop-motion").scroll_into_view_if_needed()
    page.wait_for_function(f"() => {ELEMENT}.lab?.film()")
    shown = {name: page.locator(f"hophoop-motion {name}").is_visible() for name in (".stage", ".play", ".top", ".words")}
    assert shown == {".stage": True, ".play": True, ".top": False, ".words": False}


def test_the_embed_page_makes_the_tag_and_the_code_in_the_visitors_language(visit, address):
    page = visit("embed.html?plane.mu=0.5", locale="de-DE")
    assert page.title() == page.locator("#title").inner_text() == "Einen hüpfenden Reifen in die eigene Seite setzen"
    tag = page.locator("#tag").input_value()
    assert '<hophoop-motion scenario="plane.mu=0.5"' in tag
    assert f'src="{address}static/hophoop-motion.js"' in tag
    assert 'title="Ein hüpfender Reifen"' in page.locator("#frame").input_value()
    assert page.locator("#code svg path").count() == 2
    assert page.locator("#link").get_attribute("href") == f"{address}?plane.mu=0.5"
    page.fill("#scenario", f"{address}?start.speed=2.5#t=1")
    page.locator("#scenario").press("Tab")
    page.locator("#language select").select_option("zh")
    page.wait_for_function("() => document.documentElement.lang === 'zh'")
    assert page.locator("#title").inner_text() == "把会跳的圆环放进你的网页"
    assert 'scenario="start.speed=2.5"' in page.locator("#tag").input_value()  # the motion stays
    page.wait_for_function(f"() => {ELEMENT}?.lab?.film()")


def test_a_host_that_forbids_webassembly_is_named(new_page, address):
    page = new_page()
    forbidding = {"Content-Security-Policy": "script-src 'self'"}
    page.route(address, lambda route: route.fulfill(response=(reply := route.fetch()), headers=reply.headers | forbidding))
    page.goto(address)
    page.get_by_text("Content-Security-Policy needs 'wasm-unsafe-eval' in script-src").wait_for(timeout=PATIENCE)


def test_the_folder_may_stand_anywhere_and_leads_to_the_documentation_beside_it(visit, site_folder):
    site.export(site_folder / "courses" / "play", docs="../")
    (site_folder / "courses" / "teach").mkdir()
    worksheet = '<link rel="icon" href="data:,"><title>Worksheet</title>'
    (site_folder / "courses" / "teach" / "worksheet.html").write_text(worksheet, encoding="utf-8")
    page = visit("courses/play/?start.speed=2")
    assert page.evaluate("hophoopLab.film().sequence") == "R"
    page.evaluate("hophoopLab.extras.teach.showModal()")
    page.get_by_role("link", name="Worksheet").click()
    page.wait_for_url("**/teach/worksheet.html")
    assert page.title() == "Worksheet"


def test_a_page_opened_as_a_file_says_what_to_do(site_folder, new_page):
    page = new_page()
    page.goto((site_folder / "index.html").resolve().as_uri())
    words = page.get_by_text("hophoop lab --export play.html")
    words.wait_for(state="attached")
    assert not words.is_visible()  # most pages are there before it is
    page.evaluate("for (const one of document.getAnimations()) one.finish()")
    assert words.is_visible()
