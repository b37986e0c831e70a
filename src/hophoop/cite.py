"""What to cite for hophoop; docs/howto/cite.md lists the works on which the physics of a motion rests."""

from __future__ import annotations

from hophoop._version import __version__
from hophoop.scenario import InputError
from hophoop.simulation.trajectory import Trajectory

__all__ = ["cite"]


def cite(motion: Trajectory | None = None) -> str:
    """Return the BibTeX entry of hophoop, that of CITATION.cff.

    Parameters
    ----------
    motion : Trajectory, optional
        Its version, which computed it, is cited; by default this one.

    Returns
    -------
    entry : str
        BibTeX.

    Raises
    ------
    ValueError
        If it is no motion.

    Examples
    --------
    >>> print(cite())
    @software{hophoop,
      author = {{The hophoop developers}},
      title = {hophoop: exact motion of a loaded hoop on a plane},
      version = {0.1.0},
      license = {MIT},
    }
    """
    if not (motion is None or isinstance(motion, Trajectory)):
        raise InputError(f"motion must be a Trajectory, not {type(motion).__name__}.", field="motion", value=motion)
    fields = {
        "author": "{The hophoop developers}",
        "title": "hophoop: exact motion of a loaded hoop on a plane",
        "version": __version__ if motion is None else motion.version,
        "license": "MIT",
    }
    return "\n".join(["@software{hophoop,", *(f"  {name} = {{{value}}}," for name, value in fields.items()), "}"])
