"""HTML pages from Jinja2 templates, which lie in the packages."""

from __future__ import annotations

from typing import Any


def render(jinja2: Any, template: str, **values: object) -> str:
    """Fill a template; values are escaped.

    template: path below the package hophoop, such as ``"fitting/fit.html"``; **values: names of the template.
    """
    environment = jinja2.Environment(
        loader=jinja2.PackageLoader("hophoop", ""),
        autoescape=True,
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    return str(environment.get_template(template).render(values))
