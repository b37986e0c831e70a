"""What the tests of maps share."""

import pytest


def contents(folder):
    """Every file of a store with its bytes."""
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}


def stopped(make, path, after=0):
    """The path of a map that was stopped once more than so many cells were done."""

    def stop(done, total):
        if done > after:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        make(path, progress=stop)
    return path
