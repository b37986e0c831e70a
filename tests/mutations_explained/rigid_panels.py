"""Why changes of what `hophoop.kernel.rigid` does with panels cannot be seen."""

# fmt: off
REASONS: dict[str, tuple[tuple[str, str, str, str], ...]] = {
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
        ("panel_choice", "turns_within", "if u_on_panel(body, panel, panel.way * sine, 2.0 * half * half, panel.way * reach) < 0.0:", "if u_on_panel(body, panel, panel.way * sine, 2.0 * half * half, panel.way * reach) <= 0.0:"),
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
    "a factor of the whole series, of which only the zeros count": (
        ("doubts", "grazes_zero", "before = after - 2.0 * k * series[k]", "before = after - 3.0 * k * series[k]"),
    ),
    "which panels are tried, not what comes of them": (
        ("panel_choice", "choose_panel", "if not work[U, ORDER - 1] > 0.8 * u:", "if not work[U, ORDER - 1] > 0.8 / u:"),
        ("panel_choice", "solve_arrival", "power = 1.0  # of `ahead` in θ̇² at the start", "power = 2.0 # of `ahead` in θ̇² at the start"),
        ("panel_choice", "", "MOST_MOVES = 8  # of a turning point", "MOST_MOVES = 9 # of a turning point"),
        ("panel_choice", "choose_panel", "level = min(level + int(math.floor(2.0 * math.log2(panel.extent / ahead))) - 3, finest)", "level = min(level + int(math.floor(2.0 * math.log2(panel.extent / ahead))) - 4, finest)"),
        ("panel_choice", "solve_arrival", "break", "continue"),
        ("panel_choice", "narrower", "return level + max(1, min(4, more))", "return level + max( 0, min(4, more))"),
    ),
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
