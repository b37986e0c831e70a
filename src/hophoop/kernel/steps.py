"""Panels and steps of a rigid motion: what other packages call, differentiate, or run over numbers of another kind."""

from hophoop.kernel.panels.anchor import (
    NONE,
    has_equilibria,
    rolling_anchor,
    rolling_panel_start,
    rolling_stable_equilibrium,
    rolling_unstable_equilibrium,
)
from hophoop.kernel.panels.landing import Flight, downcrossing_between, landing_time_bound, moment_of
from hophoop.kernel.panels.panel import (
    ARM,
    ARRIVE,
    COSINE,
    DRIVEN,
    FLY,
    GROWTH,
    HOLD,
    KAPPA_P_SIGMA,
    LEAVE,
    LINEAR,
    OFFSET_SINE,
    OFFSET_VERSINE,
    RATE,
    RESOLVED,
    SINE,
    SKIMMING,
    STRETCH,
    TIME,
    Totals,
    U,
    angle_at,
    fill_inside,
    from_reference,
    no_panel,
    sine_versine_of_offset,
)
from hophoop.kernel.rigid.contact_phase import (
    contact_step,
    equilibrium_is_stable,
    state_on_panel,
    state_without_rotation,
    vanishing_slip_derivatives,
)
from hophoop.kernel.rigid.flight_phase import flight_start, fly, land
from hophoop.kernel.rigid.panel_choice import solve, solve_noinline
from hophoop.kernel.rigid.phase import (
    GOING,
    ROUNDING,
    Ending,
    Limits,
    Phase,
    continue_phase,
    end_motion,
    limits_of,
)
from hophoop.kernel.rigid.run import BY_RULE, begin, can_follow, run, step
from hophoop.kernel.rigid.sampling import (
    MARGINS,
    margins_of,
    sample,
    state_in_flight,
    state_in_skim,
    xi_at_time,
)
from hophoop.kernel.rigid.transitions import collide
