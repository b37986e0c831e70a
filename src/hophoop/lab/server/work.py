"""What the processes of the server compute; imported before they start, so that a new one is ready at once."""

from __future__ import annotations

import os
import signal
import tempfile
import warnings
from dataclasses import dataclass
from typing import Any

from hophoop import maps  # noqa: F401  so that a new process has it already
from hophoop._support.stopping import clean_up
from hophoop.lab.api import calls, files
from hophoop.lab.api.limits import Limits


@dataclass(frozen=True)
class Job:
    """A request to compute, and the form of its answer.

    Attributes
    ----------
    request : hophoop.lab.api.calls.Request
        A checked request.
    limits : hophoop.lab.api.limits.Limits
    form : str
        Form of the answer: packed, json, or the name of a file.
    """

    request: calls.Request
    limits: Limits
    form: str


def prepare(folder: str) -> None:
    """Make a new process ready for jobs, and for being stopped.

    Parameters
    ----------
    folder : str
        For temporary files; the server removes it at its end, with what killed processes have left.
    """
    tempfile.tempdir = folder
    warnings.simplefilter("ignore")  # they would go to the terminal of the server
    signal.signal(signal.SIGTERM, _stop)


def _stop(*_: Any) -> None:
    clean_up()
    os._exit(1)


def outcome(job: Job) -> bytes:
    """Compute a job.

    Parameters
    ----------
    job : Job

    Returns
    -------
    content : bytes

    Raises
    ------
    InputError, MissingExtra
        What the client is told; any other error is a defect.
    """
    if job.form in files.KINDS:
        return files.KINDS[job.form].make(job.request.scenario, job.limits)
    reply = calls.answer(job.request, job.limits)
    return reply.packed() if job.form == "packed" else reply.json()
