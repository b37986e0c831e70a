"""From a film of a hoop, or a table of places, to a track: times, centre and angle with their uncertainties."""

from hophoop.tracking.camera import Camera
from hophoop.tracking.drawing import overlay
from hophoop.tracking.film import track
from hophoop.tracking.hints import Hints
from hophoop.tracking.quantities import Reading
from hophoop.tracking.reading import read_track
from hophoop.tracking.table import Track, View

__all__ = ["track", "Hints", "Track", "View", "Camera", "read_track", "Reading", "overlay"]
