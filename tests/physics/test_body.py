"""The codes of modes, events and ends: saved motions hold them as numbers, so that they can never change."""

from hophoop.kernel.physics import body


def test_codes_stay_as_files_have_them():
    def codes(kind):
        return {member.name: int(member) for member in kind}

    assert codes(body.Mode) == {"ROLL": 0, "SPIN": 1, "SKID": 2, "FLIGHT": 3, "SKIM": 4}
    words = (
        "START SLIP_START STICK SLIP_REVERSAL TAKEOFF IMPACT TURN APEX BOUNCE_LIMIT PAINLEVE_INCONSISTENT "
        "PAINLEVE_INDETERMINATE JAM KANE_GAIN SKIM REST END"
    )
    assert codes(body.Event) == {word: code for code, word in enumerate(words.split())}
    words = "COMPLETED AT_REST JAMMED UNDETERMINED EVENT_LIMIT BUFFER"
    assert codes(body.Status) == {word: code for code, word in enumerate(words.split())}
    assert codes(body.ImpactLaw) == {"NEWTON": 0, "POISSON": 1, "STRONGE": 2}
    assert body.EVENT_NAMES[5] == "impact"


def test_what_a_body_is_where_nothing_is_said():
    """Its κ is what was given, and nothing resists its rolling."""
    given = body.Body(eps=0.5, kap=0.75, mu_s=1.0, mu_k=1.0, gn=1.0, gt=0.0, rest=0.0, law=2, painleve_impact=False, slope=0.0)
    assert (given.ideal, given.resist) == (False, 0.0)
