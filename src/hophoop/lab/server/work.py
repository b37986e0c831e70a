"""A process that makes one file for the server: the scenario comes as JSON, the file goes to the standard output.

A process of its own can be ended at any time, whatever it computes.
"""

from __future__ import annotations

import json
import sys
import warnings

from hophoop._support.extras import MissingExtra
from hophoop.lab.api import files
from hophoop.lab.api.refusals import refusal
from hophoop.scenario import InputError, Scenario

REFUSED = 3  # exit status


def main(name: str) -> int:
    """Make a file; a refusal is a status of HTTP and its body, as JSON.

    Parameters
    ----------
    name : str

    Returns
    -------
    status : int
        Exit status [1].
    """
    warnings.simplefilter("ignore")  # they would go to the terminal of the server
    try:
        content = files.make(name, Scenario.loads(sys.stdin.buffer.read().decode(errors="replace"), "json", "the body"))
    except (InputError, MissingExtra) as error:
        content = json.dumps(refusal(error)).encode()
        sys.stdout.buffer.write(content)
        return REFUSED
    sys.stdout.buffer.write(content)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
