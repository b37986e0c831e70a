"""The films of the article: all of them, of its runs, small here."""

import numpy as np
import pytest
from PIL import Image

import hophoop as hh
from animate_tools import decoded
from hophoop.animate import article, article_films
from hophoop.animate.article import ARTICLE_FILMS


@pytest.fixture
def small(monkeypatch):
    monkeypatch.setattr(article, "SIZE", (128, 72))
    for name, value in (("FPS_2D", 4.0), ("FPS_3D", 2.0)):
        monkeypatch.setattr(article, name, value)


@pytest.mark.long
def test_all_films_are_made(tmp_path, small):
    told = []
    paths = article_films(tmp_path / "films", lambda *pair: told.append(pair))
    assert [path.name for path in paths] == [*(f"{film.name}.mp4" for film in ARTICLE_FILMS), "v3.1-3d.html"]
    assert told == [(k + 1, 7) for k in range(7)]
    assert paths.pop().read_text(encoding="utf-8").startswith("<!DOCTYPE html>")
    for path, film in zip(paths, ARTICLE_FILMS, strict=True):
        pictures, _ = decoded(path)
        assert len(pictures) >= film.duration * film.share * (2 if film.three_d else 4)
        assert pictures.shape[1:] == (72, 128, 3)
        with Image.open(path.with_suffix(".png")) as still:
            assert still.size == (128, 72)
            assert np.asarray(still).std() > 5.0


def test_without_pyvista_the_film_in_3d_is_a_page_that_turns(tmp_path, small, monkeypatch):
    monkeypatch.setattr(article, "find_spec", lambda name: None)
    monkeypatch.setattr(article, "ARTICLE_FILMS", ARTICLE_FILMS[-1:])
    assert [path.name for path in article_films(tmp_path)] == ["v3.1-3d.html"]
    assert [path.name for path in tmp_path.iterdir()] == ["v3.1-3d.html"]


def test_the_runs_are_the_articles():
    runs = [(film.speed, film.mu) for film in ARTICLE_FILMS if not film.three_d]
    assert runs == [(0.1, 1.0), (2.0, 1.0), (2.8, 1.0), (3.1, 1.0), (0.1, 0.3)]
    assert [film.name for film in ARTICLE_FILMS if film.three_d] == ["v3.1-3d"]
    for film in ARTICLE_FILMS:
        assert film.scenario.hoop == hh.Hoop.ideal(0.75)
        assert film.scenario.start == hh.Start.rolling(film.speed)
        assert film.scenario.plane.mu == film.mu
