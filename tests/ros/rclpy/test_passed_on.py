"""Names that programs import from modules that only happen to have them."""

from __future__ import annotations

import subprocess
import sys
from importlib import import_module

import pytest
import rclpy

from edulaunch.ros.passed_on import _tables, homes_of


@pytest.mark.parametrize('module', _tables())
def test_every_name_is_found_at_its_home(module: str) -> None:
    found = import_module(module)
    assert [name for name in homes_of(module) if getattr(found, name, None) is None] == []


@pytest.mark.parametrize(
    ('module', 'name', 'home'),
    [
        ('rclpy.node', 'Publisher', 'rclpy.publisher'),
        ('rclpy.node', 'ParameterDescriptor', 'rcl_interfaces.msg'),
        ('rclpy.parameter', 'ParameterType', 'rcl_interfaces.msg'),
        ('rclpy.executors', 'Future', 'rclpy.task'),
        ('rclpy.client', 'QoSProfile', 'rclpy.qos'),
        ('tf2_ros', 'TransformStamped', 'geometry_msgs.msg'),
        ('tf2_ros', 'Node', 'rclpy.node'),
    ],
)
def test_it_is_the_same_thing(module: str, name: str, home: str) -> None:
    assert getattr(import_module(module), name) is getattr(import_module(home), name)


def test_a_module_of_rclpy_is_there_after_import_rclpy() -> None:
    assert rclpy.service_introspection is import_module('rclpy.service_introspection')


def test_another_name_of_the_message_package_is_meant_where_two_would_clash() -> None:
    from rcl_interfaces.msg import Parameter
    from rclpy.node import ParameterMsg

    assert ParameterMsg is Parameter


def test_a_name_that_is_nowhere_is_python_s_own_error() -> None:
    with pytest.raises(ImportError, match=r"cannot import name 'Nod' from 'rclpy\.node'"):
        from rclpy.node import Nod  # noqa: F401
    with pytest.raises(ImportError, match=r"cannot import name 'TransformListner' from 'tf2_ros'"):
        from tf2_ros import TransformListner  # noqa: F401


@pytest.mark.processes
def test_nothing_of_it_is_loaded_unasked() -> None:
    code = "import edulaunch, sys; edulaunch.source(); import rclpy.node; print([m for m in ('yaml', 'rcl_interfaces.srv') if m in sys.modules])"
    assert subprocess.run([sys.executable, '-c', code], capture_output=True, text=True, check=True).stdout == '[]\n'
