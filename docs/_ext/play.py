"""The lab itself next to the pages: it computes in the visitor's browser, so that "play" needs no server.

Every page leads to it, and a page shows one of its motions with the directive ``motion``. The argument is the query of a link
of the lab, the content is the caption. On paper a drawing takes the place of the motion.
"""

from __future__ import annotations

import hashlib
from html import escape
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

import hophoop as hh
from hophoop.lab import export as site

FOLDER = "play"
ELEMENT = f"{FOLDER}/static/hophoop-motion.js"


class live(nodes.General, nodes.Element):
    """A motion that the page itself computes; `query` is that of a link of the lab."""


class Motion(SphinxDirective):
    """A hoop that moves, and its caption."""

    required_arguments = 1
    has_content = True

    def run(self) -> list[nodes.Node]:
        """Refuse a query that names no scenario: the page would show another motion."""
        query = self.arguments[0]
        try:
            hh.Scenario.from_query(query)
        except ValueError as error:
            raise self.error(f"motion: {error}") from error
        figure = live(query=query)
        figure += self.parse_content_to_nodes()
        return [figure]


def address(builder: Any, page: str, file: str) -> str:
    """Of a file of the site, from a page."""
    return "../" * builder.get_target_uri(page).count("/") + file


def draw_still(folder: Path, query: str) -> str:
    """Draw a motion as a strobe photograph in the colours of its modes and return the file's name."""
    name = f"strobe-{hashlib.sha256(query.encode()).hexdigest()[:12]}.webp"
    folder.mkdir(parents=True, exist_ok=True)
    figure = hh.plots.strobe(hh.simulate(hh.Scenario.from_query(query)), color="mode").figure
    figure.savefig(folder / name, dpi=150)
    plt.close(figure)
    return name


def visit_live(writer: Any, node: live) -> None:
    """The hoop, above its caption and a link, which is all where there are no scripts; on paper a drawing."""
    images = writer.builder.imagedir
    still = draw_still(Path(writer.builder.outdir, images), node["query"])
    query, page = escape(node["query"]), writer.builder.current_docname
    picture = address(writer.builder, page, f"{images}/{still}")
    lab, script = (address(writer.builder, page, file) for file in (f"{FOLDER}/index.html?{query}", ELEMENT))
    writer.body.append(
        '<div class="live"><div class="on-paper-not">'
        f'<hophoop-motion loading="lazy" panels="player" scenario="{query}"></hophoop-motion>'
        f'<script type="module" src="{script}"></script></div>\n'
        f'<img class="on-paper-only" fetchpriority="low" alt="The hoop at equal steps of time" src="{picture}">\n'
    )
    writer.context.append(f'<p class="on-paper-not"><a href="{lab}">Change this motion in the lab</a></p></div>\n')


def depart_live(writer: Any, node: live) -> None:
    """End what `visit_live` has begun."""
    writer.body.append(writer.context.pop())


def before_a_page(app: Sphinx, page: str, template: str, context: dict[str, Any], doctree: Any) -> None:
    """A link to the lab at the top of every page."""
    lab = address(app.builder, page, f"{FOLDER}/index.html")
    context["theme_announcement"] = f'<a href="{lab}"><strong>Play</strong> with the hoop in your browser</a>'


def after_the_pages(app: Sphinx, error: Exception | None) -> None:
    """Write the lab where the pages' links expect it."""
    if error is None and app.builder.name == "html":
        site.export(Path(app.outdir) / FOLDER, docs="../")


def setup(app: Sphinx) -> dict[str, Any]:
    """The directive, the link of every page, and the lab when all pages are written."""
    app.add_directive("motion", Motion)
    app.add_node(live, html=(visit_live, depart_live))
    app.connect("html-page-context", before_a_page)
    app.connect("build-finished", after_the_pages)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
