"""rclpy.exceptions."""

from __future__ import annotations

import pytest
from rclpy import exceptions

from .conftest import raised

NAMES = """
    InvalidHandle InvalidNamespaceException InvalidNodeNameException InvalidParameterException InvalidParameterTypeException
    InvalidParameterValueException InvalidServiceNameException InvalidTopicNameException NameValidationException
    NoTypeSupportImportedException NotInitializedException ParameterAlreadyDeclaredException ParameterException
    ParameterImmutableException ParameterNotDeclaredException ParameterUninitializedException ROSInterruptException
"""


def test_the_exceptions_are_those_of_rclpy() -> None:
    here = {name for name, value in vars(exceptions).items() if isinstance(value, type) and issubclass(value, Exception)}
    assert here == set(NAMES.split())


@pytest.mark.parametrize(
    ('error', 'bases'),
    [
        (exceptions.InvalidTopicNameException, [exceptions.NameValidationException, Exception]),
        (exceptions.ParameterUninitializedException, [exceptions.ParameterException, Exception]),
        (exceptions.InvalidHandle, [RuntimeError, Exception]),
    ],
)
def test_exceptions_have_the_bases_of_rclpy(error: type[Exception], bases: list[type]) -> None:
    assert list(error.__mro__[1:-2]) == bases


def test_exceptions_take_the_arguments_of_rclpy() -> None:
    assert str(exceptions.NotInitializedException()) == 'rclpy.init() has not been called.'
    assert str(exceptions.ParameterImmutableException(parameter_name='p')) == 'Attempted to modify read-only parameter: p'
    refused = raised(exceptions.ROSInterruptException, 'why')
    assert refused is not None and refused.startswith('TypeError: ')
