"""The exported lab, served by Python's plain web server: everything is computed in the browser, also without a network."""

import functools
import hashlib
import http.server
import threading
from pathlib import Path

import pytest

import hophoop as hh
from hophoop.lab.site import export as site
from lab_page_tools import PATIENCE, wait_for


@pytest.fixture(scope="module")
def folder(site_folder):
    (site_folder / "blog.html").write_text(
        '<!doctype html><html lang="en"><meta charset="utf-8"><title>Blog</title><body><h1>My blog</h1>'
        '<script type="module" src="static/hophoop-motion.js"></script>'
        '<hophoop-motion scenario="start.speed=2.8" panels="controls"></hophoop-motion></body></html>',
        encoding="utf-8",
    )
    return site_folder


@pytest.fixture(scope="module")
def address(folder, site_address):
    return site_address


def test_the_hop_and_a_map_are_computed_in_the_browser(visit):
    page = visit()
    wait_for(page, "lab.theory.list.children.length > 4")
    assert page.evaluate("hophoopLab.backend.constructor.name !== ''")
    takeoff = page.evaluate("hophoopLab.film().events.find((event) => event.kind === 'takeoff').t")
    assert takeoff == pytest.approx(hh.simulate(hh.Scenario()).find("takeoff")[0].t, rel=1e-12)
    assert "hops at 315.6°" in page.locator(".summary").inner_text()
    # and a map, in workers
    page.locator(".map canvas").first.scroll_into_view_if_needed()
    wait_for(page, "lab.map.layers.length > 0")


def test_a_slider_a_link_and_a_compliant_contact(visit):
    page = visit("?start.speed=2")
    wait_for(page, "lab.film().sequence === 'R'")
    page.locator("input[data-path='start.speed']").fill("3.1")
    wait_for(page, "lab.film().sequence.includes('H')")
    page.evaluate("hophoopLab.motions.change([['contact.model', 'compliant']], true)")
    wait_for(page, "lab.film().scenario.contact.model === 'compliant' && lab.film().sequence.includes('H')")


def test_what_is_not_allowed_is_said(visit):
    page = visit()
    mass = page.get_by_label("Mass, exact value in kg", exact=True)
    mass.fill("-1")
    mass.press("Enter")
    page.wait_for_selector("text=must be", timeout=PATIENCE)


def test_it_opens_without_a_network_after_the_first_visit(browser, address):
    context = browser.new_context()
    page = context.new_page()
    page.goto(address)
    page.wait_for_selector("[data-ready]", timeout=PATIENCE)
    page.evaluate("navigator.serviceWorker.ready.then(() => true)")
    page.wait_for_function("() => navigator.serviceWorker.controller !== null", timeout=PATIENCE)
    context.set_offline(True)
    page.goto(f"{address}?plane.mu=0.5&start.speed=2.8")
    page.wait_for_selector("[data-ready]", timeout=PATIENCE)
    assert page.evaluate("hophoopLab.film().scenario.plane.mu") == 0.5
    context.close()


def test_one_tag_and_one_script_show_a_hoop(browser, address):
    context = browser.new_context()
    page = context.new_page()
    errors = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.goto(f"{address}blog.html")
    page.wait_for_function("() => document.querySelector('hophoop-motion').lab?.film()", timeout=PATIENCE)
    element = "document.querySelector('hophoop-motion')"
    assert page.evaluate(f"{element}.lab.film().scenario.start.speed") == 2.8
    page.evaluate(f"{element}.setAttribute('scenario', 'start.speed=3.1')")
    page.wait_for_function(f"() => {element}.lab.film().sequence.includes('H')", timeout=PATIENCE)
    assert page.evaluate(f"{element}.shadowRoot.querySelector('canvas').width") > 100
    assert errors == []
    context.close()


def test_a_hoop_in_another_page_says_what_is_wrong_in_the_visitors_language(browser, address, site_folder):
    (site_folder / "wrong.html").write_text(
        '<!doctype html><html lang="de"><meta charset="utf-8"><title>Wrong</title><link rel="icon" href="data:,">'
        '<script type="module" src="static/hophoop-motion.js"></script>'
        '<body><hophoop-motion scenario="plane.mu=-1" panels="controls"></hophoop-motion></body></html>',
        encoding="utf-8",
    )
    context = browser.new_context(locale="de-DE")
    page = context.new_page()
    errors = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.goto(f"{address}wrong.html")
    element = page.locator("hophoop-motion")
    sentence = "plane.mu = -1 muss mindestens 0 sein (inf ist erlaubt)."
    page.wait_for_function(f"() => document.querySelector('hophoop-motion').root?.innerText === '{sentence}'", timeout=PATIENCE)
    element.evaluate("element => element.setAttribute('scenario', 'plane.mu=0.4')")
    page.wait_for_function("() => document.querySelector('hophoop-motion').lab?.film()", timeout=PATIENCE)
    element.evaluate("element => element.setAttribute('scenario', 'plane.mu=-2')")
    page.locator("hophoop-motion .message").wait_for(timeout=PATIENCE)
    assert element.evaluate("element => element.lab.film().scenario.plane.mu") == 0.4  # the last that was right
    assert page.locator("hophoop-motion .message").inner_text() == sentence.replace("-1", "-2")
    element.evaluate("element => element.setAttribute('scenario', 'plane.mu=0.5')")
    page.locator("hophoop-motion .message").wait_for(state="hidden", timeout=PATIENCE)
    assert errors == []
    context.close()


LAZY = """<!doctype html><html lang="en"><meta charset="utf-8"><title>Notes</title><body><p style="height: 300vh">Text</p>
<hophoop-motion loading="lazy" panels="player" scenario="start.speed=3.1"></hophoop-motion>
<script type="module" src="static/hophoop-motion.js"></script>"""


def test_in_a_text_it_starts_where_a_reader_comes_near_and_shows_the_player_alone(browser, address, site_folder):
    (site_folder / "notes.html").write_text(LAZY, encoding="utf-8")
    context = browser.new_context()
    page = context.new_page()
    asked = []
    page.on("request", lambda request: asked.append(request.url))
    page.goto(f"{address}notes.html")
    page.wait_for_function("() => customElements.get('hophoop-motion')", timeout=PATIENCE)
    page.wait_for_timeout(300)
    assert not any(url.endswith((".wasm", "lab.js")) for url in asked)
    page.locator("hophoop-motion").scroll_into_view_if_needed()
    page.wait_for_function("() => document.querySelector('hophoop-motion').lab?.film()", timeout=PATIENCE)
    shown = {name: page.locator(f"hophoop-motion {name}").is_visible() for name in (".stage", ".play", ".top", ".words")}
    assert shown == {".stage": True, ".play": True, ".top": False, ".words": False}
    context.close()


def test_the_embed_page_makes_the_tag_and_the_code(browser, address):
    context = browser.new_context()
    page = context.new_page()
    page.goto(f"{address}embed.html?plane.mu=0.5")
    page.wait_for_function("() => document.querySelector('hophoop-motion')?.lab?.film()", timeout=PATIENCE)
    tag = page.locator("#tag").input_value()
    assert '<hophoop-motion scenario="plane.mu=0.5"' in tag
    assert f'src="{address}static/hophoop-motion.js"' in tag
    assert page.locator("#code svg path").count() == 2
    assert page.locator("#link").get_attribute("href") == f"{address}?plane.mu=0.5"
    page.fill("#scenario", f"{address}?start.speed=2.5#t=1")
    page.locator("#scenario").press("Tab")
    assert 'scenario="start.speed=2.5"' in page.locator("#tag").input_value()
    context.close()


def test_the_embed_page_speaks_the_visitors_language(browser, address):
    context = browser.new_context(locale="de-DE")
    page = context.new_page()
    errors = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.goto(f"{address}embed.html?plane.mu=0.5")
    page.wait_for_function("() => document.querySelector('hophoop-motion')?.lab?.film()", timeout=PATIENCE)
    assert page.title() == page.locator("#title").inner_text() == "Einen hüpfenden Reifen in die eigene Seite setzen"
    assert page.evaluate("document.documentElement.lang") == "de"
    assert 'title="Ein hüpfender Reifen"' in page.locator("#frame").input_value()
    page.locator("#language select").select_option("zh")
    page.wait_for_function("() => document.documentElement.lang === 'zh'")
    assert page.locator("#title").inner_text() == "把会跳的圆环放进你的网页"
    assert "plane.mu=0.5" in page.locator("#tag").input_value()  # the motion stays
    page.wait_for_function("() => document.querySelector('hophoop-motion')?.lab?.film()", timeout=PATIENCE)
    assert errors == []
    context.close()


def test_a_host_that_forbids_webassembly_is_named(browser, address):
    context = browser.new_context()
    page = context.new_page()
    forbidding = {"Content-Security-Policy": "script-src 'self'"}
    page.route(address, lambda route: route.fulfill(response=(reply := route.fetch()), headers=reply.headers | forbidding))
    page.goto(address)
    page.get_by_text("Content-Security-Policy needs 'wasm-unsafe-eval' in script-src").wait_for(timeout=PATIENCE)
    context.close()


def test_the_whole_path_holds_what_is_still_to_come(visit):
    page = visit("?duration=2#t=0.3&show=t")
    ink = """() => {
      const canvas = document.querySelector(".stage-canvas");
      const { data, width } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
      let right = 0;
      for (let k = 0; k < data.length; k += 4) {
        const [red, green, blue] = data.slice(k, k + 3); // of the flight's trace
        if (data[k + 3] && red > 200 && green < 190 && blue < 190 && red - green > 50) right = Math.max(right, (k / 4) % width);
      }
      return right;
    }"""
    page.evaluate("hophoopLab.toggle('whole')")
    wait_for(page, "lab.stage.options.whole && !lab.requested")
    assert page.evaluate(ink) > 0  # it has not flown yet


def test_what_doubles_do_not_decide_is_said(visit):
    page = visit("?start.speed=3.616628264005025")
    assert "doubles cannot decide" in page.locator(".story .hint").inner_text()
    page.evaluate("hophoopLab.motions.change([['start.speed', 3.1]], true)")
    wait_for(page, "lab.film().values['start.speed'] === 3.1 && !lab.surrounding")
    assert not page.locator(".story .hint").is_visible()


def test_teachers_get_to_the_documentation_beside_it(visit, folder, tmp_path):
    site.export(folder / "play", docs="../")
    (folder / "teach").mkdir()
    (folder / "teach" / "worksheet.html").write_text(
        '<link rel="icon" href="data:,"><title>Worksheet</title>', encoding="utf-8"
    )
    page = visit("play/")
    page.evaluate("hophoopLab.extras.teach.showModal()")
    page.get_by_role("link", name="Worksheet").click()
    page.wait_for_url("**/teach/worksheet.html")
    assert page.title() == "Worksheet"


def test_the_folder_may_stand_anywhere(folder: Path, browser, tmp_path):
    deep = tmp_path / "courses" / "mechanics"
    site.export(deep)

    class Quiet(http.server.SimpleHTTPRequestHandler):
        def log_message(self, *_):
            pass

    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Quiet, directory=tmp_path))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    context = browser.new_context()
    page = context.new_page()
    page.goto(f"http://127.0.0.1:{server.server_address[1]}/courses/mechanics/?start.speed=2")
    page.wait_for_selector("[data-ready]", timeout=PATIENCE)
    assert page.evaluate("hophoopLab.film().sequence") == "R"
    context.close()
    server.shutdown()
    server.server_close()


def test_chromium_gives_the_same_bits_as_wasmtime(visit):
    pytest.importorskip("wasmtime")
    from hophoop.lab.wasm.stamp import HERE, MODULE
    from module.host import Host
    from module.module_tools import cell_of, given_of
    from module.test_page_kernel import scenarios

    host = Host(HERE / MODULE)
    digest = hashlib.sha256()
    for scenario in scenarios():
        digest.update(host.motion(cell_of(scenario))[1].tobytes())
    page = visit()
    found = page.evaluate(
        """async (asked) => {
          const { HoopModule } = await import(new URL("static/kernel.js", document.baseURI).href);
          const binary = await (await fetch("static/hophoop.wasm")).arrayBuffer();
          const module = new HoopModule(await WebAssembly.compile(binary));
          const rows = asked.map((given) => {
            for (const name in given) if (given[name] === "inf") given[name] = Infinity;
            return new Uint8Array(module.compute(given).rows.buffer);
          });
          const all = new Uint8Array(await new Blob(rows).arrayBuffer());
          const hash = new Uint8Array(await crypto.subtle.digest("SHA-256", all));
          return [...hash].map((byte) => byte.toString(16).padStart(2, "0")).join("");
        }""",
        [given_of(scenario) for scenario in scenarios()],
    )
    assert found == digest.hexdigest()


def test_a_page_opened_as_a_file_says_what_to_do(folder, browser):
    page = browser.new_page()
    page.goto((folder / "index.html").resolve().as_uri())
    words = page.get_by_text("python -m http.server")
    words.wait_for(state="attached")
    assert not words.is_visible()  # most pages are there before it is
    words.wait_for(state="visible", timeout=PATIENCE)
    page.close()
