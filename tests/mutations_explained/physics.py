"""Why changes of `hophoop.kernel.physics` cannot be seen."""

# fmt: off
REASONS: dict[str, tuple[tuple[str, str, str, str], ...]] = {
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
    "a quotient has the sign of the product, and only the sign counts": (
        ("impact", "singular_slip", "spin = 0.0 if rho != 0.0 and length < stop and turn * om <= 0.0 else om + turn * length", "spin = 0.0 if rho != 0.0 and length < stop and turn / om <= 0.0 else om + turn * length"),
        ("impact", "singular_slip", "stop = -vt / rate if vt * rate < 0.0 else math.inf", "stop = -vt / rate if vt / rate < 0.0 else math.inf"),
        ("modes", "opening_sign", "second = -body.eps * c * u * u", "second = -body.eps / c * u * u"),
        ("modes", "frictionless_mode", "bend = body.eps * (u - (body.gn - body.eps * c * u) * (1.0 + body.eps * c) / (body.kap + body.eps * s * body.eps * s))", "bend = body.eps / (u - (body.gn - body.eps * c * u) * (1.0 + body.eps * c) / (body.kap + body.eps * s * body.eps * s))"),
        ("modes", "frictionless_mode", "drive = s * bend if s != 0.0 else om * c * bend", "drive = s / bend if s != 0.0 else om * c * bend"),
        ("modes", "frictionless_mode", "drive = s * bend if s != 0.0 else om * c * bend", "drive = s * bend if s != 0.0 else om / c * bend"),
        ("modes", "frictionless_mode", "drive = s * bend if s != 0.0 else om * c * bend", "drive = s * bend if s != 0.0 else om * c / bend"),
    ),
    "an even function": (
        ("mass", "part_reach", "return math.hypot(at, 0.5 * first)", "return math.hypot(at, -0.5 * first)"),
        ("energy", "kinetic_energy", "return _kinetic(body, s, c, cosine(0.5 * th), om, vt, vn, th_low)", "return _kinetic(body, s, c, cosine( -0.5 * th), om, vt, vn, th_low)"),
        ("energy", "kinetic_energies", "return _kinetic(body, s, c, elementwise.cosine(0.5 * th), om, vt, vn, th_low)", "return _kinetic(body, s, c, elementwise.cosine( -0.5 * th), om, vt, vn, th_low)"),
        ("energy", "potential_energy", "return _potential(body, x, y, sine(th), sine(0.5 * th))", "return _potential(body, x, y, sine(th), sine( -0.5 * th))"),
        ("energy", "potential_energies", "return _potential(body, x, y, elementwise.sine(th), elementwise.sine(0.5 * th))", "return _potential(body, x, y, elementwise.sine(th), elementwise.sine( -0.5 * th))"),
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
    "a case that never comes: where θ̇ grows the slip stops first, or it jams": (
        ("impact", "singular_slip", "spin = 0.0 if rho != 0.0 and length < stop and turn * om <= 0.0 else om + turn * length", "spin = 0.0 if rho != 0.0 and length < stop and turn * om <= 1.0 else om + turn * length"),
    ),
    "any place will do to measure from": (
        ("mass", "combined", "first = parts[0, AT] / radius", "first = parts[ -1, AT] / radius"),
    ),
}
# fmt: on
