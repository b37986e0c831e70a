"""Claims about the hoop itself: massless, with mass in its rim, on a slope."""

from __future__ import annotations

from hophoop.article.statement import AGREES, DIFFERS
from hophoop.claims import numbers
from hophoop.claims.claim import NOT_READ, Claim

MASSLESS = (
    Claim(
        "littlewood_angle", "Littlewood1953",
        "A weightless hoop with a weight on its rim, started from the top, leaves the plane when it has turned by 90°.",
        "90°",
        "the contact force vanishes at", "90.000000", "°", AGREES,
        "The angle is right for the smallest push and for μ ≥ 1.",
        numbers.massless_loss_angle, 90.0, 1e-9,
    ),
    Claim(
        "littlewood_hop", "Littlewood1953",
        "From there it hops.",
        "hop",
        "the rim rises by", "0.000000", "m", DIFFERS,
        "Without a contact force the load falls freely. Nothing lifts the rim: it can only skim the plane, which keeps "
        "it clear of the ground without a force.",
        numbers.massless_height,
    ),
    Claim(
        "tokieda_angle", "Tokieda1997",
        "The geometry of the motion gives the same 90°.",
        "90°",
        "the computed motion loses contact at", "89.999994", "°", AGREES,
        "With 1 mm/s at the top; the 5.8·10⁻⁶° that are missing are v₀²/(gR).",
        numbers.massless_skim_angle, 90.0, 1e-4,
    ),
    Claim(
        "butler_massless", "Butler1999",
        "Hopping hoops do not hop (its title).",
        "no hop",
        "without mass in the rim there is no flight below", "3.132092", "m/s", AGREES,
        "√(gR); from there on the hoop has no contact force at the first instant.",
        numbers.massless_hop_speed,
    ),
    Claim(
        "butler_with_mass", "Butler1999",
        "The same, if it is read as a statement about hoops with mass in the rim.",
        "no hop",
        "the hoop with γ = 3/4 takes off at", "315.637202", "°", DIFFERS,
        "With 3.1 m/s and μ = 1. The rim's inertia lets it leave the plane out of slip.",
        numbers.take_off_angle,
    ),
    Claim(
        "theron_du_plessis_skim", "TheronDuPlessis2001",
        "After the loss of contact the massless hoop skims the plane.",
        "skims",
        "the rim rises by", "0.000000", "m", AGREES,
        "Skimming is an assumption that we share; the limit of ever lighter rims supports it up to 180°.",
        numbers.massless_height,
    ),
    Claim(
        "theron_du_plessis_fall", "TheronDuPlessis2001",
        "The skim lasts until the load strikes the plane.",
        "until 180°",
        "the load falls for", "0.233726", "s", AGREES,
        "A free fall from the height R with √(gR) downwards: (√3 − 1) √(R/g) = 0.233727 s from the smallest push.",
        numbers.massless_fall, 0.233727, 2e-6,
    ),
    Claim(
        "aglaev_skim", "AglaevKovaldzhi2024",
        "Skimming is not derived but wrongly postulated.",
        "no skim",
        "the load strikes the plane at", "180.000000", "°", DIFFERS,
        "That it is an added assumption is right. Rims of ever less mass come to it as far as 180°, for finite friction.",
        numbers.massless_strike,
    ),
)  # fmt: skip

WITH_MASS = (
    Claim(
        "pritchett_slip_first", "Pritchett1999",
        "The hoop must slip before it can become airborne.",
        "slip first",
        "before it takes off the hoop slips through", "81.332988", "°", AGREES,
        "The article's hoop at 3.1 m/s, which takes off out of slip.",
        numbers.slip_before_take_off,
    ),
    Claim(
        "pritchett_never_from_rolling", "Pritchett1999",
        "There is no take-off out of rolling.",
        "none",
        "the classes of the first revolution that take off out of rolling number", "0", "", AGREES,
        "Of all classes in the catalogue of 54 hoops. On a slope there are such jumps: see the jumping cylinder.",
        numbers.take_offs_out_of_rolling, 0.0, 0.0,
    ),
    Claim(
        "theron_rolling", "Theron2000",
        "Its subject: the rolling motion of an eccentrically loaded wheel.",
        "–",
        "the friction that γ = 3/4 needs to roll from the smallest push is", "0.377243", "", NOT_READ,
        "For whoever has the paper: our closed form gives this.",
        numbers.friction_from_rest,
    ),
    Claim(
        "liu_xue_rolling", "LiuXue2004",
        "Its subject: a qualitative analysis of a rolling hoop with mass unbalance.",
        "–",
        "the hoop with γ = 3/4 on μ = 1 slips from", "2.043174", "m/s", NOT_READ,
        "For whoever has the paper: this border of rolling is exact.",
        numbers.first_slip_speed,
    ),
    Claim(
        "taylor_fehrs_dynamics", "TaylorFehrs2010",
        "Its subject: the dynamics of an eccentrically loaded hoop.",
        "–",
        "the slip that ends in the article's hop begins at", "234.304215", "°", NOT_READ,
        "For whoever has the paper: one event of one motion.",
        numbers.over_rotation_angle,
    ),
    Claim(
        "theron_maritz_sequences", "TheronMaritz2008",
        "The hoop has thirty-six possible sequences of rolling and slipping.",
        "36",
        "for γ = 3/4 the sequences with their endings number", "39", "", DIFFERS,
        "A count is one at a width. Ours goes down to 10⁻¹⁴ of the window; without the three smallest it is 36.",
        numbers.sequences_with_endings, 36.0, 0.0,
    ),
    Claim(
        "theron_maritz_letters", "TheronMaritz2008",
        "The same, if only the phases count and not what ends the revolution.",
        "36",
        "for γ = 3/4 the sequences of phases number", "29", "", DIFFERS,
        "We have not had the list itself, so that which of the two is counted stays open.",
        numbers.sequences, 36.0, 0.0,
    ),
    Claim(
        "bronars_oreilly_jump", "BronarsOReilly2019",
        "With the rim's inertia in the model the hoop jumps by itself.",
        "jumps",
        "the hoop with γ = 3/4 on μ = 1 jumps from", "2.908160", "m/s", AGREES,
        "Bisected between a motion that takes off in its first turn and one that does not.",
        numbers.first_hop_speed,
    ),
    Claim(
        "aglaev_first_instant", "AglaevKovaldzhi2024",
        "On an absolutely rough plane the hoop hops at the first instant, under a condition on mass and speed.",
        "hop at once",
        "the hoop with γ = 3/4 hops at once from", "3.616628", "m/s", AGREES,
        "√(gR/γ). We have read the abstract only, which does not print the condition.",
        numbers.immediate_hop_speed,
    ),
)  # fmt: skip

ON_SLOPES = (
    Claim(
        "gomez_rolls_to_the_jump", "Gomez2012",
        "The cylinder with a rod rolls without slipping down to where it jumps.",
        "no slip",
        "a cylinder of the kind on 30°, μ = 1, slips first at", "57.753577", "°", DIFFERS,
        "Its masses are not known to us; ours has three quarters in the rod. Rolling uses up the friction before N vanishes.",
        numbers.cylinder_slip_angle,
    ),
    Claim(
        "gomez_jump", "Gomez2012",
        "It loses contact with the ramp.",
        "jumps",
        "the same cylinder takes off at", "297.331838", "°", AGREES,
        "Out of slip. The films agree well with the calculation of the authors, as they report.",
        numbers.cylinder_jump_angle,
    ),
    Claim(
        "gomez_force", "Gomez2012",
        "Where it jumps follows from its equation of motion in rolling (as we read the abstract).",
        "from rolling",
        "if the same cylinder could only roll, N would vanish at", "69.618430", "°", DIFFERS,
        "There the free rim would sink, so that it cannot jump: this is a quasi-jump.",
        numbers.cylinder_force_lost_angle,
    ),
)  # fmt: skip
