"""Maps on a GPU, without one: the driver in Numba's simulator, the kernel compiled for CUDA, and what is refused."""

import importlib.util
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

import hophoop as hh
from hophoop import maps
from hophoop.maps.grid import gpu, kernel
from hophoop.maps.grid.cells import make_cells
from hophoop.maps.grid.evaluate import run_cells
from hophoop.maps.grid.quantities import make_span

AXES = {"plane.mu": [0.3, 1.0], "start.speed": [0.1, 3.1, 5.0]}
WANTED = kernel.FLIGHT_REQUESTED | kernel.UTILIZATION_REQUESTED


def chosen_cells():
    """Cells of every kind: also one that is not allowed, one that hops at once, many bounces, few events allowed."""
    speeds = {"plane.mu": np.array([0.02, 0.3, 0.5, 0.9, 1.4, 2.0]), "start.speed": np.linspace(0.1, 5.0, 6)}
    plain = make_cells(hh.Scenario(duration=3.0), speeds, 6)
    plain[kernel.ALLOWED, 2] = 0.0
    thrown = hh.Scenario(duration=30.0, start=hh.Start(height=1.0, omega=3.0)).replace("plane.slope", 0.1)
    bounces = {"plane.restitution": np.array([0.5, 0.9, 0.9]), "contact.max_events": np.array([3000, 20, 3000])}
    return np.concatenate([plain, make_cells(thrown, bounces, 3)], axis=1)


PROGRAM = """
import sys
import numpy as np
from hophoop import maps
from hophoop.maps.grid import gpu
from hophoop.maps.grid.evaluate import run_cells
from hophoop.maps.grid.quantities import make_span
cells = np.load("cells.npy")
for name in ("first_revolution", "duration"):
    if name == "duration":  # batches of four cells, and memory for the events of three
        gpu.CELLS_PER_BATCH, gpu.MEMORY = 4, 3 * 12144
    results = run_cells(cells, make_span(name), 3, "gpu")
    np.savez(name, **results._asdict())
axes = {"plane.mu": [0.3, 1.0], "start.speed": [0.1, 3.1, 5.0]}
maps.sweep(None, axes, ["sequence", "time"], device="gpu", out="map.zarr")
"""


@pytest.fixture(scope="module")
def simulated(tmp_path_factory):
    """A folder with what the simulator computed."""
    pytest.importorskip("numba.cuda")
    folder = tmp_path_factory.mktemp("gpu")
    np.save(folder / "cells.npy", chosen_cells())
    environment = os.environ | {"NUMBA_ENABLE_CUDASIM": "1"}
    subprocess.run([sys.executable, "-c", PROGRAM], cwd=folder, env=environment, check=True)
    return folder


@pytest.mark.long
@pytest.mark.parametrize("name", ["first_revolution", "duration"])
def test_simulated_threads_give_what_the_cpu_gives(simulated, name):
    cells = chosen_cells()
    expected = run_cells(cells, make_span(name), WANTED, "serial")
    with np.load(simulated / f"{name}.npz") as found:
        np.testing.assert_array_equal(found["words"], expected.words)
        np.testing.assert_array_equal(found["sequences"], expected.sequences)
        np.testing.assert_allclose(found["numbers"], expected.numbers, rtol=1e-12, atol=1e-14)
    assert np.any(expected.words[:, kernel.STATUS_WORD] == kernel.NOT_ALLOWED)
    if name == "duration":
        assert expected.words[7, kernel.STATUS_WORD] == kernel.EVENT_LIMIT
        assert expected.words[8, kernel.STATUS_WORD] != kernel.EVENT_LIMIT
        base = hh.Scenario(duration=30.0, start=hh.Start(height=1.0, omega=3.0)).replace("plane.slope", 0.1)
        assert len(hh.simulate(base.replace("plane.restitution", 0.9)).events) > kernel.FIRST_EVENTS


@pytest.mark.long
def test_a_map_says_what_computed_it(simulated):
    found = maps.open_map(simulated / "map.zarr")
    expected = maps.sweep(None, AXES, ["sequence", "time"])
    np.testing.assert_array_equal(found["sequence"], expected["sequence"])
    np.testing.assert_allclose(found["time"], expected["time"], rtol=1e-12)
    assert '"device": "gpu"' in found.attrs["plan"]
    with pytest.raises(ValueError, match="another device"):
        maps.sweep(None, AXES, ["sequence", "time"], out=simulated / "map.zarr", resume=True)


def test_without_numba_cuda_it_says_what_to_install(monkeypatch):
    monkeypatch.setattr(gpu, "find_spec", lambda name: None)
    with pytest.raises(ValueError, match=r'pip install "hophoop\[gpu\]"'):
        maps.sweep(None, AXES, device="gpu")


def test_without_a_gpu_it_says_so(monkeypatch):
    cuda = pytest.importorskip("numba.cuda")
    monkeypatch.setattr(gpu, "find_spec", lambda name: "found")
    monkeypatch.setattr(cuda, "is_available", lambda: False)
    with pytest.raises(ValueError, match="needs a CUDA GPU with its driver, and there is none: use 'cpu'"):
        maps.sweep(None, AXES, device="gpu")


def test_a_gpu_is_not_for_a_cluster(tmp_path):
    with pytest.raises(ValueError, match="device = 'gpu' is for this machine"):
        maps.sweep(None, AXES, device="gpu", workers=1, out=tmp_path / "map.zarr")


def test_kernels_keep_to_what_a_gpu_can_do():
    package = Path(hh.__file__).parent / "kernel"
    files = [*(package / "physics").glob("*.py"), *(package / "rigid").glob("*.py")]
    # the arrays are made there, or energies and errors of a motion that is computed
    outside = ("records.py", "sampling.py", "energy.py", "errors.py")
    files = [file for file in files if file.name not in outside]
    assert len(files) > 12
    for file in files:
        text = file.read_text(encoding="utf-8")
        assert "numpy" not in text, f"{file.name}: a GPU can make no arrays"
        # math.ceil and math.floor give an int on the CPU and a float on a GPU
        loose = re.findall(r".*(?<!int\()(?<!\* )math\.(?:ceil|floor)\(.*", text)
        assert not loose, f"{file.name}: {loose}"


@pytest.mark.slow
@pytest.mark.skipif(importlib.util.find_spec("numba_cuda") is None, reason="numba-cuda is not installed")
def test_the_kernel_compiles_for_cuda(monkeypatch, tmp_path):
    from numba import cuda, from_dtype, types
    from numba.cuda import dispatcher
    from numba.cuda.cudadrv import nvvm

    from hophoop.kernel.records.layout import EVENT, SEGMENT, MapRequest, MapResults
    from hophoop.maps.grid.gpu_kernel import evaluate_thread

    if not nvvm.is_available():
        pytest.skip("the CUDA toolkit's NVVM is not installed")
    # functions of the CPU are compiled for the GPU that is there
    monkeypatch.setattr(dispatcher, "get_current_device", lambda: SimpleNamespace(compute_capability=(8, 0)))
    matrix, whole = types.float64[:, ::1], types.int64
    signature = types.void(
        matrix, whole[::1], types.NamedTuple((types.float64, whole, types.boolean, whole), MapRequest),
        from_dtype(EVENT)[:, ::1], from_dtype(SEGMENT)[::1],
        types.NamedTuple((matrix, types.int32[:, ::1], types.uint64[:, ::1]), MapResults), types.int8[::1],
    )  # fmt: skip
    code, _ = cuda.compile_ptx(evaluate_thread, signature, cc=(8, 0))
    assert code.count(".entry") == 1
    assert ".extern" not in code  # nothing is left to be found at a link, such as an allocation
    assembler = shutil.which("ptxas") or next(
        (str(path) for folder in sys.path for path in Path(folder).glob("nvidia/cuda_nvcc/bin/ptxas")), None
    )
    if assembler is None:
        pytest.skip("it compiles; there is no ptxas to assemble it")
    (tmp_path / "kernel.ptx").write_text(code)
    subprocess.run([assembler, "-arch=sm_80", "kernel.ptx", "-o", "kernel.cubin"], cwd=tmp_path, check=True)
    assert (tmp_path / "kernel.cubin").stat().st_size > 0
