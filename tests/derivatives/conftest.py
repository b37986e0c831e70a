"""Kernels run interpreted where a test asks for it, so that mutants and coverage see them."""

import pytest

from hophoop.kernel.native import forced


@pytest.fixture
def interpreted():
    with forced("interpreted"):
        yield
