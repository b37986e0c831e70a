"""Nothing in the pages leads nowhere, and nothing is fetched from elsewhere."""

from site_tools import broken_links


def test_links_inside_lead_somewhere(site):
    assert broken_links(site) == []


def test_a_broken_link_is_found(tmp_path):
    (tmp_path / "a.html").write_text(
        '<p id="here"><a href="#here">a</a><a href="#gone">b</a><a href="b.html">c</a><a href="c.html#x">d</a>'
        '<a href="https://example.org">e</a><script src="https://example.org/f.js"></script><img src="g%20h.png">',
        encoding="utf-8",
    )
    (tmp_path / "c.html").write_text("<p>", encoding="utf-8")
    (tmp_path / "g h.png").write_bytes(b"")
    assert broken_links(tmp_path) == [
        "a.html loads https://example.org/f.js from elsewhere",
        "a.html: #gone names no place of its page",
        "a.html: b.html is not there",
        "a.html: c.html#x names no place of its page",
    ]
