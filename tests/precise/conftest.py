"""Tests compute in sixty digits."""

from decimal import localcontext

import pytest
from mpmath import mp


@pytest.fixture(autouse=True)
def sixty_digits():
    with mp.workdps(60), localcontext() as context:
        context.prec = 60
        yield
