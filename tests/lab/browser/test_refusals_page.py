"""What the page says where its server gives no answer: in the language of the page, whatever the server says."""

import json
from pathlib import Path

WORDS = Path(__file__).parents[3] / "src/hophoop/lab/words"
REFUSALS = {
    403: "server.not_from_here",
    404: "server.no_match",
    408: "server.late",
    413: "server.too_much",
    415: "server.no_match",
    422: "server.no_match",
    500: "server.failed",
    501: "server.missing_extra",
    502: "backend.server_status",
    503: "server.busy",
}


def test_refusals_of_the_server_are_said_in_the_language_of_the_page(visit):
    page = visit(own=True, locale="de-DE", expected=["Failed to load resource"])
    status = 0

    def refuse(route):
        body = {"detail": "This is English.", **({"install": "pip install files"} if status == 501 else {})}
        route.fulfill(status=status, json=body)

    page.route("**/files/motion.nc", refuse)
    own = json.loads((WORDS / "de.json").read_text(encoding="utf-8"))
    for status, key in REFUSALS.items():
        page.evaluate("hophoopLab.notice.clear()")
        page.evaluate("hophoopLab.share.download('motion.nc').catch((error) => hophoopLab.notice.fail(error))")
        text = own[key] if isinstance(own[key], str) else own[key].get("one", own[key]["other"])
        expected = text.replace("{status}", str(status)).replace("{install}", "pip install files").replace("{count}", "1")
        assert page.locator(".message").inner_text() == expected, status
