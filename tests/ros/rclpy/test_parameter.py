"""The class Parameter, and the texts and files that become parameters."""

from __future__ import annotations

from array import array
from pathlib import Path
from typing import Any

import pytest
import yaml
from rclpy.parameter import Parameter, get_parameter_value, parameter_dict_from_yaml_file, parameter_value_to_python

from .conftest import raised


@pytest.mark.parametrize(('text', 'value'), [('off', False), ('5', 5), ('[1.0]', [1.0]), ('a: b', 'a: b'), ('!!str 5', '5')])
def test_texts_become_values_as_in_ros2_param_set(text: str, value: Any) -> None:
    read = parameter_value_to_python(get_parameter_value(text))
    assert (list(read) if isinstance(value, list) else read) == value


def test_a_parameter_file_becomes_messages(tmp_path: Path) -> None:
    file = tmp_path / 'f.yaml'
    file.write_text('/n:\n  ros__parameters:\n    a:\n      b: 1\n/**:\n  ros__parameters:\n    c: x\n')
    found = parameter_dict_from_yaml_file(str(file), use_wildcard=True, target_nodes=['/n'])
    assert {name: parameter_value_to_python(message.value) for name, message in found.items()} == {'c': 'x', 'a.b': 1}


def test_type_and_value_must_agree() -> None:
    assert raised(Parameter, 'p', Parameter.Type.INTEGER, 1.0) == "ValueError: Type 'Type.INTEGER' and value '1.0' do not agree"


def test_a_parameter_survives_its_message() -> None:
    for value in (True, 5, 1.5, 'x', [True], ['a', 'b']):
        assert Parameter.from_parameter_msg(Parameter('p', value=value).to_parameter_msg()).value == value


@pytest.mark.parametrize(
    ('text', 'nodes', 'words'),
    [
        (
            '/a:\n  ros__parameters:\n    x: 1\n',
            ['/b'],
            r"Param file does not contain parameters for /b,only for nodes: \['/a'\] ",
        ),
        ('/**:\n  ros__parameters:\n    x: 1\n', None, 'Param file does not contain selected parameters'),
        ('/a:\n  x: 1\n', None, 'YAML file is not a valid ROS parameter file for node /a'),
    ],
)
def test_a_file_without_the_wanted_parameters_is_refused(tmp_path: Path, text: str, nodes: list[str] | None, words: str) -> None:
    file = tmp_path / 'p.yaml'
    file.write_text(text)
    with pytest.raises(RuntimeError, match=words):
        parameter_dict_from_yaml_file(str(file), target_nodes=nodes)


def test_the_type_goes_by_its_name_in_ros2() -> None:
    assert (repr(Parameter.Type.DOUBLE), str(Parameter.Type.DOUBLE)) == ('<Type.DOUBLE: 3>', 'Type.DOUBLE')
    assert raised(Parameter, 'p', 'int', 1) == "TypeError: type must be an instance of '<enum 'Type'>'"


def test_parameters_are_compared_and_shown_as_plain_objects() -> None:
    parameter = Parameter('p', value=1)
    assert (parameter == Parameter('p', value=1), {parameter: 2}[parameter]) == (False, 2)
    assert repr(parameter).startswith('<rclpy.parameter.Parameter object at 0x')


@pytest.mark.parametrize(
    ('value', 'words'),
    [
        ({'a': 1}, "The given value is not one of the allowed types '{'a': 1}'."),
        ([1, 2.0], "The given value is not a list of one of the allowed types '[1, 2.0]'."),
    ],
)
def test_a_value_that_no_parameter_can_hold_is_named(value: Any, words: str) -> None:
    assert raised(Parameter, 'p', None, value) == f'TypeError: {words}'


@pytest.mark.parametrize(
    ('text', 'number'), [('[]', Parameter.Type.BOOL_ARRAY), ('[1', Parameter.Type.STRING), ('~', Parameter.Type.STRING)]
)
def test_odd_texts_still_have_a_type(text: str, number: Parameter.Type) -> None:
    assert get_parameter_value(text).type == number.value


def test_a_text_without_yaml_tokens_is_refused_by_yaml() -> None:
    with pytest.raises(yaml.scanner.ScannerError, match="found character '@' that cannot start any token"):
        get_parameter_value('@')


def test_numbers_of_a_message_become_a_list_in_python_and_an_array_in_a_parameter() -> None:
    message = Parameter('p', value=[1, 2]).to_parameter_msg()
    assert parameter_value_to_python(message.value) == [1, 2]
    assert Parameter.from_parameter_msg(message).value == array('q', [1, 2])


def test_what_a_file_may_hold(tmp_path: Path) -> None:
    """A namespace stands before names without a dot of its own, the last node wins, and nothing is the text 'None'."""
    file = tmp_path / 'p.yaml'
    file.write_text('/a:\n  ros__parameters: {x: 1, n: }\n/b:\n  ros__parameters: {x: 5}\n')
    found = parameter_dict_from_yaml_file(str(file), namespace='ns.')
    assert {name: parameter_value_to_python(message.value) for name, message in found.items()} == {'ns.x': 5, 'ns.n': 'None'}
    file.write_text('/a:\n  ros__parameters: {}\n')
    assert parameter_dict_from_yaml_file(str(file)) == {}
    file.write_text('')
    with pytest.raises(AttributeError, match="'NoneType' object has no attribute 'keys'"):
        parameter_dict_from_yaml_file(str(file))


def test_bytes_of_a_byte_array_are_single() -> None:
    with pytest.raises(ValueError, match='do not agree'):
        Parameter('n', value=[b'ab'])
