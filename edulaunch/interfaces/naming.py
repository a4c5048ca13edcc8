"""Names of types."""

from __future__ import annotations

import re


def module_name(type_name: str) -> str:
    """The module that ROS generates for a type name: 'TransformStamped' -> 'transform_stamped', 'Pose2D' ->
    'pose2_d'.
    """
    spaced = re.sub('(.)([A-Z][a-z]+)', r'\1_\2', type_name)
    return re.sub('([a-z0-9])([A-Z])', r'\1_\2', spaced).lower()
