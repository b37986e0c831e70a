"""The kernels that take long to compile, compiled before the first test: two at a time, with nothing else beside.

A test that comes upon a kernel without compiled code interprets it until there is some, and the process that compiles is
the least urgent one. With a test on each processor this took as long again as compiling. What is not called here is compiled
when a test calls it.
"""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

# One process compiles these, another the rest, which takes about as long.
FIRST = {"hophoop.rigid.kernel", "hophoop.rigid.sampling", "hophoop.maps.kernel"}

Wanted = list[tuple[Any, Any]]


def asked(config: Any) -> bool:
    """Whether all tests are to run, in this process or in workers that it starts; a few may need no kernel."""
    tests = config.rootpath / "tests"
    return (
        not hasattr(config, "workerinput")
        and any((config.invocation_params.dir / name).resolve() == tests for name in config.args)
        and not config.option.collectonly
        and not config.option.keyword
    )


def compile_ahead() -> None:
    """Compile what is not compiled yet, and wait for it; in a process of its own, since tests fork this one."""
    path = [str(Path(__file__).parent), *sys.path]
    code = f"import sys; sys.path[:] = {path!r}; import compile_ahead; compile_ahead.main()"
    subprocess.run([sys.executable, "-c", code], stdin=subprocess.DEVNULL, check=False)


def calls() -> None:
    """Call them, with arguments of the kinds that all callers give."""
    import hophoop as hh
    from hophoop.maps import sweep

    motion = hh.simulate(hh.Scenario(duration=1.0))
    motion.at(0.5)
    motion.sensitivity("at(0.5).angle", ["start.speed"])
    hh.simulate(hh.Scenario(duration=0.01, contact=hh.Compliant())).at(0.005)
    hoop, plane = hh.Hoop.ideal(0.75), hh.Plane(mu=1.0)
    hh.theory.first_slip_speed(hoop, plane)
    hh.theory.needed_friction(hoop, 1.0, plane)
    sweep(hh.Scenario(), {"start.speed": [1.0, 2.0], "plane.mu": [0.5, 1.0]})


def called(run: Callable[[], None]) -> Wanted:
    """The kernels that something calls, with the kinds of their arguments; they are interpreted meanwhile."""
    from hophoop._jit import forced, policy

    found: dict[tuple[Any, Any], None] = {}

    def load(kernel: Any, kinds: Any) -> Callable[..., Any]:
        found[kernel, kinds] = None
        return kernel._interpret

    before = policy.Kernel.load
    policy.Kernel.load = load
    try:
        with forced("compiled"):
            run()
    finally:
        policy.Kernel.load = before
    return list(found)


def main() -> None:
    """Find out which they are, and compile them."""
    from hophoop._jit import beside, mode, store

    if mode() == "interpreted":
        return
    missing = [(kernel, kinds) for kernel, kinds in called(calls) if not store.is_ready(kernel, kinds)]
    if missing:
        print(f"compiling {len(missing)} kernels ahead of the tests", flush=True)
    first = [one for one in missing if one[0].py_func.__module__ in FIRST]
    rest = [one for one in missing if one not in first]
    for job in [beside.start(part) for part in (first, rest) if part]:
        job.wait()
