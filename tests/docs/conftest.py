"""The extensions of the documentation are no package: their tests import them from their folder."""

import sys

from checkout import ROOT

sys.path.insert(0, str(ROOT / "docs" / "_ext"))
