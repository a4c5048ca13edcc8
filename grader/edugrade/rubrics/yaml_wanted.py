"""The values of a check in a YAML rubric. They may contain launch arguments and calculations."""

from __future__ import annotations

import ast
import operator
import re
from collections.abc import Callable, Iterator
from copy import copy
from math import isfinite
from typing import TYPE_CHECKING, Any

from ..evidence import Advice, Evidence, Mismatch
from ..library.close import require_close
from ..library.written import value_of
from ..shortened import readable

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording

ARGUMENT = re.compile(r'\$\(arg (\w+)\)')
OPERATORS: dict[type[ast.AST], Callable[[float, float], float]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
}

LISTS = ('absent', 'are', 'shows', 'topics')
"""Fields that are lists of names."""
SCALARS = ('default', 'is', 'value')
"""Fields that can have any type of a parameter or an argument."""
MEASURES = ('tolerance', 'within', 'since', 'rate', 'near')
CALCULATED = ('at_least', 'at_most', 'radius', 'x', 'y', 'z', 'yaw', 'at', 'ago')


class Wanted(dict[str, Any]):
    """The values of a check by field name. They may contain ``$(arg name)``, the value of a launch argument in the run.

    A field that the rubric does not contain has the value ''.

    :ivar shows: a function that applies the checks that show the effect of a default, or None.
    :ivar may_end: whether a check of the rubric expects that something ends.
    """

    shows: Callable[[Evidence], object] | None = None
    may_end = False

    def __init__(self, given: dict[str, Any], try_: Advice) -> None:
        super().__init__(given)
        self.try_: Advice = try_

    def __missing__(self, key: str) -> str:
        return ''

    @property
    def shown(self) -> Wanted:
        """The values as strings for a sentence. ``$(arg speed)`` becomes speed, and commas separate the entries of a list."""
        parts = {key: ', '.join(map(str, value)) if isinstance(value, list) else str(value) for key, value in self.items()}
        parts = {key: readable(text) if key == 'pattern' else text for key, text in parts.items()}
        return Wanted({key: ARGUMENT.sub(r'\1', text) for key, text in parts.items()}, None)

    def advising(self, advice: Advice) -> Wanted:
        """Return the values with the given advice, unless the rubric contains advice."""
        if self.try_ is not None:
            return self
        advised = copy(self)
        advised.try_ = advice
        return advised

    def of_each(self, run: Evidence) -> Iterator[OfRun]:
        """Yield the values of the check for each run."""
        return (OfRun(self, run, scenario) for scenario in run)

    def refuse_odd_values(self) -> None:
        """Raise an error for a value with a wrong type, or a number that is out of range.

        :raises ValueError: with a message that names the field and its value.
        """
        for key, value in self.items():
            if key in LISTS:
                if not isinstance(value, list) or not value or not all(isinstance(each, str) for each in value):
                    raise ValueError(f'{key} is {value!r}; write a list of names')
            elif key in SCALARS:
                if not all(isinstance(each, (str, int, float)) for each in (value if isinstance(value, list) else [value])):
                    raise ValueError(f'{key} is {value!r}; write a string, a number, true, false, or a list of those')
            elif key not in (*MEASURES, *CALCULATED, 'after', 'from', 'share') and not all(
                isinstance(each, str) and each.isprintable()
                for each in (value.values() if key == 'package' and isinstance(value, dict) else [value])
            ):
                raise ValueError(f'{key} is {value!r}; write a string')
        for key in MEASURES:
            if key in self and not (_is_number(self[key]) and self[key] >= 0):
                raise ValueError(f'{key} is {self[key]!r}; write a number of at least 0')
        self._refuse_odd_programs()
        for key in CALCULATED:
            try:
                calculated(ARGUMENT.sub('1', str(self.get(key, 0))))
            except ValueError:
                raise ValueError(f'{key} is {self[key]!r}; write a number, $(arg NAME), or a calculation with + - * /') from None
        if 'share' in self and not (isinstance(self['share'], (int, float)) and 0 < self['share'] < 1):
            raise ValueError(f'share is {self["share"]!r}; write a number between 0 and 1')
        try:
            re.compile(str(self['pattern']))
        except re.error as error:
            raise ValueError(f'pattern is not a valid regular expression: {error}') from None

    def _refuse_odd_programs(self) -> None:
        """Raise ValueError if `after` or `from` does not name a program or a topic in a valid form."""
        one_of = {'after': ({'node'}, {'topic'}), 'from': ({'node'}, {'package'}, {'node', 'package'})}
        topic = {'after': '{topic: NAME, package: PACKAGE}', 'from': '{package: PACKAGE, executable: EXECUTABLE}'}
        for key, allowed in one_of.items():
            value = self.get(key, {'node': ''})
            parts = value if isinstance(value, dict) else {'node': value}
            names = set(parts) & {'node', 'topic', 'package'} - ({'package'} if key == 'after' else set())
            is_known = set(parts) <= {'node', 'topic', 'package', 'executable'} and names in allowed
            if not is_known or not all(isinstance(each, str) for each in parts.values()):
                forms = f'the name of a node, {{node: NAME, package: PACKAGE}}, or {topic[key]}'
                raise ValueError(f'{key} is {value!r}; write {forms}')


class OfRun:
    """The values of a check for one run.

    :ivar alone: the evidence that contains only this run.
    :ivar advice: the place and the advice for a Failure.
    """

    def __init__(self, wanted: Wanted, run: Evidence, scenario: str) -> None:
        self.wanted, self.run, self.scenario = wanted, run, scenario
        self.recording: Recording = run[scenario]
        self.words = run.scenario(scenario).words
        self.alone = run.only([scenario])
        self.advice: dict[str, Any] = {'where': run.source.place, 'try_': wanted.try_}

    def program(self) -> tuple[str | None, str | None]:
        """Return the package and the executable that the rubric names. Each of them may be None."""
        return self.wanted['package'] or None, self.wanted['executable'] or None

    def text(self, key: str) -> str:
        """Return the value of a field as a string, in which launch arguments are replaced."""
        return self.filled(self.wanted[key])

    def other(self, key: str) -> tuple[str, str | None, str | None]:
        """Return (name, package, executable) of the node in a field, such as `/sim` or `{node: /sim, package: turtlesim}`.

        The package and the executable may be None.
        """
        value = self.wanted[key]
        found = value if isinstance(value, dict) else {'node': value}
        return self.filled(found.get('node', '')), found.get('package'), found.get('executable')

    def filled(self, value: object) -> str:
        """Return a value as a string, in which the launch arguments of the run replace ``$(arg name)``."""
        arguments = self.run.arguments_of(self.scenario)
        return ARGUMENT.sub(lambda found: arguments[found[1]], str(value))

    def number(self, key: str) -> float:
        """Return the value of a field as a number. The field may contain a calculation.

        :raises Mismatch: if a launch argument in the field is not a number.
        """
        try:
            return calculated(self.text(key))
        except ValueError:  # the default is not a number
            raise Mismatch(f'the value of {self.wanted[key]}', 'a number', self.text(key), **self.advice) from None

    def same_type(self, key: str) -> Any:
        """Return the value of a field with its type in YAML: ``$(arg radius)`` is the number 0.5 for radius:=0.5."""
        if not isinstance(self.wanted[key], str) or not ARGUMENT.search(self.wanted[key]):
            return self.wanted[key]
        import yaml

        return yaml.safe_load(self.text(key))

    def code(self, key: str) -> str:
        """Return the code for the value of a field in a launch file. ``$(arg radius)`` is a LaunchConfiguration."""
        argument = ARGUMENT.fullmatch(str(self.wanted[key]))
        return value_of(self.run, argument[1]) if argument else str(self.same_type(key))

    def tolerance(self, usual: float) -> float:
        """Return the tolerance of the rubric, or `usual` if the rubric states no tolerance."""
        return float(self.wanted['tolerance']) if 'tolerance' in self.wanted else usual

    def require_close(
        self, thing: str, seen: float, asked: float, usual: float, try_: Advice = None, beside: str = '', unit: str = ''
    ) -> None:
        """Require a number within the tolerance of the rubric (default: `usual`). Within `near`, the check gives a share of its
        points.

        :param beside: a remark about the number that was found.
        :param unit: the unit of both numbers.
        :raises Mismatch: with both numbers.
        """
        near, share = float(self.wanted['near'] or 0.0), float(self.wanted['share'] or 0.5)
        advice, close = try_ or self.wanted.try_, (seen, asked, self.tolerance(usual), near, share)
        require_close(self.run, self.scenario, thing, *close, try_=advice, beside=beside, unit=unit)


def calculated(text: str) -> float:
    """Return the value of a calculation with numbers, + - * / and brackets: ``5.544 + 4 * 0.3``.

    :raises ValueError: if the string is not such a calculation.
    """
    try:
        return _value(ast.parse(text.strip(), mode='eval').body)
    except (SyntaxError, ZeroDivisionError, RecursionError, KeyError):
        raise ValueError(f'{text!r} is not a number or a calculation with + - * / and brackets') from None


def _value(node: ast.expr) -> float:
    if isinstance(node, ast.Constant) and isinstance(node.value, (int, float)) and node.value is not True:
        return float(node.value)
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        return -_value(node.operand)
    if isinstance(node, ast.BinOp):
        return OPERATORS[type(node.op)](_value(node.left), _value(node.right))
    raise KeyError(type(node))


def _is_number(value: object) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool) and isfinite(value)
