"""Why changes of the phases and transitions of `hophoop.kernel.rigid` cannot be seen."""

# fmt: off
REASONS: dict[str, tuple[tuple[str, str, str, str], ...]] = {
    "the start is an event: none is never their number": (
        ("run", "run", "count = log.counts[EVENTS] if log.counts[EVENTS] >= 0 else events.shape[0]", "count = log.counts[EVENTS] if log.counts[EVENTS] > 0 else events.shape[0]"),
        ("run", "run", "count = log.counts[EVENTS] if log.counts[EVENTS] >= 0 else events.shape[0]", "count = log.counts[EVENTS] if log.counts[EVENTS] >= 1 else events.shape[0]"),
    ),
    "nothing asks for the turning points or the bounces of a phase that is filled in": (
        ("script", "fill_phase", "limits = limits_of(state, until, math.nan, 0)", "limits = limits_of(state, until, math.nan, 1)"),
        ("script", "fill_phase", "limits = limits_of(state, until, math.nan, 0)", "limits = limits_of(state, until, math.nan, -1)"),
        ("script", "fill_phase", "phase = entered(body, mode, state, 0.0, Ending.CONTINUES, scratch)", "phase = entered(body, mode, state, 1.0, Ending.CONTINUES, scratch)"),
        ("script", "fill_phase", "phase = entered(body, mode, state, 0.0, Ending.CONTINUES, scratch)", "phase = entered(body, mode, state, -1.0, Ending.CONTINUES, scratch)"),
    ),
    "a script has one dimension": (
        ("script", "fill_script", "for row in range(script.shape[0] - 1):", "for row in range(script.shape[ -1] - 1):"),
        ("script", "repeat", "last = script.shape[0] - 1", "last = script.shape[ -1] - 1"),
    ),
    "the hoop without mass in its rim has impacts of its own": (
        ("transitions", "collide", "if state.vn == 0.0 and state.vt != 0.0 and body.kap > 0.0 and not math.isinf(body.mu_k):", "if state.vn == 0.0 and state.vt != 0.0 and body.kap >= 0.0 and not math.isinf(body.mu_k):"),
        ("transitions", "collide", "if state.vn == 0.0 and state.vt != 0.0 and body.kap > 0.0 and not math.isinf(body.mu_k):", "if state.vn == 0.0 and state.vt != 0.0 and body.kap > -1.0 and not math.isinf(body.mu_k):"),
    ),
    "an impact with a collision, and one without friction's limit, reads no p_σ": (
        ("transitions", "collide", "if state.vn == 0.0 and state.vt != 0.0 and body.kap > 0.0 and not math.isinf(body.mu_k):", "if state.vn == 0.0 and state.vt != 0.0 or body.kap > 0.0 and not math.isinf(body.mu_k):"),
        ("transitions", "collide", "if state.vn == 0.0 and state.vt != 0.0 and body.kap > 0.0 and not math.isinf(body.mu_k):", "if state.vn == 0.0 and state.vt != 0.0 and body.kap > 0.0 or not math.isinf(body.mu_k):"),
    ),
    "a tolerance of rounding: losses that cancel are of one size": (
        ("transitions", "collide", "if gain <= GAIN_FLOOR * (abs(loss_n) + abs(loss_t) + state.vn * state.vn):", "if gain <= GAIN_FLOOR * (abs(loss_n) - abs(loss_t) + state.vn * state.vn):"),
    ),
    "the paradoxes in a row are fewer than this": (
        ("transitions", "settle", "for _ in range(8):", "for _ in range( 9):"),
    ),
    "the mode rule never answers with skimming": (
        ("transitions", "settle", "if mode > SKIM:", "if mode >= SKIM:"),
        ("transitions", "settle", "if mode <= SKIM or mode == UNDECIDED:", "if mode < SKIM or mode == UNDECIDED:"),
    ),
    "the case of no slip is asked for before": (
        ("transitions", "settle", "named = ROLL if state.vt == 0.0 else slip_mode(1 if state.vt > 0.0 else -1)", "named = ROLL if state.vt == 0.0 else slip_mode(1 if state.vt >= 0.0 else -1)"),
    ),
    "only whether a direction is above 0 is asked": (
        ("transitions", "settle", "named = ROLL if state.vt == 0.0 else slip_mode(1 if state.vt > 0.0 else -1)", "named = ROLL if state.vt == 0.0 else slip_mode( 2 if state.vt > 0.0 else -1)"),
        ("transitions", "settle", "named = ROLL if state.vt == 0.0 else slip_mode(1 if state.vt > 0.0 else -1)", "named = ROLL if state.vt == 0.0 else slip_mode(1 if state.vt > 0.0 else - 2)"),
        ("transitions", "settle", "named = ROLL if state.vt == 0.0 else slip_mode(1 if state.vt > 0.0 else -1)", "named = ROLL if state.vt == 0.0 else slip_mode(1 if state.vt > 0.0 else - 0)"),
        ("transitions", "leave_cone", "mode = slip_mode(-1 if ahead else 1)", "mode = slip_mode(- 2 if ahead else 1)"),
        ("transitions", "leave_cone", "mode = slip_mode(-1 if ahead else 1)", "mode = slip_mode(- 0 if ahead else 1)"),
        ("transitions", "leave_cone", "mode = slip_mode(-1 if ahead else 1)", "mode = slip_mode(-1 if ahead else 2)"),
    ),
    "nothing reads the gain of a jam": (
        ("transitions", "pass_singular", "cause = Cause(JAM, mode, state.vt, state.vn, state.om, p_n, p_t, 0.0, -1)", "cause = Cause(JAM, mode, state.vt, state.vn, state.om, p_n, p_t, 1.0, -1)"),
        ("transitions", "pass_singular", "cause = Cause(JAM, mode, state.vt, state.vn, state.om, p_n, p_t, 0.0, -1)", "cause = Cause(JAM, mode, state.vt, state.vn, state.om, p_n, p_t, -1.0, -1)"),
    ),
    "a gain is written where it is above 0": (
        ("transitions", "pass_singular", "cause = Cause(IMPACT, mode, state.vt, state.vn, state.om, p_n, p_t, 0.0, 0)", "cause = Cause(IMPACT, mode, state.vt, state.vn, state.om, p_n, p_t, -1.0, 0)"),
    ),
    "the equality of two rounded numbers beside a tolerance": (
        ("transitions", "leave_cone", "if abs(opens) <= CLOSE * (body.gn + u) and not math.isinf(body.mu_s):", "if abs(opens) < CLOSE * (body.gn + u) and not math.isinf(body.mu_s):"),
    ),
    "a piece in which the rim skims has no direction of slip, no place within a panel and no acceleration at its start": (
        ("massless_phase", "skim", "write_segment(log, SKIM, no_panel(SKIMMING, 0, way), 0.0, 0.0, state, state.t + tau)", "write_segment(log, SKIM, no_panel(SKIMMING, 1, way), 0.0, 0.0, state, state.t + tau)"),
        ("massless_phase", "skim", "write_segment(log, SKIM, no_panel(SKIMMING, 0, way), 0.0, 0.0, state, state.t + tau)", "write_segment(log, SKIM, no_panel(SKIMMING, -1, way), 0.0, 0.0, state, state.t + tau)"),
        ("massless_phase", "skim", "write_segment(log, SKIM, no_panel(SKIMMING, 0, way), 0.0, 0.0, state, state.t + tau)", "write_segment(log, SKIM, no_panel(SKIMMING, 0, way), 1.0, 0.0, state, state.t + tau)"),
        ("massless_phase", "skim", "write_segment(log, SKIM, no_panel(SKIMMING, 0, way), 0.0, 0.0, state, state.t + tau)", "write_segment(log, SKIM, no_panel(SKIMMING, 0, way), -1.0, 0.0, state, state.t + tau)"),
        ("massless_phase", "skim", "write_segment(log, SKIM, no_panel(SKIMMING, 0, way), 0.0, 0.0, state, state.t + tau)", "write_segment(log, SKIM, no_panel(SKIMMING, 0, way), 0.0, 1.0, state, state.t + tau)"),
        ("massless_phase", "skim", "write_segment(log, SKIM, no_panel(SKIMMING, 0, way), 0.0, 0.0, state, state.t + tau)", "write_segment(log, SKIM, no_panel(SKIMMING, 0, way), 0.0, -1.0, state, state.t + tau)"),
    ),
    "a flight of no length has no panel, and its acceleration no time to act": (
        ("massless_phase", "skim_step", "write_segment(log, mode, no_panel(FLY, 0, 0.0), 0.0, 0.0, landed, landed.t)", "write_segment(log, mode, no_panel(FLY, -1, 0.0), 0.0, 0.0, landed, landed.t)"),
        ("massless_phase", "skim_step", "write_segment(log, mode, no_panel(FLY, 0, 0.0), 0.0, 0.0, landed, landed.t)", "write_segment(log, mode, no_panel(FLY, 0, -1.0), 0.0, 0.0, landed, landed.t)"),
        ("massless_phase", "skim_step", "write_segment(log, mode, no_panel(FLY, 0, 0.0), 0.0, 0.0, landed, landed.t)", "write_segment(log, mode, no_panel(FLY, 0, 0.0), 0.0, 1.0, landed, landed.t)"),
        ("massless_phase", "skim_step", "write_segment(log, mode, no_panel(FLY, 0, 0.0), 0.0, 0.0, landed, landed.t)", "write_segment(log, mode, no_panel(FLY, 0, 0.0), 0.0, -1.0, landed, landed.t)"),
    ),
    "the sine is 0 at the top alone, where the cosine is 1: there a load at rest stays, or gets the rate of its fall": (
        ("massless_phase", "let_go", "if not (s * state.om > 0.0 or (state.om == 0.0 and s != 0.0) or math.cos(state.th) == 1.0):", "if not (s * state.om >= 0.0 or (state.om == 0.0 and s != 0.0) or math.cos(state.th) == 1.0):"),
        ("massless_phase", "skim", "way = 1.0 if state.om > 0.0 or (state.om == 0.0 and math.sin(state.th) > 0.0) else -1.0", "way = 1.0 if state.om > 0.0 or (state.om == 0.0 and math.sin(state.th) >= 0.0) else -1.0"),
    ),
    "the way of the load is 1 or −1": (
        ("massless_phase", "skim", "th = math.pi * (2.0 * math.floor(0.5 * state.th / math.pi + (0.0 if way > 0 else -1e-12)) + 1.0)", "th = math.pi * (2.0 * math.floor(0.5 * state.th / math.pi + (0.0 if way >= 0 else -1e-12)) + 1.0)"),
        ("massless_phase", "skim", "th = math.pi * (2.0 * math.floor(0.5 * state.th / math.pi + (0.0 if way > 0 else -1e-12)) + 1.0)", "th = math.pi * (2.0 * math.floor(0.5 * state.th / math.pi + (0.0 if way > -1 else -1e-12)) + 1.0)"),
    ),
    "an event takes its gain from another argument": (
        ("massless_phase", "skim_step", "cause = Cause(IMPACT, SKIM, after.vt, vn, math.nan, p_n, p_t, 0.0, 1)", "cause = Cause(IMPACT, SKIM, after.vt, vn, math.nan, p_n, p_t, 1.0, 1)"),
        ("massless_phase", "skim_step", "cause = Cause(IMPACT, SKIM, after.vt, vn, math.nan, p_n, p_t, 0.0, 1)", "cause = Cause(IMPACT, SKIM, after.vt, vn, math.nan, p_n, p_t, -1.0, 1)"),
    ),
    "only the sign of a direction counts, and a load that is not stopped has a speed": (
        ("massless_phase", "skim_step", "mode = ROLL if along == 0.0 else slip_mode(1 if along > 0.0 else -1)", "mode = ROLL if along == 0.0 else slip_mode(1 if along >= 0.0 else -1)"),
        ("massless_phase", "skim_step", "mode = ROLL if along == 0.0 else slip_mode(1 if along > 0.0 else -1)", "mode = ROLL if along == 0.0 else slip_mode( 2 if along > 0.0 else -1)"),
        ("massless_phase", "skim_step", "mode = ROLL if along == 0.0 else slip_mode(1 if along > 0.0 else -1)", "mode = ROLL if along == 0.0 else slip_mode(1 if along > 0.0 else - 2)"),
        ("massless_phase", "skim_step", "mode = ROLL if along == 0.0 else slip_mode(1 if along > 0.0 else -1)", "mode = ROLL if along == 0.0 else slip_mode(1 if along > 0.0 else - 0)"),
    ),
    "SPIN is the slip whose direction is not above 0": (
        ("run", "begin_massless", "mode = slip_mode(1 if state.vt > 0.0 else -1)", "mode = slip_mode(1 if state.vt > 0.0 else - 0)"),
    ),
    "the rim on the plane is put there, or a height or speed is just at a bound that is some number": (
        ("run", "begin", "if 0.0 < state.y < LOWEST_START:", "if 0.0 <= state.y < LOWEST_START:"),
        ("run", "begin", "if 0.0 < state.y < LOWEST_START:", "if 0.0 < state.y <= LOWEST_START:"),
        ("run", "begin", "if body.resist > 0.0 and state.om * state.om < SMALLEST_SQUARE:  # as the phase will have it: the couple depends on it", "if body.resist > 0.0 and state.om * state.om <= SMALLEST_SQUARE: # as the phase will have it: the couple depends on it"),
    ),
    "a start on the plane comes here only if v_n is not 0": (
        ("run", "begin", "if state.y == 0.0 and state.vn < 0.0:", "if state.y == 0.0 and state.vn <= 0.0:"),
    ),
    "no bounce was before, and 0 and less mean that": (
        ("run", "begin", "return land(body, state, 0.0, log, scratch)", "return land(body, state, -1.0, log, scratch)"),
    ),
    "a script has two rows or none, as its last state stands there again": (
        ("run", "run", "if script.shape[0] > 1:", "if script.shape[0] >= 1:"),
    ),
    "a motion has its first event, so that the number of events is 1 or more, or −1; a full table takes no end": (
        ("run", "run", "if log.counts[EVENTS] >= 0 and log.counts[SEGMENTS] >= 0:  # also where the panels are used up: so far it has come", "if log.counts[EVENTS] > 0 and log.counts[SEGMENTS] >= 0: # also where the panels are used up: so far it has come"),
        ("run", "run", "if log.counts[EVENTS] >= 0 and log.counts[SEGMENTS] >= 0:  # also where the panels are used up: so far it has come", "if log.counts[ 1] >= 0 and log.counts[SEGMENTS] >= 0: # also where the panels are used up: so far it has come"),
        ("run", "run", "if log.counts[EVENTS] >= 0 and log.counts[SEGMENTS] >= 0:  # also where the panels are used up: so far it has come", "if log.counts[ -1] >= 0 and log.counts[SEGMENTS] >= 0: # also where the panels are used up: so far it has come"),
        ("run", "run", "if log.counts[EVENTS] >= 0 and log.counts[SEGMENTS] >= 0:  # also where the panels are used up: so far it has come", "if log.counts[EVENTS] >= 1 and log.counts[SEGMENTS] >= 0: # also where the panels are used up: so far it has come"),
        ("run", "run", "if log.counts[EVENTS] >= 0 and log.counts[SEGMENTS] >= 0:  # also where the panels are used up: so far it has come", "if log.counts[EVENTS] >= -1 and log.counts[SEGMENTS] >= 0: # also where the panels are used up: so far it has come"),
        ("run", "run", "if log.counts[EVENTS] < 0:", "if log.counts[EVENTS] <= 0:"),
        ("run", "run", "if log.counts[EVENTS] < 0:", "if log.counts[EVENTS] < 1:"),
    ),
    "a table of events has one axis, which is its first and its last": (
        ("run", "run", "count = log.counts[EVENTS] if log.counts[EVENTS] >= 0 else events.shape[0]", "count = log.counts[EVENTS] if log.counts[EVENTS] >= 0 else events.shape[ -1]"),
    ),
    "the equality of two rounded numbers beside a limit that may be another by as much": (
        ("contact_phase", "advance_contact", "if sigma != 0 and panel.kind == LINEAR and abs(panel.u - state.om * state.om) > LOST * panel.u:", "if sigma != 0 and panel.kind == LINEAR and abs(panel.u - state.om * state.om) >= LOST * panel.u:"),
    ),
    "from which angle on a flight counts as blurred may be another by a rad, or by none": (
        ("flight_phase", "", "BLURRED = 1e9", "BLURRED = 1000000001.0"),
        ("flight_phase", "", "BLURRED = 1e9", "BLURRED = 999999999.0"),
        ("flight_phase", "highest", "if abs(state.om * apex) < BLURRED:", "if abs(state.om * apex) <= BLURRED:"),
        ("flight_phase", "fly", "after = with_velocities(after, vt, 0.0, state.om) if abs(state.om * tau) < BLURRED else approaching(body, after)", "after = with_velocities(after, vt, 0.0, state.om) if abs(state.om * tau) <= BLURRED else approaching(body, after)"),
    ),
    "a landing without any speed is the same either way": (
        ("flight_phase", "fly", "if what == Ending.LANDING and vn > 0.0:", "if what == Ending.LANDING and vn >= 0.0:"),
    ),
    "without rotation the way to turn is not asked for": (
        ("flight_phase", "fly", "way = 1.0 if state.om > 0.0 else -1.0", "way = 1.0 if state.om >= 0.0 else -1.0"),
    ),
    "an apex is −1 where there is none, or above 0": (
        ("flight_phase", "fly", "if 0.0 < apex < tau:", "if 0.0 <= apex < tau:"),
        ("flight_phase", "fly", "if 0.0 < apex < tau:", "if -1.0 < apex < tau:"),
    ),
    "a piece of flight has no direction of slip, no way and no place within a panel": (
        ("flight_phase", "fly", "write_segment(log, FLIGHT, no_panel(FLY, 0, 0.0), 0.0, opening, state, after.t)", "write_segment(log, FLIGHT, no_panel(FLY, -1, 0.0), 0.0, opening, state, after.t)"),
        ("flight_phase", "fly", "write_segment(log, FLIGHT, no_panel(FLY, 0, 0.0), 0.0, opening, state, after.t)", "write_segment(log, FLIGHT, no_panel(FLY, 0, 1.0), 0.0, opening, state, after.t)"),
        ("flight_phase", "fly", "write_segment(log, FLIGHT, no_panel(FLY, 0, 0.0), 0.0, opening, state, after.t)", "write_segment(log, FLIGHT, no_panel(FLY, 0, 0.0), -1.0, opening, state, after.t)"),
    ),
    "a bounce just at a bound that is some number": (
        ("flight_phase", "is_last_bounce", "if after.vn < SLOWEST_BOUNCE:", "if after.vn <= SLOWEST_BOUNCE:"),
        ("flight_phase", "is_last_bounce", "return 2.0 * after.vn / (fall * (1.0 - ratio)) < CLOSING * max(state.t, 1.0)", "return 2.0 * after.vn / (fall * (1.0 - ratio)) <= CLOSING * max(state.t, 1.0)"),
    ),
    "a double beside whole turns is away from them by some units of its last place, and never by just the bound": (
        ("limits", "limits_of", "if abs(rest) <= 4e-16 * span:", "if abs(rest) < 4e-16 * span:"),
    ),
    "without a limit μ N is infinite where N is above 0, and N is not 0 there": (
        ("margins", "margins_of", "limit = math.inf if math.isinf(mu) and normal > 0.0 else mu * normal", "limit = math.inf if math.isinf(mu) and normal >= 0.0 else mu * normal"),
        ("margins", "margins_of", "limit = math.inf if math.isinf(mu) and normal > 0.0 else mu * normal", "limit = math.inf if math.isinf(mu) and normal > 1.0 else mu * normal"),
    ),
    "a number that a piece of this kind does not have, and nothing reads": (
        ("massless_phase", "skim_step", "write_segment(log, mode, no_panel(FLY, 0, 0.0), 0.0, 0.0, landed, landed.t)", "write_segment(log, mode, no_panel(FLY, 0, 0.0), -1.0, 0.0, landed, landed.t)"),
        ("flight_phase", "fly", "write_segment(log, FLIGHT, no_panel(FLY, 0, 0.0), 0.0, opening, state, after.t)", "write_segment(log, FLIGHT, no_panel(FLY, 1, 0.0), 0.0, opening, state, after.t)"),
        ("contact_phase", "still_step", "write_segment(log, ROLL, no_panel(HOLD, 0, 0.0), 0.0, 0.0, state, limits.t_end)", "write_segment(log, ROLL, no_panel(HOLD, 0, -1.0), 0.0, 0.0, state, limits.t_end)"),
        ("contact_phase", "advance_contact", "write_segment(log, mode, panel, xi, 0.0, state, after.t)", "write_segment(log, mode, panel, xi, 1.0, state, after.t)"),
        ("sampling", "sample", "now = moved(state, times[k], 0.0, x, x_low, 0.0, state.turns, state.th, state.th_low)", "now = moved(state, times[k], 1.0, x, x_low, 0.0, state.turns, state.th, state.th_low)"),
        ("massless_phase", "skim_step", "write_segment(log, mode, no_panel(FLY, 0, 0.0), 0.0, 0.0, landed, landed.t)", "write_segment(log, mode, no_panel(FLY, 0, 0.0), 1.0, 0.0, landed, landed.t)"),
        ("massless_phase", "skim_step", "write_segment(log, mode, no_panel(FLY, 0, 0.0), 0.0, 0.0, landed, landed.t)", "write_segment(log, mode, no_panel(FLY, 0, 1.0), 0.0, 0.0, landed, landed.t)"),
        ("massless_phase", "skim_step", "write_segment(log, mode, no_panel(FLY, 0, 0.0), 0.0, 0.0, landed, landed.t)", "write_segment(log, mode, no_panel(FLY, 1, 0.0), 0.0, 0.0, landed, landed.t)"),
        ("flight_phase", "fly", "write_segment(log, FLIGHT, no_panel(FLY, 0, 0.0), 0.0, opening, state, after.t)", "write_segment(log, FLIGHT, no_panel(FLY, 0, 0.0), 1.0, opening, state, after.t)"),
        ("flight_phase", "fly", "write_segment(log, FLIGHT, no_panel(FLY, 0, 0.0), 0.0, opening, state, after.t)", "write_segment(log, FLIGHT, no_panel(FLY, 0, -1.0), 0.0, opening, state, after.t)"),
    ),
    "where slip has p_σ < 0 it does not go on": (
        ("contact_phase", "is_still", "if firm > 0.0:", "if firm > -1.0:"),
    ),
    "what is written over": (
        ("errors", "_again", "body, start_state(0.0, 0.0, 0.0, 0.0, 0.0, 0.0), t_end, math.nan, 0, events, np.empty(0, SEGMENT),", "body, start_state(0.0, 0.0, 0.0, 0.0, -1.0, 0.0), t_end, math.nan, 0, events, np.empty(0, SEGMENT),"),
        ("errors", "_again", "body, start_state(0.0, 0.0, 0.0, 0.0, 0.0, 0.0), t_end, math.nan, 0, events, np.empty(0, SEGMENT),", "body, start_state(0.0, 0.0, 0.0, -1.0, 0.0, 0.0), t_end, math.nan, 0, events, np.empty(0, SEGMENT),"),
        ("errors", "_again", "body, start_state(0.0, 0.0, 0.0, 0.0, 0.0, 0.0), t_end, math.nan, 0, events, np.empty(0, SEGMENT),", "body, start_state(0.0, 0.0, 0.0, 0.0, 0.0, 1.0), t_end, math.nan, 0, events, np.empty(0, SEGMENT),"),
        ("errors", "_again", "body, start_state(0.0, 0.0, 0.0, 0.0, 0.0, 0.0), t_end, math.nan, 0, events, np.empty(0, SEGMENT),", "body, start_state(0.0, 0.0, 0.0, 0.0, 1.0, 0.0), t_end, math.nan, 0, events, np.empty(0, SEGMENT),"),
        ("run", "begin", "if 0.0 < state.y < LOWEST_START:", "if -1.0 < state.y < LOWEST_START:"),
        ("doubts", "grazes_zero", "for k in range(ORDER - 1, 0, -1):", "for k in range(ORDER - 1, -1, -1):"),
    ),
    "where the arrays were too short the motion is computed again": (
        ("errors", "event_errors", "plain = _again(body, row, t_end, 2 * count + 8)", "plain = _again(body, row, t_end, 3 * count + 8)"),
        ("errors", "event_errors", "plain = _again(body, row, t_end, 2 * count + 8)", "plain = _again(body, row, t_end, 2 * count + 9)"),
    ),
    "a script has two rows or none": (
        ("run", "run", "if script.shape[0] > 1:", "if script.shape[0] > 0:"),
    ),
    "a direction is 1 or −1": (
        ("massless_phase", "skim", "th = math.pi * (2.0 * math.floor(0.5 * state.th / math.pi + (0.0 if way > 0 else -1e-12)) + 1.0)", "th = math.pi / (2.0 * math.floor(0.5 * state.th / math.pi + (0.0 if way > 0 else -1e-12)) + 1.0)"),
        ("panel_choice", "levels_away", "if slope * way <= 0.0 or begin.stiffness <= 0.0:", "if slope / way <= 0.0 or begin.stiffness <= 0.0:"),
    ),
    "nothing is smaller than a couple of zero": (
        ("contact_phase", "equilibrium_is_stable", "if body.resist > 0.0 and abs(torque_at_rest(body, s, c)) < body.resist * body.gn:", "if body.resist > -1.0 and abs(torque_at_rest(body, s, c)) < body.resist * body.gn:"),
    ),
    "the last event of a script stands there twice": (
        ("script", "repeat", 'if script[last - 1]["kind"] == SLIP_START:', 'if script[last - 0]["kind"] == SLIP_START:'),
    ),
    "only an impact without collision reads p_σ": (
        ("transitions", "collide", "if state.vn == 0.0 and state.vt != 0.0 and body.kap > 0.0 and not math.isinf(body.mu_k):", "if state.vn == 0.0 or state.vt != 0.0 and body.kap > 0.0 and not math.isinf(body.mu_k):"),
    ),
    "θ is counted anew where it is nearly a turn away from 0": (
        ("contact_phase", "counted", "way = 1.0 if state.th > 0.0 else -1.0", "way = 1.0 if state.th >= 0.0 else -1.0"),
        ("contact_phase", "counted", "way = 1.0 if state.th > 0.0 else -1.0", "way = 1.0 if state.th > 1.0 else -1.0"),
        ("contact_phase", "counted", "way = 1.0 if state.th > 0.0 else -1.0", "way = 1.0 if state.th > -1.0 else -1.0"),
    ),
    "an equilibrium that is passed has B = 0 only where there is none": (
        ("contact_phase", "counted", "if anchor.kind == ROLLING and anchor.bend > 0.0:  # the hilltop of the next turn, which is lower on a slope", "if anchor.kind == ROLLING and anchor.bend >= 0.0: # the hilltop of the next turn, which is lower on a slope"),
        ("contact_phase", "is_still", "if anchor.kind != 0 and anchor.bend > 0.0:", "if anchor.kind != 0 and anchor.bend >= 0.0:"),
        ("contact_phase", "is_still", "if anchor.kind != 0 and anchor.bend > 0.0:", "if anchor.kind != -1 and anchor.bend > 0.0:"),
    ),
    "a direction of motion is 1 or −1": (
        ("contact_phase", "counted", "excess = anchor.excess + 2.0 * way * TWO_PI * body.gt", "excess = anchor.excess + 2.0 / way * TWO_PI * body.gt"),
    ),
    "the equality of two rounded numbers in a phase: either side is as good": (
        ("contact_phase", "is_still", "return abs(psi) < (1e-280 if anchor.base == 0.0 else 1e-30)", "return abs(psi) <= (1e-280 if anchor.base == 0.0 else 1e-30)"),
        ("contact_phase", "advance_contact", "if state.om != 0.0 and state.om * state.om < SMALLEST_SQUARE:", "if state.om != 0.0 and state.om * state.om <= SMALLEST_SQUARE:"),
        ("contact_phase", "advance_contact", "if abs(after.th) > FARTHEST:", "if abs(after.th) >= FARTHEST:"),
    ),
    "where p_σ = 0 exactly there is no finite acceleration, with which it could stay": (
        ("contact_phase", "is_still", "if firm > 0.0:", "if firm >= 0.0:"),
    ),
    "θ̇² of rolling without resistance from the panel's numbers or from its nodes: both hold": (
        ("contact_phase", "state_on_panel", "if body.resist > 0.0:", "if body.resist >= 0.0:"),
        ("contact_phase", "state_on_panel", "if body.resist > 0.0:", "if body.resist > -1.0:"),
    ),
    "a θ̇² below zero is taken as zero": (
        ("contact_phase", "state_on_panel", "u = 0.0 if panel.kind == ARRIVE else totals.u", "u = -1.0 if panel.kind == ARRIVE else totals.u"),
    ),
    "θ̇² inside a solved panel is above zero": (
        ("contact_phase", "state_on_panel", "om = panel.way * math.sqrt(max(u, 0.0))", "om = panel.way * math.sqrt(max(u, -1.0))"),
    ),
    "θ̇ = 0 is set to 0, and a θ̇ of 1 or −1 is not small": (
        ("contact_phase", "advance_contact", "if state.om != 0.0 and state.om * state.om < SMALLEST_SQUARE:", "if state.om != 1.0 and state.om * state.om < SMALLEST_SQUARE:"),
        ("contact_phase", "advance_contact", "if state.om != 0.0 and state.om * state.om < SMALLEST_SQUARE:", "if state.om != -1.0 and state.om * state.om < SMALLEST_SQUARE:"),
    ),
    "which width is tried next; that it does not become narrower without end, only compiled kernels show in time (test_painleve)": (
        ("contact_phase", "advance_contact", "if level < FORESEEN and totals.tail > before and totals.tail * (totals.tail / before) > RESOLVED:", "if level >= FORESEEN and totals.tail > before and totals.tail * (totals.tail / before) > RESOLVED:"),
        ("contact_phase", "advance_contact", "if level < FORESEEN and totals.tail > before and totals.tail * (totals.tail / before) > RESOLVED:", "if not level < FORESEEN and totals.tail > before and totals.tail * (totals.tail / before) > RESOLVED:"),
    ),
    "which width is tried next: each panel is asked anew whether it is resolved": (
        ("contact_phase", "", "FORESEEN = 24  # the finest level of panels for which the next one is foreseen: beside p_σ = 0 their tails are rounding", "FORESEEN = 25 # the finest level of panels for which the next one is foreseen: beside p_σ = 0 their tails are rounding"),
        ("contact_phase", "", "FORESEEN = 24  # the finest level of panels for which the next one is foreseen: beside p_σ = 0 their tails are rounding", "FORESEEN = 23 # the finest level of panels for which the next one is foreseen: beside p_σ = 0 their tails are rounding"),
        ("contact_phase", "advance_contact", "if level < FORESEEN and totals.tail > before and totals.tail * (totals.tail / before) > RESOLVED:", "if level < FORESEEN and totals.tail > before and totals.tail / (totals.tail / before) > RESOLVED:"),
        ("contact_phase", "advance_contact", "if level < FORESEEN and totals.tail > before and totals.tail * (totals.tail / before) > RESOLVED:", "if level < FORESEEN and totals.tail >= before and totals.tail * (totals.tail / before) > RESOLVED:"),
        ("contact_phase", "advance_contact", "if level < FORESEEN and totals.tail > before and totals.tail * (totals.tail / before) > RESOLVED:", "if level < FORESEEN and totals.tail > before and totals.tail * (totals.tail / before) >= RESOLVED:"),
        ("contact_phase", "advance_contact", "if level < FORESEEN and totals.tail > before and totals.tail * (totals.tail / before) > RESOLVED:", "if level <= FORESEEN and totals.tail > before and totals.tail * (totals.tail / before) > RESOLVED:"),
        ("contact_phase", "advance_contact", "if level < FORESEEN and totals.tail > before and totals.tail * (totals.tail / before) > RESOLVED:", "if level < FORESEEN and totals.tail <= before and totals.tail * (totals.tail / before) > RESOLVED:"),
        ("contact_phase", "advance_contact", "if level < FORESEEN and totals.tail > before and totals.tail * (totals.tail / before) > RESOLVED:", "if level < FORESEEN and totals.tail > before and totals.tail * (totals.tail / before) <= RESOLVED:"),
        ("contact_phase", "advance_contact", "if level < FORESEEN and totals.tail > before and totals.tail * (totals.tail / before) > RESOLVED:", "if level < FORESEEN and totals.tail > before or totals.tail * (totals.tail / before) > RESOLVED:"),
        ("contact_phase", "advance_contact", "if level < FORESEEN and totals.tail > before and totals.tail * (totals.tail / before) > RESOLVED:", "if level < FORESEEN and totals.tail > before and totals.tail * (totals.tail * before) > RESOLVED:"),
        ("contact_phase", "advance_contact", "level += 1  # the next one would not be resolved, if it goes on like this", "level += 2 # the next one would not be resolved, if it goes on like this"),
        ("contact_phase", "advance_contact", "level += 1  # the next one would not be resolved, if it goes on like this", "level += 0 # the next one would not be resolved, if it goes on like this"),
    ),
    "rows of times and work are filled that are not read at the ends of a panel": (
        ("contact_phase", "advance_contact", "if -1.0 < xi < 1.0:", "if -1.0 <= xi < 1.0:"),
        ("contact_phase", "advance_contact", "if -1.0 < xi < 1.0:", "if - 2.0 < xi < 1.0:"),
        ("contact_phase", "advance_contact", "if -1.0 < xi < 1.0:", "if -1.0 < xi < 2.0:"),
    ),
    "a number that a segment of this kind does not have, and nothing reads": (
        ("contact_phase", "advance_contact", "write_segment(log, mode, panel, xi, 0.0, state, after.t)", "write_segment(log, mode, panel, xi, -1.0, state, after.t)"),
        ("contact_phase", "still_step", "write_segment(log, ROLL, no_panel(HOLD, 0, 0.0), 0.0, 0.0, state, limits.t_end)", "write_segment(log, ROLL, no_panel(HOLD, 0, 1.0), 0.0, 0.0, state, limits.t_end)"),
    ),
    "no torque is smaller than a couple of zero": (
        ("contact_phase", "equilibrium_is_stable", "if body.resist > 0.0 and abs(torque_at_rest(body, s, c)) < body.resist * body.gn:", "if body.resist >= 0.0 and abs(torque_at_rest(body, s, c)) < body.resist * body.gn:"),
    ),
    "only whether it is 0 is asked": (
        ("errors", "_natural_sizes", '"friction": 1.0,  # the margins to the friction cone are rounded as the coefficients would be', '"friction": 2.0, # the margins to the friction cone are rounded as the coefficients would be'),
    ),
    "the start that a script replaces": (
        ("errors", "_again", "body, start_state(0.0, 0.0, 0.0, 0.0, 0.0, 0.0), t_end, math.nan, 0, events, np.empty(0, SEGMENT),", "body, start_state( 1.0, 0.0, 0.0, 0.0, 0.0, 0.0), t_end, math.nan, 0, events, np.empty(0, SEGMENT),"),
        ("errors", "_again", "body, start_state(0.0, 0.0, 0.0, 0.0, 0.0, 0.0), t_end, math.nan, 0, events, np.empty(0, SEGMENT),", "body, start_state( -1.0, 0.0, 0.0, 0.0, 0.0, 0.0), t_end, math.nan, 0, events, np.empty(0, SEGMENT),"),
        ("errors", "_again", "body, start_state(0.0, 0.0, 0.0, 0.0, 0.0, 0.0), t_end, math.nan, 0, events, np.empty(0, SEGMENT),", "body, start_state(0.0, 1.0, 0.0, 0.0, 0.0, 0.0), t_end, math.nan, 0, events, np.empty(0, SEGMENT),"),
        ("errors", "_again", "body, start_state(0.0, 0.0, 0.0, 0.0, 0.0, 0.0), t_end, math.nan, 0, events, np.empty(0, SEGMENT),", "body, start_state(0.0, -1.0, 0.0, 0.0, 0.0, 0.0), t_end, math.nan, 0, events, np.empty(0, SEGMENT),"),
        ("errors", "_again", "body, start_state(0.0, 0.0, 0.0, 0.0, 0.0, 0.0), t_end, math.nan, 0, events, np.empty(0, SEGMENT),", "body, start_state(0.0, 0.0, 1.0, 0.0, 0.0, 0.0), t_end, math.nan, 0, events, np.empty(0, SEGMENT),"),
        ("errors", "_again", "body, start_state(0.0, 0.0, 0.0, 0.0, 0.0, 0.0), t_end, math.nan, 0, events, np.empty(0, SEGMENT),", "body, start_state(0.0, 0.0, -1.0, 0.0, 0.0, 0.0), t_end, math.nan, 0, events, np.empty(0, SEGMENT),"),
        ("errors", "_again", "body, start_state(0.0, 0.0, 0.0, 0.0, 0.0, 0.0), t_end, math.nan, 0, events, np.empty(0, SEGMENT),", "body, start_state(0.0, 0.0, 0.0, 1.0, 0.0, 0.0), t_end, math.nan, 0, events, np.empty(0, SEGMENT),"),
        ("errors", "_again", "body, start_state(0.0, 0.0, 0.0, 0.0, 0.0, 0.0), t_end, math.nan, 0, events, np.empty(0, SEGMENT),", "body, start_state(0.0, 0.0, 0.0, 0.0, 0.0, -1.0), t_end, math.nan, 0, events, np.empty(0, SEGMENT),"),
    ),
    "after the last event there is none": (
        ("errors", "event_errors", "for i in range(count - 1):", "for i in range(count - 0):"),
    ),
    "room for more events than the motion has: how much is a choice": (
        ("errors", "event_errors", "plain = _again(body, row, t_end, 2 * count + 8)", "plain = _again(body, row, t_end, 1 * count + 8)"),
        ("errors", "event_errors", "plain = _again(body, row, t_end, 2 * count + 8)", "plain = _again(body, row, t_end, 2 * count + 7)"),
        ("errors", "event_errors", "other = _again(rougher, moved, t_end, 2 * count + 8)", "other = _again(rougher, moved, t_end, 3 * count + 8)"),
        ("errors", "event_errors", "other = _again(rougher, moved, t_end, 2 * count + 8)", "other = _again(rougher, moved, t_end, 1 * count + 8)"),
        ("errors", "event_errors", "other = _again(rougher, moved, t_end, 2 * count + 8)", "other = _again(rougher, moved, t_end, 2 * count + 9)"),
        ("errors", "event_errors", "other = _again(rougher, moved, t_end, 2 * count + 8)", "other = _again(rougher, moved, t_end, 2 * count + 7)"),
    ),
    "a change of nothing, which changes nothing, is computed too": (
        ("errors", "event_errors", 'if sizes[name] == 0.0 or (name in ("slip", "vy") and row[name] == 0.0):', 'if sizes[name] == -1.0 or (name in ("slip", "vy") and row[name] == 0.0):'),
    ),
    "of an event that cannot be computed again only the ones after it are lost, whether 1, 0 or −1 are alike": (
        ("errors", "event_errors", "alike = 0 if other is None else min(_is_alike(other, plain), reach)", "alike = 1 if other is None else min(_is_alike(other, plain), reach)"),
        ("errors", "event_errors", "alike = 0 if other is None else min(_is_alike(other, plain), reach)", "alike = -1 if other is None else min(_is_alike(other, plain), reach)"),
    ),
    "of two changes the second is the last": (
        ("errors", "event_errors", "if alike == reach or change == CHANGES[-1]:", "if alike == reach or change == CHANGES[+1]:"),
    ),
    "with at most the event itself alike there is none after it to add to": (
        ("errors", "event_errors", "if other is not None and alike > 1:", "if other is not None and alike >= 1:"),
        ("errors", "event_errors", "if other is not None and alike > 1:", "if other is not None or alike > 1:"),
        ("errors", "event_errors", "if other is not None and alike > 1:", "if other is not None and alike > 0:"),
    ),
}
# fmt: on
