"""Parameters of a filmed hoop, with what the film does not tell; and what a film would tell before it is taken."""

from hophoop.fitting.backdrop import Backdrop, backdrop
from hophoop.fitting.fitting import fit
from hophoop.fitting.planning import Plan, plan
from hophoop.fitting.reporting import report
from hophoop.fitting.result import Fit, load_fit
from hophoop.fitting.sampling import Posterior, sample

__all__ = ["fit", "Fit", "load_fit", "report", "sample", "Posterior", "plan", "Plan", "backdrop", "Backdrop"]
