"""The codes of modes, events and ends: saved motions hold them as numbers, so that they can never change."""

import pytest

from hophoop.kernel.physics import body


@pytest.mark.parametrize(
    ("kind", "names"),
    [
        (body.Mode, "ROLL SPIN SKID FLIGHT SKIM"),
        (
            body.Event,
            "START SLIP_START STICK SLIP_REVERSAL TAKEOFF IMPACT TURN APEX BOUNCE_LIMIT PAINLEVE_INCONSISTENT "
            "PAINLEVE_INDETERMINATE JAM KANE_GAIN SKIM REST END",
        ),
        (body.Status, "COMPLETED AT_REST JAMMED UNDETERMINED EVENT_LIMIT BUFFER"),
        (body.ImpactLaw, "NEWTON POISSON STRONGE"),
    ],
)
def test_codes_stay_as_files_have_them(kind, names):
    assert [(member.name, int(member)) for member in kind] == [(name, code) for code, name in enumerate(names.split())]
