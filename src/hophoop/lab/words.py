"""A motion told in words: what happens, where and when."""

from __future__ import annotations

import math
from typing import Any

from hophoop.physics.body import MODE_LETTERS
from hophoop.results import EventRecord
from hophoop.trajectory import Trajectory
from hophoop.vocabulary.words import EVENTS, FLIGHT, MODES, SKIM, SPIN, STATUSES, VERBS, mode_word

UNTOLD = ("turn", "apex", "end")  # events that a summary leaves out


def story(motion: Trajectory, most: int = 400) -> list[dict[str, Any]]:
    """The motion as a list of sentences.

    Parameters
    ----------
    motion : Trajectory
    most : int, default 400
        Most sentences; the last one then says how many events are left out [1].

    Returns
    -------
    sentences : list of dict
        `t` [s], `event` (its number in `motion.events`), `mode` (what follows: the letter in 'RSKHM' that a hoop
        that rolls ahead would have for the same word) and `text`.
    """
    told: list[dict[str, Any]] = []
    left_out = 0
    many = _many_bounces(motion)
    for number, event in enumerate(motion.events):
        if many.get(number) == 0:
            continue
        text = f"It bounces {many[number]} more times." if number in many else _say(motion, number, event)
        if not text:
            continue
        if len(told) >= most:
            left_out += 1
            continue
        letter = MODE_LETTERS[MODES.index(_word(motion, number))]
        told.append({"t": event.t, "event": number, "mode": letter, "text": text})
    if left_out:
        told.append({**told[-1], "text": f"… and {left_out} more."})
    return told


def _many_bounces(motion: Trajectory, least: int = 6, told: int = 3) -> dict[int, int]:
    """Where bounces follow each other: at the first that is not told by itself, how many there are; at the others 0."""
    found: dict[int, int] = {}
    run: list[int] = []  # events of one row of bounces
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
    """The motion in one sentence, such as 'Rolls, skids at 49.8°, rolls at 152.7°.'

    Parameters
    ----------
    motion : Trajectory
    most : int, default 6
        Most changes of mode that are told [1].

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
                phrases.append(f"and {many[number]} more times")
            continue
        if event.kind == "start" or not phrases:
            phrases.append(VERBS[_word(motion, number)])
            continue
        phrase = "" if event.kind in UNTOLD else EVENTS[event.kind].verb
        if event.kind in ("slip_start", "slip_reversal") or _turns_in_slip(event):
            phrase = VERBS[_word(motion, number)]
        if _bounces(event):
            phrase = "bounces"
        if event.collision is False:
            phrase = "stops its slip at once"
        if not phrase:
            continue
        changes += 1
        if changes <= most:
            phrases.append(f"{phrase} at {degrees(event.angle)}")
    more = f", … ({changes - most} more)" if changes > most else ""
    text = ", ".join(phrases).replace(", and ", " and ") + more
    return f"{text[:1].upper()}{text[1:]}. {STATUSES[motion.status]}".strip()


def degrees(angle: float) -> str:
    """An angle in words.

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
    where = degrees(event.angle)
    word = _word(motion, number)
    verb, kind = VERBS[word], event.kind
    if kind == "start":
        return f"It {_started(word)} with the load at {where} and the centre at {_number(event.vx)} m/s."
    if kind == "slip_start":
        why = "friction is used up: the rim"
        turn = "turns too fast for the way it goes" if word == SPIN else "slides ahead"
        return f"It {verb} at {where}; {why} {turn}."
    if kind == "stick":
        return f"It rolls again at {where}; the slip has stopped."
    if kind == "slip_reversal":
        return f"The slip turns round at {where}; it {verb}."
    if kind == "takeoff":
        landing = next((later for later in motion.events[number + 1 :] if later.kind == "impact"), None)
        top = max((e.height for e in motion.events[number:] if landing and e.t <= landing.t), default=0.0)
        how = f" It rises {_length(top)} and stays up for {_number(landing.t - event.t)} s." if landing and top else ""
        return f"It hops at {where}.{how}"
    if kind == "impact":
        if event.collision is False:
            return f"An impact without collision at {where} stops the slip; then it {verb}."
        downwards = abs(event.before.vy)
        after = "bounces" if event.to_mode == "H" else verb
        return f"It lands at {where} with {_number(downwards)} m/s downwards and {after}."
    return _say_the_rest(event, where, word)


def _say_the_rest(event: EventRecord, where: str, word: str) -> str:
    texts = {
        "turn": f"It turns back at {where}" + (f", and {VERBS[word]} now." if _turns_in_slip(event) else "."),
        "apex": f"The centre is highest at {where}: the gap is {_length(event.height)}.",
        "bounce_limit": f"Bounces without number end here, at {where}.",
        "painleve_inconsistent": f"Painlevé's paradox at {where}: no contact force agrees with this slip.",
        "painleve_indeterminate": f"Painlevé's paradox at {where}: several contact forces agree with it.",
        "jam": f"Dynamic jam at {where}: the contact force grows without bound.",
        "kane_gain": f"Newton's law of impact has created {_number(event.gain)} J (Kane's example).",
        "skim": f"No contact force is left at {where}: the load falls freely and the rim skims the plane.",
        "rest": f"It rests at {where}" + ("." if event.stable is not False else ", which is not stable."),
        "end": "",
    }
    return texts.get(event.kind, f"{event.kind.replace('_', ' ')} at {where}.")


def _word(motion: Trajectory, number: int) -> str:
    """The word for the mode that follows an event."""
    event = motion.events[number]
    if event.omega == 0.0 and number + 1 < len(motion.events):
        # the direction in which it begins to turn
        return mode_word(event.to_mode, motion.at(0.5 * (event.t + motion.events[number + 1].t)).omega)
    return mode_word(event.to_mode, event.omega)


def _turns_in_slip(event: EventRecord) -> bool:
    # what was a spin is then a skid, or the reverse
    return event.kind == "turn" and event.to_mode in ("S", "K")


def _started(word: str) -> str:
    return {FLIGHT: "starts in the air", SKIM: "starts skimming"}.get(word, f"starts and {VERBS[word]}")


def _length(value: float) -> str:
    if value >= 0.995:
        return f"{_number(value)} m"
    return f"{_number(value * 100)} cm" if value >= 0.00995 else f"{_number(value * 1000)} mm"


_RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def _number(value: float | None) -> str:
    """Three digits, a real minus sign, powers of ten as they are written."""
    mantissa, _, power = f"{value:.3g}".replace("nan", "?").partition("e")
    raised = f"·10{str(int(power)).translate(_RAISED)}" if power else ""
    return f"{mantissa}{raised}".replace("-", "−")
