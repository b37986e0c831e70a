"""The kept scenarios of data/bits, the bits of their motions, and the hashes of these.

A motion's bits are three tables of doubles: its events as the kernel wrote them, its samples at nine times and its ledger, both
in SI units. −0 counts as 0 and every nan as the quiet one.
"""

import hashlib
import json
from typing import NamedTuple

import numpy as np
from numpy.lib.recfunctions import structured_to_unstructured

import hophoop as hh
from checkout import DATA
from hophoop.kernel.physics.body import MODE_LETTERS, Status
from hophoop.lab.wasm.layout import SAMPLE_COLUMNS

FOLDER = DATA / "bits"
SCENARIOS, HASHES = FOLDER / "scenarios.json", FOLDER / "hashes.json"
LEDGER = ("kinetic", "potential", "friction", "impact_normal", "impact_tangential", "rolling_resistance", "spring", "damping")
LEDGER_FIELDS = ("status", "duration", *LEDGER, "residual")
SAMPLES = 9
DIGITS = 12  # of a motion's own hashes; those of all motions have all 64


class Kept(NamedTuple):
    """One of the kept scenarios."""

    index: int
    kind: str
    scenario: hh.Scenario


class Bits(NamedTuple):
    """All that is compared of a motion."""

    events: np.ndarray
    samples: np.ndarray
    ledger: np.ndarray


def scenario_of(sections, most_events):
    """A scenario from its line of the file."""
    keys = {name: value for name, value in sections.items() if name != "kind"}
    return hh.Scenario.from_dict({"contact": {"model": "rigid", "max_events": most_events}, **keys})


def kept_scenarios(every=1):
    """All kept scenarios, or every so many of them."""
    told = json.loads(SCENARIOS.read_text(encoding="utf-8"))
    return [
        Kept(index, one["kind"], scenario_of(one, told["max_events"]))
        for index, one in enumerate(told["scenarios"])
        if index % every == 0
    ]


def kept_hashes():
    """The content of the file of hashes."""
    return json.loads(HASHES.read_text(encoding="utf-8"))


# --- bits ------------------------------------------------------------------------------------------------------------


def canonical(table):
    """Doubles with one zero and one nan."""
    numbers = np.array(table, dtype="<f8") + 0.0
    numbers[np.isnan(numbers)] = np.nan
    return numbers


def event_rows(events):
    """Records of the kernel as rows of doubles."""
    return canonical(structured_to_unstructured(events))


def sample_times(duration):
    """Times of the samples [s]."""
    return duration * np.arange(float(SAMPLES)) / (SAMPLES - 1)


def bits_of(motion):
    """The bits of a motion that the library computed."""
    duration, ledger = motion.duration, motion.ledger
    rows = np.empty((0, len(SAMPLE_COLUMNS)))
    if duration > 0.0:
        sample = motion.at(sample_times(duration))
        modes = [MODE_LETTERS.index(letter) for letter in sample.mode]
        columns = vars(sample) | {"mode": modes, "utilization": sample.utilization(motion.scenario.plane)}
        rows = np.column_stack([columns[name] for name in SAMPLE_COLUMNS])
    energies = [getattr(ledger, name) for name in (*LEDGER, "residual")]
    return Bits(
        event_rows(motion.tables["events"]),
        canonical(rows),
        canonical([float(Status[motion.status.upper()]), duration, *energies]),
    )


def bits_of_heads(heads, events, samples):
    """The same from what the module's entries wrote: heads, the kernel's records of events, rows of samples."""
    return Bits(event_rows(events), canonical(samples), canonical([heads[name] for name in LEDGER_FIELDS]))


# --- hashes ----------------------------------------------------------------------------------------------------------


def hash_of(tables):
    """SHA-256 of tables, one after the other."""
    digest = hashlib.sha256()
    for table in tables:
        digest.update(table.tobytes())
    return digest.hexdigest()


def own_hashes(bits):
    """The hashes of the three tables of one motion."""
    return [hash_of([table])[:DIGITS] for table in bits]


def hashes_text(found):
    """The text of the file of hashes, one motion a line, from the bits of all motions in order."""
    lines = ",\n".join(json.dumps(" ".join(own_hashes(bits))) for bits in found)
    return f'{{\n "events": "{hash_of(bits.events for bits in found)}",\n "motions": [\n{lines}\n]}}\n'


def differing(found):
    """Motions whose bits are not the kept ones."""
    lines = kept_hashes()["motions"]
    return [index for index, bits in found.items() if own_hashes(bits) != lines[index].split()]


def of_kinds(kept, *kinds):
    """Those of some kinds."""
    return [each for each in kept if each.kind in kinds]
