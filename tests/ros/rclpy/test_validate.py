"""rclpy.validate_*: names that are no names."""

from __future__ import annotations

from typing import Any

import pytest
from rclpy._rclpy_pybind11 import RCLError, RMWError
from rclpy.validate_full_topic_name import validate_full_topic_name
from rclpy.validate_namespace import validate_namespace
from rclpy.validate_node_name import validate_node_name
from rclpy.validate_topic_name import validate_topic_name


@pytest.mark.parametrize(
    ('validate', 'of_none'),
    [
        (validate_full_topic_name, (RMWError, 'failed to validate name: error not set')),
        (validate_namespace, (RMWError, 'failed to validate namespace: error not set')),
        (validate_node_name, (RMWError, 'failed to validate node name: error not set')),
        (validate_topic_name, (RCLError, 'failed to validate name: topic_name argument is null')),
    ],
)
def test_what_is_no_text_is_refused_as_by_the_c_layer(validate: Any, of_none: Any) -> None:
    with pytest.raises(TypeError, match='incompatible function arguments'):
        validate(1)
    with pytest.raises(of_none[0], match=of_none[1]):
        validate(None)
