"""A motion in words: the events, their times and positions."""

from __future__ import annotations

import math
from typing import Any

from hophoop.results.records import EventRecord
from hophoop.simulation.trajectory import Trajectory
from hophoop.vocabulary.events import EVENTS
from hophoop.vocabulary.modes import FLIGHT, MODE_LETTERS, MODE_WORDS, SKIM, SPIN, VERBS, mode_word
from hophoop.vocabulary.sentences import STORY, SUMMARY
from hophoop.vocabulary.statuses import STATUSES
from hophoop.vocabulary.words import plain


def story(motion: Trajectory, most: int = 400) -> list[dict[str, Any]]:
    """Return the motion as a list of sentences.

    Parameters
    ----------
    motion : Trajectory
    most : int, default 400
        Maximum number of sentences; a last one then gives the number of events left out [1].

    Returns
    -------
    sentences : list of dict
        `t` [s], `event` (its index in `motion.events`), `mode` (the letter in 'RSKHM' of the following mode's word, for a hoop
        that rolls forward) and `text`.
    """
    told: list[dict[str, Any]] = []
    left_out = 0
    many = _many_bounces(motion)
    for number, event in enumerate(motion.events):
        if many.get(number) == 0:
            continue
        text = STORY["more_bounces"].format(count=many[number]) if number in many else _say(motion, number, event)
        if not text:
            continue
        if len(told) >= most:
            left_out += 1
            continue
        letter = MODE_LETTERS[MODE_WORDS.index(_word(motion, number))]
        told.append({"t": event.t, "event": number, "mode": letter, "text": text})
    if left_out:
        told.append({**told[-1], "text": STORY["left_out"].format(count=left_out)})
    return told


def _many_bounces(motion: Trajectory, least: int = 6, told: int = 3) -> dict[int, int]:
    """Return counts by event for sequences of bounces: at the first one not described, the number of the rest; at those, 0."""
    found: dict[int, int] = {}
    run: list[int] = []  # events of one sequence of bounces
    for number, event in [*enumerate(motion.events), (-1, None)]:
        if event is not None and (_bounces(event) or (run and event.kind == "apex")):
            run.append(number)
            continue
        bounces = [at for at in run if motion.events[at].kind == "impact"]
        if len(bounces) >= least:
            found.update(dict.fromkeys(run[run.index(bounces[told]) :], 0))
            found[bounces[told]] = len(bounces) - told
        run = []
    return found


def _bounces(event: EventRecord) -> bool:
    return event.kind == "impact" and event.to_mode == "H" and event.collision is not False


def summary(motion: Trajectory, most: int = 6) -> str:
    """Describe the motion in one sentence, such as 'Rolls, skids at 49.8°, rolls at 152.7°.'

    Parameters
    ----------
    motion : Trajectory
    most : int, default 6
        Maximum number of mode changes in the sentence [1].

    Returns
    -------
    sentence : str
    """
    phrases: list[str] = []
    changes = 0
    many = _many_bounces(motion, told=1)
    for number, event in enumerate(motion.events):
        if number in many:
            if many[number]:
                phrases.append(SUMMARY["more_bounces"].format(count=many[number]))
            continue
        if event.kind == "start" or not phrases:
            phrases.append(VERBS[_word(motion, number)])
            continue
        phrase = EVENTS[event.kind].verb if EVENTS[event.kind].summed_up else ""
        if event.kind in ("slip_start", "slip_reversal") or _turns_in_slip(event):
            phrase = VERBS[_word(motion, number)]
        if _bounces(event):
            phrase = SUMMARY["bounces"]
        if event.collision is False:
            phrase = SUMMARY["without_collision"]
        if not phrase:
            continue
        changes += 1
        if changes <= most:
            phrases.append(SUMMARY["change"].format(phrase=phrase, where=degrees(event.angle)))
    more = SUMMARY["more_changes"].format(count=changes - most) if changes > most else ""
    text = ", ".join(phrases).replace(", and ", " and ") + more
    whole = SUMMARY["sentence"].format(phrases=f"{text[:1].upper()}{text[1:]}", ending=STATUSES[motion.status].sentence)
    return whole.strip()


def degrees(angle: float) -> str:
    """Return an angle in words.

    Parameters
    ----------
    angle : float
        [rad].

    Returns
    -------
    text : str
        In degrees with one decimal.
    """
    return f"{math.degrees(angle):.1f}°".replace("-", "−")


def _say(motion: Trajectory, number: int, event: EventRecord) -> str:
    word = _word(motion, number)
    name: str = event.kind
    values = {"where": degrees(event.angle), "verb": VERBS[word]}
    if name == "start":
        values |= {"started": _started(word), "speed": _number(event.vx)}
    elif name == "slip_start" and word == SPIN:
        name = "slip_start_spin"
    elif name == "takeoff":
        landing = next((later for later in motion.events[number + 1 :] if later.kind == "impact"), None)
        top = max((e.height for e in motion.events[number:] if landing and e.t <= landing.t), default=0.0)
        if landing and top:
            name = "takeoff_and_landing"
            values |= {"top": _length(top), "time": _number(landing.t - event.t)}
    elif name == "impact":
        values["speed"] = _number(abs(event.before.vy))
        if event.collision is False:
            name = "impact_without_collision"
        elif event.to_mode == "H":
            name = "impact_bounce"
    elif name == "turn" and _turns_in_slip(event):
        name = "turn_in_slip"
    elif name == "apex":
        values["gap"] = _length(event.height)
    elif name == "kane_gain":
        values["gain"] = _number(event.gain)
    elif name == "rest" and event.stable is False:
        name = "rest_unstable"
    return STORY.get(name, STORY["other"]).format(**values, kind=plain(event.kind))


def _word(motion: Trajectory, number: int) -> str:
    """Return the word for the mode that follows an event."""
    event = motion.events[number]
    if event.omega == 0.0 and number + 1 < len(motion.events):
        # the direction in which it starts to rotate
        return mode_word(event.to_mode, motion.at(0.5 * (event.t + motion.events[number + 1].t)).omega)
    return mode_word(event.to_mode, event.omega)


def _turns_in_slip(event: EventRecord) -> bool:
    # a spin then becomes a skid, or the reverse
    return event.kind == "turn" and event.to_mode in ("S", "K")


def _started(word: str) -> str:
    names = {FLIGHT: "started_flight", SKIM: "started_skim"}
    return STORY[names.get(word, "started")].format(verb=VERBS[word])


def _length(value: float) -> str:
    if value >= 0.995:
        return f"{_number(value)} m"
    return f"{_number(value * 100)} cm" if value >= 0.00995 else f"{_number(value * 1000)} mm"


_RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def _number(value: float | None) -> str:
    """Return a number with three digits, a real minus sign, and powers of ten with superscripts."""
    mantissa, _, power = f"{value:.3g}".replace("nan", "?").partition("e")
    raised = f"·10{str(int(power)).translate(_RAISED)}" if power else ""
    return f"{mantissa}{raised}".replace("-", "−")
