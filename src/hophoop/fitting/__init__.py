"""Parameters of a filmed hoop, with what the film does not tell; and what a film would tell before it is taken."""

from hophoop.fitting.fitting import fit
from hophoop.fitting.planning import Plan, plan
from hophoop.fitting.reporting import report
from hophoop.fitting.result import Fit, load_fit

__all__ = ["fit", "Fit", "load_fit", "report", "plan", "Plan"]
