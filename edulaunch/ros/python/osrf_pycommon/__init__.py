"""The parts of osrf_pycommon that launch and tests of launch files use."""

from __future__ import annotations

from importlib import import_module
from typing import Any


def __getattr__(name: str) -> Any:
    if name != 'process_utils':
        raise AttributeError(f'module {__name__!r} has no attribute {name!r}')
    # Upstream has this attribute after an import of launch, which imports the module.
    return import_module(f'{__name__}.{name}')
