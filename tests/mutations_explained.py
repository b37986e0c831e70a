"""Why a change of the source cannot be seen: by module, function, the line as it stands and as it is with the change."""

from __future__ import annotations

# fmt: off
_BY_REASON: dict[str, tuple[tuple[str, str, str, str], ...]] = {
    "an equality of two rounded numbers, where both sides give the same or the model has a tie": (
        ("compliant", "first_regime", "if abs(bristle_force) <= comp.mu_s * normal:", "if abs(bristle_force) < comp.mu_s * normal:"),  # noqa: E501
        ("compliant", "first_regime", "return 1 if bristle_force > 0.0 else -1", "return 1 if bristle_force >= 0.0 else -1"),  # noqa: E501
        ("compliant", "first_regime", "if abs(vt) <= creep_speed(comp):", "if abs(vt) < creep_speed(comp):"),  # noqa: E501
        ("compliant", "first_regime", "return 1 if vt > 0.0 else -1", "return 1 if vt >= 0.0 else -1"),  # noqa: E501
        ("compliant", "ratio_restitution", "if ratio < 1.0:", "if ratio <= 1.0:"),  # noqa: E501
        ("compliant", "ratio_restitution", "return math.exp(-2.0 * ratio * math.acos(ratio) / root) if root > 0.0 else math.exp(-2.0)", "return math.exp(-2.0 * ratio * math.acos(ratio) / root) if root >= 0.0 else math.exp(-2.0)"),  # noqa: E501
        ("compliant", "damping_ratio", "while ratio_restitution(high) > restitution:", "while ratio_restitution(high) >= restitution:"),  # noqa: E501
        ("compliant", "hunt_crossley_number", "if excess(high) < 0.0:  # the root is the pole, to rounding", "if excess(high) <= 0.0: # the root is the pole, to rounding"),  # noqa: E501
        ("compliant", "hunt_crossley_number", "while excess(low) >= 0.0:", "while excess(low) > 0.0:"),  # noqa: E501
        ("compliant", "static_excess", "if height(left) < height(right):", "if height(left) <= height(right):"),  # noqa: E501
        ("compliant", "static_excess", "while peak(high) < mu_static:", "while peak(high) <= mu_static:"),  # noqa: E501
        ("compliant", "_bisect", "if not low < middle < high:", "if not low <= middle < high:"),  # noqa: E501
        ("compliant", "_bisect", "if not low < middle < high:", "if not low < middle <= high:"),  # noqa: E501
        ("compliant", "_bisect", "if rising(middle) < 0.0:", "if rising(middle) <= 0.0:"),  # noqa: E501
        ("contact", "load_height", "return s * s / (1.0 - c) if c < 0.0 else 1.0 + c", "return s * s / (1.0 - c) if c <= 0.0 else 1.0 + c"),  # noqa: E501
        ("impact", "impulse_ratio", "if abs(stick) <= body.mu_s:", "if abs(stick) < body.mu_s:"),  # noqa: E501
        ("impact", "impulse_ratio", "return (-body.mu_k if stick < 0.0 else body.mu_k), False", "return (-body.mu_k if stick <= 0.0 else body.mu_k), False"),  # noqa: E501
        ("impact", "impact", "if not collision and compression and not stick and kn < 1e-9:", "if not collision and compression and not stick and kn <= 1e-9:"),  # noqa: E501
        ("impact", "impact", "length = -vn / kn if kn > 0.0 else math.inf", "length = -vn / kn if kn >= 0.0 else math.inf"),  # noqa: E501
        ("impact", "impact", "length = (target - vn) / kn if kn > 0.0 else math.inf", "length = (target - vn) / kn if kn >= 0.0 else math.inf"),  # noqa: E501
        ("impact", "impact", "if length <= step:", "if length < step:"),  # noqa: E501
        ("impact", "singular_slip", "sigma = 1.0 if vt > 0.0 else -1.0", "sigma = 1.0 if vt >= 0.0 else -1.0"),  # noqa: E501
        ("impact", "singular_slip", "stop = -vt / rate if vt * rate < 0.0 else math.inf", "stop = -vt / rate if vt * rate <= 0.0 else math.inf"),  # noqa: E501
        ("impact", "singular_slip", "limit = (math.copysign(math.sqrt(body.gn / outward), om) - om) / turn if outward > 0.0 else math.inf", "limit = (math.copysign(math.sqrt(body.gn / outward), om) - om) / turn if outward >= 0.0 else math.inf"),  # noqa: E501
        ("impact", "singular_slip", "if limit <= stop:", "if limit < stop:"),  # noqa: E501
        ("impact", "singular_angle", "if slope != 0.0 and abs(distance) <= 1e-10 * abs(slope):", "if slope != 0.0 and abs(distance) < 1e-10 * abs(slope):"),  # noqa: E501
        ("jets", "leading_sign", "if abs(value) > ZERO * scale:", "if abs(value) >= ZERO * scale:"),  # noqa: E501
        ("jets", "leading_sign", "return 1 if value > 0.0 else -1", "return 1 if value >= 0.0 else -1"),  # noqa: E501
        ("massless", "skim_state", "if versine >= 2.0:", "if versine > 2.0:"),  # noqa: E501
        ("massless", "strike", "if abs(vx) <= limit:", "if abs(vx) < limit:"),  # noqa: E501
        ("modes", "opening_sign", "return 1 if f_n > 0.0 else -1", "return 1 if f_n >= 0.0 else -1"),  # noqa: E501
        ("modes", "opening_sign", "return 1 if first > 0.0 else -1", "return 1 if first >= 0.0 else -1"),  # noqa: E501
        ("modes", "opening_sign", "return 1 if second > 0.0 else -1", "return 1 if second >= 0.0 else -1"),  # noqa: E501
        ("modes", "can_roll", "if normal > tie and margin > tie:", "if normal >= tie and margin > tie:"),  # noqa: E501
        ("modes", "can_roll", "if normal > tie and margin > tie:", "if normal > tie and margin >= tie:"),  # noqa: E501
        ("modes", "can_roll", "if normal < -tie or margin < -tie:", "if normal <= -tie or margin < -tie:"),  # noqa: E501
        ("modes", "can_roll", "if normal < -tie or margin < -tie:", "if normal < -tie or margin <= -tie:"),  # noqa: E501
        ("modes", "can_start_slip", "if stiffness <= 0.0:", "if stiffness < 0.0:"),  # noqa: E501
        ("modes", "can_start_slip", "if load < -tie or sigma * slip < -tie:", "if load <= -tie or sigma * slip < -tie:"),  # noqa: E501
        ("modes", "can_start_slip", "if load < -tie or sigma * slip < -tie:", "if load < -tie or sigma * slip <= -tie:"),  # noqa: E501
        ("modes", "can_start_slip", "if load > tie and sigma * slip > tie:", "if load >= tie and sigma * slip > tie:"),  # noqa: E501
        ("modes", "can_start_slip", "if load > tie and sigma * slip > tie:", "if load > tie and sigma * slip >= tie:"),  # noqa: E501
        ("modes", "frictionless_mode", "return slip_mode(1 if drive > 0.0 else -1)", "return slip_mode(1 if drive >= 0.0 else -1)"),  # noqa: E501
        ("modes", "next_mode", "if a * normal >= b * abs(friction):", "if a * normal > b * abs(friction):"),  # noqa: E501
        ("modes", "next_mode", "return slip_mode(-1 if friction > 0.0 else 1)", "return slip_mode(-1 if friction >= 0.0 else 1)"),  # noqa: E501
        ("modes", "next_mode", "sigma = 1 if vt > 0.0 else -1", "sigma = 1 if vt >= 0.0 else -1"),  # noqa: E501
        ("modes", "next_mode", "if abs(stiffness) <= 4e-16 * (1.0 + body.mu_k):", "if abs(stiffness) < 4e-16 * (1.0 + body.mu_k):"),  # noqa: E501
        ("modes", "next_mode", "if stiffness > 0.0:", "if stiffness >= 0.0:"),  # noqa: E501
        ("modes", "next_mode", "return INDETERMINATE if stiffness < 0.0 else FLIGHT", "return INDETERMINATE if stiffness <= 0.0 else FLIGHT"),  # noqa: E501
    ),
    "where a search begins or how it goes on, which finds the same root": (
        ("compliant", "damping_ratio", "low, high = 0.0, 1.0", "low, high = -1.0, 1.0"),  # noqa: E501
        ("compliant", "damping_ratio", "low, high = 0.0, 1.0", "low, high = 0.0, 2.0"),  # noqa: E501
        ("compliant", "damping_ratio", "low, high = high, 2.0 * high", "low, high = high, 2.0 / high"),  # noqa: E501
        ("compliant", "damping_ratio", "low, high = high, 2.0 * high", "low, high = high, 3.0 * high"),  # noqa: E501
        ("compliant", "hunt_crossley_number", "if excess(high) < 0.0:  # the root is the pole, to rounding", "if excess(high) < 1.0: # the root is the pole, to rounding"),  # noqa: E501
        ("compliant", "hunt_crossley_number", "if excess(high) < 0.0:  # the root is the pole, to rounding", "if excess(high) < -1.0: # the root is the pole, to rounding"),  # noqa: E501
        ("compliant", "hunt_crossley_number", "low = 0.5 * pole", "low = 0.5 / pole"),  # noqa: E501
        ("compliant", "hunt_crossley_number", "low *= 0.5", "low *= -0.5"),  # noqa: E501
        ("compliant", "static_excess", "low, high = 0.0, 4.0 * STRIBECK", "low, high = 1.0, 4.0 * STRIBECK"),  # noqa: E501
        ("compliant", "static_excess", "low, high = 0.0, 4.0 * STRIBECK", "low, high = -1.0, 4.0 * STRIBECK"),  # noqa: E501
        ("compliant", "static_excess", "low, high = 0.0, 4.0 * STRIBECK", "low, high = 0.0, 5.0 * STRIBECK"),  # noqa: E501
        ("compliant", "static_excess", "low, high = 0.0, 4.0 * STRIBECK", "low, high = 0.0, 3.0 * STRIBECK"),  # noqa: E501
        ("compliant", "static_excess", "share = 0.5 * (math.sqrt(5.0) - 1.0)", "share = 0.5 * (math.sqrt( 6.0) - 1.0)"),  # noqa: E501
        ("compliant", "static_excess", "for _ in range(80):", "for _ in range( 81):"),  # noqa: E501
        ("compliant", "static_excess", "for _ in range(80):", "for _ in range( 79):"),  # noqa: E501
        ("compliant", "static_excess", "high = mu_static - mu_kinetic", "high = mu_static + mu_kinetic"),  # noqa: E501
        ("compliant", "static_excess", "high *= 2.0", "high *= 3.0"),  # noqa: E501
        ("compliant", "static_excess", "return _bisect(lambda excess: peak(excess) - mu_static, 0.0, high)", "return _bisect(lambda excess: peak(excess) - mu_static, -1.0, high)"),  # noqa: E501
        ("compliant", "_bisect", "for _ in range(200):", "for _ in range( 201):"),  # noqa: E501
        ("compliant", "_bisect", "for _ in range(200):", "for _ in range( 199):"),  # noqa: E501
    ),
    "an initial value that is written over before it is read": (
        ("impact", "impact", "target = 0.0", "target = 1.0"),  # noqa: E501
        ("impact", "impact", "target = 0.0", "target = -1.0"),  # noqa: E501
        ("jets", "candidate_series", "normal = (0.0, 0.0, 0.0, 0.0, 0.0)", "normal = ( 1.0, 0.0, 0.0, 0.0, 0.0)"),  # noqa: E501
        ("jets", "candidate_series", "normal = (0.0, 0.0, 0.0, 0.0, 0.0)", "normal = ( -1.0, 0.0, 0.0, 0.0, 0.0)"),  # noqa: E501
        ("jets", "candidate_series", "normal = (0.0, 0.0, 0.0, 0.0, 0.0)", "normal = (0.0, 1.0, 0.0, 0.0, 0.0)"),  # noqa: E501
        ("jets", "candidate_series", "normal = (0.0, 0.0, 0.0, 0.0, 0.0)", "normal = (0.0, -1.0, 0.0, 0.0, 0.0)"),  # noqa: E501
        ("jets", "candidate_series", "normal = (0.0, 0.0, 0.0, 0.0, 0.0)", "normal = (0.0, 0.0, 1.0, 0.0, 0.0)"),  # noqa: E501
        ("jets", "candidate_series", "normal = (0.0, 0.0, 0.0, 0.0, 0.0)", "normal = (0.0, 0.0, -1.0, 0.0, 0.0)"),  # noqa: E501
        ("jets", "candidate_series", "normal = (0.0, 0.0, 0.0, 0.0, 0.0)", "normal = (0.0, 0.0, 0.0, 1.0, 0.0)"),  # noqa: E501
        ("jets", "candidate_series", "normal = (0.0, 0.0, 0.0, 0.0, 0.0)", "normal = (0.0, 0.0, 0.0, -1.0, 0.0)"),  # noqa: E501
        ("jets", "candidate_series", "normal = (0.0, 0.0, 0.0, 0.0, 0.0)", "normal = (0.0, 0.0, 0.0, 0.0, 1.0)"),  # noqa: E501
        ("jets", "candidate_series", "normal = (0.0, 0.0, 0.0, 0.0, 0.0)", "normal = (0.0, 0.0, 0.0, 0.0, -1.0)"),  # noqa: E501
    ),
    "coefficients that the passes over the series write over": (
        ("jets", "candidate_series", "rate = (om, 0.0, 0.0, 0.0, 0.0)", "rate = (om, 1.0, 0.0, 0.0, 0.0)"),  # noqa: E501
        ("jets", "candidate_series", "rate = (om, 0.0, 0.0, 0.0, 0.0)", "rate = (om, -1.0, 0.0, 0.0, 0.0)"),  # noqa: E501
        ("jets", "candidate_series", "rate = (om, 0.0, 0.0, 0.0, 0.0)", "rate = (om, 0.0, 1.0, 0.0, 0.0)"),  # noqa: E501
        ("jets", "candidate_series", "rate = (om, 0.0, 0.0, 0.0, 0.0)", "rate = (om, 0.0, -1.0, 0.0, 0.0)"),  # noqa: E501
        ("jets", "candidate_series", "rate = (om, 0.0, 0.0, 0.0, 0.0)", "rate = (om, 0.0, 0.0, 1.0, 0.0)"),  # noqa: E501
        ("jets", "candidate_series", "rate = (om, 0.0, 0.0, 0.0, 0.0)", "rate = (om, 0.0, 0.0, -1.0, 0.0)"),  # noqa: E501
        ("jets", "candidate_series", "rate = (om, 0.0, 0.0, 0.0, 0.0)", "rate = (om, 0.0, 0.0, 0.0, 1.0)"),  # noqa: E501
        ("jets", "candidate_series", "rate = (om, 0.0, 0.0, 0.0, 0.0)", "rate = (om, 0.0, 0.0, 0.0, -1.0)"),  # noqa: E501
    ),
    "a bound on a loop that ends before": (
        ("impact", "impact", "for _ in range(8):", "for _ in range( 9):"),  # noqa: E501
        ("impact", "impact", "for _ in range(8):", "for _ in range( 7):"),  # noqa: E501
    ),
    "a quotient has the sign of the product, and only the sign counts": (
        ("impact", "singular_slip", "stop = -vt / rate if vt * rate < 0.0 else math.inf", "stop = -vt / rate if vt / rate < 0.0 else math.inf"),  # noqa: E501
        ("modes", "opening_sign", "second = -body.eps * c * u * u", "second = -body.eps / c * u * u"),  # noqa: E501
        ("modes", "frictionless_mode", "bend = body.eps * (u - (body.gn - body.eps * c * u) * (1.0 + body.eps * c) / (body.kap + body.eps * s * body.eps * s))", "bend = body.eps / (u - (body.gn - body.eps * c * u) * (1.0 + body.eps * c) / (body.kap + body.eps * s * body.eps * s))"),  # noqa: E501
        ("modes", "frictionless_mode", "drive = s * bend if s != 0.0 else om * c * bend", "drive = s / bend if s != 0.0 else om * c * bend"),  # noqa: E501
        ("modes", "frictionless_mode", "drive = s * bend if s != 0.0 else om * c * bend", "drive = s * bend if s != 0.0 else om / c * bend"),  # noqa: E501
        ("modes", "frictionless_mode", "drive = s * bend if s != 0.0 else om * c * bend", "drive = s * bend if s != 0.0 else om * c / bend"),  # noqa: E501
    ),
    "only the sign counts, and the number is never 0": (
        ("massless", "skim_state", "th_end = turns + 2.0 * half if way > 0 else turns + 2.0 * math.pi - 2.0 * half", "th_end = turns + 2.0 * half if way >= 0 else turns + 2.0 * math.pi - 2.0 * half"),  # noqa: E501
        ("massless", "skim_state", "th_end = turns + 2.0 * half if way > 0 else turns + 2.0 * math.pi - 2.0 * half", "th_end = turns + 2.0 * half if way > -1 else turns + 2.0 * math.pi - 2.0 * half"),  # noqa: E501
        ("massless", "skim_state", "if way < 0 and s == 0.0 and c > 0.0:", "if way <= 0 and s == 0.0 and c > 0.0:"),  # noqa: E501
        ("massless", "skim_state", "if way < 0 and s == 0.0 and c > 0.0:", "if way < 0 and s == 0.0 and c >= 0.0:"),  # noqa: E501
        ("massless", "skim_state", "if way < 0 and s == 0.0 and c > 0.0:", "if way < 1 and s == 0.0 and c > 0.0:"),  # noqa: E501
        ("massless", "skim_state", "if way < 0 and s == 0.0 and c > 0.0:", "if way < 0 and s == 0.0 and c > -1.0:"),  # noqa: E501
        ("modes", "slip_mode", "return SKID if sigma > 0 else SPIN", "return SKID if sigma >= 0 else SPIN"),  # noqa: E501
        ("modes", "slip_mode", "return SKID if sigma > 0 else SPIN", "return SKID if sigma > -1 else SPIN"),  # noqa: E501
        ("modes", "can_start_slip", "if load < -tie or sigma * slip < -tie:", "if load < -tie or sigma / slip < -tie:"),  # noqa: E501
        ("modes", "can_start_slip", "if load > tie and sigma * slip > tie:", "if load > tie and sigma / slip > tie:"),  # noqa: E501
        ("modes", "can_start_slip", "return leading_sign(series_n, scale * body.kap / stiffness) > 0 and sigma * leading_sign(series_v, scale) > 0", "return leading_sign(series_n, scale * body.kap / stiffness) > 0 and sigma / leading_sign(series_v, scale) > 0"),  # noqa: E501
        ("modes", "frictionless_mode", "return slip_mode(1 if drive > 0.0 else -1)", "return slip_mode( 2 if drive > 0.0 else -1)"),  # noqa: E501
        ("modes", "frictionless_mode", "return slip_mode(1 if drive > 0.0 else -1)", "return slip_mode(1 if drive > 0.0 else - 2)"),  # noqa: E501
        ("modes", "frictionless_mode", "return slip_mode(1 if drive > 0.0 else -1)", "return slip_mode(1 if drive > 0.0 else - 0)"),  # noqa: E501
    ),
    "the size of a tolerance, of which the order counts": (
        ("impact", "singular_angle", "if slope != 0.0 and abs(distance) <= 1e-10 * abs(slope):", "if slope != 0.0 and abs(distance) <= 1e-10 / abs(slope):"),  # noqa: E501
        ("impact", "singular_angle", "near = abs(distance) <= 1e-5 * abs(slope) and opening <= 1e-5 * (body.gn + body.eps * u)", "near = abs(distance) <= 1e-5 / abs(slope) and opening <= 1e-5 * (body.gn + body.eps * u)"),  # noqa: E501
        ("impact", "singular_angle", "near = abs(distance) <= 1e-5 * abs(slope) and opening <= 1e-5 * (body.gn + body.eps * u)", "near = abs(distance) <= 1e-5 * abs(slope) and opening <= 1e-5 / (body.gn + body.eps * u)"),  # noqa: E501
        ("impact", "singular_angle", "near = abs(distance) <= 1e-5 * abs(slope) and opening <= 1e-5 * (body.gn + body.eps * u)", "near = abs(distance) <= 1e-5 * abs(slope) and opening <= 1e-5 * (body.gn + body.eps / u)"),  # noqa: E501
        ("jets", "leading_sign", "if abs(value) > ZERO * scale:", "if abs(value) > ZERO / scale:"),  # noqa: E501
        ("modes", "can_roll", "tie = TIE * (body.gn + abs(body.gt) + u)", "tie = TIE * (body.gn - abs(body.gt) + u)"),  # noqa: E501
        ("modes", "can_roll", "tie = TIE * (body.gn + abs(body.gt) + u)", "tie = TIE * (body.gn + abs(body.gt) - u)"),  # noqa: E501
        ("modes", "can_roll", "tie = TIE * (body.gn + abs(body.gt) + u)", "tie = TIE / (body.gn + abs(body.gt) + u)"),  # noqa: E501
        ("modes", "can_roll", "scale = body.gn + abs(body.gt) + u", "scale = body.gn - abs(body.gt) + u"),  # noqa: E501
        ("modes", "can_roll", "scale = body.gn + abs(body.gt) + u", "scale = body.gn + abs(body.gt) - u"),  # noqa: E501
        ("modes", "can_start_slip", "scale = body.gn + abs(body.gt) + u", "scale = body.gn - abs(body.gt) + u"),  # noqa: E501
        ("modes", "can_start_slip", "scale = body.gn + abs(body.gt) + u", "scale = body.gn + abs(body.gt) - u"),  # noqa: E501
        ("modes", "can_start_slip", "tie = TIE * scale", "tie = TIE / scale"),  # noqa: E501
    ),
    "an even function": (
        ("energy", "kinetic_energy", "height = 2.0 * np.cos(0.5 * th) ** 2  # 1 + cos θ, with all its digits also near θ = π", "height = 2.0 * np.cos( -0.5 * th) ** 2 # 1 + cos θ, with all its digits also near θ = π"),  # noqa: E501
        ("energy", "potential_energy", "drop = y - 2.0 * body.eps * np.sin(0.5 * th) ** 2", "drop = y - 2.0 * body.eps * np.sin( -0.5 * th) ** 2"),  # noqa: E501
    ),
}
# fmt: on

EXPLAINED = {key: reason for reason, keys in _BY_REASON.items() for key in keys}
