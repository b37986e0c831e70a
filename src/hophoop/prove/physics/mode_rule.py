"""The mode rule of docs/model.md: every inequality shown, ties by the first derivative that is not zero.

A quantity is in a tie only where it is zero exactly: an enclosure that merely contains zero decides nothing.
"""

from __future__ import annotations

from hophoop.kernel.physics.body import Mode
from hophoop.precise.impact import Contact
from hophoop.prove._flint import Ball, Jet, Undecided, arb, sign
from hophoop.prove.physics.equations import Model, State, Still

TIE_ORDER = 6
INCONSISTENT, INDETERMINATE, UNDETERMINED = 10, 11, 12


def slip_mode(sigma: int) -> int:
    """Skid for sliding ahead (v_t > 0), spin for over-rotating."""
    return int(Mode.SKID if sigma > 0 else Mode.SPIN)


def leading(jet: Jet, what: str) -> int:
    """Sign of the first coefficient that is not exactly zero."""
    for value in jet:
        found = sign(value, what)
        if found:
            return found
    return 0


def free_opening(model: Model, th: Ball, om: Ball) -> Ball:
    """f_n."""
    return model.eps * th.cos() * om * om - model.gn


def opening_sign(model: Model, state: State) -> int:
    """Sign of f_n, or of its first derivative in free motion that is not zero."""
    s, c = state.th.sin_cos()
    turned = model.eps * state.om * state.om
    om = state.om
    jet = [turned * c - model.gn, -turned * s * om, -turned * c * om * om, turned * s * om * om * om]
    return leading(jet, "f_n")


def can_roll(model: Model, state: State) -> bool:
    """Return True if rolling from here has N > 0 and abs(F) ≤ μs N, now or, in a tie, just after."""
    model = model.after(state.th, state.om, 0)
    s, c = state.th.sin_cos()
    forces = model.rolling(s, c, state.om * state.om)
    normal = sign(forces.normal, "N in rolling") if not _tied(forces.normal) else 0
    if normal < 0:
        return False
    if normal > 0 and model.mu_s is None:
        return True
    if model.mu_s is not None and normal > 0:
        below, above = model.mu_s * forces.normal - forces.friction, model.mu_s * forces.normal + forces.friction
        if below > 0 and above > 0:
            return True
        if below < 0 or above < 0:
            return False
        if not (_tied(below) or _tied(above)):
            raise Undecided("whether the friction suffices to roll is not certain")
    normals, frictions, _, _ = model.candidate(state.th, state.om, 0, TIE_ORDER)
    if leading(normals, "N in rolling") <= 0:
        return False
    if model.mu_s is None:
        return True
    margins = [[model.mu_s * n + way * f for n, f in zip(normals, frictions, strict=True)] for way in (1, -1)]
    signs = [leading(margin, "the margin of friction in rolling") for margin in margins]
    if 0 in signs and model.mu_s.is_zero() and not _identically_free(model, state):
        raise Undecided("rolling without friction is in a tie of high order")
    return min(signs) >= 0


def _tied(value: Ball) -> bool:
    return bool(value.is_zero())


def _identically_free(model: Model, state: State) -> bool:
    """Return True if rolling needs no friction at all: without gravity along the plane, at rest in equilibrium or balanced."""
    balanced = model.eps.is_zero() or isinstance(model, Still) or (state.om.is_zero() and state.th.is_zero())
    return bool(model.gt.is_zero() and balanced)


def can_start_slip(model: Model, state: State, sigma: int) -> bool:
    """Return True if slip of direction σ can start from v_t = 0: N > 0 and σ v̇_t > 0."""
    model = model.after(state.th, state.om, sigma)
    s, c = state.th.sin_cos()
    if sign(model.stiffness(s, c, sigma), "p_σ") <= 0:
        return False
    forces = model.slipping(s, c, state.om * state.om, sigma)
    normal, slip = forces.free_normal, sigma * forces.slip
    if normal < 0 or slip < 0:
        return False
    if normal > 0 and slip > 0:
        return True
    if not ((_tied(normal) or normal > 0) and (_tied(slip) or slip > 0)):
        raise Undecided("whether slip can start is not certain")
    normals, _, slips, _ = model.candidate(state.th, state.om, sigma, TIE_ORDER)
    return leading(normals, "N in slip") > 0 and sigma * leading(slips, "v̇_t") > 0


def next_mode(model: Model, state: State) -> int:
    """Mode that follows a state in contact (y = 0, v_n = 0): rules 1, 3 and 4."""
    sigma = sign(state.vt, "v_t")
    if sigma == 0:
        if can_roll(model, state):
            return int(Mode.ROLL)
        if model.mu_k is not None:
            for way in (-1, 1):
                if can_start_slip(model, state, way):
                    return slip_mode(way)
        return int(Mode.FLIGHT) if opening_sign(model, state) >= 0 else UNDETERMINED
    opening = opening_sign(model, state)
    if model.mu_k is None:
        return int(Mode.FLIGHT) if opening >= 0 else INCONSISTENT
    s, c = state.th.sin_cos()
    stiffness = sign(model.after(state.th, state.om, sigma).stiffness(s, c, sigma), "p_σ")
    if stiffness > 0:
        return slip_mode(sigma) if opening < 0 else int(Mode.FLIGHT)
    if model.resisted and sign(model.stiffness(s, c, sigma), "p_σ") > 0 and (opening < 0 or model.problem.strike):
        return UNDETERMINED  # an impact, which is without rolling resistance, would change nothing
    if opening < 0:
        return INCONSISTENT
    return INDETERMINATE if stiffness < 0 else int(Mode.FLIGHT)


class Certain:
    """Balls, as `impact` decides upon them: by signs that are certain."""

    @property
    def zero(self) -> Ball:
        """0."""
        return arb(0)

    def sign(self, value: Ball, what: str) -> int:
        """Return the sign of a number."""
        return sign(value, what)

    def judged_sign(self, value: Ball, scale: Ball, what: str) -> int:
        """Return the sign of a number, whatever its scale."""
        return sign(value, what)

    def order(self, one: Ball, other: Ball) -> int:
        """Return −1 or 1; two impulses that may be equal are undecided."""
        if one < other:
            return -1
        if other < one:
            return 1
        raise Undecided("slip stops in an impact as a part of it ends, as far as can be told")

    def is_zero(self, value: Ball) -> bool:
        """Return True if a number is exactly 0."""
        return bool(value.is_zero())

    def sqrt(self, value: Ball) -> Ball:
        """Return the square root."""
        return value.sqrt()

    def endless(self) -> Exception:
        """Return the error of an impact that does not end."""
        return Undecided("an impact does not end")


def contact_at(model: Model, th: Ball) -> Contact:
    """Body and plane as `impact` takes them."""
    s, c = th.sin_cos()
    return Contact(1 + model.eps * c, model.eps * s, model.kap, model.mu_s, model.mu_k, model.problem.law)
