"""What a launch test file contains."""

from __future__ import annotations

import functools
import inspect
import unittest
from collections.abc import Callable, Iterator, Mapping, Sequence
from types import MappingProxyType, ModuleType
from typing import Any

from launch.launch_description import LaunchDescription
from launch.launch_description_entity import LaunchDescriptionEntity

from .actions.ready import ReadyToTest
from .decorator import DEFAULT_TIMEOUT_S

Tests = Sequence[unittest.TestCase]


class TestRun:
    """One launch with its tests.

    :param test_description_function: `generate_test_description`, parameters already filled in.
    :param param_args: those parameters.
    :param tests, post_shutdown_tests: to run while it is up, and afterwards.
    """

    __test__ = False  # pytest is not to take this class for a test case

    def __init__(
        self,
        name: str,
        test_description_function: Callable[..., Any],
        param_args: Mapping[str, Any],
        pre_shutdown_tests: Tests,
        post_shutdown_tests: Tests,
        *,
        timeout_s: float = DEFAULT_TIMEOUT_S,
        markers: Mapping[str, Any] | None = None,
    ) -> None:
        self.name = name
        self.param_args = dict(param_args)
        self.pre_shutdown_tests = pre_shutdown_tests
        self.post_shutdown_tests = post_shutdown_tests
        self.timeout_s = timeout_s
        self.markers = dict(markers or {})
        self.test_description_function = test_description_function

    def __str__(self) -> str:
        return f'{self.name}[{", ".join(map(str, self.param_args.values()))}]' if self.param_args else self.name

    def normalized_test_description(self, ready_fn: Callable[[], None]) -> tuple[LaunchDescription, dict[str, Any]]:
        """Make the description, and the context for the tests that came with it.

        :param ready_fn: called when the tests may begin.
        :raises Exception: when there is no `ReadyToTest`, or more than one.
        """
        function = self.test_description_function
        if self._takes_ready_fn():
            return _with_context(function(ready_fn=ready_fn))
        description, context = _with_context(function())
        actions = ready_actions(description)
        if len(actions) != 1:
            wanted = 'only one ReadyToTest action' if actions else 'a ReadyToTest action'
            raise Exception(
                'generate_test_description functions without a ready_fn argument must return '
                f'a LaunchDescription containing {wanted}'
            )
        actions[0]._add_callback(ready_fn)
        return description, context

    def validate(self) -> None:
        """Check the signature of `generate_test_description`.

        :raises TypeError: when it wants arguments that nobody gives.
        """
        given = {**self.param_args, 'ready_fn': None} if self._takes_ready_fn() else self.param_args
        self._signature().bind(**given)

    def _takes_ready_fn(self) -> bool:
        return 'ready_fn' in self._signature().parameters

    def _signature(self) -> inspect.Signature:
        """Of `generate_test_description` itself, without the parameters filled in."""
        function = self.test_description_function
        return inspect.signature(function.func if isinstance(function, functools.partial) else function)

    def get_launch_description(self) -> LaunchDescription:
        """The description alone, to look at."""
        return self.normalized_test_description(lambda: None)[0]

    def all_cases(self) -> Iterator[unittest.TestCase]:
        """All tests."""
        yield from self.pre_shutdown_tests
        yield from self.post_shutdown_tests

    def bind(
        self,
        tests: Tests,
        injected_attributes: Mapping[str, Any] = MappingProxyType({}),
        injected_args: Mapping[str, Any] = MappingProxyType({}),
    ) -> None:
        """Give the tests attributes, and their methods the arguments whose names they have."""
        for test in tests:
            for name, value in injected_attributes.items():
                setattr(test, name, value)
            method: str = test._testMethodName
            for name in (method, 'setUp', 'tearDown'):
                setattr(test, name, _bound(getattr(test, name), injected_args))
            for name in ('setUpClass', 'tearDownClass'):
                setattr(type(test), name, staticmethod(_bound(getattr(type(test), name), injected_args)))


def LoadTestsFromPythonModule(module: ModuleType, *, name: str = 'launch_tests') -> list[TestRun]:
    """The launches that a test file describes: one, or one for each parameter.

    :raises AttributeError: when there is no `generate_test_description`.
    """
    function = module.generate_test_description
    runs = function() if getattr(function, '__parametrized__', False) else [(function, {})]
    timeout_s = getattr(function, '__ready_to_test_action_timeout__', DEFAULT_TIMEOUT_S)
    markers = getattr(function, '__markers__', {})
    return [
        TestRun(
            name,
            description,
            parameters,
            _tests(PreShutdownTestLoader(), module),
            _tests(PostShutdownTestLoader(), module),
            timeout_s=timeout_s,
            markers=markers,
        )
        for description, parameters in runs
    ]


class PreShutdownTestLoader(unittest.TestLoader):
    """Loads the tests that run while processes run."""

    def loadTestsFromTestCase(self, testCaseClass: type[unittest.TestCase]) -> unittest.TestSuite:
        """Those of a class; none of one marked `post_shutdown_test`."""
        return _suite(super().loadTestsFromTestCase, testCaseClass, not _is_post_shutdown(testCaseClass))


class PostShutdownTestLoader(unittest.TestLoader):
    """Loads the tests that run when all processes have ended."""

    def loadTestsFromTestCase(self, testCaseClass: type[unittest.TestCase]) -> unittest.TestSuite:
        """Those of a class marked `post_shutdown_test`; none of another."""
        return _suite(super().loadTestsFromTestCase, testCaseClass, _is_post_shutdown(testCaseClass))


def _is_post_shutdown(test_class: type) -> bool:
    return bool(getattr(test_class, '__post_shutdown_test__', False))


def _suite(
    load: Callable[[type[unittest.TestCase]], unittest.TestSuite], test_class: type[unittest.TestCase], wanted: bool
) -> unittest.TestSuite:
    return load(test_class) if wanted else unittest.TestSuite()


def _tests(loader: unittest.TestLoader, module: ModuleType) -> list[unittest.TestCase]:
    return list(_flat(loader.loadTestsFromModule(module)))


def _flat(suite: Any) -> Iterator[Any]:
    if isinstance(suite, unittest.TestSuite):
        for part in suite:
            yield from _flat(part)
    else:
        yield suite


def _with_context(result: Any) -> tuple[LaunchDescription, dict[str, Any]]:
    return (result[0], dict(result[1])) if isinstance(result, tuple) else (result, {})


def ready_actions(description: LaunchDescription) -> list[ReadyToTest]:
    """The `ReadyToTest` actions of a description, each once."""
    return [*{id(action): action for action in _ready_actions(description.entities)}.values()]


def _ready_actions(entities: Sequence[LaunchDescriptionEntity]) -> Iterator[ReadyToTest]:
    """All of them, also in groups, timers and the lists of event handlers."""
    for entity in entities:
        if isinstance(entity, ReadyToTest):
            yield entity
        yield from _ready_actions(list(entity.describe_sub_entities()))
        for _, conditional in entity.describe_conditional_sub_entities():
            yield from _ready_actions(list(conditional))


def _bound(function: Callable[..., Any], values: Mapping[str, Any]) -> Callable[..., Any]:
    names = inspect.signature(function).parameters
    matching = {name: value for name, value in values.items() if name in names}
    return functools.wraps(function)(functools.partial(function, **matching)) if matching else function
