"""Files damaged at random, and what comes of reading them."""

import random
import shutil
from collections import Counter

from hophoop import io
from hophoop._support.checksum import checksum


def contents(folder):
    """Every file of a folder with its bytes."""
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}


def damaged(whole, copy, count):
    """Put a damaged copy of a file, or of a folder of files, in place again and again; says what was done to it.

    Every third is cut short somewhere, every other has one bit turned. In a folder any file may be hit, half of the time in
    proportion to its size.
    """
    draw = random.Random(2026)
    files = [whole] if whole.is_file() else sorted(file for file in whole.rglob("*") if file.is_file())
    sizes = [file.stat().st_size for file in files]
    for k in range(count):
        if copy.is_dir():
            shutil.rmtree(copy)
        if whole.is_dir():
            shutil.copytree(whole, copy)
        file = draw.choices(files, sizes)[0] if k % 2 else draw.choice(files)
        content = bytearray(file.read_bytes())
        if k % 3 == 0:
            length = draw.randrange(len(content))
            content, done = content[:length], f"cut after {length} bytes"
        else:
            place, bit = draw.randrange(len(content)), draw.randrange(8)
            content[place] ^= 1 << bit
            done = f"bit {bit} of byte {place} turned"
        (copy if whole.is_file() else copy / file.relative_to(whole)).write_bytes(content)
        yield f"{file.name}: {done}"


def unseal(file):
    """Take the checksum from the end of a netCDF file."""
    content = file.read_bytes()
    file.write_bytes(content[: content.rindex(b"\nhophoop sha256 ")])


def sign(file):
    """Give an unsealed motion that was changed the checksum of its present content."""
    if file.suffix == ".nc":
        import netCDF4

        content = checksum(io._read(file, "netcdf"))
        with netCDF4.Dataset(file, "a") as changed:
            for group in (changed, *changed.groups.values()):
                group.checksum = content
    else:
        import zarr

        content = checksum(io._read(file, "zarr"))
        root = zarr.open_group(file, mode="a", use_consolidated=False)
        for group in (root, *(each for _, each in root.groups())):
            group.attrs["checksum"] = content


def same(one, other):
    """Whether two motions have the same bits; all that a motion has follows from these."""
    equal = one.scenario == other.scenario
    equal &= (one.status, one.version, one.doubt) == (other.status, other.version, other.doubt)
    tables = zip(one.tables.values(), other.tables.values(), strict=True)
    return equal and all((mine.dtype, mine.tobytes()) == (its.dtype, its.tobytes()) for mine, its in tables)


SAME, REFUSED = "the same", "one sentence"


def tally(load, alike, whole, copy, count):
    """How often a damaged copy was read as the same, or refused by one sentence; what else came is under its own name."""
    came = Counter()
    for done in damaged(whole, copy, count):
        try:
            loaded = load(copy)
        except ValueError as error:
            text = str(error)
            came[REFUSED if text.isprintable() and text.endswith((".", "?")) else f"{done}: {text}"] += 1
        except Exception as error:
            came[f"{done}: {error!r}"] += 1
        else:
            came[SAME if alike(loaded) else f"{done}: another"] += 1
    return came
