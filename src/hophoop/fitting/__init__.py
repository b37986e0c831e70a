"""Parameters of a filmed hoop, with what a film does not determine; and what a planned film would."""

from hophoop.fitting.backdrop import Backdrop, backdrop
from hophoop.fitting.fitting import fit
from hophoop.fitting.planning import plan
from hophoop.fitting.reporting import report
from hophoop.fitting.result import Fit, load_fit

__all__ = ["fit", "Fit", "load_fit", "report", "plan", "backdrop", "Backdrop"]
