"""The fingerprint of a motion: its definition, what counts and what does not."""

import hashlib
import math
import struct

import numpy as np
import pytest

import hophoop as hh
from hophoop._support.fingerprint import fingerprint, is_fingerprint

QUIET_NAN = bytes.fromhex("000000000000f87f")


def by_hand(motion):
    """From the public events, one number at a time."""
    text = b""
    for event in motion.events:
        text += event.kind.encode()
        for name in ("t", "x", "height", "angle", "vx", "vy", "omega", "slip"):
            value = getattr(event, name)
            text += QUIET_NAN if math.isnan(value) else struct.pack("<d", value if value != 0.0 else 0.0)
    return hashlib.sha256(text).hexdigest()[:16]


MOTIONS = {
    "hop": "duration=2",
    "end by the duration asked for": "duration=1.7&hoop.radius=0.3&hoop.mass=2&hoop.load_fraction=0.6",
    "massless": "duration=3&hoop.load_fraction=1&start.speed=0.1",
    "massless, no answer": "hoop.load_fraction=1&plane.mu=3&start.speed=-2",
    "rest": "start.angle=0",
    "bounces": "duration=3&plane.restitution=0.7&start.height=0.3&start.omega=1",
    "compliant": "duration=0.2&start.height=0.02&start.omega=3&contact.model=compliant&contact.stiffness=1e4",
}


def test_it_is_the_hash_of_the_public_events():
    for name, link in MOTIONS.items():
        motion = hh.simulate(hh.Scenario.from_query(link))
        assert motion.fingerprint == by_hand(motion), name
        assert is_fingerprint(motion.fingerprint), name
        assert motion.to_dict()["fingerprint"] == motion.fingerprint, name


def test_a_kept_value():
    """The bytes of 'start' and eight numbers, hashed by coreutils' sha256sum."""
    assert fingerprint(["start"], [[0.0, 1.0, -0.0, -2.5, 1e-310, math.inf, 3.0, 0.1]]) == "54f71afa5f213e6e"


def test_zeros_and_nans_have_one_form_and_what_is_given_stays_as_it_is():
    nans = np.frombuffer(bytes.fromhex("010000000000f87f" + "000000000000f8ff" + "000000000000f87f"), "<f8")
    for nan in nans:
        given = np.array([[nan, -0.0, nan, 0.0] * 2])
        before = given.tobytes()
        assert fingerprint(["end"], given) == hashlib.sha256(b"end" + 4 * (QUIET_NAN + bytes(8))).hexdigest()[:16]
        assert given.tobytes() == before


def test_each_event_has_eight_numbers():
    with pytest.raises(ValueError, match="argument"):
        fingerprint(["start", "end"], np.zeros((1, 8)))


def test_the_form_of_one():
    assert is_fingerprint("0123456789abcdef")
    assert is_fingerprint("0123456789ABCDEF")
    assert not any(map(is_fingerprint, ("", "0123", "0123456789abcdeg", "0123456789abcdef0", "0123456789abcdef\n")))
