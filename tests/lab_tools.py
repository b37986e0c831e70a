"""What tests of the lab's server share."""

import os

import pytest

POSIX = pytest.mark.skipif(os.name != "posix", reason="only POSIX has interrupts of one process")
