"""The lab as one file, opened from a disk without a network, in Chromium and in Firefox."""

import pytest

from firefox import Tab, firefox
from hophoop.lab import export
from hophoop.vocabulary.names import FATES, identifier
from lab_page_tools import PATIENCE

# Begun by hand: a page that opens at a time does not play by itself.
AT_REST = "#t=0&view=everything?start.speed=2"
KNOWN = """
  const lab = globalThis.hophoopLab;
  const first = (selector) => document.querySelector(selector);
  const until = async (holds) => { while (!holds()) await new Promise((done) => setTimeout(done, 20)); };"""
MOVES = "await until(() => globalThis.hophoopLab?.clock.time > 0.05); return performance.now();"
READY = "await until(() => first('[data-ready]') && !hophoopLab.surrounding);"


class Chromium:
    """A window of Chromium, as `firefox.Tab`."""

    def __init__(self, page):
        self.page = page
        page.set_default_timeout(PATIENCE)

    def open(self, address):
        self.page.goto("about:blank")
        self.page.goto(address)

    def ask(self, body):
        return self.page.evaluate(f"async () => {{ {body} }}")

    def drag(self, *places):
        for number, (x, y) in enumerate(places):
            self.page.mouse.move(x, y)
            if number == 0:
                self.page.mouse.down()
        self.page.mouse.up()


@pytest.fixture(scope="module")
def file(tmp_path_factory):
    """Where the page lies."""
    return export.export(tmp_path_factory.mktemp("disk") / "play.html")[0].as_uri()


@pytest.fixture(scope="module")
def fox(tmp_path_factory):
    """One Firefox for all, as it takes long to start."""
    with firefox(tmp_path_factory.mktemp("profile")) as tab:
        tab.size(1280, 800)
        yield tab


@pytest.fixture(params=["chromium", "firefox"])
def window(request):
    if request.param == "firefox":
        yield (tab := request.getfixturevalue("fox"))
        tab.ask("localStorage.clear(); sessionStorage.clear();")
        return
    page, troubles = request.getfixturevalue("new_page")(viewport={"width": 1280, "height": 800}, offline=True), []
    page.on("pageerror", lambda error: troubles.append(str(error)))
    page.on("request", lambda asked: troubles.append(asked.url))
    yield Chromium(page)
    assert [trouble for trouble in troubles if not trouble.startswith(("file:", "blob:", "data:", "about:"))] == []


def asked(window, body):
    return window.ask(f"{KNOWN} {body}")


def opened(window, address):
    window.open(address)
    asked(window, READY)


def test_it_moves_within_two_seconds(window, file):
    seconds = []
    while len(seconds) < 3 and min(seconds, default=9.0) > 2.0:  # other work on the machine is no fault of the page
        window.open(file)
        seconds.append(asked(window, MOVES) / 1000)
    assert min(seconds) < 2.0, seconds


@pytest.mark.long
def test_a_load_is_dragged_a_map_is_there_and_a_link_is_copied_and_opened_again(window, file):
    opened(window, file + AT_REST)
    x, y, reach = asked(
        window,
        """const [load, hoop] = ['load', 'hoop'].map((name) => first(`.grip-${name}`).getBoundingClientRect());
        const middle = ({ x, y, width, height }) => [x + width / 2, y + height / 2];
        return [...middle(load), middle(hoop)[1] - middle(load)[1]];""",
    )
    window.drag((x, y), (x + 0.7 * reach, y + 0.3 * reach), (x + reach, y + reach))  # a quarter turn
    asked(window, "await until(() => lab.motions.history.past.length === 1 && !lab.surrounding);")
    start = asked(window, "lab.clock.play(false); lab.clock.seek(0.3); return lab.film().scenario.start;")
    assert start["angle"] == pytest.approx(1.57, abs=0.1)  # the speed is that of the hand
    colours = asked(
        window,
        """first('.map-body').scrollIntoView({ block: 'center' });
        await until(() => lab.map.level === 4);
        const { values } = lab.map.layers.at(-1);
        return new Set(values).size;""",
    )
    assert colours > 5
    link, address, query = asked(
        window,
        """Object.defineProperty(navigator, 'clipboard', { value: { writeText: async (text) => { lab.copied = text; } } });
        await lab.share.copyLink([]);
        await until(() => location.hash.includes('t=0.3'));
        return [lab.copied, location.href, lab.film().query];""",
    )
    assert link.startswith(f"{file}?{query}#t=0.3&")
    assert address == f"{file}#{link.partition('#')[2]}?{query}"
    for again in (link, address):
        opened(window, again)
        assert asked(window, "return [lab.film().query, lab.clock.time];") == [query, 0.3]
    names = asked(window, "return performance.getEntriesByType('resource').map(({ name }) => name.split(':')[0]);")
    assert set(names) <= {"blob", "data"}


def test_its_address_holds_what_is_seen_where_it_was_opened_with_another_hoop(window, file):
    opened(window, f"{file}?start.speed=2.5#t=1")
    address = asked(
        window,
        """lab.motions.change([['start.speed', 3.1]], true);
        await until(() => lab.address.number === 1 && location.href.split('#').length === 2);
        return location.href;""",
    )
    opened(window, address)
    assert asked(window, "return [lab.film().query, lab.clock.time];") == ["", 1]


def test_all_is_in_it_and_it_says_whose_it_is(window, file):
    opened(window, file + AT_REST)
    for code, word in {"de": "Parameter", "es": "Parámetros", "fr": "Paramètres", "zh": "参数", "en": "Parameters"}.items():
        asked(window, f"const list = first('.language'); list.value = '{code}'; list.dispatchEvent(new Event('change'));")
        asked(window, f"await until(() => first('.side').ariaLabel === '{word}');")
    # a Firefox without a display may have no WebGL
    can = asked(window, "return Boolean(document.createElement('canvas').getContext('webgl2'));")
    assert can or isinstance(window, Tab)
    assert asked(window, "await lab.toggle('three'); return lab.stage.options.three;") is can
    said = asked(window, "return [first('.about details').textContent, first('.menu-body').textContent];")
    assert "svgcanvas" in said[0]
    assert "Permission is hereby granted" in said[0]
    names = asked(
        window,
        """const made = [];
        HTMLAnchorElement.prototype.click = function () { made.push(this.download); };
        await lab.toggle('three');
        await lab.load('duration=0.3');
        for (const button of document.querySelectorAll('.menu-body button')) {
          if (!/Save|Record/.test(button.textContent)) continue;
          const { length } = made;
          button.click();
          await until(() => made.length > length);
        }
        return made;""",
    )
    film = names.pop()
    assert names == ["hophoop-motion.toml", "hophoop-motion.csv", "hophoop-motion.json", "hophoop.png", "hophoop.svg"]
    assert film in ("hophoop.mp4", "hophoop.webm")
    assert asked(window, "await lab.load(''); await lab.ending.fetch(); return lab.ending.known.fate;") in map(
        identifier, FATES
    )


def test_a_frame_without_storage_and_clipboard_shows_it_all_the_same(new_page, file, tmp_path):
    page = new_page(viewport={"width": 1000, "height": 800}, offline=True)
    frame = f'<iframe sandbox="allow-scripts" src="{file}" width="980" height="780"></iframe>'
    (tmp_path / "course.html").write_text(frame)
    page.goto((tmp_path / "course.html").as_uri())
    inner = page.frames[1]
    inner.wait_for_function("() => globalThis.hophoopLab?.clock.time > 0.05", timeout=PATIENCE)
    inner.evaluate("() => hophoopLab.clock.play(false)")
    inner.wait_for_function("() => location.hash.includes('t=')", timeout=PATIENCE)
    inner.evaluate("() => hophoopLab.share.copyLink([])")
    assert inner.locator(".code-dialog[open] pre").inner_text().startswith(file)


def test_without_scripts_it_says_what_to_do(new_page, file):
    page = new_page(java_script_enabled=False, offline=True)
    page.goto(file)
    lines = page.locator(".late p")
    assert [lines.nth(k).get_attribute("lang") for k in range(lines.count())] == [None, "de", "es", "fr", "zh"]
    lines.first.wait_for(state="visible", timeout=PATIENCE)
