"""What a client is told when it gets no answer: a status of HTTP, and a body with one sentence."""

from __future__ import annotations

from hophoop._support.extras import MissingExtra, install_command
from hophoop.lab.api.limits import TooMuch
from hophoop.scenario import InputError


def refusal(error: InputError | MissingExtra) -> tuple[int, dict[str, str]]:
    """Return the reply to a request that cannot be computed.

    Parameters
    ----------
    error : InputError or MissingExtra

    Returns
    -------
    status : int
        413, 422 or 501.
    body : dict
        `detail` is the sentence; with status 501 `extra` names the missing extra, and `install` the command for it.
    """
    if isinstance(error, MissingExtra):
        return 501, {"detail": str(error), "extra": error.extra, "install": install_command(error.extra)}
    return (413 if isinstance(error, TooMuch) else 422), {"detail": str(error)}
