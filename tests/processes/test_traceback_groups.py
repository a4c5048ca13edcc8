"""Exception groups are told as Python tells them."""

from __future__ import annotations

import re
import sys
import traceback
from typing import Any

import pytest

from edulaunch.processes.traceback_text import student_traceback

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
