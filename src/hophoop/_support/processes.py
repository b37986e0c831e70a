"""Another Python process with the same packages; a script needs no `if __name__ == "__main__"` for it."""

from __future__ import annotations

import subprocess
import sys
from typing import Any


def start_python(code: str, **options: Any) -> subprocess.Popen[bytes]:
    """Start a Python process that runs some code, with this process's import path.

    Parameters
    ----------
    code : str
    **options
        Options of `subprocess.Popen`.

    Returns
    -------
    process : subprocess.Popen

    Raises
    ------
    OSError
        If no process can be started.
    """
    if not sys.executable:
        raise FileNotFoundError("The path of the Python executable is unknown.")
    # warnings would go to the terminal of this process
    whole = f"import sys; sys.path[:] = {sys.path!r}\n{code}"
    return subprocess.Popen([sys.executable, "-W", "ignore", "-c", whole], **options)
