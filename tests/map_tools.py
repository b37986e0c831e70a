"""What the tests of maps share."""


def contents(folder):
    """Every file of a store with its bytes."""
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}
