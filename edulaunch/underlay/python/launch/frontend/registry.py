"""Which element of a launch file, and which `$(...)`, is made by what. `launch.frontend.expose` fills it."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

ParseMethod = Callable[..., tuple[type, dict[str, Any]]]
"""Gives what to make: a class (or function) and its keyword arguments."""

action_parse_methods: dict[str, ParseMethod] = {}
"""Element name -> function (entity, parser) -> (class, keyword arguments)."""
substitution_parse_methods: dict[str, ParseMethod] = {}
"""Name of `$(name ...)` -> function (list of arguments) -> (class, keyword arguments)."""
