"""Films of motions, in 2D and 3D: files, pictures, scenes that turn in a browser, a player for notebooks.

What they need is in the extra ``films`` and loaded when a film is made.
"""

from hophoop._support.progress import bar
from hophoop.animate.films import Player, film, film_3d, picture, player
from hophoop.animate.frames import Timing
from hophoop.animate.look import Look, Look3D
from hophoop.animate.web import scene

__all__ = ["Look", "Look3D", "Player", "Timing", "bar", "film", "film_3d", "picture", "player", "scene"]
