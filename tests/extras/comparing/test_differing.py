from __future__ import annotations

from typing import Any

import pytest

from edulaunch.extras.comparing import differing
from edulaunch.extras.comparing.differing import Difference
from edulaunch.extras.comparing.observation import BRIEFLY, End, Flow, Line, Observation, Program, Values

ASKED_S = 10.0


def differences(simulated: Observation, real: Observation) -> list[Difference]:
    return differing.differences([simulated], real)


def seen(**parts: Any) -> Observation:
    nothing: dict[str, Any] = {'nodes': {'/a': 0.0}, 'ends': {}, 'parameters': {}, 'flows': {}, 'lines': [], 'programs': {}}
    codes = parts.pop('codes', {})
    parts['programs'] = parts.get('programs') or {
        f'{name}-{number}': Program(0.0, ASKED_S + 0.3, code) for name in codes for number, code in enumerate(codes[name])
    }
    return Observation(**{**nothing, 'asked_s': ASKED_S, **parts})


def flow(*rows: tuple[float, Any], field: str = 'x') -> Flow:
    values = Values()
    for time_s, value in rows:
        values.add(time_s, value)
    return Flow([time_s for time_s, _ in rows], {field: values})


def steady(hz: float, begin_s: float = 0.0, value: Any = 1.0) -> Flow:
    return flow(*((begin_s + index / hz, value) for index in range(int((ASKED_S - begin_s) * hz))))


def test_equal_runs_differ_in_nothing() -> None:
    one = seen(flows={'/t': steady(10)}, parameters={'/a': {'p': 1}}, lines=[Line('a', 'x', 1.0)], codes={'a': [0]})
    assert differences(one, one) == []


def test_nodes() -> None:
    found = differences(seen(nodes={'/a': 0.0, '/b': 1.0, '/late': 10.5}), seen(nodes={'/a': 0.8, '/c': 1.0}))
    assert found == [Difference('node', '/b', 'there', 'missing'), Difference('node', '/c', 'missing', 'there')]


def test_types_and_qos_of_endpoints() -> None:
    here = {
        End('publisher', '/t', 'x/msg/A', '/a'): ('reliable volatile', 0.0),
        End('subscription', '/t', 'x/msg/A', '/a'): ('reliable volatile', 0.0),
        End('service', '/s', 'x/srv/S', '/a'): ('', 0.0),
        End('client', '/late', 'x/srv/S', '/a'): ('', 10.5),
        End('client', '/of_nobody', 'x/srv/S', '/gone'): ('', 0.0),
    }
    there = {
        End('publisher', '/t', 'x/msg/B', '/a'): ('reliable volatile', 0.0),
        End('subscription', '/t', 'x/msg/A', '/a'): ('best_effort volatile', 0.0),
    }
    assert differences(seen(ends=here), seen(ends=there)) == [
        Difference('publisher', '/t of /a', 'x/msg/A', 'x/msg/B'),
        Difference('service', '/s of /a', 'x/srv/S', 'missing'),
        Difference('QoS of subscription', '/t of /a', 'reliable volatile', 'best_effort volatile'),
    ]


def test_parameters() -> None:
    here, there = {'/a': {'n': 1, 'same': [1.0], 'gone': 'x'}, '/silent': {'p': 1}}, {'/a': {'n': 1.0, 'same': [1.0]}}
    assert differences(seen(parameters=here), seen(parameters=there)) == [
        Difference('parameter', 'gone of /a', "'x'", 'missing'),
        Difference('parameter', 'n of /a', '1', '1.0'),
    ]


def test_a_topic_on_which_one_is_silent() -> None:
    found = differences(seen(flows={'/a': steady(5), '/early': flow((1.0, 0))}), seen(flows={'/b': flow((1.0, 0))}))
    assert found == [Difference('messages', '/a', '50', 'none'), Difference('messages', '/b', 'none', '1')]


@pytest.mark.parametrize(('hz', 'differs'), [(10.0, False), (8.5, False), (7.0, True), (20.0, True)])
def test_rates(hz: float, differs: bool) -> None:
    found = differences(seen(flows={'/t': steady(10)}), seen(flows={'/t': steady(hz, 1.0)}))
    assert found == ([Difference('rate of messages', '/t', '10 Hz', f'{hz:.3g} Hz')] if differs else [])


@pytest.mark.parametrize(('hz', 'differs'), [(1000.0, False), (20.0, True)])
def test_a_burst_makes_no_rate(hz: float, differs: bool) -> None:
    here, there = flow(*((number / 5, 1.0) for number in range(12))), flow(*((1.0 + number / hz, 1.0) for number in range(12)))
    found = differences(seen(flows={'/t': here}), seen(flows={'/t': there}))
    assert [each.kind for each in found] == ['rate of messages'] * differs


def test_numbers_of_what_was_never_so_in_simulation() -> None:
    here = flow(*((time / 10, time / 10) for time in range(100)))
    later = flow(*((time / 10 + 1.0, time / 10) for time in range(90)))
    wild = flow(*((time / 10 + 1.0, -time / 10) for time in range(90)))
    assert differences(seen(flows={'/t': here}), seen(flows={'/t': later})) == []
    assert differences(seen(flows={'/t': here}), seen(flows={'/t': wild})) == [
        Difference('values in messages', '/t x', '0 to 9.9', '-8.9 to 0')
    ]


def test_numbers_that_were_so_in_simulation_only() -> None:
    here = flow(*((float(time), 5.0 if time == 4 else 0.0) for time in range(10)))
    still = flow(*((float(time), 0.0) for time in range(1, 10)))
    assert differences(seen(flows={'/t': here}), seen(flows={'/t': still})) == [
        Difference('values in messages', '/t x', '0 to 5', '0', lacks=True)
    ]


def test_what_was_said_before_anybody_listened_for_real_is_no_difference() -> None:
    here = flow((0.1, 99.0), *((float(time), 1.0) for time in range(1, 10)))
    assert differences(seen(flows={'/t': here}), seen(flows={'/t': steady(1, 2.0)})) == []


def test_texts_in_messages() -> None:
    here, there = flow((5.0, 'Hello'), (6.0, 'Hello')), flow((5.0, 'Hello'), (6.0, 'Bye'))
    assert differences(seen(flows={'/t': here}), seen(flows={'/t': there})) == [
        Difference('values in messages', '/t x', "'Hello'", "'Bye', 'Hello'")
    ]


def test_output() -> None:
    here = [Line('a', 'both', 1.0), Line('a', 'only here', 2.0), Line('a', 'at Ctrl-C', 10.1)]
    there = [Line('a', 'both', 1.5), Line('a', 'only there', 2.0)]
    assert differences(seen(lines=here), seen(lines=there)) == [
        Difference('output', 'a', 'at Ctrl-C', 'missing'),
        Difference('output', 'a', 'only here', 'missing'),
        Difference('output', 'a', 'missing', 'only there'),
    ]


def test_exit_codes_in_any_order() -> None:
    found = differences(seen(codes={'a': [0, 1], 'b': [0]}), seen(codes={'a': [1, 0], 'b': [-2], 'c': [0]}))
    assert found == [Difference('exit code', 'b', '0', '-2'), Difference('exit code', 'c', 'still running', '0')]


def test_a_bad_moment_for_ctrl_c_is_no_difference() -> None:
    error = 'rclpy.RCLError: failed to shutdown: rcl_shutdown already called'
    assert differences(seen(codes={'a': [0]}), seen(codes={'a': [1]}, lines=[Line('a', error, 10.2)])) == []
    assert differences(seen(codes={'a': [0]}), seen(codes={'a': [1]}, lines=[Line('a', error, 9.8)])) == [
        Difference('output', 'a', 'missing', error),
        Difference('exit code', 'a', '0', '1'),
    ]


def test_what_differs_from_one_of_several_simulations_only_is_a_matter_of_chance() -> None:
    early, late = seen(nodes={'/a': 0.0, '/b': 0.0}, parameters={'/a': {'n': 1}}), seen(parameters={'/a': {'n': 2}})
    real = seen(nodes={'/a': 0.0, '/c': 0.0}, parameters={'/a': {'n': 1}})
    assert differing.differences([early, late], real) == [Difference('node', '/c', 'missing', 'there')]
    neither = seen(parameters={'/a': {'n': 3}})
    assert differing.differences([early, late], neither) == [Difference('parameter', 'n of /a', '2', '3')]


def test_values_that_a_short_simulation_has_not_yet_and_a_long_one_has_beyond_are_no_difference() -> None:
    def turn(seconds: int) -> Flow:
        return flow(*((float(second), 10.0 * second) for second in range(seconds)))

    short, long, real = (seen(flows={'/t': turn(seconds)}) for seconds in (10, 30, 15))
    assert [each.lacks for each in differences(short, real)] == [False]
    assert [each.lacks for each in differing.differences([long._replace(asked_s=30.0)], real)] == [True]
    assert differing.differences([short, long._replace(asked_s=30.0)], real) == []


def test_the_last_words_of_python_after_ctrl_c_are_no_difference() -> None:
    words = ('lost sys.stderr', 'object address  : #', 'object refcount : #', 'object type name: RCLError')
    there = [Line('a', text, 10.2) for text in words]
    here = [Line('a', 'at work', 5.0), Line('a', 'the end', 10.1)]
    assert differences(seen(lines=here), seen(lines=[Line('a', 'at work', 5.0), *there], codes={})) == []
    assert differences(seen(lines=here), seen(lines=there)) == [Difference('output', 'a', 'at work', 'missing')]
    assert differences(seen(lines=here), seen(lines=here[:1])) == [Difference('output', 'a', 'the end', 'missing')]


def test_what_launch_itself_ended_at_a_bad_moment_is_no_difference_either() -> None:
    here = seen(lines=[Line('a', 'the end', 5.0)], programs={'a-1': Program(0.0, 5.0, 0)})
    error = Line('a', 'SystemError: <built-in method f> returned a result with an exception set', 5.2)
    there = {'a-1': Program(0.1, 5.6, 1, signalled_s=5.1, spoke_s=1.0)}
    assert differences(here, seen(lines=[error, Line('a', 'KeyboardInterrupt', 5.3)], programs=there)) == []
    found = differences(here, seen(lines=[error._replace(time_s=4.0)], programs=there))
    assert [each.kind for each in found] == ['output', 'output', 'exit code']


def test_the_same_last_words_without_a_signal_are_compared() -> None:
    said = [Line('a', "Failed to publish: publisher's context is invalid", 2.0)]
    here = seen(lines=said, programs={'a-1': Program(0.0, 2.0, 1)})
    there = {'a-1': Program(0.1, 2.8, 1, spoke_s=2.5)}
    assert differences(here, seen(lines=[said[0]._replace(time_s=2.5)], programs=there)) == []
    assert [each.kind for each in differences(here, seen(programs=there))] == ['output']


def test_a_crash_after_a_signal_is_no_difference() -> None:
    here = seen(lines=[Line('a', 'the end', 10.0)], programs={'a-1': Program(0.0, 10.0, 0)})
    there = Program(0.1, 10.6, -11, signalled_s=10.1, spoke_s=1.0)
    assert differences(here, seen(programs={'a-1': there})) == []
    found = differences(here, seen(programs={'a-1': there._replace(signalled_s=BRIEFLY)}))
    assert [each.kind for each in found] == ['output', 'exit code']


def test_what_other_random_numbers_change_is_by_chance() -> None:
    one = seen(parameters={'/a': {'n': 1}}, lines=[Line('a', 'odd', 1.0)], codes={'a': [0]})
    other = seen(parameters={'/a': {'n': 2}}, lines=[Line('a', 'even', 1.0)], codes={'a': [0]})
    chance = differing.by_chance([one, other])
    assert chance == {('parameter', 'n of /a'), ('output', 'a', 'odd'), ('output', 'a', 'even')}
    assert differing.subject(Difference('output', 'a', 'missing', 'even')) in chance
    assert differing.subject(Difference('exit code', 'a', '0', '1')) not in chance
