"""tf2_ros.BufferInterface: types that register how they are transformed."""

from __future__ import annotations

from typing import Any

import pytest
import rclpy
import tf2_ros
from geometry_msgs.msg import PointStamped
from rclpy.time import Time

from edulaunch.engine.processes.current import current_process

from .listening import stamped


def test_objects_are_transformed_by_the_function_of_their_type(stage, program):
    results: list[Any] = []

    class Thing:
        header = PointStamped().header

    def body() -> None:
        rclpy.init()
        buffer = tf2_ros.Buffer()
        buffer.set_transform_static(stamped('world', '', 0.0, 1.0), 'me')
        buffer.set_transform_static(stamped('world', 'a', 0.0, 5.0), 'me')
        thing = Thing()
        thing.header.frame_id = 'a'
        try:
            buffer.transform(thing, 'world')
        except tf2_ros.TypeException as error:
            results.append(str(error))
        tf2_ros.TransformRegistration().add(Thing, lambda one, found: found.transform.translation.x)
        results.append(buffer.transform(thing, 'world'))

    program(body)
    stage.until(10)
    assert results == [f'Type {Thing} is not loaded or supported', 5.0]


def test_points_are_transformed_once_tf2_geometry_msgs_is_imported(stage, program):
    results: list[Any] = []

    def body() -> None:
        current_process().loader.import_('tf2_geometry_msgs')  # as the import statement of a program does

        rclpy.init()
        buffer = tf2_ros.Buffer()
        for seconds in (1, 2):
            buffer.set_transform(stamped('world', 'a', seconds, 5.0 * seconds), 'me')
        point = PointStamped()
        point.header.frame_id, point.point.x = 'a', 1.0
        results.append(buffer.transform(point, 'world').point.x)
        point.header.stamp.sec = 1
        results.append(buffer.transform_full(point, 'a', Time(seconds=2), 'world').point.x)
        results.append(buffer.transform(point, 'world', new_type=PointStamped).header.frame_id)

    program(body)
    stage.until(10)
    assert results == [11.0, -4.0, 'world']


def test_convert_goes_directly_or_over_a_message(stage, program):
    results: list[Any] = []

    def body() -> None:
        registration = tf2_ros.ConvertRegistration()
        registration.add_to_msg(complex, lambda value: (value.real, value.imag))
        registration.add_from_msg(str, lambda pair: f'{pair[0]} {pair[1]}')
        registration.add_convert((complex, float), abs)
        results.extend([tf2_ros.convert(3 + 4j, str), tf2_ros.convert(3 + 4j, float), tf2_ros.convert('x', str)])
        with pytest.raises(tf2_ros.TypeException, match="Type <class 'int'> is not loaded or supported"):
            tf2_ros.convert(3 + 4j, int)

    program(body)
    stage.until(10)
    assert results == ['3.0 4.0', 5.0, 'x']


def test_all_names_of_the_package_can_be_imported():
    assert {name: getattr(tf2_ros, name).__name__ for name in tf2_ros.__all__} == {n: n for n in tf2_ros.__all__}
    assert tf2_ros.buffer.Buffer is tf2_ros.Buffer
    with pytest.raises(ImportError):
        from tf2_ros import Bufer  # noqa: F401
