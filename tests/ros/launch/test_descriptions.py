"""What the parts of a launch description say of themselves, and what they read and return without a running launch."""

from __future__ import annotations

import math
from types import SimpleNamespace
from typing import Any

import pytest
from launch import Condition, Event, EventHandler, LaunchContext, LaunchDescription, LaunchDescriptionSource
from launch.actions import (
    DeclareLaunchArgument,
    GroupAction,
    IncludeLaunchDescription,
    LogInfo,
    OpaqueFunction,
    RegisterEventHandler,
    ResetLaunchConfigurations,
    TimerAction,
)
from launch.conditions import IfCondition, LaunchConfigurationEquals, LaunchConfigurationNotEquals, UnlessCondition
from launch.conditions.evaluate_condition_expression_impl import evaluate_condition_expression
from launch.conditions.invalid_condition_expression_error import InvalidConditionExpressionError
from launch.event_handler import BaseEventHandler
from launch.event_handlers import OnShutdown
from launch.event_handlers.on_action_event_base import OnActionEventBase
from launch.events import Shutdown
from launch.events.process import matches_executable, matches_name, matches_pid
from launch.substitutions import (
    AllSubstitution,
    AndSubstitution,
    AnonName,
    AnySubstitution,
    Command,
    EnvironmentVariable,
    EqualsSubstitution,
    FindExecutable,
    IfElseSubstitution,
    LaunchConfiguration,
    LocalSubstitution,
    NotEqualsSubstitution,
    NotSubstitution,
    OrSubstitution,
    TextSubstitution,
    ThisLaunchFile,
    ThisLaunchFileDir,
)


@pytest.mark.parametrize(
    ('substitution', 'text'),
    [
        (AnonName(['a', 'b']), "AnonName('a' + 'b')"),
        (NotSubstitution('true'), "NotSubstitution('true')"),
        (AndSubstitution('1', LaunchConfiguration('x')), "AndSubstitution('1' LaunchConfig('x'))"),
        (OrSubstitution('1', '0'), "OrSubstitution('1' '0')"),
        (AnySubstitution('1', '0', '1'), "AnySubstitution('1' '0' '1')"),
        (AllSubstitution(), 'AllSubstitution()'),
        (Command(['ls ', LaunchConfiguration('x')]), "Command('ls ' + LaunchConfig('x'))"),
        (EnvironmentVariable('HOME'), "EnvVar('HOME')"),
        (EqualsSubstitution('a', LaunchConfiguration('x')), "EqualsSubstitution('a' LaunchConfig('x'))"),
        (NotEqualsSubstitution('a', 1), "NotEqualsSubstitution('a' '1')"),
        (FindExecutable(name='ls'), "FindExec('ls')"),
        (IfElseSubstitution('1', 'a', 'b'), "IfElseSubstitution('1', 'a', 'b')"),
        (LaunchConfiguration(['a', 'b'], default='c'), "LaunchConfig('a' + 'b')"),
        (LocalSubstitution('event.action'), "LocalVar('event.action')"),
        (LocalSubstitution('event.action', 'the action'), "LocalVar('the action')"),
        (ThisLaunchFile(), 'ThisLaunchFile()'),
        (ThisLaunchFileDir(), 'ThisLaunchFileDir()'),
        (TextSubstitution(text='a'), "'a'"),
    ],
)
def test_a_substitution_says_what_it_is(substitution: Any, text: str) -> None:
    assert substitution.describe() == text


def texts(parts: Any) -> list[str]:
    return [part.text for part in parts]


def test_a_substitution_shows_what_it_was_made_of() -> None:
    pair, many = AndSubstitution('l', 'r'), AnySubstitution('a', ['b', 'c'])
    assert (texts(pair.left), texts(pair.right), [texts(arg) for arg in many.args]) == (['l'], ['r'], [['a'], ['b', 'c']])
    choice = IfElseSubstitution('1', 'a', 'b')
    assert [texts(part) for part in (choice.condition, choice.if_value, choice.else_value)] == [['1'], ['a'], ['b']]
    command = Command('ls', on_stderr='warn')
    assert (texts(command.command), texts(command.on_stderr)) == (['ls'], ['warn'])
    variable = EnvironmentVariable('A', default_value='d')
    assert (texts(variable.name), texts(variable.default_value), EnvironmentVariable('A').default_value) == (['A'], ['d'], None)
    assert texts(LaunchConfiguration('x').variable_name) == ['x']
    assert (LocalSubstitution('a.b').expression, texts(NotSubstitution('x').value)) == ('a.b', ['x'])
    equal = EqualsSubstitution(True, None)
    assert (texts(equal.left), texts(equal.right)) == (['true'], [''])


@pytest.mark.parametrize(
    ('default', 'value'),
    [('d', 'd'), (5, '5'), (['a', TextSubstitution(text='b'), 1.5], 'ab1.5'), (TextSubstitution(text='t'), 't')],
)
def test_a_configuration_has_its_value_or_its_default(default: Any, value: str) -> None:
    context = LaunchContext()
    assert LaunchConfiguration('x', default=default).perform(context) == value
    context.launch_configurations['x'] = ''
    assert LaunchConfiguration('x', default=default).perform(context) == ''


@pytest.mark.parametrize(
    ('left', 'right', 'is_equal'),
    [
        ('a', 'a', True),
        ('a', 'b', False),
        ('A', 'a', False),
        ('TRUE', '1', True),
        ('false', '0', True),
        ('true', 'false', False),
        ('true', 'yes', False),
        ('1.0', 1, True),
        ('1.0', '2', False),
        ('0.1', 0.1 + 1e-12, True),
        (None, '', True),
        (True, 'True', True),
        (math.inf, 'inf', True),
        ('1', 'x', False),
    ],
)
def test_values_are_equal_as_booleans_as_numbers_or_as_texts(left: Any, right: Any, is_equal: bool) -> None:
    context = LaunchContext()
    assert EqualsSubstitution(left, right).perform(context) == str(is_equal).lower()
    assert NotEqualsSubstitution(left, right).perform(context) == str(not is_equal).lower()


@pytest.mark.parametrize('text', ['true', 'TRUE', ' 1\n', 'True'])
def test_conditions_that_hold(text: str) -> None:
    context = LaunchContext()
    assert evaluate_condition_expression(context, [TextSubstitution(text=text)]) is True
    assert (IfCondition(text).evaluate(context), UnlessCondition(text).evaluate(context)) == (True, False)


@pytest.mark.parametrize('text', ['false', 'FALSE', ' 0'])
def test_conditions_that_do_not_hold(text: str) -> None:
    context = LaunchContext()
    assert evaluate_condition_expression(context, [TextSubstitution(text=text)]) is False
    assert (IfCondition([text]).evaluate(context), UnlessCondition(text).evaluate(context)) == (False, True)


def test_another_text_is_no_condition() -> None:
    with pytest.raises(InvalidConditionExpressionError, match=r"expected one of \[true, 1, false, 0\] but got 'yes'"):
        IfCondition('Yes').evaluate(LaunchContext())


def test_conditions_say_what_they_are() -> None:
    expression = ['a', LaunchConfiguration('x')]
    assert (IfCondition(expression).describe(), IfCondition('1').in_words) == ("IfCondition('a' + LaunchConfig('x'))", "if '1'")
    assert (UnlessCondition('1').describe(), UnlessCondition('1').in_words) == ("UnlessCondition('1')", "unless '1'")
    plain = Condition()
    assert (plain.describe(), plain.in_words, plain.evaluate(LaunchContext())) == (repr(plain), 'if Condition says so', False)
    assert repr(plain) == '<launch.condition.Condition object at 0x>'
    assert Condition(predicate=lambda context: 'x' in context.launch_configurations).evaluate(LaunchContext()) is False


@pytest.mark.parametrize(
    ('value', 'expected', 'holds'),
    [('1', '1', True), ('1', ['1'], True), ('1', '2', False), (None, None, True), ('1', None, False)],
)
def test_a_configuration_is_compared(value: str | None, expected: Any, holds: bool) -> None:
    context = LaunchContext()
    if value is not None:
        context.launch_configurations['x'] = value
    with pytest.warns(UserWarning, match=r"IfCondition\(EqualsSubstitution\(LaunchConfiguration\('x'\)") as warned:
        equals, differs = LaunchConfigurationEquals('x', expected), LaunchConfigurationNotEquals('x', expected)
    assert (equals.evaluate(context), differs.evaluate(context)) == (holds, not holds)
    shown = 'unset' if expected is None else f"'{''.join(expected)}'"
    assert equals.in_words == f"if 'x' is {shown}"
    assert warned[0].filename == __file__


def test_a_handler_says_which_events_it_handles_and_what_it_visits() -> None:
    hears = callable
    info = LogInfo(msg='a')
    base = BaseEventHandler(matcher=hears, handle_once=True)
    assert base.describe() == (f"BaseEventHandler(matcher='{callable}', handler='<callable>', handle_once=True)", [])
    assert (base.handle_once, BaseEventHandler(matcher=hears).handle_once) == (True, False)
    assert EventHandler(matcher=hears).describe() == (
        f"EventHandler(matcher='{callable}', handler='<entities>', handle_once=False)",
        [],
    )
    for entities in (info, [info]):
        assert EventHandler(matcher=hears, entities=entities).describe()[1] == [info]
    handler = OnShutdown(on_shutdown=[info])
    assert (handler.handler_description, handler.matcher_description) == (
        str([info]),
        'event issubclass of launch.events.Shutdown',
    )
    assert RegisterEventHandler(EventHandler(matcher=hears)).describe_conditional_sub_entities() == []
    one = EventHandler(matcher=hears, entities=[info])
    assert RegisterEventHandler(one).describe_conditional_sub_entities() == [(one.describe()[0], [info])]
    assert RegisterEventHandler(one).event_handler is one


def test_a_handler_handles_what_matches_and_leaves_after_one_event_if_it_should() -> None:
    context, event, info = LaunchContext(), Event(), LogInfo(msg='a')
    handler = EventHandler(matcher=lambda event: isinstance(event, Shutdown), entities=[info], handle_once=True)
    assert (handler.matches(event), handler.matches(Shutdown())) == (False, True)
    context.register_event_handler(handler)
    assert handler.handle(event, context) == [info]
    assert context.locals.event is event
    with pytest.raises(ValueError, match='not in list|not registered'):
        context.unregister_event_handler(handler)
    always = EventHandler(matcher=callable, entities=info)
    context.register_event_handler(always)
    assert always.handle(event, context) is info
    context.unregister_event_handler(always)


def test_what_a_shutdown_leads_to_is_a_list_or_the_answer_of_a_function() -> None:
    context, event, info = LaunchContext(), Shutdown(reason='why'), LogInfo(msg='a')
    assert OnShutdown(on_shutdown=[info]).handle(event, context) == [info]
    asked: list[Any] = []
    handler = OnShutdown(on_shutdown=lambda *given: asked.append(given) or [info])
    assert (handler.handle(event, context), asked) == ([info], [(event, context)])
    assert (handler.matches(event), handler.matches(Event())) == (True, False)


class Acted(Event):
    def __init__(self, action: Any) -> None:
        self.action = action


def on_acted(**changes: Any) -> OnActionEventBase:
    given = {'action_matcher': None, 'on_event': [], 'target_event_cls': Acted, 'target_action_cls': LogInfo}
    return OnActionEventBase(**{**given, **changes})


def test_a_handler_of_an_actions_events_asks_for_the_action() -> None:
    mine, other = LogInfo(msg='a'), LogInfo(msg='b')
    assert [on_acted().matches(event) for event in (Acted(mine), Event())] == [True, False]
    assert [on_acted(action_matcher=mine).matches(Acted(one)) for one in (mine, other)] == [True, False]
    by_text = on_acted(action_matcher=lambda action: texts(action.msg) == ['b'])
    assert [by_text.matches(Acted(one)) for one in (mine, other)] == [False, True]
    assert (on_acted(action_matcher=mine).only_action, by_text.only_action, on_acted().only_action) == (mine, None, None)
    assert on_acted().matcher_description == 'event == Acted'
    assert on_acted(action_matcher=mine).matcher_description == 'event == Acted and LogInfo(event.action)'
    for wrong in (OpaqueFunction(function=print), 'talker', 3):
        with pytest.raises(TypeError, match="action_matcher must be an 'LogInfo' instance or a callable"):
            on_acted(action_matcher=wrong)


def test_a_handler_of_an_actions_events_leads_to_actions_or_asks_a_function() -> None:
    context, info = LaunchContext(), LogInfo(msg='a')
    event = Acted(info)
    for leads_to in (info, [info], (one for one in [info])):
        handler = on_acted(on_event=leads_to)
        assert (handler.handle(event, context), handler.describe()[1], handler.handler_description) == (
            [info],
            [info],
            '<actions>',
        )
    asked = on_acted(on_event=lambda event, context: [event.action])
    assert (asked.handle(event, context), asked.describe()[1]) == ([info], [])
    assert 'lambda' in asked.handler_description
    with pytest.raises(TypeError, match="of type 'LaunchDescriptionEntity' but got '<class 'str'>'"):
        on_acted(on_event=[info, 'a'])


def test_programs_are_found_by_number_by_name_and_by_path() -> None:
    details = {'pid': 7, 'name': 'talker-1', 'cmd': ['/lib/talker', 'x']}
    action: Any = SimpleNamespace(process_details=details)
    waits: Any = SimpleNamespace(process_details=None)
    for right, wrong in (
        (matches_pid(7), matches_pid(8)),
        (matches_name('talker-1'), matches_name('talker')),
        (matches_executable('talker'), matches_executable('x')),
    ):
        assert (right(action), wrong(action), right(waits)) == (True, False, False)


def test_a_launch_description_lists_its_arguments_once_with_the_includes_that_lead_to_them() -> None:
    inner = LaunchDescription([DeclareLaunchArgument('b'), DeclareLaunchArgument('a', default_value='other')])
    include = IncludeLaunchDescription(LaunchDescriptionSource(inner))
    first, sometimes = DeclareLaunchArgument('a'), DeclareLaunchArgument('c', condition=IfCondition('0'))
    hidden, late = DeclareLaunchArgument('d'), DeclareLaunchArgument('e')
    reset = GroupAction([ResetLaunchConfigurations(), hidden], scoped=False)
    description = LaunchDescription([first, include, sometimes, TimerAction(period=1.0, actions=[late]), reset])
    found = description.get_launch_arguments_with_include_launch_description_actions()
    assert [(argument.name, includes) for argument, includes in found] == [
        ('a', None),
        ('b', [include]),
        ('c', None),
        ('e', None),
    ]
    assert found[0][0] is first
    assert [argument._conditionally_included for argument, _ in found] == [False, False, True, True]
    assert [argument.name for argument in description.get_launch_arguments()] == ['a', 'b', 'c', 'e']
    assert [one._conditionally_included for one in description.get_launch_arguments(conditional_inclusion=True)][0] is True
    assert description.describe() == repr(description)


def test_a_description_says_that_it_is_deprecated() -> None:
    old, new = LaunchDescription(deprecated_reason='use b'), LaunchDescription()
    assert [(one.deprecated, one.deprecated_reason) for one in (old, new)] == [(True, 'use b'), (False, None)]
    info = LogInfo(msg='a')
    new.add_action(info)
    assert new.entities == new.describe_sub_entities() == new.visit(LaunchContext()) == [info]


def test_a_source_knows_its_place_once_it_is_read() -> None:
    context, inner = LaunchContext(), LaunchDescription()
    context.launch_configurations['x'] = 'b'
    source = LaunchDescriptionSource(inner, location=['/a/', LaunchConfiguration('x')], method='by hand')
    assert (source.described_location, source.method) == ("'/a/' + LaunchConfig('x')", 'by hand')
    assert source.try_get_launch_description_without_context() is inner
    assert source.get_launch_description(context) is inner
    assert source.location == source.described_location == '/a/b'
    nothing = LaunchDescriptionSource(location='/c')
    assert nothing.try_get_launch_description_without_context() is None
    with pytest.raises(RuntimeError, match="no way to load one from '/c'"):
        nothing.get_launch_description(context)
    assert LaunchDescriptionSource(location=LaunchConfiguration('x')).try_get_launch_description_without_context() is None
