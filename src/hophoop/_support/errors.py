"""The one error for bad input: a sentence, and the field at fault."""

from __future__ import annotations

import re
from typing import Any

# Longer than the name of a file may be: a word, or a value in quotation marks, which may have spaces.
_LONG = re.compile(r"""(?<== )(['"]).{256,}?\1(?=[\s:.,])|\S{257,}[^\s:.,]""")


def plain(text: str) -> str:
    """A text that is safe to print: escapes in place of characters that are not printable, the start of what is very long.

    Parameters
    ----------
    text : str

    Returns
    -------
    text : str
        One line.
    """
    text = _LONG.sub(lambda found: shortened(found[0]), text)
    if text.isprintable():
        return text
    return "".join(sign if sign.isprintable() else sign.encode("unicode_escape").decode() for sign in text)


def shortened(text: str) -> str:
    """At most sixty characters of a text.

    Parameters
    ----------
    text : str

    Returns
    -------
    text : str
        With three dots where something is left out.
    """
    return text if len(text) <= 60 else text[:57] + "..."


class InputError(ValueError):
    """Bad input, described in one sentence.

    Every other exception of hophoop, except OSError for files and ImportError for missing extras, is a defect of hophoop.

    Parameters
    ----------
    message : str
        The sentence: field, value, what is allowed.
    errors : list of dict, optional
        Everything that pydantic found, as its ``ValidationError.errors()`` gives it.
    field : str, optional
        The argument or the scenario's path at fault, where it is a single one.
    value : object, optional
        The value that was given for it.
    allowed : str, optional
        The values that are allowed.

    Examples
    --------
    >>> import hophoop as hh
    >>> try:
    ...     hh.Plane(gravity=-1.0)
    ... except hh.scenario.InputError as error:
    ...     print(error.field, error.value, error.allowed, sep=" | ")
    plane.gravity | -1.0 | at least 0
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
        """Error for the value of one field, with the sentence "field = value must be allowed".

        Parameters
        ----------
        field : str
        value : object
        allowed : str
            The end of the sentence, without its stop.
        rule : str, optional
            The words before it, such as "must end in".

        Returns
        -------
        error : InputError
        """
        return cls(f"{field} = {_shown(value)} {rule} {allowed}.", field=field, value=value, allowed=allowed)

    def renamed(self, name: str) -> InputError:
        """The same error with another name of its field, such as an option of the command line.

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


def _shown(value: Any) -> str:
    # the repr of a NumPy scalar has the name of its type
    return repr(value.item() if hasattr(value, "item") and getattr(value, "ndim", 1) == 0 else value)
