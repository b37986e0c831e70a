"""The page in every language and place: as wide as its window, in every state, and for everyone."""

import pytest

from lab_page_tools import PHONE, SETTLED, SHOWN, accessible, picture, wait_for

WHERE = {
    "desktop": {},
    "phone": PHONE,
    "narrow": {"viewport": {"width": 320, "height": 640}},
    "dark": {"color_scheme": "dark"},
    "forced colours": {"forced_colors": "active"},
}
# Colours are the same in all languages.
PLACES = [("dark", "en"), ("forced colours", "en")]
PLACES += [(where, locale) for locale in ("en", "de", "es", "fr", "zh") for where in ("desktop", "phone", "narrow")]
# Each leads from the state before.
STATES = {
    "simple": "null",
    "everything": "hophoopLab.view.choose()",
    "ending": "(extras.visit.leave(), hophoopLab.ending.fetch())",
    "arrows": "(extras.more.turn(true), document.querySelector('.more-events summary').click())",
    "map": "(extras.more.turn(false), document.querySelector('.map-body').scrollIntoView())",
    "sketch": "extras.visit.go(2)",
    "circle": "extras.visit.go(0)",
    "challenges and table": "(extras.visit.leave(), extras.challenges.open(), extras.table.open(true))",
    "presentation": "extras.present.turn(true)",
    "teachers": "(extras.present.turn(false), extras.teach.showModal())",
    "help": "(extras.teach.close(), hophoopLab.help.showModal())",
    "about": "(hophoopLab.help.close(), hophoopLab.about.showModal())",
    "code": "(hophoopLab.about.close(), hophoopLab.share.code())",
    "menu": "(hophoopLab.share.dialog.close(), hophoopLab.share.menu.querySelector('summary').click())",
    "two hoops": "(hophoopLab.share.menu.querySelector('summary').click(), hophoopLab.motions.compare())",
    "a refusal": "hophoopLab.controls.refuse([['start.speed', 1]], 'motion.copied')",
    "real parts": "hophoopLab.motions.change([['hoop.parts', [{ shape: 'disk', mass: 1, radius: 1, at: 0 }]]], true)",
    "in space": "hophoopLab.toggle('three')",
}


@pytest.mark.parametrize(
    ("where", "locale"),
    [place if place == ("phone", "en") else pytest.param(*place, marks=pytest.mark.long) for place in PLACES],
)
def test_everyone_can_use_it(visit, where, locale):
    page = visit("#t=0.5", simple=True, locale=locale, **WHERE[where])
    wait_for(page, SHOWN)
    assert page.evaluate("hophoopLab.root.dataset.theme") == ("dark" if where == "dark" else "light")
    for name, action in STATES.items():
        page.evaluate(f"async () => {{ const {{ extras }} = hophoopLab; await {action}; }}")
        wait_for(page, f"{SETTLED} && (!lab.extras.more.on || lab.extras.more.changes)")
        wide = page.evaluate("[document.documentElement.scrollWidth, innerWidth]")
        assert wide[0] <= wide[1], name
        assert accessible(page) == [], name
        if name in ("simple", "everything", "ending", "arrows"):
            picture(page, f"{name}-{where.replace(' ', '-')}-{locale}", full_page=True)


@pytest.mark.long
def test_keys_alone_reach_and_change_everything(visit):
    page = visit("?start.speed=2")
    wait_for(page, SHOWN)
    name = "({ labels, textContent, ariaLabel }) => ariaLabel ?? labels?.[0]?.textContent ?? textContent"
    reached = []
    while len(reached) < 120 and not (reached and reached[-1].startswith("Map of motions")):
        page.keyboard.press("Tab")
        reached.append(page.evaluate(f"({name})(document.activeElement)").strip())
        if reached[-1].startswith("Speedv"):
            page.keyboard.press("End")  # the slider's greatest speed
            wait_for(page, "lab.film().values['start.speed'] > 4")
    for name in ("Skip to the player", "Examples", "Language", "Friction", "Angle of the load", "Time", "Play"):
        assert any(text.startswith(name) for text in reached), name
    assert reached[-1].startswith("Map of motions")
    page.keyboard.press("Control+z")
    wait_for(page, "lab.film().values['start.speed'] === 2")
