"""The films of the article, small here, and of its runs."""

from PIL import Image

import hophoop as hh
from animate_tools import decoded
from hophoop.animate import article, article_films
from hophoop.animate.article import ARTICLE_FILMS


def test_without_pyvista_the_film_in_3d_is_a_page_that_turns(tmp_path, monkeypatch):
    """A small film and its poster, and the page; README's first command makes all of them."""
    for name, value in (("SIZE", (128, 72)), ("FPS_2D", 4.0), ("ARTICLE_FILMS", (ARTICLE_FILMS[1], ARTICLE_FILMS[-1]))):
        monkeypatch.setattr(article, name, value)
    monkeypatch.setattr(article, "find_spec", lambda name: None)
    told = []
    film, page = article_films(tmp_path / "films", lambda *pair: told.append(pair))
    assert told == [(1, 2), (2, 2)]
    assert (film.name, page.name) == ("v2.mp4", "v3.1-3d.html")
    assert decoded(film)[0].shape == (13, 72, 128, 3)
    with Image.open(film.with_suffix(".png")) as still:
        assert still.size == (128, 72)
    assert {path.name for path in film.parent.iterdir()} == {film.name, page.name, "v2.png"}


def test_the_runs_are_the_articles():
    runs = [film.scenario.replace("duration", 1.0) for film in ARTICLE_FILMS if not film.three_d]
    assert [film.name for film in ARTICLE_FILMS if film.three_d] == ["v3.1-3d"]
    wanted = [one.replace("duration", 1.0) for one in hh.article.scenarios().values()]
    assert runs == wanted
    assert ARTICLE_FILMS[-1].scenario == ARTICLE_FILMS[3].scenario
