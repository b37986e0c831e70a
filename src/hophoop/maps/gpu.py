"""Whether maps can be computed on a GPU here, said in one sentence."""

from __future__ import annotations

from hophoop.scenario import InputError


def require_gpu() -> None:
    """Refuse `device='gpu'` with the reason.

    Raises
    ------
    ValueError
        If there is no CUDA GPU with its driver; and where there is one, since the kernel has not been brought
        to it: its rule for ties (`physics.jets`) makes arrays on the way, which Numba's CUDA target refuses.
    """
    from numba import cuda

    if not cuda.is_available():
        raise InputError("device = 'gpu' needs a CUDA GPU with its driver, and there is none: use 'cpu'.")
    raise InputError("device = 'gpu' is not supported by this version, though there is a GPU: use 'cpu'.")
