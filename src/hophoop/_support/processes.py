"""Another Python process beside this one, with the same packages; it needs no `if __name__ == "__main__"` in a script."""

from __future__ import annotations

import subprocess
import sys
from typing import Any


def python_beside(code: str, **options: Any) -> subprocess.Popen[bytes]:
    """Start Python on some code, with this process's import path.

    Parameters
    ----------
    code : str
    **options
        Of `subprocess.Popen`.

    Returns
    -------
    process : subprocess.Popen

    Raises
    ------
    OSError
        If no process can be started.
    """
    if not sys.executable:
        raise FileNotFoundError("It is not known where Python is.")
    # warnings are for the person whose process this is
    whole = f"import sys; sys.path[:] = {sys.path!r}\n{code}"
    return subprocess.Popen([sys.executable, "-W", "ignore", "-c", whole], **options)
