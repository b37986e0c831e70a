"""The one error for bad input: a sentence, and the field at fault."""

from __future__ import annotations

import re
from typing import Any

# A very long word or quoted value; the maximum length of a file name is 255.
_LONG = re.compile(r"""(?<== )(['"]).{256,}?\1(?=[\s:.,])|\S{257,}[^\s:.,]""")


def plain(text: str) -> str:
    """Return a text that is safe to print: escapes for unprintable characters, and only the start of very long words.

    text: one line.
    """
    text = _LONG.sub(lambda found: shortened(found[0]), text)
    if text.isprintable():
        return text
    return "".join(sign if sign.isprintable() else sign.encode("unicode_escape").decode() for sign in text)


def shortened(text: str) -> str:
    """Return a text shortened to at most 60 characters.

    text: with three dots for the part left out.
    """
    return text if len(text) <= 60 else text[:57] + "..."


class InputError(ValueError):
    """Bad input, described in one sentence.

    Every other exception of hophoop, except OSError for files and ImportError for missing extras, is a defect of hophoop.

    Parameters
    ----------
    message : str
        The sentence: field, value, allowed values.
    errors : list of dict, optional
        All findings of pydantic, as its ``ValidationError.errors()`` returns them.
    field : str, optional
        The argument or the scenario's path at fault, if it is a single one.
    value : object, optional
        The given value.
    allowed : str, optional
        The allowed values.

    Examples
    --------
    >>> import hophoop as hh
    >>> try:
    ...     hh.Plane(gravity=-1.0)
    ... except hh.scenario.InputError as error:
    ...     print(error.field, error.value, error.allowed, sep=" | ")
    plane.gravity | -1.0 | 0 or from 1e-06 to 1e+06 m/s²
    """

    def __init__(
        self,
        message: str,
        errors: list[Any] | None = None,
        *,
        field: str | None = None,
        value: Any = None,
        allowed: str | None = None,
    ) -> None:
        super().__init__(plain(message))
        self.errors = errors or []
        self.field = field
        self.value = value
        self.allowed = allowed

    @classmethod
    def of_field(cls, field: str, value: Any, allowed: str, rule: str = "must be") -> InputError:
        """Return an error for the value of one field, with the sentence "field = value must be allowed".

        Parameters
        ----------
        field : str
        value : object
        allowed : str
            The end of the sentence, without the full stop.
        rule : str, optional
            The words before it, such as "must end in".

        Returns
        -------
        error : InputError
        """
        return cls(f"{field} = {shown(value)} {rule} {allowed}.", field=field, value=value, allowed=allowed)

    def renamed(self, name: str) -> InputError:
        """Return the same error with another name of its field, such as an option of the command line.

        Parameters
        ----------
        name : str

        Returns
        -------
        error : InputError
        """
        message = str(self)
        if self.field is not None and message.startswith(f"{self.field} "):
            message = name + message[len(self.field) :]
        return InputError(message, self.errors, field=name, value=self.value, allowed=self.allowed)


def shown(value: Any) -> str:
    """Return a value as errors write it."""
    # the repr of a NumPy scalar contains the name of its type
    return repr(value.item() if hasattr(value, "item") and getattr(value, "ndim", 1) == 0 else value)


def check_type(field: str, value: object, kind: type) -> None:
    """Refuse a value of another type."""
    if not isinstance(value, kind):
        named = f"the class {value.__name__}" if isinstance(value, type) else type(value).__name__
        raise InputError(f"{field} must be a {kind.__name__}, not {named}.", field=field, value=value)


def check_whole(field: str, value: object, least: int, most: int, where: str = "") -> None:
    """Refuse a value that is no integer within bounds.

    least, most: both are allowed; where: what the bounds hold for, such as "for this section".
    """
    if isinstance(value, bool) or not isinstance(value, int) or not least <= value <= most:
        raise InputError.of_field(field, value, f"an integer from {least} to {most} {where}".rstrip())
