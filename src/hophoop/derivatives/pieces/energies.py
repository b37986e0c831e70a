"""Kinetic and potential energy of states, with their changes in all directions."""

from __future__ import annotations

from hophoop.derivatives.layout import OM, TH, VN, VT, X, Y, body_tangent
from hophoop.derivatives.transform import tangent_of
from hophoop.kernel.model import kinetic_energy, potential_energy

d_kinetic_energy = tangent_of(kinetic_energy, "body", "th", "om", "vt", "vn")
d_potential_energy = tangent_of(potential_energy, "body", "x", "y", "th")


def fill_energies(body, states, tangents, parameter_tangents, values, rates):
    """Fill in the energies of m states and their changes in n directions, in kernel units.

    Parameters
    ----------
    body : Body
    states : ndarray, shape (m, 6)
        x, height, θ, θ̇, slip and v_n.
    tangents : ndarray, shape (m, STATE_ROWS or more, n)
        Of the states.
    parameter_tangents : ndarray, shape (PARAMETERS, n)
    values : ndarray, shape (m, 2)
        Kinetic and potential energy.
    rates : ndarray, shape (m, 2, n)
        Their changes.
    """
    for i in range(states.shape[0]):
        x, y, th, om = states[i, 0], states[i, 1], states[i, 2], states[i, 3]
        vt, vn = states[i, 4], states[i, 5]
        values[i, 0] = kinetic_energy(body, th, om, vt, vn, 0.0)
        values[i, 1] = potential_energy(body, x, y, th)
        for k in range(tangents.shape[2]):
            d_body = body_tangent(parameter_tangents, k)
            change = tangents[i, :, k]
            rates[i, 0, k] = d_kinetic_energy(
                body, th, om, vt, vn, 0.0, d_body, change[TH], change[OM], change[VT], change[VN]
            )[1]
            rates[i, 1, k] = d_potential_energy(body, x, y, th, d_body, change[X], change[Y], change[TH])[1]
