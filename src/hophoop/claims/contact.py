"""Claims about rigid contact with friction: detachment, Painlevé's paradox, impacts."""

from __future__ import annotations

from hophoop.article.statement import AGREES
from hophoop.claims import numbers
from hophoop.claims.claim import Claim

DETACHMENT = (
    Claim(
        "ivanov_force", "Ivanov2008",
        "With friction the sign of the contact force and the possibility of detachment can part.",
        "can differ",
        "on infinite friction, from 3.1 m/s, N vanishes at", "71.615952", "°", AGREES,
        "The next row has the other condition at the same place.",
        numbers.quasi_jump_angle,
    ),
    Claim(
        "ivanov_detachment", "Ivanov2008",
        "Looking at the force alone can lead to wrong conclusions.",
        "can differ",
        "there the free contact point would accelerate by", "-5.629421", "m/s²", AGREES,
        "Negative means into the plane: the force is gone, and yet the rim cannot leave.",
        numbers.quasi_jump_free_acceleration,
    ),
    Claim(
        "aglaev_quasi_jump", "AglaevKovaldzhi2024",
        "A rigid hoop on an absolutely rough plane leads to a contradiction, the quasi-jump.",
        "contradiction",
        "γ = 3/4 meets it from", "3.075135", "m/s", AGREES,
        "From there on rolling would need the plane to pull. The motion ends with the status undetermined.",
        numbers.force_lost_speed,
    ),
)  # fmt: skip

PARADOX = (
    Claim(
        "painleve_threshold", "Painleve1895",
        "With enough sliding friction the rigid laws have no solution, or several.",
        "a least friction",
        "for γ = 3/4 this begins at a friction of", "0.881917", "", AGREES,
        "√(1 − γ²)/γ, at cos θ = γ. His example is a rod; the law is the same.",
        numbers.painleve_friction,
    ),
    Claim(
        "genot_brogliato_jam", "GenotBrogliato1999",
        "Sliding can run into a singular point, near which the contact force may grow without bound.",
        "singular point",
        "a thrown hoop (γ = 0.85, μ = 0.8, 8.9 m/s) jams at", "298.072487", "°", AGREES,
        "The motion comes to the point that p_σ = 0 and f_n = 0 give, in the next row.",
        numbers.jam_angle,
    ),
    Claim(
        "genot_brogliato_point", "GenotBrogliato1999",
        "The singular point is where both numerator and denominator of the force vanish.",
        "singular point",
        "theory has it at", "298.072487", "°", AGREES,
        "Without any motion.",
        numbers.jam_angle_of_theory,
    ),
    Claim(
        "hogan_kristiansen_impact", "HoganKristiansen2017",
        "A stiff compliant contact recovers the impact without collision.",
        "a finite impulse",
        "just above the threshold (θ = −0.7, v_t = 2 m/s) its impulse is", "0.483163", "N s", AGREES,
        "The page on compliant contact has the limit with springs.",
        numbers.impulse_without_collision,
    ),
    Claim(
        "champneys_varkonyi_limit", "ChampneysVarkonyi2016",
        "With impact without collision allowed, inconsistent states are resolved.",
        "resolved",
        "slip just below the threshold takes an impulse of", "0.483164", "N s", AGREES,
        "Ordinary slip, 10⁻⁶ below the threshold, tends to the impulse of the impact without collision.",
        numbers.impulse_of_slip,
    ),
)  # fmt: skip

IMPACTS = (
    Claim(
        "routh_reversal", "Routh1877",
        "Friction in an impact follows Coulomb's law along the impulse: slip can stop and reverse.",
        "reverses",
        "μ = 1/8 turns a slip of −1 m/s, by the end of a plastic blow, into", "1.185567", "m/s", AGREES,
        "By hand: slip stops at p = 1/2 and grows at 2/3 up to p = 221/97, so 115/97 m/s.",
        numbers.routh_reversal, 115.0 / 97.0, 1e-12,
    ),
    Claim(
        "kane_gain", "Kane1984",
        "Newton's law of restitution with friction can create energy.",
        "creates",
        "a blow of 5 J with e = 1 and μ = 1/2 gains", "0.573661", "J", AGREES,
        "By hand 257/448 J.",
        numbers.kane_gain, 257.0 / 448.0, 1e-12,
    ),
    Claim(
        "stronge_separation", "Stronge2000",
        "Restitution by the work of the normal force is consistent with energy.",
        "e² of the work",
        "after the same blow the rim parts with", "2.762211", "m/s", AGREES,
        "By hand √20631/52 m/s; Newton's law gives 3 m/s.",
        numbers.stronge_separation, 20631.0**0.5 / 52.0, 1e-12,
    ),
    Claim(
        "stronge_no_gain", "Stronge2000",
        "The normal direction never gives back more than it took.",
        "no gain",
        "with e = 1 the normal direction loses", "0.000000", "J", AGREES,
        "All that the blow loses goes to friction.",
        numbers.stronge_normal_loss, 0.0, 1e-12,
    ),
)  # fmt: skip
