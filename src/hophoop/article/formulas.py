"""The displayed formulas of the report, by name, for the ideal hoop on the level.

The formulas of `COMPUTED` are equations for a quantity; a test checks them on the computed motion.
"""

from __future__ import annotations

COMPUTED = {
    # of a rolling hoop, from θ, θ̇, and v₀
    "kinetic": r"W_k=\frac{1}{2}m R^2\dot\theta^2(1+2\gamma\cos\theta+\gamma^2)+\frac{1}{2}m R^2(1-\gamma^2)\dot\theta^2",
    "kinetic_short": r"W_k=m R^2(1+\gamma\cos\theta)\dot\theta^2",
    "potential": r"W_p=\gamma m g R(\cos\theta-1)",
    "rolling_speed": r"R^2\dot\theta^2=\frac{\gamma g R(1-\cos\theta)+v_0^2(1+\gamma)}{1+\gamma\cos\theta}",
    "largest_speed": r"R^2\omega_m^2=\frac{2\gamma g R+v_0^2(1+\gamma)}{1-\gamma}",
    "acceleration": r"\ddot\theta=\frac{\gamma\sin\theta}{2(1+\gamma\cos\theta)}(\dot\theta^2+\frac{g}{R})",
    "friction": r"F=m R((1+\gamma\cos\theta)\ddot\theta-\gamma\dot\theta^2\sin\theta)",
    "normal": r"N=m g-\gamma m R(\ddot\theta\sin\theta+\dot\theta^2\cos\theta)",
    # where a slipping hoop leaves the plane
    "lift": r"g=\gamma R\dot\theta^2\cos\theta",
    # in flight, from the take-off at θ₀ with ω; τ is the time since then
    "gap": r"y=\gamma R(\cos\theta_0-\cos(\theta_0+\omega\tau))-\gamma R\omega\tau\sin\theta_0-\frac{1}{2}g\tau^2",
    "velocity_in_flight": r"v=V-\gamma R\omega\cos\theta",
    # the landing: V and U are the velocities of the centre of gravity before it, ω the angular velocity
    "landing": r"\omega_a=\frac{(1+\gamma\cos\theta)V-\gamma U\sin\theta+(1-\gamma^2)R\omega}{2R(1+\gamma\cos\theta)}",
    # slip, spinning
    "slip_normal": r"N=\frac{m(g-\gamma R\dot\theta^2\cos\theta)}"
    r"{1+\frac{\gamma\sin\theta}{1-\gamma^2}(\gamma\sin\theta-\mu(1+\gamma\cos\theta))}",
    # at the top
    "top_normal": r"N=m g-\frac{\gamma m v_0^2}{R}",
}

FORMULAS = COMPUTED | {
    "rolls_while": r"|F|\le\mu N,\qquad N>0",
}
