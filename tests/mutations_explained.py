"""Why a change of the source cannot be seen: by module, function, the line as it stands and as it is with the change."""

from __future__ import annotations

# fmt: off
_BY_REASON: dict[str, tuple[tuple[str, str, str, str], ...]] = {
    # panel_choice
    "it only matters which row of the scratch array holds a series for a moment": (
        ("panel_choice", "anchored", "return with_anchor(state, slip_anchor(body, sigma, state.th, state.th_low, s, c, u, scratch.values[0]))", "return with_anchor(state, slip_anchor(body, sigma, state.th, state.th_low, s, c, u, scratch.values[ 1]))"),
        ("panel_choice", "anchored", "return with_anchor(state, slip_anchor(body, sigma, state.th, state.th_low, s, c, u, scratch.values[0]))", "return with_anchor(state, slip_anchor(body, sigma, state.th, state.th_low, s, c, u, scratch.values[ -1]))"),
        ("panel_choice", "begin_of", "arm, u = slip_begin(body, state.anchor, sigma, state.th, state.th_low, arm, u, scratch.values[0])", "arm, u = slip_begin(body, state.anchor, sigma, state.th, state.th_low, arm, u, scratch.values[ 1])"),
        ("panel_choice", "begin_of", "arm, u = slip_begin(body, state.anchor, sigma, state.th, state.th_low, arm, u, scratch.values[0])", "arm, u = slip_begin(body, state.anchor, sigma, state.th, state.th_low, arm, u, scratch.values[ -1])"),
    ),
    "a couple of at most zero holds nothing": (
        ("panel_choice", "begin_of", "if body.resist > 0.0:", "if body.resist >= 0.0:"),
        ("panel_choice", "begin_of", "if body.resist > 0.0:", "if body.resist > -1.0:"),
    ),
    "the equality of two rounded numbers on the way to a panel: either side gives one": (
        ("panel_choice", "levels_away", "if slope * way <= 0.0 or begin.stiffness <= 0.0:", "if slope * way < 0.0 or begin.stiffness <= 0.0:"),
        ("panel_choice", "turns_within", "if u_on_panel(body, panel, panel.way * math.sin(reach), versine, panel.way * reach) < 0.0:", "if u_on_panel(body, panel, panel.way * math.sin(reach), versine, panel.way * reach) <= 0.0:"),
        ("panel_choice", "solve_arrival", "if not (totals.tail <= RESOLVED and totals.u > 0.0) or abs(totals.u - before.u) <= START_ROUNDING * before.u:", "if not (totals.tail < RESOLVED and totals.u > 0.0) or abs(totals.u - before.u) <= START_ROUNDING * before.u:"),
        ("panel_choice", "solve_arrival", "if not (totals.tail <= RESOLVED and totals.u > 0.0) or abs(totals.u - before.u) <= START_ROUNDING * before.u:", "if not (totals.tail <= RESOLVED and totals.u > 0.0) or abs(totals.u - before.u) < START_ROUNDING * before.u:"),
        ("panel_choice", "solve_arrival", "if totals.u > 0.0 and abs(totals.u - u) > 1e-9 * u:", "if totals.u > 0.0 and abs(totals.u - u) >= 1e-9 * u:"),
        ("panel_choice", "first_extent", "if not rate * sigma < 0.0 or abs(alpha) <= NO_TURNING * abs(rate):", "if not rate * sigma <= 0.0 or abs(alpha) <= NO_TURNING * abs(rate):"),
        ("panel_choice", "first_extent", "if not rate * sigma < 0.0 or abs(alpha) <= NO_TURNING * abs(rate):", "if not rate * sigma < 0.0 or abs(alpha) < NO_TURNING * abs(rate):"),
        ("panel_choice", "first_extent", "part = SOON if 2.0 * FIRST_EXTENT * rate * rate > FAST * abs(alpha) else SOONEST", "part = SOON if 2.0 * FIRST_EXTENT * rate * rate >= FAST * abs(alpha) else SOONEST"),
        ("panel_choice", "first_extent", "return FIRST_EXTENT if ahead > part * FIRST_EXTENT else max(WIDER * ahead, SMALLEST_EXTENT)", "return FIRST_EXTENT if ahead >= part * FIRST_EXTENT else max(WIDER * ahead, SMALLEST_EXTENT)"),
        ("panel_choice", "choose_panel", "way = 1.0 if begin.arm > 0.0 else -1.0", "way = 1.0 if begin.arm >= 0.0 else -1.0"),
        ("panel_choice", "choose_panel", "if totals.tail <= RESOLVED or extent < SMALLEST_EXTENT:", "if totals.tail <= RESOLVED or extent <= SMALLEST_EXTENT:"),
        ("panel_choice", "choose_panel", "if totals.tail <= RESOLVED or extent < SMALLEST_EXTENT:", "if totals.tail < RESOLVED or extent < SMALLEST_EXTENT:"),
        ("panel_choice", "choose_panel", "if u < SLOW * SLOW:", "if u <= SLOW * SLOW:"),
        ("panel_choice", "choose_panel", "if sigma != 0 and begin.stiffness * min(u, 1.0) < BESIDE_SINGULAR:", "if sigma != 0 and begin.stiffness * min(u, 1.0) <= BESIDE_SINGULAR:"),
        ("panel_choice", "choose_panel", "if totals.tail <= RESOLVED:", "if totals.tail < RESOLVED:"),
        ("panel_choice", "choose_panel", "return panel, totals, max(level - 1, 0) if totals.tail < WIDEN else level", "return panel, totals, max(level - 1, 0) if totals.tail <= WIDEN else level"),
        ("panel_choice", "choose_panel", "if not work[U, ORDER - 1] > 0.8 * u:", "if not work[U, ORDER - 1] >= 0.8 * u:"),
        ("panel_choice", "choose_panel", "if ahead > 0.0 and ahead < panel.extent / 16.0 and level < finest:", "if ahead > 0.0 and ahead <= panel.extent / 16.0 and level < finest:"),
        ("panel_choice", "outlasts", "return totals.time > LONG * max(left, 1.0) and left > 0.0", "return totals.time >= LONG * max(left, 1.0) and left > 0.0"),
    ),
    "θ̇ is not zero there, as is asked before": (
        ("panel_choice", "choose_panel", "way = 1.0 if state.om > 0.0 else -1.0", "way = 1.0 if state.om >= 0.0 else -1.0"),
    ),
    "where a panel to a turning point is resolved θ̇² is above 0 at its start": (
        ("panel_choice", "solve_arrival", "if not (totals.tail <= RESOLVED and totals.u > 0.0) or abs(totals.u - before.u) <= START_ROUNDING * before.u:", "if not (totals.tail <= RESOLVED and totals.u >= 0.0) or abs(totals.u - before.u) <= START_ROUNDING * before.u:"),
        ("panel_choice", "solve_arrival", "if not (totals.tail <= RESOLVED and totals.u > 0.0) or abs(totals.u - before.u) <= START_ROUNDING * before.u:", "if not (totals.tail <= RESOLVED and totals.u > -1.0) or abs(totals.u - before.u) <= START_ROUNDING * before.u:"),
        ("panel_choice", "solve_arrival", "if totals.u > 0.0 and abs(totals.u - u) > 1e-9 * u:", "if totals.u >= 0.0 and abs(totals.u - u) > 1e-9 * u:"),
        ("panel_choice", "solve_arrival", "if totals.u > 0.0 and abs(totals.u - u) > 1e-9 * u:", "if totals.u > 0.0 or abs(totals.u - u) > 1e-9 * u:"),
        ("panel_choice", "solve_arrival", "if totals.u > 0.0 and abs(totals.u - u) > 1e-9 * u:", "if totals.u > -1.0 and abs(totals.u - u) > 1e-9 * u:"),
    ),
    "the start is an event: none is never their number": (
        ("kernel", "run", "count = log.written[0] if log.written[0] >= 0 else events.shape[0]", "count = log.written[0] if log.written[0] > 0 else events.shape[0]"),
        ("kernel", "run", "count = log.written[0] if log.written[0] >= 0 else events.shape[0]", "count = log.written[0] if log.written[0] >= 1 else events.shape[0]"),
    ),
    "a search for a fall asks for a value not above 0 anyway": (
        ("panel_choice", "turning_point_ahead", "xi = first_fall(scratch.series, 0.0, scratch.stack)", "xi = first_fall(scratch.series, -1.0, scratch.stack)"),
    ),
    "only more or fewer panels are tried: whether wider ones are for a turning point, which none of them shows": (
        ("panel_choice", "turning_point_ahead", "if panel.sigma == 0 and body.resist == 0.0 and not turns_within(body, panel, 8.0 * panel.extent):", "if panel.sigma == 0 and body.resist == 0.0 and not turns_within(body, panel, 8.0 / panel.extent):"),
        ("panel_choice", "turning_point_ahead", "if panel.sigma == 0 and body.resist == 0.0 and not turns_within(body, panel, 8.0 * panel.extent):", "if panel.sigma == 0 and body.resist != 0.0 and not turns_within(body, panel, 8.0 * panel.extent):"),
        ("panel_choice", "turning_point_ahead", "if panel.sigma == 0 and body.resist == 0.0 and not turns_within(body, panel, 8.0 * panel.extent):", "if panel.sigma == 0 and body.resist == 1.0 and not turns_within(body, panel, 8.0 * panel.extent):"),
        ("panel_choice", "turning_point_ahead", "if panel.sigma == 0 and body.resist == 0.0 and not turns_within(body, panel, 8.0 * panel.extent):", "if panel.sigma == 0 and body.resist == -1.0 and not turns_within(body, panel, 8.0 * panel.extent):"),
        ("panel_choice", "turning_point_ahead", "if panel.sigma == 0 and body.resist == 0.0 and not turns_within(body, panel, 8.0 * panel.extent):", "if panel.sigma == 0 and body.resist == 0.0 and not turns_within(body, panel, 9.0 * panel.extent):"),
        ("panel_choice", "turning_point_ahead", "if panel.level == 0:", "if panel.level == -1:"),
    ),
    "only more or fewer panels are tried: how the turning point is moved, and how often once it stands": (
        ("panel_choice", "", "MOST_MOVES = 8  # of a turning point", "MOST_MOVES = 7 # of a turning point"),
        ("panel_choice", "", "START_ROUNDING = 1e-15  # of θ̇² at the start of a panel that arrives at one", "START_ROUNDING = -0.999999999999999 # of θ̇² at the start of a panel that arrives at one"),
        ("panel_choice", "solve_arrival", "if not (totals.tail <= RESOLVED and totals.u > 0.0) or abs(totals.u - before.u) <= START_ROUNDING * before.u:", "if not (totals.tail <= RESOLVED and totals.u > 0.0) or abs(totals.u + before.u) <= START_ROUNDING * before.u:"),
        ("panel_choice", "solve_arrival", "if totals.u > 0.0 and abs(totals.u - u) > 1e-9 * u:", "if totals.u > 0.0 and abs(totals.u + u) > 1e-9 * u:"),
        ("panel_choice", "solve_arrival", "if totals.u > 0.0 and abs(totals.u - u) > 1e-9 * u:", "if totals.u > 0.0 and abs(totals.u - u) > -0.999999999 * u:"),
        ("panel_choice", "solve_arrival", "power = min(max(math.log(totals.u / u) / math.log(moved / ahead), 0.25), 4.0)", "power = min(max(math.log(totals.u / u) / math.log(moved / ahead), -0.75), 4.0)"),
        ("panel_choice", "solve_arrival", "power = min(max(math.log(totals.u / u) / math.log(moved / ahead), 0.25), 4.0)", "power = min(max(math.log(totals.u / u) / math.log(moved / ahead), 0.25), 5.0)"),
        ("panel_choice", "solve_arrival", "power = min(max(math.log(totals.u / u) / math.log(moved / ahead), 0.25), 4.0)", "power = min(max(math.log(totals.u / u) / math.log(moved / ahead), 0.25), 3.0)"),
    ),
    "only more or fewer panels are tried: when one counts as near to a turning point": (
        ("panel_choice", "choose_panel", "if not work[U, ORDER - 1] > 0.8 * u:", "if not work[U, ORDER - 2] > 0.8 * u:"),
        ("panel_choice", "choose_panel", "if not work[U, ORDER - 1] > 0.8 * u:", "if not work[U, ORDER - 1] > 1.8 * u:"),
        ("panel_choice", "choose_panel", "if ahead > 0.0 and ahead < panel.extent / 16.0 and level < finest:", "if ahead > 0.0 and ahead < panel.extent / 16.0 and level >= finest:"),
        ("panel_choice", "choose_panel", "if ahead > 0.0 and ahead < panel.extent / 16.0 and level < finest:", "if ahead > 1.0 and ahead < panel.extent / 16.0 and level < finest:"),
        ("panel_choice", "choose_panel", "if ahead > 0.0 and ahead < panel.extent / 16.0 and level < finest:", "if ahead > 0.0 and ahead < panel.extent / 17.0 and level < finest:"),
        ("panel_choice", "choose_panel", "if ahead > 0.0 and ahead < panel.extent / 16.0 and level < finest:", "if ahead > 0.0 and ahead < panel.extent / 15.0 and level < finest:"),
    ),
    "only more or fewer panels are tried: a turning point at no distance gives none": (
        ("panel_choice", "choose_panel", "if ahead > 0.0:", "if ahead >= 0.0:"),
        ("panel_choice", "choose_panel", "if ahead > 0.0:", "if ahead > -1.0:"),
    ),
    "a panel is resolved long before it is as narrow as that": (
        ("panel_choice", "choose_panel", "if sigma != 0 and begin.stiffness * min(u, 1.0) < BESIDE_SINGULAR:", "if sigma != 0 or begin.stiffness * min(u, 1.0) < BESIDE_SINGULAR:"),
        ("panel_choice", "choose_panel", "if sigma != 0 and begin.stiffness * min(u, 1.0) < BESIDE_SINGULAR:", "if sigma != 0 and begin.stiffness * min(u, 2.0) < BESIDE_SINGULAR:"),
        ("panel_choice", "choose_panel", "if sigma != 0 and begin.stiffness * min(u, 1.0) < BESIDE_SINGULAR:", "if sigma != 0 and begin.stiffness * min(u, 0.0) < BESIDE_SINGULAR:"),
        ("panel_choice", "choose_panel", "if ahead > 0.0 and ahead < panel.extent / 16.0 and level < finest:", "if ahead > 0.0 and ahead < panel.extent / 16.0 and level <= finest:"),
    ),
    "how wide a panel is tried first, by less than a part in a hundred": (
        ("panel_choice", "", "WIDEN = RESOLVED / 200.0", "WIDEN = RESOLVED / 201.0"),
        ("panel_choice", "", "WIDEN = RESOLVED / 200.0", "WIDEN = RESOLVED / 199.0"),
        ("panel_choice", "", "SOONEST, SOON, FAST, WIDER = 1e-14, 1e-6, 1e4, 16.0", "SOONEST, SOON, FAST, WIDER = 1e-14, 1e-6, 10001.0, 16.0"),
        ("panel_choice", "", "SOONEST, SOON, FAST, WIDER = 1e-14, 1e-6, 1e4, 16.0", "SOONEST, SOON, FAST, WIDER = 1e-14, 1e-6, 9999.0, 16.0"),
    ),
    "σ is 1 or −1 there": (
        ("panel_choice", "first_extent", "if not rate * sigma < 0.0 or abs(alpha) <= NO_TURNING * abs(rate):", "if not rate / sigma < 0.0 or abs(alpha) <= NO_TURNING * abs(rate):"),
    ),
    "of a tolerance the order counts: v̇_t is of the order of g": (
        ("panel_choice", "first_extent", "if not rate * sigma < 0.0 or abs(alpha) <= NO_TURNING * abs(rate):", "if not rate * sigma < 0.0 or abs(alpha) <= NO_TURNING / abs(rate):"),
    ),
    # script
    "nothing asks for the turning points or the bounces of a phase that is filled in": (
        ("script", "fill_phase", "limits = limits_of(state, until, math.nan, 0)", "limits = limits_of(state, until, math.nan, 1)"),
        ("script", "fill_phase", "limits = limits_of(state, until, math.nan, 0)", "limits = limits_of(state, until, math.nan, -1)"),
        ("script", "fill_phase", "phase = entered(body, mode, state, 0.0, ON, scratch)", "phase = entered(body, mode, state, 1.0, ON, scratch)"),
        ("script", "fill_phase", "phase = entered(body, mode, state, 0.0, ON, scratch)", "phase = entered(body, mode, state, -1.0, ON, scratch)"),
    ),
    "a script has one dimension": (
        ("script", "fill_script", "for row in range(script.shape[0] - 1):", "for row in range(script.shape[ -1] - 1):"),
        ("script", "repeat", "last = script.shape[0] - 1", "last = script.shape[ -1] - 1"),
    ),
    # sampling
    "a table of samples has one dimension": (
        ("sampling", "find_segment", "high = segments.shape[0]", "high = segments.shape[ -1]"),
        ("sampling", "sample", "for k in range(times.shape[0]):", "for k in range(times.shape[ -1]):"),
    ),
    "a search for a fall is for a value not above 0 anyway": (
        ("sampling", "place_on_panel", "xi = first_fall(scratch.series, 0.0, scratch.stack)", "xi = first_fall(scratch.series, -1.0, scratch.stack)"),
    ),
    "a time that is not found on its panel is beside an end, before all nodes or after them": (
        ("sampling", "place_on_panel", 'xi = segment["xi"] if tau > panel_time[0] else -1.0', 'xi = segment["xi"] if tau > panel_time[ 1] else -1.0'),
        ("sampling", "place_on_panel", 'xi = segment["xi"] if tau > panel_time[0] else -1.0', 'xi = segment["xi"] if tau > panel_time[ -1] else -1.0'),
    ),
    "the first segment with a panel solves it, before these are read": (
        ("sampling", "sample", "totals = Totals(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)", "totals = Totals( -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)"),
        ("sampling", "sample", "totals = Totals(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)", "totals = Totals(0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0)"),
        ("sampling", "sample", "totals = Totals(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)", "totals = Totals(0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0)"),
        ("sampling", "sample", "totals = Totals(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)", "totals = Totals(0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0)"),
        ("sampling", "sample", "totals = Totals(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)", "totals = Totals(0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0)"),
        ("sampling", "sample", "totals = Totals(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)", "totals = Totals(0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0)"),
        ("sampling", "sample", "totals = Totals(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)", "totals = Totals(0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0)"),
        ("sampling", "sample", "totals = Totals(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)", "totals = Totals(0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0)"),
        ("sampling", "sample", "totals = Totals(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)", "totals = Totals(0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0)"),
        ("sampling", "sample", "totals = Totals(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)", "totals = Totals(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0)"),
        ("sampling", "sample", "totals = Totals(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)", "totals = Totals(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0)"),
    ),
    "the first segment with a panel fetches it, before this one is read": (
        ("sampling", "sample", "panel = no_panel(FLY, 0, 0.0)", "panel = no_panel(FLY, 1, 0.0)"),
        ("sampling", "sample", "panel = no_panel(FLY, 0, 0.0)", "panel = no_panel(FLY, -1, 0.0)"),
        ("sampling", "sample", "panel = no_panel(FLY, 0, 0.0)", "panel = no_panel(FLY, 0, 1.0)"),
    ),
    "a sample has no column for it": (
        ("sampling", "sample", "now = moved(state, times[k], 0.0, x, x_low, 0.0, state.turns, state.th, state.th_low)", "now = moved(state, times[k], -1.0, x, x_low, 0.0, state.turns, state.th, state.th_low)"),
        ("sampling", "sample", "now = moved(state, times[k], 0.0, x, 0.0, 0.0, state.turns, th, 0.0)", "now = moved(state, times[k], 1.0, x, 0.0, 0.0, state.turns, th, 0.0)"),
        ("sampling", "sample", "now = moved(state, times[k], 0.0, x, 0.0, 0.0, state.turns, th, 0.0)", "now = moved(state, times[k], -1.0, x, 0.0, 0.0, state.turns, th, 0.0)"),
        ("sampling", "sample", "now = moved(state, times[k], 0.0, x, 0.0, 0.0, state.turns, th, 0.0)", "now = moved(state, times[k], 0.0, x, 1.0, 0.0, state.turns, th, 0.0)"),
        ("sampling", "sample", "now = moved(state, times[k], 0.0, x, 0.0, 0.0, state.turns, th, 0.0)", "now = moved(state, times[k], 0.0, x, -1.0, 0.0, state.turns, th, 0.0)"),
    ),
    # transitions
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
    # panel_events
    "a short cut for a margin far from zero, beyond which no zero is found either": (
        ("panel_events", "", "FAR_FROM_ZERO = 0.25", "FAR_FROM_ZERO = 1.25"),
        ("panel_events", "fall_of", "if lowest > FAR_FROM_ZERO * (highest - lowest):", "if lowest > FAR_FROM_ZERO * (highest + lowest):"),
    ),
    "near zero the smallest value is nothing beside the range": (
        ("panel_events", "fall_of", "near = abs(lowest) < NEARBY * (highest - lowest)", "near = abs(lowest) < NEARBY * (highest + lowest)"),
    ),
    "the equality of two rounded numbers on a panel: either side is right": (
        ("panel_events", "fall_of", "if lowest > FAR_FROM_ZERO * (highest - lowest):", "if lowest >= FAR_FROM_ZERO * (highest - lowest):"),
        ("panel_events", "fall_of", "near = abs(lowest) < NEARBY * (highest - lowest)", "near = abs(lowest) <= NEARBY * (highest - lowest)"),
        ("panel_events", "end_of_slip", "if fresh and zeros == 0 and work[B, 0] < 0.0 and (stop > NODES[0] or state.vt * state.vt < SMALLEST_SQUARE):", "if fresh and zeros == 0 and work[B, 0] <= 0.0 and (stop > NODES[0] or state.vt * state.vt < SMALLEST_SQUARE):"),
        ("panel_events", "end_of_slip", "if fresh and zeros == 0 and work[B, 0] < 0.0 and (stop > NODES[0] or state.vt * state.vt < SMALLEST_SQUARE):", "if fresh and zeros == 0 and work[B, 0] < 0.0 and (stop > NODES[0] or state.vt * state.vt <= SMALLEST_SQUARE):"),
        ("panel_events", "end_of_slip", "if fresh and zeros == 0 and work[B, 0] < 0.0 and (stop > NODES[0] or state.vt * state.vt < SMALLEST_SQUARE):", "if fresh and zeros == 0 and work[B, 0] < 0.0 and (stop >= NODES[0] or state.vt * state.vt < SMALLEST_SQUARE):"),
        ("panel_events", "end_of_slip", "if stop != NOT_FOUND and lift != NOT_FOUND and abs(stop - lift) < CLOSE and body.mu_k > 0.0:", "if stop != NOT_FOUND and lift != NOT_FOUND and abs(stop - lift) <= CLOSE and body.mu_k > 0.0:"),
    ),
    "without rolling resistance both formulas are one": (
        ("panel_events", "end_of_rolling", "if body.resist > 0.0:", "if body.resist > -1.0:"),
    ),
    "the way is 1 or −1": (
        ("panel_events", "end_of_rolling", "if back < ahead or (back == ahead and panel.way < 0.0):", "if back < ahead or (back == ahead and panel.way < 1.0):"),
    ),
    "slip that begins with a speed was looked at before": (
        ("panel_events", "end_of_slip", "elif fresh and zeros > 0 and body.mu_k == 0.0 and stop == NOT_FOUND and extremes(work[B])[1] < 0.0:", "elif fresh and zeros >= 0 and body.mu_k == 0.0 and stop == NOT_FOUND and extremes(work[B])[1] < 0.0:"),
        ("panel_events", "end_of_slip", "elif fresh and zeros > 0 and body.mu_k == 0.0 and stop == NOT_FOUND and extremes(work[B])[1] < 0.0:", "elif fresh and zeros > -1 and body.mu_k == 0.0 and stop == NOT_FOUND and extremes(work[B])[1] < 0.0:"),
    ),
    "a search for a fall is for a value that is not above 0, whatever the floor": (
        ("panel_events", "end_of_time", "found = first_fall(scratch.series, 0.0, scratch.stack)", "found = first_fall(scratch.series, -1.0, scratch.stack)"),
    ),
    "an equality of two rounded numbers, where both sides give the same or the model has a tie": (
        ("modes", "can_roll", "if normal < -tie or margin < -close:", "if normal < -tie or margin <= -close:"),
        ("modes", "can_roll", "if normal < -tie or margin < -close:", "if normal <= -tie or margin < -close:"),
        ("modes", "can_roll", "if normal > tie and margin > close:", "if normal > tie and margin >= close:"),
        ("modes", "can_roll", "if normal > tie and margin > close:", "if normal >= tie and margin > close:"),
        ("panel_events", "end_of_rolling", "if back < ahead or (back == ahead and panel.way < 0.0):", "if back < ahead or (back == ahead and panel.way <= 0.0):"),
        ("flight_phase", "fly", "if 0.0 < apex < tau:", "if 0.0 < apex <= tau:"),
        ("flight_phase", "fly", "if until < limit:", "if until <= limit:"),
        ("painleve", "slip_coefficients", "if abs(stiffness) < NEARLY:", "if abs(stiffness) <= NEARLY:"),
        ("impact", "singular_slip", "spin = 0.0 if rho != 0.0 and length < stop and turn * om <= 0.0 else om + turn * length", "spin = 0.0 if rho != 0.0 and length < stop and turn * om < 0.0 else om + turn * length"),
        ("transitions", "collide", "if gain <= GAIN_FLOOR * (abs(loss_n) + abs(loss_t) + state.vn * state.vn):", "if gain < GAIN_FLOOR * (abs(loss_n) + abs(loss_t) + state.vn * state.vn):"),
        ("sampling", "place_on_panel", 'xi = segment["xi"] if tau > panel_time[0] else -1.0', 'xi = segment["xi"] if tau >= panel_time[0] else -1.0'),
        ("phase", "opening_of", "if opening <= 1e-13 * (body.gn + state.om * state.om):", "if opening < 1e-13 * (body.gn + state.om * state.om):"),
        ("panel_events", "end_of_span", "if not ahead > 0.0:", "if not ahead >= 0.0:"),
        ("panel_events", "end_of_slip", "elif fresh and zeros > 0 and body.mu_k == 0.0 and stop == NOT_FOUND and extremes(work[B])[1] < 0.0:", "elif fresh and zeros > 0 and body.mu_k == 0.0 and stop == NOT_FOUND and extremes(work[B])[1] <= 0.0:"),
        ("panel_events", "fall_of", "if row[i] < -floor:", "if row[i] <= -floor:"),
        ("flight_phase", "fly", "if 0.0 <= landing <= limit:", "if 0.0 <= landing < limit:"),
        ("contact_phase", "advance_contact", "if -1.0 < xi < 1.0:", "if -1.0 < xi <= 1.0:"),
        ("contact_phase", "advance_contact", "if not totals.tail <= RESOLVED:", "if not totals.tail < RESOLVED:"),
        ("contact_phase", "is_still", "return abs(acceleration_in_contact(body, s, c, 0.0, sigma)) <= rounding", "return abs(acceleration_in_contact(body, s, c, 0.0, sigma)) < rounding"),
        ("scenario", "_check_compliance", "if depth > MOST_DEPTH:", "if depth >= MOST_DEPTH:"),
        ("impact", "singular_angle", "near = abs(distance) <= 1e-5 * abs(slope) and opening <= 1e-5 * (body.gn + body.eps * u)", "near = abs(distance) < 1e-5 * abs(slope) and opening <= 1e-5 * (body.gn + body.eps * u)"),
        ("impact", "singular_angle", "near = abs(distance) <= 1e-5 * abs(slope) and opening <= 1e-5 * (body.gn + body.eps * u)", "near = abs(distance) <= 1e-5 * abs(slope) and opening < 1e-5 * (body.gn + body.eps * u)"),
        ("modes", "next_mode", "if rho != 0.0 and stiffness + body.eps * s * rho > 0.0 and (opening < 0 or body.strike):", "if rho != 0.0 and stiffness + body.eps * s * rho >= 0.0 and (opening < 0 or body.strike):"),
        ("compliant", "first_regime", "return 1 if bristle_force > 0.0 else -1", "return 1 if bristle_force >= 0.0 else -1"),
        ("compliant", "first_regime", "return 1 if vt > 0.0 else -1", "return 1 if vt >= 0.0 else -1"),
        ("compliant", "ratio_restitution", "if ratio < 1.0:", "if ratio <= 1.0:"),
        ("compliant", "ratio_restitution", "return math.exp(-2.0 * ratio * math.acos(ratio) / root) if root > 0.0 else math.exp(-2.0)", "return math.exp(-2.0 * ratio * math.acos(ratio) / root) if root >= 0.0 else math.exp(-2.0)"),
        ("compliant", "damping_ratio", "while ratio_restitution(high) > restitution:", "while ratio_restitution(high) >= restitution:"),
        ("contact", "load_height", "return s * s / (1.0 - c) if c < 0.0 else 1.0 + c", "return s * s / (1.0 - c) if c <= 0.0 else 1.0 + c"),
        ("impact", "impulse_ratio", "return (-body.mu_k if stick < 0.0 else body.mu_k), False", "return (-body.mu_k if stick <= 0.0 else body.mu_k), False"),
        ("impact", "impact", "length = (target - vn) / kn if kn > 0.0 else math.inf", "length = (target - vn) / kn if kn >= 0.0 else math.inf"),
        ("impact", "impact", "if length <= step:", "if length < step:"),
        ("impact", "singular_slip", "sigma = 1.0 if vt > 0.0 else -1.0", "sigma = 1.0 if vt >= 0.0 else -1.0"),
        ("impact", "singular_slip", "stop = -vt / rate if vt * rate < 0.0 else math.inf", "stop = -vt / rate if vt * rate <= 0.0 else math.inf"),
        ("impact", "singular_slip", "if limit <= stop:", "if limit < stop:"),
        ("impact", "singular_angle", "if slope != 0.0 and abs(distance) <= 1e-10 * abs(slope):", "if slope != 0.0 and abs(distance) < 1e-10 * abs(slope):"),
        ("jets", "leading_sign", "return 1 if value > 0.0 else -1", "return 1 if value >= 0.0 else -1"),
        ("modes", "opening_sign", "return 1 if f_n > 0.0 else -1", "return 1 if f_n >= 0.0 else -1"),
        ("modes", "opening_sign", "return 1 if first > 0.0 else -1", "return 1 if first >= 0.0 else -1"),
        ("modes", "opening_sign", "return 1 if second > 0.0 else -1", "return 1 if second >= 0.0 else -1"),
        ("modes", "can_start_slip", "if load < -tie or sigma * slip < -tie:", "if load <= -tie or sigma * slip < -tie:"),
        ("modes", "can_start_slip", "if load < -tie or sigma * slip < -tie:", "if load < -tie or sigma * slip <= -tie:"),
        ("modes", "can_start_slip", "if load > tie and sigma * slip > tie:", "if load >= tie and sigma * slip > tie:"),
        ("modes", "can_start_slip", "if load > tie and sigma * slip > tie:", "if load > tie and sigma * slip >= tie:"),
        ("modes", "frictionless_mode", "return slip_mode(1 if drive > 0.0 else -1)", "return slip_mode(1 if drive >= 0.0 else -1)"),
        ("modes", "next_mode", "if a * normal >= b * abs(friction):", "if a * normal > b * abs(friction):"),
        ("modes", "next_mode", "return slip_mode(-1 if friction > 0.0 else 1)", "return slip_mode(-1 if friction >= 0.0 else 1)"),
        ("modes", "next_mode", "sigma = 1 if vt > 0.0 else -1", "sigma = 1 if vt >= 0.0 else -1"),
    ),
    "where a search begins or how it goes on, which finds the same root": (
        ("compliant", "static_excess", "if static_peak(mu_kinetic, middle) < mu_static:", "if static_peak(mu_kinetic, middle) <= mu_static:"),
        ("compliant", "static_excess", "break", "continue"),
        ("compliant", "static_excess", "if not low < middle < high:", "if not low < middle <= high:"),
        ("compliant", "static_excess", "if not low < middle < high:", "if not low <= middle < high:"),
        ("compliant", "static_excess", "while static_peak(mu_kinetic, high) < mu_static:", "while static_peak(mu_kinetic, high) <= mu_static:"),
        ("compliant", "static_excess", "low, high = 0.0, mu_static - mu_kinetic", "low, high = -1.0, mu_static - mu_kinetic"),
        ("compliant", "static_excess", "low, high = 0.0, mu_static - mu_kinetic", "low, high = 0.0, mu_static + mu_kinetic"),
        ("compliant", "static_peak", "if static_height(mu_kinetic, excess, left) < static_height(mu_kinetic, excess, right):", "if static_height(mu_kinetic, excess, left) <= static_height(mu_kinetic, excess, right):"),
        ("compliant", "static_peak", "for _ in range(80):", "for _ in range( 79):"),
        ("compliant", "static_peak", "for _ in range(80):", "for _ in range( 81):"),
        ("compliant", "static_peak", "share = 0.5 * (math.sqrt(5.0) - 1.0)", "share = 0.5 * (math.sqrt( 6.0) - 1.0)"),
        ("compliant", "static_peak", "low, high = 0.0, 4.0 * STRIBECK", "low, high = 0.0, 3.0 * STRIBECK"),
        ("compliant", "static_peak", "low, high = 0.0, 4.0 * STRIBECK", "low, high = 0.0, 5.0 * STRIBECK"),
        ("compliant", "static_peak", "low, high = 0.0, 4.0 * STRIBECK", "low, high = -1.0, 4.0 * STRIBECK"),
        ("compliant", "static_peak", "low, high = 0.0, 4.0 * STRIBECK", "low, high = 1.0, 4.0 * STRIBECK"),
        ("compliant", "hunt_crossley_number", "if hunt_crossley_excess(restitution, middle) < 0.0:", "if hunt_crossley_excess(restitution, middle) <= 0.0:"),
        ("compliant", "hunt_crossley_number", "break", "continue"),
        ("compliant", "hunt_crossley_number", "if not low < middle < high:", "if not low < middle <= high:"),
        ("compliant", "hunt_crossley_number", "if not low < middle < high:", "if not low <= middle < high:"),
        ("compliant", "hunt_crossley_number", "while hunt_crossley_excess(restitution, low) >= 0.0:", "while hunt_crossley_excess(restitution, low) > 0.0:"),
        ("compliant", "damping_ratio", "if ratio_restitution(middle) > restitution:", "if ratio_restitution(middle) >= restitution:"),
        ("compliant", "damping_ratio", "break", "continue"),
        ("compliant", "damping_ratio", "if not low < middle < high:", "if not low < middle <= high:"),
        ("compliant", "damping_ratio", "if not low < middle < high:", "if not low <= middle < high:"),
        ("compliant", "damping_ratio", "low, high = 0.0, 1.0", "low, high = -1.0, 1.0"),
        ("compliant", "damping_ratio", "low, high = 0.0, 1.0", "low, high = 0.0, 2.0"),
        ("compliant", "damping_ratio", "low, high = high, 2.0 * high", "low, high = high, 3.0 * high"),
        ("compliant", "hunt_crossley_number", "low = 0.5 * pole", "low = 0.5 / pole"),
        ("compliant", "hunt_crossley_number", "low *= 0.5", "low *= -0.5"),
        ("compliant", "static_excess", "high *= 2.0", "high *= 3.0"),
    ),
    "an initial value that is written over before it is read": (
        ("sampling", "sample", "totals = Totals(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)", "totals = Totals( 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)"),
        ("sampling", "sample", "panel = no_panel(FLY, 0, 0.0)", "panel = no_panel(FLY, 0, -1.0)"),
        ("sampling", "sample", "totals = Totals(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)", "totals = Totals(0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0)"),
        ("sampling", "sample", "totals = Totals(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)", "totals = Totals(0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0)"),
        ("sampling", "sample", "solved = -1", "solved = - 2"),
        ("impact", "impact", "target = 0.0", "target = 1.0"),
        ("impact", "impact", "target = 0.0", "target = -1.0"),
    ),
    "coefficients that the passes over the series write over": (
        ("jets", "candidate_series", "rate = (om, 0.0, 0.0, 0.0, 0.0)", "rate = (om, 1.0, 0.0, 0.0, 0.0)"),
        ("jets", "candidate_series", "rate = (om, 0.0, 0.0, 0.0, 0.0)", "rate = (om, -1.0, 0.0, 0.0, 0.0)"),
        ("jets", "candidate_series", "rate = (om, 0.0, 0.0, 0.0, 0.0)", "rate = (om, 0.0, 1.0, 0.0, 0.0)"),
        ("jets", "candidate_series", "rate = (om, 0.0, 0.0, 0.0, 0.0)", "rate = (om, 0.0, -1.0, 0.0, 0.0)"),
        ("jets", "candidate_series", "rate = (om, 0.0, 0.0, 0.0, 0.0)", "rate = (om, 0.0, 0.0, 1.0, 0.0)"),
        ("jets", "candidate_series", "rate = (om, 0.0, 0.0, 0.0, 0.0)", "rate = (om, 0.0, 0.0, -1.0, 0.0)"),
        ("jets", "candidate_series", "rate = (om, 0.0, 0.0, 0.0, 0.0)", "rate = (om, 0.0, 0.0, 0.0, 1.0)"),
        ("jets", "candidate_series", "rate = (om, 0.0, 0.0, 0.0, 0.0)", "rate = (om, 0.0, 0.0, 0.0, -1.0)"),
    ),
    "a case that never comes: below 1 the root of (1 − ζ)(1 + ζ) is above 0": (
        ("compliant", "ratio_restitution", "return math.exp(-2.0 * ratio * math.acos(ratio) / root) if root > 0.0 else math.exp(-2.0)", "return math.exp(-2.0 * ratio * math.acos(ratio) / root) if root > 0.0 else math.exp(+2.0)"),
        ("compliant", "ratio_restitution", "return math.exp(-2.0 * ratio * math.acos(ratio) / root) if root > 0.0 else math.exp(-2.0)", "return math.exp(-2.0 * ratio * math.acos(ratio) / root) if root > 0.0 else math.exp(- 3.0)"),
        ("compliant", "ratio_restitution", "return math.exp(-2.0 * ratio * math.acos(ratio) / root) if root > 0.0 else math.exp(-2.0)", "return math.exp(-2.0 * ratio * math.acos(ratio) / root) if root > 0.0 else math.exp(- 1.0)"),
        ("compliant", "ratio_restitution", "return math.exp(-2.0 * ratio * math.acos(ratio) / root) if root > 0.0 else math.exp(-2.0)", "return math.exp(-2.0 * ratio * math.acos(ratio) / root) if root > -1.0 else math.exp(-2.0)"),
    ),
    "a bound on a loop that ends before": (
        ("compliant", "", "BISECTIONS = 200  # at most; two neighbouring doubles end it before", "BISECTIONS = 201 # at most; two neighbouring doubles end it before"),
        ("compliant", "", "BISECTIONS = 200  # at most; two neighbouring doubles end it before", "BISECTIONS = 199 # at most; two neighbouring doubles end it before"),
        ("transitions", "settle", "for _ in range(8):", "for _ in range( 7):"),
        ("impact", "impact", "for _ in range(8):", "for _ in range( 9):"),
        ("impact", "impact", "for _ in range(8):", "for _ in range( 7):"),
    ),
    "a quotient has the sign of the product, and only the sign counts": (
        ("impact", "singular_slip", "spin = 0.0 if rho != 0.0 and length < stop and turn * om <= 0.0 else om + turn * length", "spin = 0.0 if rho != 0.0 and length < stop and turn / om <= 0.0 else om + turn * length"),
        ("impact", "singular_slip", "stop = -vt / rate if vt * rate < 0.0 else math.inf", "stop = -vt / rate if vt / rate < 0.0 else math.inf"),
        ("modes", "opening_sign", "second = -body.eps * c * u * u", "second = -body.eps / c * u * u"),
        ("modes", "frictionless_mode", "bend = body.eps * (u - (body.gn - body.eps * c * u) * (1.0 + body.eps * c) / (body.kap + body.eps * s * body.eps * s))", "bend = body.eps / (u - (body.gn - body.eps * c * u) * (1.0 + body.eps * c) / (body.kap + body.eps * s * body.eps * s))"),
        ("modes", "frictionless_mode", "drive = s * bend if s != 0.0 else om * c * bend", "drive = s / bend if s != 0.0 else om * c * bend"),
        ("modes", "frictionless_mode", "drive = s * bend if s != 0.0 else om * c * bend", "drive = s * bend if s != 0.0 else om / c * bend"),
        ("modes", "frictionless_mode", "drive = s * bend if s != 0.0 else om * c * bend", "drive = s * bend if s != 0.0 else om * c / bend"),
    ),
    "only the sign counts, and the number is never 0": (
        ("transitions", "collide", "p_sigma = slip_coefficients(body, state.th, state.th_low, s, c, 1 if state.vt > 0.0 else -1, 0.0)[1] / body.kap", "p_sigma = slip_coefficients(body, state.th, state.th_low, s, c, 1 if state.vt >= 0.0 else -1, 0.0)[1] / body.kap"),
        ("kernel", "begin_massless", "mode = slip_mode(1 if state.vt > 0.0 else -1)", "mode = slip_mode(1 if state.vt > 0.0 else - 2)"),
        ("kernel", "begin_massless", "mode = slip_mode(1 if state.vt > 0.0 else -1)", "mode = slip_mode( 2 if state.vt > 0.0 else -1)"),
        ("kernel", "begin_massless", "mode = slip_mode(1 if state.vt > 0.0 else -1)", "mode = slip_mode(1 if state.vt >= 0.0 else -1)"),
        ("modes", "next_mode", "return slip_mode(-1 if friction > 0.0 else 1)", "return slip_mode(- 2 if friction > 0.0 else 1)"),
        ("modes", "next_mode", "return slip_mode(-1 if friction > 0.0 else 1)", "return slip_mode(- 0 if friction > 0.0 else 1)"),
        ("modes", "next_mode", "return slip_mode(-1 if friction > 0.0 else 1)", "return slip_mode(-1 if friction > 0.0 else 2)"),
        ("modes", "frictionless_mode", "drive = motion_slipping(body, s, c, om, 0)[2]", "drive = motion_slipping(body, s, c, om, 1)[2]"),
        ("modes", "frictionless_mode", "drive = motion_slipping(body, s, c, om, 0)[2]", "drive = motion_slipping(body, s, c, om, -1)[2]"),
        ("massless", "skim_state", "th_end = turns + 2.0 * half if way > 0 else turns + 2.0 * math.pi - 2.0 * half", "th_end = turns + 2.0 * half if way >= 0 else turns + 2.0 * math.pi - 2.0 * half"),
        ("massless", "skim_state", "th_end = turns + 2.0 * half if way > 0 else turns + 2.0 * math.pi - 2.0 * half", "th_end = turns + 2.0 * half if way > -1 else turns + 2.0 * math.pi - 2.0 * half"),
        ("massless", "skim_state", "if way < 0 and s == 0.0 and c > 0.0:", "if way <= 0 and s == 0.0 and c > 0.0:"),
        ("massless", "skim_state", "if way < 0 and s == 0.0 and c > 0.0:", "if way < 0 and s == 0.0 and c >= 0.0:"),
        ("massless", "skim_state", "if way < 0 and s == 0.0 and c > 0.0:", "if way < 1 and s == 0.0 and c > 0.0:"),
        ("massless", "skim_state", "if way < 0 and s == 0.0 and c > 0.0:", "if way < 0 and s == 0.0 and c > -1.0:"),
        ("modes", "slip_mode", "return SKID if sigma > 0 else SPIN", "return SKID if sigma >= 0 else SPIN"),
        ("modes", "slip_mode", "return SKID if sigma > 0 else SPIN", "return SKID if sigma > -1 else SPIN"),
        ("modes", "frictionless_mode", "return slip_mode(1 if drive > 0.0 else -1)", "return slip_mode( 2 if drive > 0.0 else -1)"),
        ("modes", "frictionless_mode", "return slip_mode(1 if drive > 0.0 else -1)", "return slip_mode(1 if drive > 0.0 else - 2)"),
        ("modes", "frictionless_mode", "return slip_mode(1 if drive > 0.0 else -1)", "return slip_mode(1 if drive > 0.0 else - 0)"),
    ),
    "the size of a tolerance, of which the order counts": (
        ("modes", "can_roll", "close = min(tie, TIE * (a * abs(normal) + b * abs(friction)) + ROUNDING * (body.gn + abs(body.gt) + u))", "close = min(tie, TIE * (a * abs(normal) + b * abs(friction)) + ROUNDING * (body.gn - abs(body.gt) + u))"),
        ("panel_events", "end_of_rolling", "rounding = MARGIN_ROUNDING * (body.gn + abs(body.gt) + panel.u)", "rounding = MARGIN_ROUNDING * (body.gn - abs(body.gt) + panel.u)"),
        ("modes", "can_start_slip", "return leading_sign(series_n, scale * body.kap / stiffness) > 0 and sigma * leading_sign(series_v, scale) > 0", "return leading_sign(series_n, scale / body.kap / stiffness) > 0 and sigma * leading_sign(series_v, scale) > 0"),
        ("modes", "can_start_slip", "return leading_sign(series_n, scale * body.kap / stiffness) > 0 and sigma * leading_sign(series_v, scale) > 0", "return leading_sign(series_n, scale * body.kap * stiffness) > 0 and sigma * leading_sign(series_v, scale) > 0"),
        ("modes", "can_start_slip", "scale = body.gn + abs(body.gt) + u", "scale = body.gn - abs(body.gt) + u"),
    ),
    "where one of two formulas takes over from the other, and both hold": (
        ("painleve", "", "NEARLY = 1e-8  # nearer to zero than this κ p_σ and q have lost half their digits", "NEARLY = 1.00000001 # nearer to zero than this κ p_σ and q have lost half their digits"),
        ("flight", "flight_rates", "if abs(phi) > MANY_TURNS:", "if abs(phi) >= MANY_TURNS:"),
        ("compliant", "hunt_crossley_number", "if hunt_crossley_excess(restitution, high) < 0.0:  # the root is the pole, to rounding", "if hunt_crossley_excess(restitution, high) < -1.0: # the root is the pole, to rounding"),
        ("compliant", "hunt_crossley_number", "if hunt_crossley_excess(restitution, high) < 0.0:  # the root is the pole, to rounding", "if hunt_crossley_excess(restitution, high) < 1.0: # the root is the pole, to rounding"),
        ("compliant", "hunt_crossley_number", "if hunt_crossley_excess(restitution, high) < 0.0:  # the root is the pole, to rounding", "if hunt_crossley_excess(restitution, high) <= 0.0: # the root is the pole, to rounding"),
        ("panel_events", "end_of_rolling", "if body.resist > 0.0:", "if body.resist >= 0.0:"),
        ("flight", "", "MANY_TURNS = 1_000.0", "MANY_TURNS = 1001.0"),
        ("flight", "", "MANY_TURNS = 1_000.0", "MANY_TURNS = 999.0"),
    ),
    # the module massless_phase
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
    # the module kernel
    "SPIN is the slip whose direction is not above 0": (
        ("kernel", "begin_massless", "mode = slip_mode(1 if state.vt > 0.0 else -1)", "mode = slip_mode(1 if state.vt > 0.0 else - 0)"),
    ),
    "the rim on the plane is put there, or a height or speed is just at a bound that is some number": (
        ("kernel", "begin", "if 0.0 < state.y < LOWEST_START:", "if 0.0 <= state.y < LOWEST_START:"),
        ("kernel", "begin", "if 0.0 < state.y < LOWEST_START:", "if 0.0 < state.y <= LOWEST_START:"),
        ("kernel", "begin", "if body.resist > 0.0 and state.om * state.om < SMALLEST_SQUARE:  # as the phase will have it: the couple depends on it", "if body.resist > 0.0 and state.om * state.om <= SMALLEST_SQUARE: # as the phase will have it: the couple depends on it"),
    ),
    "a start on the plane comes here only if v_n is not 0": (
        ("kernel", "begin", "if state.y == 0.0 and state.vn < 0.0:", "if state.y == 0.0 and state.vn <= 0.0:"),
    ),
    "no bounce was before, and 0 and less mean that": (
        ("kernel", "begin", "return land(body, state, 0.0, log, scratch)", "return land(body, state, -1.0, log, scratch)"),
    ),
    "a script has two rows or none, as its last state stands there again": (
        ("kernel", "run", "if script.shape[0] > 1:", "if script.shape[0] >= 1:"),
    ),
    "a motion has its first event, so that the number of events is 1 or more, or −1; a full table takes no end": (
        ("kernel", "run", "if log.written[0] >= 0 and log.written[1] >= 0:  # also where the panels are used up: so far it has come", "if log.written[0] > 0 and log.written[1] >= 0: # also where the panels are used up: so far it has come"),
        ("kernel", "run", "if log.written[0] >= 0 and log.written[1] >= 0:  # also where the panels are used up: so far it has come", "if log.written[ 1] >= 0 and log.written[1] >= 0: # also where the panels are used up: so far it has come"),
        ("kernel", "run", "if log.written[0] >= 0 and log.written[1] >= 0:  # also where the panels are used up: so far it has come", "if log.written[ -1] >= 0 and log.written[1] >= 0: # also where the panels are used up: so far it has come"),
        ("kernel", "run", "if log.written[0] >= 0 and log.written[1] >= 0:  # also where the panels are used up: so far it has come", "if log.written[0] >= 1 and log.written[1] >= 0: # also where the panels are used up: so far it has come"),
        ("kernel", "run", "if log.written[0] >= 0 and log.written[1] >= 0:  # also where the panels are used up: so far it has come", "if log.written[0] >= -1 and log.written[1] >= 0: # also where the panels are used up: so far it has come"),
        ("kernel", "run", "if log.written[0] < 0:", "if log.written[0] <= 0:"),
        ("kernel", "run", "if log.written[0] < 0:", "if log.written[0] < 1:"),
    ),
    "a table of events has one axis, which is its first and its last": (
        ("kernel", "run", "count = log.written[0] if log.written[0] >= 0 else events.shape[0]", "count = log.written[0] if log.written[0] >= 0 else events.shape[ -1]"),
    ),
    "the equality of two rounded numbers beside a limit that may be another by as much": (
        ("contact_phase", "advance_contact", "if sigma != 0 and panel.kind == LINEAR and abs(panel.u - state.om * state.om) > LOST * panel.u:", "if sigma != 0 and panel.kind == LINEAR and abs(panel.u - state.om * state.om) >= LOST * panel.u:"),
        ("panel_events", "fall_of", "if found == NOT_FOUND and not state_is_fresh and lowest < -floor and highest <= floor:", "if found == NOT_FOUND and not state_is_fresh and lowest <= -floor and highest <= floor:"),
        ("panel_events", "fall_of", "if found == NOT_FOUND and not state_is_fresh and lowest < -floor and highest <= floor:", "if found == NOT_FOUND and not state_is_fresh and lowest < -floor and highest < floor:"),
    ),
    # the module flight_phase
    "from which angle on a flight counts as blurred may be another by a rad, or by none": (
        ("flight_phase", "", "BLURRED = 1e9", "BLURRED = 1000000001.0"),
        ("flight_phase", "", "BLURRED = 1e9", "BLURRED = 999999999.0"),
        ("flight_phase", "highest", "if abs(state.om * apex) < BLURRED:", "if abs(state.om * apex) <= BLURRED:"),
        ("flight_phase", "fly", "after = with_velocities(after, vt, 0.0, state.om) if abs(state.om * tau) < BLURRED else approaching(body, after)", "after = with_velocities(after, vt, 0.0, state.om) if abs(state.om * tau) <= BLURRED else approaching(body, after)"),
    ),
    "a landing without any speed is the same either way": (
        ("flight_phase", "fly", "if what == STOP and vn > 0.0:", "if what == STOP and vn >= 0.0:"),
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
    # the module limits
    "a double beside whole turns is away from them by some units of its last place, and never by just the bound": (
        ("limits", "limits_of", "if abs(rest) <= 4e-16 * span:", "if abs(rest) < 4e-16 * span:"),
    ),
    # the module phase
    # the module margins
    "without a limit μ N is infinite where N is above 0, and N is not 0 there": (
        ("margins", "margins_of", "limit = math.inf if math.isinf(mu) and normal > 0.0 else mu * normal", "limit = math.inf if math.isinf(mu) and normal >= 0.0 else mu * normal"),
        ("margins", "margins_of", "limit = math.inf if math.isinf(mu) and normal > 0.0 else mu * normal", "limit = math.inf if math.isinf(mu) and normal > 1.0 else mu * normal"),
    ),
    # end of these modules
    "an even function": (
        ("mass", "part_reach", "return math.hypot(at, 0.5 * first)", "return math.hypot(at, -0.5 * first)"),
        ("energy", "kinetic_energy", "height = 2.0 * np.cos(0.5 * th) ** 2 - sine * th_low  # 1 + cos θ, with all its digits also near θ = π", "height = 2.0 * np.cos( -0.5 * th) ** 2 - sine * th_low # 1 + cos θ, with all its digits also near θ = π"),
        ("energy", "potential_energy", "drop = y - 2.0 * body.eps * np.sin(0.5 * th) ** 2", "drop = y - 2.0 * body.eps * np.sin( -0.5 * th) ** 2"),
    ),
    "a short cut: what comes after it gives the same answer": (
        ("modes", "can_roll", "if normal < -tie or margin < -close:", "if normal < -tie and margin < -close:"),
        ("modes", "can_roll", "if normal > tie and margin > close:", "if not normal > tie and margin > close:"),
        ("modes", "can_roll", "if normal > tie and margin > close:", "if normal <= tie and margin > close:"),
        ("jets", "candidate_series", "q = _shifted(-rho, 1.0, _sum(eps, s, drag, arm)) if rho != 0.0 else _sum(eps, s, drag, arm)", "q = _shifted(-rho, 1.0, _sum(eps, s, drag, arm)) if rho != -1.0 else _sum(eps, s, drag, arm)"),
        ("jets", "candidate_series", "q = _shifted(-rho, 1.0, _sum(eps, s, drag, arm)) if rho != 0.0 else _sum(eps, s, drag, arm)", "q = _shifted(-rho, 1.0, _sum(eps, s, drag, arm)) if rho != 1.0 else _sum(eps, s, drag, arm)"),
        ("jets", "candidate_series", "if rho != 0.0:", "if rho != -1.0:"),
        ("jets", "candidate_series", "if rho != 0.0:", "if rho != 1.0:"),
        ("sampling", "place_on_panel", "if tau <= 0.0:", "if tau <= -1.0:"),
        ("sampling", "place_on_panel", "if tau <= 0.0:", "if tau < 0.0:"),
        ("resistance", "forces_rolling", "if body.resist == 0.0:", "if body.resist == -1.0:"),
        ("resistance", "motion_slipping", "if body.resist == 0.0:", "if body.resist == -1.0:"),
        ("resistance", "stiffness_slipping", "if body.resist == 0.0:", "if body.resist == -1.0:"),
        ("resistance", "acceleration_in_contact", "if body.resist == 0.0:", "if body.resist == -1.0:"),
        ("modes", "can_start_slip", "if load < -tie or sigma * slip < -tie:", "if load < -tie and sigma * slip < -tie:"),
        ("impact", "impact", "if rest == 0.0 or (body.law == NEWTON and not collision):", "if rest == 0.0 and (body.law == NEWTON and not collision):"),
        ("impact", "impact", "if rest == 0.0 or (body.law == NEWTON and not collision):", "if rest == -1.0 or (body.law == NEWTON and not collision):"),
    ),
    "a further piece of the impact that has no length": (
        ("impact", "impact", "break", "continue"),
        ("impact", "impact", "if vn > 0.0:  # the jerk along the plane alone lifts the hoop", "if vn >= 0.0: # the jerk along the plane alone lifts the hoop"),
    ),
    "a case that never comes: f_n and its first derivative vanish together only at the top, where the second is negative": (
        ("modes", "opening_sign", "return 1 if second > 0.0 else -1", "return 2 if second > 0.0 else -1"),
        ("modes", "opening_sign", "return 1 if second > 0.0 else -1", "return 0 if second > 0.0 else -1"),
        ("modes", "opening_sign", "return 1 if second > 0.0 else -1", "return 1 if second > 1.0 else -1"),
    ),
    "a case that never comes: restitution begins in stick, or in slip that is pushed off": (
        ("impact", "impact", "if not collision and compression and kn < 1e-9:", "if not collision and compression and kn < 1.000000001:"),
        ("impact", "impact", "length = (target - vn) / kn if kn > 0.0 else math.inf", "length = (target - vn) / kn if kn > -1.0 else math.inf"),
        ("impact", "impact", "if not collision and compression and kn < 1e-9:", "if not collision or compression and kn < 1e-9:"),
    ),
    "a case that never comes: where p_σ = 0 friction always slows the slip": (
        ("impact", "singular_slip", "stop = -vt / rate if vt * rate < 0.0 else math.inf", "stop = -vt / rate if vt * rate < 1.0 else math.inf"),
    ),
    "a collision so near to p_σ = 0 that a part in 10⁹ of v_n is all that changes": (
        ("impact", "impact", "if not collision and compression and kn < 1e-9:", "if not collision and compression or kn < 1e-9:"),
        ("impact", "impact", "if not collision and compression and kn < 1e-9:", "if not collision and compression and kn <= 1e-9:"),
    ),
    "a number that a slope never is": (
        ("impact", "singular_angle", "if slope != 0.0 and abs(distance) <= 1e-10 * abs(slope):", "if slope != 1.0 and abs(distance) <= 1e-10 * abs(slope):"),
        ("impact", "singular_angle", "if slope != 0.0 and abs(distance) <= 1e-10 * abs(slope):", "if slope != -1.0 and abs(distance) <= 1e-10 * abs(slope):"),
    ),
    "the sign of a zero": (
        ("resistance", "resistance_arm", "if body.resist == 0.0:", "if body.resist == -1.0:"),
    ),
    "a case that never comes: without rotation and gravity the couple makes p_σ no smaller": (
        ("modes", "next_mode", "if rho != 0.0 and stiffness + body.eps * s * rho > 0.0 and (opening < 0 or body.strike):", "if rho != 0.0 and stiffness + body.eps * s * rho > 0.0 and (opening <= 0 or body.strike):"),
        ("modes", "next_mode", "if rho != 0.0 and stiffness + body.eps * s * rho > 0.0 and (opening < 0 or body.strike):", "if rho != 0.0 and stiffness + body.eps * s * rho > 0.0 and (opening < 1 or body.strike):"),
    ),
    "how many times something is tried, or how many digits a name has, is a choice": (
        ("io", "", "MOST_READS = 100", "MOST_READS = 101"),
        ("io", "", "MOST_READS = 100", "MOST_READS = 99"),
        ("_files", "replacing", "temporary = target.with_name(f\".{uuid.uuid4().hex[:12]}.{target.name}\")", "temporary = target.with_name(f\".{uuid.uuid4().hex[: 13]}.{target.name}\")"),
        ("_files", "replacing", "temporary = target.with_name(f\".{uuid.uuid4().hex[:12]}.{target.name}\")", "temporary = target.with_name(f\".{uuid.uuid4().hex[: 11]}.{target.name}\")"),
        ("_files", "_put_folder", "old = target.with_name(f\".{uuid.uuid4().hex[:12]}.old\")", "old = target.with_name(f\".{uuid.uuid4().hex[: 13]}.old\")"),
        ("_files", "_put_folder", "old = target.with_name(f\".{uuid.uuid4().hex[:12]}.old\")", "old = target.with_name(f\".{uuid.uuid4().hex[: 11]}.old\")"),
        ("_files", "_put_folder", "for _ in range(1000):", "for _ in range( 1001):"),
        ("_files", "_put_folder", "for _ in range(1000):", "for _ in range( 999):"),
        ("store", "_create", "fresh = path.with_name(f\".{os.urandom(6).hex()}.{path.name}\")", "fresh = path.with_name(f\".{os.urandom( 7).hex()}.{path.name}\")"),
        ("store", "_create", "fresh = path.with_name(f\".{os.urandom(6).hex()}.{path.name}\")", "fresh = path.with_name(f\".{os.urandom( 5).hex()}.{path.name}\")"),
    ),
    "how many bytes are read at once": (
        ("formats", "_decoded", "content = stream.read(MOST_BYTES + 1)", "content = stream.read(MOST_BYTES + 2)"),
        ("_checksum", "is_broken", "piece = stream.read(min(length, 1 << 20))", "piece = stream.read(min(length, 2 << 20))"),
        ("_checksum", "is_broken", "piece = stream.read(min(length, 1 << 20))", "piece = stream.read(min(length, 1 << 21))"),
        ("_checksum", "is_broken", "piece = stream.read(min(length, 1 << 20))", "piece = stream.read(min(length, 1 << 19))"),
    ),
    "behind what was read to its end is the end": (
        ("_checksum", "seal", "stream.seek(0, 2)", "stream.seek(0, 1)"),
    ),
    "columns of one table have the same length": (
        ("export", "write_csv", "_write_rows(Path(path), header, zip(*(column.tolist() for column in columns), strict=True))", "_write_rows(Path(path), header, zip(*(column.tolist() for column in columns), strict=False))"),
        ("io", "_unpacked", "first = dataset[layout[0][0]]", "first = dataset[layout[ 1][0]]"),
        ("io", "_unpacked", "first = dataset[layout[0][0]]", "first = dataset[layout[ -1][0]]"),
        ("io", "_unpacked", "table = np.empty(first.shape[0], dtype=np.dtype(layout))", "table = np.empty(first.shape[ -1], dtype=np.dtype(layout))"),
    ),
    "JSON reads the same with and without escapes": (
        ("export", "_attributes", "\"scenario\": json.dumps(motion.scenario.to_dict(), ensure_ascii=False),", "\"scenario\": json.dumps(motion.scenario.to_dict(), ensure_ascii=True),"),
    ),
    "only another process at the same moment makes a difference": (
        ("_files", "_put_folder", "shutil.rmtree(fresh, ignore_errors=True)", "shutil.rmtree(fresh, ignore_errors=False)"),
        ("store", "finish", "left.unlink(missing_ok=True)", "left.unlink(missing_ok=False)"),
    ),
    "an array or a group that is not there yet": (
        ("export", "save", 'mode = "w" if name == "/" else "a"', 'mode = "w" if name != "/" else "a"'),
        ("export", "save", 'mode = "w" if name == "/" else "a"', 'mode = "w" if not name == "/" else "a"'),
        ("store", "", "def _create_array(group: Any, plan: Plan, quantity: Quantity, dtype: str, overwrite: bool = False) -> Any:", "def _create_array(group: Any, plan: Plan, quantity: Quantity, dtype: str, overwrite: bool = True) -> Any:"),
    ),
    "what pydantic says besides, which is not read": (
        ("sentences", "sentence", "return findings_sentence(error.errors(include_url=False), _PLACES.get(error.title, error.title.lower()))", "return findings_sentence(error.errors(include_url=True), _PLACES.get(error.title, error.title.lower()))"),
    ),
    "of several near names the nearest is the first, and one is asked for": (
        ("base", "Frozen._known_keys", "close = difflib.get_close_matches(str(key), known, n=1)", "close = difflib.get_close_matches(str(key), known, n= 2)"),
        ("base", "Frozen._known_keys", 'hint = say("did_you_mean", close=close[0]) if close else say("known_are", known=", ".join(known))', 'hint = say("did_you_mean", close=close[ -1]) if close else say("known_are", known=", ".join(known))'),
    ),
    "nothing in a frozen model can change": (
        ("base", "", "def model_copy(self, *, update: Mapping[str, Any] | None = None, deep: bool = False) -> Self:", "def model_copy(self, *, update: Mapping[str, Any] | None = None, deep: bool = True) -> Self:"),
    ),
    "the only one is the first and the last": (
        ("models", "Hoop._complete", 'raise refuse(say("half_a_hoop", missing=missing, given=given[0]))', 'raise refuse(say("half_a_hoop", missing=missing, given=given[ -1]))'),
    ),
    "a case that never comes: only a rolling start has no omega of its own": (
        ("models", "Start.state", "omega = self.omega if self.omega is not None else 0.0", "omega = self.omega if self.omega is not None else 1.0"),
        ("models", "Start.state", "omega = self.omega if self.omega is not None else 0.0", "omega = self.omega if self.omega is not None else -1.0"),
    ),
    "a length that this kind of part does not have, and nothing reads": (
        ("parts", "Disk.row", "return mass.DISK, self.mass, self.radius, 0.0, self.at", "return mass.DISK, self.mass, self.radius, 1.0, self.at"),
        ("parts", "Disk.row", "return mass.DISK, self.mass, self.radius, 0.0, self.at", "return mass.DISK, self.mass, self.radius, -1.0, self.at"),
        ("parts", "PointMass.row", "return mass.POINT_MASS, self.mass, 0.0, 0.0, self.at", "return mass.POINT_MASS, self.mass, 1.0, 0.0, self.at"),
        ("parts", "PointMass.row", "return mass.POINT_MASS, self.mass, 0.0, 0.0, self.at", "return mass.POINT_MASS, self.mass, -1.0, 0.0, self.at"),
        ("parts", "PointMass.row", "return mass.POINT_MASS, self.mass, 0.0, 0.0, self.at", "return mass.POINT_MASS, self.mass, 0.0, 1.0, self.at"),
        ("parts", "PointMass.row", "return mass.POINT_MASS, self.mass, 0.0, 0.0, self.at", "return mass.POINT_MASS, self.mass, 0.0, -1.0, self.at"),
        ("parts", "Rod.row", "return kind, self.mass, self.length, 0.0, self.at", "return kind, self.mass, self.length, 1.0, self.at"),
        ("parts", "Rod.row", "return kind, self.mass, self.length, 0.0, self.at", "return kind, self.mass, self.length, -1.0, self.at"),
    ),
    "only the order counts": (
        ("paths", "_rank", 'return (section == "start", 0 if not rest else 1 if path in ("contact.model", "hoop.parts") else 2)', 'return (section == "start", -1 if not rest else 1 if path in ("contact.model", "hoop.parts") else 2)'),
        ("paths", "_rank", 'return (section == "start", 0 if not rest else 1 if path in ("contact.model", "hoop.parts") else 2)', 'return (section == "start", 0 if not rest else 1 if path in ("contact.model", "hoop.parts") else 3)'),
    ),
    "keys and words are plain letters": (
        ("scenario", "Scenario.save", 'text = json.dumps(self.to_dict(), indent=2, ensure_ascii=False) + "\\n"', 'text = json.dumps(self.to_dict(), indent=2, ensure_ascii=True) + "\\n"'),
    ),
    "only arrays and numbers of NumPy have an item, and these have dimensions": (
        ("sentences", "_show", 'return shortened(repr(value.item() if hasattr(value, "item") and getattr(value, "ndim", 1) == 0 else value))', 'return shortened(repr(value.item() if hasattr(value, "item") and getattr(value, "ndim", 2) == 0 else value))'),
        ("sentences", "_show", 'return shortened(repr(value.item() if hasattr(value, "item") and getattr(value, "ndim", 1) == 0 else value))', 'return shortened(repr(value.item() if hasattr(value, "item") and getattr(value, "ndim", 0) == 0 else value))'),
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
        ("kernel", "begin", "if 0.0 < state.y < LOWEST_START:", "if -1.0 < state.y < LOWEST_START:"),
        ("doubts", "grazes_zero", "for k in range(ORDER - 1, 0, -1):", "for k in range(ORDER - 1, -1, -1):"),
    ),
    "a factor of the whole series, of which only the zeros count": (
        ("doubts", "grazes_zero", "before = after - 2.0 * k * series[k]", "before = after - 3.0 * k * series[k]"),
    ),
    "where the arrays were too short the motion is computed again": (
        ("errors", "event_errors", "plain = _again(body, row, t_end, 2 * count + 8)", "plain = _again(body, row, t_end, 3 * count + 8)"),
        ("errors", "event_errors", "plain = _again(body, row, t_end, 2 * count + 8)", "plain = _again(body, row, t_end, 2 * count + 9)"),
    ),
    "a table of one column of rows": (
        ("kernel", "run", "if script.shape[0] > 1:", "if script.shape[ -1] > 1:"),
        ("friction", "utilizations", "for i in range(out.shape[0]):", "for i in range(out.shape[ -1]):"),
        ("kernel", "run", "return BUFFER, count, segments.shape[0]", "return BUFFER, count, segments.shape[ -1]"),
    ),
    "a script has two rows or none": (
        ("kernel", "run", "if script.shape[0] > 1:", "if script.shape[0] > 0:"),
    ),
    "which panels are tried, not what comes of them": (
        ("panel_choice", "choose_panel", "if not work[U, ORDER - 1] > 0.8 * u:", "if not work[U, ORDER - 1] > 0.8 / u:"),
        ("panel_choice", "solve_arrival", "power = 1.0  # of `ahead` in θ̇² at the start", "power = 2.0 # of `ahead` in θ̇² at the start"),
        ("panel_choice", "", "MOST_MOVES = 8  # of a turning point", "MOST_MOVES = 9 # of a turning point"),
        ("panel_choice", "choose_panel", "level = min(level + int(math.floor(2.0 * math.log2(panel.extent / ahead))) - 3, finest)", "level = min(level + int(math.floor(2.0 * math.log2(panel.extent / ahead))) - 4, finest)"),
        ("panel_choice", "solve_arrival", "break", "continue"),
        ("panel_choice", "narrower", "return level + max(1, min(4, more))", "return level + max( 0, min(4, more))"),
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
    "a case that never comes: where θ̇ grows the slip stops first, or it jams": (
        ("impact", "singular_slip", "spin = 0.0 if rho != 0.0 and length < stop and turn * om <= 0.0 else om + turn * length", "spin = 0.0 if rho != 0.0 and length < stop and turn * om <= 1.0 else om + turn * length"),
    ),
    "any place will do to measure from": (
        ("mass", "combined", "first = parts[0, AT] / radius", "first = parts[ -1, AT] / radius"),
    ),
    # contact_phase
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
    # errors
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
    # doubts
    "where the nodes show no graze it is looked for as well, which takes time": (
        ("doubts", "", "NEARBY = 0.015  # of the range of a margin on a panel: half the distance of two nodes, squared, beside half the panel", "NEARBY = 1.015 # of the range of a margin on a panel: half the distance of two nodes, squared, beside half the panel"),
    ),
    "begin and end of a doubt are set together": (
        ("doubts", "note_doubt", "if math.isnan(scratch.doubt[0]):", "if math.isnan(scratch.doubt[ 1]):"),
        ("doubts", "note_doubt", "if math.isnan(scratch.doubt[0]):", "if math.isnan(scratch.doubt[ -1]):"),
    ),
    "a rounded number as large as a tolerance, or a margin that is zero, where the answer came before": (
        ("doubts", "mode_is_in_doubt", "return opening <= CLOSE * (body.gn + body.eps * u)", "return opening < CLOSE * (body.gn + body.eps * u)"),
        ("doubts", "mode_is_in_doubt", "return margin < 0.0 and opening <= CLOSE * scale", "return margin < 0.0 and opening < CLOSE * scale"),
        ("doubts", "mode_is_in_doubt", "if abs(margin) <= CLOSE * scale or abs(normal) <= CLOSE * scale:", "if abs(margin) < CLOSE * scale or abs(normal) <= CLOSE * scale:"),
        ("doubts", "mode_is_in_doubt", "if abs(margin) <= CLOSE * scale or abs(normal) <= CLOSE * scale:", "if abs(margin) <= CLOSE * scale or abs(normal) < CLOSE * scale:"),
        ("doubts", "mode_is_in_doubt", "return margin < 0.0 and opening <= CLOSE * scale", "return margin <= 0.0 and opening <= CLOSE * scale"),
        ("doubts", "grazes_zero", "if abs(series_value(series, xi)) <= CLOSE * scale:", "if abs(series_value(series, xi)) < CLOSE * scale:"),
    ),
    "which row of the scratch arrays the derivative is in": (
        ("doubts", "grazes_zero", "rate = scratch.values[1]", "rate = scratch.values[ 0]"),
    ),
    "a factor of all the derivative, of which only the falls through zero count": (
        ("doubts", "grazes_zero", "before = after - 2.0 * k * series[k]", "before = after - 1.0 * k * series[k]"),
    ),
    "before the panel and at its very begin no smallest value is found": (
        ("doubts", "grazes_zero", "begin = -2.0", "begin = - 3.0"),
        ("doubts", "grazes_zero", "begin = -2.0", "begin = - 1.0"),
    ),
    "how many smallest values are looked at is a choice": (
        ("doubts", "grazes_zero", "for _ in range(4):", "for _ in range( 5):"),
    ),
    "where a value falls through zero it is not above 0": (
        ("doubts", "grazes_zero", "xi = first_fall_after(rate, begin, 0.0, scratch.stack)", "xi = first_fall_after(rate, begin, -1.0, scratch.stack)"),
    ),
}
# fmt: on

EXPLAINED = {key: reason for reason, keys in _BY_REASON.items() for key in keys}
