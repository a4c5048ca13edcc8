"""The command line that runs a program in the environment of the real rclpy."""

from __future__ import annotations

import json
import os
import sys
from typing import Any

from edulaunch.engine.interfaces.registry import Registry
from edulaunch.engine.packages import Index, Program
from edulaunch.engine.packages.index import interfaces_of
from edulaunch.engine.processes.spec import ProcessSpec
from edulaunch.engine.underlay_place import engine_folder
from edulaunch.extras.native.environment import Environment

HOME = os.path.dirname(engine_folder())


def interface_layers(registry: Registry) -> list[tuple[list[str], list[str]]]:
    """Return the share folders of a registry and of the registries below it, lowest first.

    Each entry also has the packages that the registry leaves to other registries.
    """
    layers: list[tuple[list[str], list[str]]] = []
    below: Registry | None = registry
    while below is not None:
        layers.insert(0, (list(below.roots), sorted(below.leave)))
        below = below.base
    return layers


def command(
    environment: Environment, program: Program, spec: ProcessSpec, index: Index, *, parent: int | str | None = None
) -> tuple[str, ...]:
    """Return the words that run a program in the environment of the real rclpy. The program's own words follow them.

    :param parent: the process with which the program ends, or a file that is locked while that process runs. None means this
        process.
    """
    known = description(program, spec, index, os.getpid() if parent is None else parent)
    return environment.python, os.path.join(HOME, 'edulaunch', 'extras', 'native', 'program.py'), known


def description(program: Program, spec: ProcessSpec, index: Index, parent: int | str) -> str:
    """Return the input of :mod:`edulaunch.extras.native.program`, as JSON."""
    what: dict[str, Any] = {**program._asdict(), 'name': spec.name}
    return json.dumps(
        {
            'parent': parent,
            'home': HOME,
            'path': [*index.python_roots(), *(folder for folder in sys.path if folder.endswith('-packages'))],
            'interfaces': interface_layers(interfaces_of(index)[1]),
            'program': what,
        }
    )
