"""Types of the `parameters` of a node: as given in a launch file, normalized, and evaluated.

The parameters are a list of parameter files and mappings. A mapping may be nested. Its values may be literals, substitutions,
lists of values of one type, or :class:`~launch_ros.parameter_descriptions.ParameterValue`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from launch.substitution import Substitution

SomeParameterFile = Any
"""A path: a string, substitutions, `pathlib.Path`, bytes, or a ParameterFile."""


SomeParameterName = Any
"""A string, a substitution, or a tuple of both."""


SomeParameterValue = Any
"""A value. The ROS documentation of `Node` has a table of the results for each kind."""


SomeParametersDict = Mapping[Any, Any]


SomeParameters = Sequence[Any]


ParameterFile = Sequence[Substitution]


ParameterName = tuple[Substitution, ...]


ParameterValue = Any
"""A literal, a uniform tuple of literals, substitutions, or a tuple of substitutions for each item."""


ParametersDict = dict[ParameterName, Any]


Parameters = Sequence[Any]
"""A sequence of ParameterFile, ParametersDict and Parameter."""


EvaluatedParameterValue = str | int | float | bool | bytes | tuple[Any, ...]


EvaluatedParameters = tuple[Any, ...]
"""A sequence of Path, dict of names and plain values, and Parameter."""
