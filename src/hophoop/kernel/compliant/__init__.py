"""Compliant contact: what other packages use of it."""

from hophoop.kernel.compliant.event_loop import COLUMNS, MAX_STEPS, run, sample
from hophoop.kernel.compliant.motion import RTOL, chosen_in_si, compliance_of, load_contact
from hophoop.kernel.compliant.records import (
    FIRST,
    FLY,
    KIND,
    MODE,
    OM,
    REGIME,
    RESTING,
    REVOLUTIONS,
    SEGMENT,
    SIZE,
    STAGES,
    TH,
    VN,
    VT,
    WIDTH,
    X,
    Y,
)
