"""What a program prints when an exception ends it: what Python prints, without the engine.

Exception groups are told as Python tells them.
"""

from __future__ import annotations

import re
import sys
import traceback
from typing import Any

import pytest

from edulaunch.engine.processes.traceback_text import student_traceback


def printed(world: Any, text: str) -> list[str]:
    return [line.replace(str(world.folder), '@') for line in world.run(text).splitlines()]


def test_an_exception_comes_with_the_one_it_was_raised_from(world: Any) -> None:
    lines = printed(world, 'try:\n    {}["a"]\nexcept KeyError as error:\n    raise ValueError("no a") from error')
    assert lines[3:6] == ["KeyError: 'a'", '', 'The above exception was the direct cause of the following exception:']
    assert lines[-1] == 'ValueError: no a' and len(lines) == 11


@pytest.mark.parametrize(('ending', 'count'), [('', 2), (' from None', 1)])
def test_an_exception_comes_with_the_one_that_was_being_handled(world: Any, ending: str, count: int) -> None:
    lines = printed(world, f'try:\n    1 / 0\nexcept ZeroDivisionError:\n    raise ValueError("second"){ending}')
    assert lines.count('Traceback (most recent call last):') == count
    assert ('During handling of the above exception, another exception occurred:' in lines) == (count == 2)


def test_what_the_engine_handled_inside_is_not_told(world: Any) -> None:
    lines = printed(world, 'import rclpy\nrclpy.init()\nrclpy.create_node("a").get_parameter("speed")')
    assert lines.count('Traceback (most recent call last):') == 1 and lines[4].startswith('  help: ') and len(lines) == 5


def test_endless_recursion_is_told_in_a_few_lines(world: Any) -> None:
    lines = printed(world, 'def again():\n    again()\nagain()')
    assert len(lines) < 15 and lines[-1].startswith('RecursionError') and lines[-2].startswith('  [Previous line repeated ')


def test_a_wrong_field_is_shown_where_the_student_set_it(world: Any) -> None:
    lines = printed(world, 'from geometry_msgs.msg import Twist\nTwist().linear.x = 1\n')
    assert lines == [
        'Traceback (most recent call last):',
        '  File "@/program-1.py", line 2, in <module>',
        '    Twist().linear.x = 1',
        "AssertionError: The 'x' field must be of type 'float'",
        '  help: the field x is of type float, but the value is of type int; write 1.0',
    ]


@pytest.mark.parametrize('text', ['class Odd(BaseException):\n    pass\nraise Odd("x")', 'raise GeneratorExit'])
def test_no_exception_ends_a_program_in_silence(world: Any, text: str) -> None:
    assert printed(world, text)[0] == 'Traceback (most recent call last):' and world.codes == {'program-1': 1}


def test_a_programs_own_excepthook_is_called(world: Any) -> None:
    assert printed(world, 'import sys\nsys.excepthook = lambda kind, error, trace: print("hook", kind.__name__)\n1 / 0') == [
        'hook ZeroDivisionError'
    ]
    assert world.codes == {'program-1': 1}


def test_python_tells_of_modules_that_import_each_other(world: Any) -> None:
    world.write('lib/one.py', 'from two import b\na = 1')
    world.write('lib/two.py', 'from one import a\nb = 1')
    error, help = printed(world, 'import one')[-2:]
    assert error.startswith(
        "ImportError: cannot import name 'a' from partially initialized module 'one' (most likely due to a circular import)"
    )
    assert (
        help
        == '  help: one is not fully imported yet, because two modules import each other; write the import inside the function that needs it'
    )


def test_an_executor_of_a_thread_ends_without_frames_of_the_engine(world: Any) -> None:
    lines = printed(
        world,
        'import threading, time, rclpy\nfrom rclpy.executors import MultiThreadedExecutor\nrclpy.init()\n'
        'executor = MultiThreadedExecutor()\nthread = threading.Thread(target=executor.spin)\nthread.start()\n'
        'time.sleep(1)\nrclpy.shutdown()\nthread.join()',
    )
    assert lines == ['Exception in thread Thread-1 (spin):', 'rclpy.executors.ExternalShutdownException']


@pytest.mark.parametrize(
    ('text', 'last'),
    [
        (
            'import rclpy\nrclpy.init()\nrclpy.create_node("a").creat_timer(1, print)',
            "AttributeError: 'Node' object has no attribute 'creat_timer'. Did you mean: 'create_timer'?",
        ),
        ('from rclpy.qos import QoSProfil', "rclpy/qos.py). Did you mean: 'QoSProfile'?"),
        ('print(math.pi)', "NameError: name 'math' is not defined. Did you forget to import 'math'?"),
        ('counter = 1\nprint(conter)', "NameError: name 'conter' is not defined. Did you mean: 'counter'?"),
        (
            'class A:\n    def __init__(self):\n        self.speed = 1\n        print(speed)\nA()',
            "NameError: name 'speed' is not defined. Did you mean: 'self.speed'?",
        ),
        ('timer = 1\nprint(time)', "Did you mean: 'timer'? Or did you forget to import 'time'?"),
        ('print(qqqqq)', "NameError: name 'qqqqq' is not defined"),
        ('"".qqqqq', "AttributeError: 'str' object has no attribute 'qqqqq'"),
    ],
)
def test_the_nearest_name_is_suggested_as_by_newer_pythons(world: Any, text: str, last: str) -> None:
    assert [line for line in printed(world, text) if not line.startswith('  help:')][-1].endswith(last)


def test_a_death_inside_a_library_is_at_the_students_line(world: Any) -> None:
    process = world.start(world.write('p.py', 'import numpy\ndef solve():\n    numpy.linalg.solve([[0.0]], [0.0])\nsolve()'))
    world.sim.run(world.sim.now_ns)
    assert process.exception['place'] == (f'{world.folder}/p.py', 3)
    assert any('site-packages' in line for line in ''.join(text for *_, text in world.log).splitlines())


pytestmark = pytest.mark.skipif(sys.version_info < (3, 11), reason='Python has exception groups from 3.11 on')
MARKS = re.compile(r'\n[ |]*[~^]+(?=\n)')


def raised(error: BaseException, cause: BaseException | None = None) -> BaseException:
    try:
        raise error from cause
    except BaseException as caught:
        return caught


def group(text: str, *members: BaseException) -> Any:
    return ExceptionGroup(text, members)  # type: ignore[arg-type]  # noqa: F821


def groups() -> list[BaseException]:
    """Of many shapes: nested first and last, chained inside and outside, too large, never raised."""
    chained = raised(TypeError('two\nlines'), raised(ValueError('first')))
    inner = raised(group('inner', ValueError(1), chained))
    outer = raised(group('outer', raised(KeyError('a')), inner))
    return [
        inner,
        outer,
        raised(group('first', inner, ValueError(2))),
        group('bare', ValueError(3)),
        raised(RuntimeError('after'), outer),
        raised(group('many', *map(ValueError, range(18)))),
        raised(group('one too many', *map(ValueError, range(16)))),
    ]


@pytest.mark.parametrize('error', groups() if sys.version_info >= (3, 11) else [], ids=str)
def test_the_text_is_python_s_without_marks_below_the_lines(error: BaseException) -> None:
    assert student_traceback(error)[0] == MARKS.sub('', ''.join(traceback.format_exception(error)))


def test_the_place_is_that_of_the_first_member() -> None:
    member = raised(ValueError('a'))
    assert member.__traceback__ is not None
    place = student_traceback(raised(group('g', member)))[1]
    assert place is not None
    assert place.line == member.__traceback__.tb_lineno
