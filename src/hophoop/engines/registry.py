"""Registry of engines: those of the package, those of entry points, and commands."""

from __future__ import annotations

import platform
import re
import shlex
import shutil
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from importlib import import_module
from importlib.metadata import PackageNotFoundError, entry_points, version
from typing import Any

from hophoop.engines.adapters.npm import NODE_ENGINES, npm_folder
from hophoop.scenario import InputError

GROUP = "hophoop.engines"
PYTHON_ENGINES = (
    "hophoop", "compliant", "scipy", "exudyn", "drake", "mujoco", "dart", "pybullet", "pymunk", "box2d", "newton",
)  # fmt: skip
NO_PHYSICS_ENGINES = ("hophoop", "compliant", "scipy")  # ours, and a solver of differential equations


@dataclass(frozen=True)
class Engine:
    """An engine of the comparison.

    Attributes
    ----------
    name : str
        Key on the command line and in files.
    title : str
        Name in tables.
    run : callable or None
        ``run(task, dt, **settings)`` gives states; None for a command.
    command : tuple of str
        Command that runs it, empty for Python.
    package : str
        Name of its distribution.
    version : str
        Empty if it is not installed.
    step : float
        Its manual's time step [s].
    model, contact : str
        How the hoop is represented, and how the engine solves contact.
    settings : dict
        Sets of settings by name; the first is the manual's.
    ours : bool
        Whether the authors of the benchmark wrote it.
    """

    name: str
    title: str
    run: Callable[..., Any] | None = None
    command: tuple[str, ...] = ()
    package: str = ""
    version: str = ""
    step: float = 0.001
    model: str = ""
    contact: str = ""
    settings: Mapping[str, Mapping[str, Any]] = field(default_factory=lambda: {"default": {}})
    ours: bool = False

    @property
    def installed(self) -> bool:
        """True if its package is installed; also for a command and for an adapter without package."""
        if self.name in NODE_ENGINES:
            folder = npm_folder().absolute()
            packages = (place / "node_modules" / self.package for place in (folder, *folder.parents))
            return shutil.which(self.command[0]) is not None and any(package.is_dir() for package in packages)
        return bool(self.version) or not self.package


def engine_of(name: str, adapter: Any, ours: bool = False) -> Engine:
    """Return the engine of an adapter, a module or any object with ``run`` and further attributes.

    Parameters
    ----------
    name : str
    adapter : module or object
    ours : bool, default False

    Returns
    -------
    engine : Engine

    Raises
    ------
    ValueError
        If it has no ``run``.
    """
    run = getattr(adapter, "run", adapter if callable(adapter) else None)
    if run is None:
        raise InputError(f"the adapter {name!r} has no run(task, dt).")
    package = getattr(adapter, "PACKAGE", "")
    return Engine(
        name=name,
        title=getattr(adapter, "TITLE", name),
        run=run,
        package=package,
        version=_version(package),
        step=getattr(adapter, "STEP", 0.001),
        model=getattr(adapter, "MODEL", ""),
        contact=getattr(adapter, "CONTACT", ""),
        settings=getattr(adapter, "SETTINGS", {"default": {}}),
        ours=ours,
    )


def command_engine(text: str) -> Engine:
    """Return the engine of ``NAME=COMMAND``.

    Parameters
    ----------
    text : str

    Returns
    -------
    engine : Engine

    Raises
    ------
    ValueError
        If the text is not of that form.
    """
    name, _, command = text.partition("=")
    try:
        words = tuple(shlex.split(command))
    except ValueError:  # an unclosed quotation mark
        words = ()
    if not re.fullmatch(r"[\w.-]+", name) or not words:
        raise InputError.of_field("command", text, "NAME=COMMAND, such as mine='node mine.mjs'")
    return Engine(name=name, title=name, command=words, model="a command")


def engines() -> dict[str, Engine]:
    """Return all engines with adapters, installed or not.

    Returns
    -------
    engines : dict of str to Engine
        hophoop first, then the package's other adapters, then those of entry points.

    Raises
    ------
    ValueError
        If an entry point has no ``run``.
    """
    found = {name: _own(name) for name in (*PYTHON_ENGINES, *NODE_ENGINES)}
    for point in entry_points(group=GROUP):
        if point.name not in found:
            found[point.name] = engine_of(point.name, point.load())
    return found


def physics_engines() -> list[Engine]:
    """Return the installed physics engines: all except ours and SciPy.

    Returns
    -------
    engines : list of Engine
    """
    return [one for name, one in engines().items() if name not in NO_PHYSICS_ENGINES and one.installed]


def engine(name: str) -> Engine:
    """Return one engine by name.

    Parameters
    ----------
    name : str

    Returns
    -------
    engine : Engine

    Raises
    ------
    ValueError
        If there is no such engine.
    """
    if name in PYTHON_ENGINES or name in NODE_ENGINES:
        return _own(name)
    known = engines()
    if name not in known:
        raise InputError.of_field("engine", name, ", ".join(known), rule="is not one of")
    return known[name]


def _own(name: str) -> Engine:
    if name in NODE_ENGINES:
        node = NODE_ENGINES[name]
        return Engine(
            name=name,
            title=node.title,
            command=tuple(node.command()),
            package=node.package,
            step=node.step,
            model=node.model,
            contact=node.contact,
            settings=node.settings,
        )
    return engine_of(name, import_module(f"hophoop.engines.adapters.{name}"), ours=name in ("hophoop", "compliant"))


def _version(package: str) -> str:
    if package == "python":
        return platform.python_version()
    try:
        return version(package) if package else ""
    except PackageNotFoundError:
        return ""
