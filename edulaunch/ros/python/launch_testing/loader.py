"""Loads a launch test file."""

from __future__ import annotations

import functools
import inspect
import unittest
from collections.abc import Callable, Iterator, Mapping, Sequence
from types import ModuleType
from typing import Any

from launch.launch_description import LaunchDescription
from launch.launch_description_entity import LaunchDescriptionEntity

from .actions.ready import ReadyToTest
from .decorator import DEFAULT_TIMEOUT_S


class TestRun:
    """One launch with its tests.

    :param module: the module of the test file.
    :param describe: the function `generate_test_description` of the file, with its parameters filled in.
    :param parameters: the parameters of this launch, by name.
    :ivar pre_shutdown_tests: the tests to run while the launch runs.
    :ivar post_shutdown_tests: the tests to run after the shutdown of the launch.
    """

    __test__ = False  # pytest must not collect this class as a test case

    def __init__(self, name: str, module: ModuleType, describe: Callable[..., Any], parameters: Mapping[str, Any]) -> None:
        self.name = name
        self.parameters = parameters
        self._describe = describe
        function = module.generate_test_description
        self.timeout_s: float = getattr(function, '__ready_to_test_action_timeout__', DEFAULT_TIMEOUT_S)
        self.keeps_alive = 'keep_alive' in getattr(function, '__markers__', {})
        tests = list(_flat(unittest.TestLoader().loadTestsFromModule(module)))
        self.pre_shutdown_tests = [test for test in tests if not _is_post_shutdown(test)]
        self.post_shutdown_tests = [test for test in tests if _is_post_shutdown(test)]

    def __str__(self) -> str:
        return f'{self.name}[{", ".join(map(str, self.parameters.values()))}]' if self.parameters else self.name

    def description(self, ready: Callable[[], None]) -> tuple[LaunchDescription, dict[str, Any]]:
        """Create the launch description. Return the description, and the arguments for tests that the file returned with it.

        :param ready: a function that is called when the tests may begin.
        :raises Exception: when there is no `ReadyToTest`, or more than one.
        """
        if 'ready_fn' in inspect.signature(self._describe).parameters:
            return _with_context(self._describe(ready_fn=ready))
        description, context = _with_context(self._describe())
        actions = ready_actions(description)
        if len(actions) != 1:
            wanted = 'only one ReadyToTest action' if actions else 'a ReadyToTest action'
            raise Exception(
                'generate_test_description functions without a ready_fn argument must return '
                f'a LaunchDescription containing {wanted}'
            )
        actions[0].call_when_executed(ready)
        return description, context


def runs_of(module: ModuleType, name: str) -> list[TestRun]:
    """Return the launches that a test file describes: one launch, or one for each set of parameters.

    :raises AttributeError: when the file does not define `generate_test_description`.
    """
    function = module.generate_test_description
    each = function() if getattr(function, '__parametrized__', False) else [(function, {})]
    return [TestRun(name, module, describe, parameters) for describe, parameters in each]


def LoadTestsFromPythonModule(module: ModuleType, *, name: str = 'launch_tests') -> list[TestRun]:  # noqa: N802
    """Return the launches that a module describes. The name of this function is that of ROS 2."""
    return runs_of(module, name)


def _flat(suite: Any) -> Iterator[Any]:
    if isinstance(suite, unittest.TestSuite):
        for part in suite:
            yield from _flat(part)
    else:
        yield suite


def _is_post_shutdown(test: unittest.TestCase) -> bool:
    return bool(getattr(type(test), '__post_shutdown_test__', False))


def _with_context(result: Any) -> tuple[LaunchDescription, dict[str, Any]]:
    return (result[0], dict(result[1])) if isinstance(result, tuple) else (result, {})


def ready_actions(description: LaunchDescription) -> list[ReadyToTest]:
    """Return the `ReadyToTest` actions of a description, without repetitions."""
    return [*{id(action): action for action in _ready_actions(description.entities)}.values()]


def _ready_actions(entities: Sequence[LaunchDescriptionEntity]) -> Iterator[ReadyToTest]:
    """Yield the `ReadyToTest` actions of entities, including those in groups, timers and the entities of event handlers."""
    for entity in entities:
        if isinstance(entity, ReadyToTest):
            yield entity
        yield from _ready_actions(list(entity.describe_sub_entities()))
        for _, conditional in entity.describe_conditional_sub_entities():
            yield from _ready_actions(list(conditional))


def give(tests: Sequence[unittest.TestCase], attributes: Mapping[str, Any], values: Mapping[str, Any]) -> None:
    """Set attributes of tests, and pass arguments to the test methods that have parameters with the same names."""
    for test in tests:
        vars(test).update(attributes)
        for name in (test.id().rpartition('.')[2], 'setUp', 'tearDown'):
            setattr(test, name, _bound(getattr(test, name), values))
        for name in ('setUpClass', 'tearDownClass'):
            setattr(type(test), name, staticmethod(_bound(getattr(type(test), name), values)))


def _bound(function: Callable[..., Any], values: Mapping[str, Any]) -> Callable[..., Any]:
    names = inspect.signature(function).parameters
    matching = {name: value for name, value in values.items() if name in names}
    return functools.wraps(function)(functools.partial(function, **matching)) if matching else function
