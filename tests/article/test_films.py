"""The films of the article, small here, and of its runs."""

import multiprocessing
import os
import signal
import subprocess
import sys

import pytest
from PIL import Image

import hophoop as hh
from animate_tools import decoded
from hophoop.article import article_films, films
from hophoop.article.films import ARTICLE_FILMS, ArticleFilm, started_films


def test_without_pyvista_the_film_in_3d_is_a_page_that_turns(tmp_path, monkeypatch):
    """A small film and its poster, and the page; README's first command makes all of them."""
    for name, value in (("SIZE", (128, 72)), ("FPS_2D", 4.0), ("ARTICLE_FILMS", (ARTICLE_FILMS[1], ARTICLE_FILMS[-1]))):
        monkeypatch.setattr(films, name, value)
    monkeypatch.setattr(films, "find_spec", lambda name: None)
    told = []
    film, page = article_films(tmp_path / "films", lambda *pair: told.append(pair))
    assert told == [(1, 2), (2, 2)]
    assert (film.name, page.name) == ("v2.mp4", "v3.1-3d.html")
    assert decoded(film)[0].shape == (13, 72, 128, 3)
    with Image.open(film.with_suffix(".png")) as still:
        assert still.size == (128, 72)
    assert {path.name for path in film.parent.iterdir()} == {film.name, page.name, "v2.png"}


@pytest.fixture
def short(monkeypatch):
    """Two films of 3 pictures each."""
    pair = (ArticleFilm("one", "faster", 0.04), ArticleFilm("two", "slow", 0.04))
    monkeypatch.setattr(films, "ARTICLE_FILMS", pair)
    return pair


@pytest.mark.long
@pytest.mark.parametrize("killed", [False, True])
def test_other_processes_make_the_films_and_this_one_what_a_killed_one_leaves(tmp_path, short, killed):
    told = []
    with started_films(tmp_path / "films") as finish:
        for child in multiprocessing.active_children() if killed else ():
            child.kill()
            child.join()
        made = finish(lambda *pair: told.append(pair))
    assert told == [(1, 2), (2, 2)]
    assert [path.relative_to(tmp_path).as_posix() for path in made] == ["films/one.mp4", "films/two.mp4"]
    assert [decoded(path)[0].shape for path in made] == [(3, 540, 960, 3)] * 2
    assert sorted(path.name for path in tmp_path.iterdir()) == ["films"]
    assert sorted(path.name for path in (tmp_path / "films").iterdir()) == ["one.mp4", "one.png", "two.mp4", "two.png"]
    assert not multiprocessing.active_children()


def test_an_error_ends_the_other_processes_and_leaves_nothing(tmp_path, short):
    with pytest.raises(RuntimeError, match="elsewhere"), started_films(tmp_path / "films"):
        raise RuntimeError("elsewhere")
    assert not multiprocessing.active_children()
    assert not list(tmp_path.iterdir())


KILLED = """
import multiprocessing, os, signal
from concurrent.futures import ProcessPoolExecutor
from hophoop.article.films import _end_with_parent
if __name__ == "__main__":
    pool = ProcessPoolExecutor(1, multiprocessing.get_context("spawn"), initializer=_end_with_parent)
    print(pool.submit(os.getpid).result(), flush=True)
    os.kill(os.getpid(), signal.SIGKILL)
"""


@pytest.mark.skipif(os.name != "posix", reason="SIGKILL")
def test_no_process_outlives_the_one_that_started_it(tmp_path):
    (tmp_path / "killed.py").write_text(KILLED, encoding="utf-8")
    # waits until the other one has closed the pipe as well
    done = subprocess.run([sys.executable, tmp_path / "killed.py"], stdout=subprocess.PIPE, text=True, check=False, timeout=60)
    assert done.returncode == -signal.SIGKILL
    assert int(done.stdout) > 0


def test_the_runs_are_the_articles():
    runs = [film.scenario.replace("duration", 1.0) for film in ARTICLE_FILMS if not film.three_d]
    assert [film.name for film in ARTICLE_FILMS if film.three_d] == ["v3.1-3d"]
    wanted = [one.replace("duration", 1.0) for one in hh.article.scenarios().values()]
    assert runs == wanted
    assert ARTICLE_FILMS[-1].scenario == ARTICLE_FILMS[3].scenario
