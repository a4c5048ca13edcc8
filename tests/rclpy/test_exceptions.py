"""rclpy.exceptions."""

from __future__ import annotations

import pytest
from rclpy import exceptions

from .conftest import raised


def test_every_exception_is_in_the_exceptions_module() -> None:
    assert {name for name in exceptions.__all__ if not isinstance(getattr(exceptions, name), type)} == set()


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
