"""The checks of YAML rubrics, in ROS terms. Each check is a function with the name that rubrics use."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from math import inf
from typing import TYPE_CHECKING, NamedTuple

from ..evidence import Advice, Evidence, Failure, Mismatch, Missing
from ..library.arguments import require_default
from ..library.deaths import refuse_dead, refuse_gone
from ..library.identity import nodes_of, processes_of
from ..library.launched import require_process
from ..library.node_graph import (
    own_name_of_topic,
    require_ended,
    require_listener,
    require_node,
    require_nodes,
    require_started,
    require_topic,
)
from ..library.parameters import named_origin, refuse_missing_file, require_parameter, value_and_origin
from ..library.parameters import node_parameter as read_parameter
from ..library.written import argument_as_namespace, name_of_node, parameter_of_node, remapping_to
from ..shortened import shortened
from .yaml_wanted import ARGUMENT, OfRun, Wanted

if TYPE_CHECKING:
    from edulaunch.engine.recording.records import NodeRecord, Parameter

Function = Callable[[Evidence, Wanted], None]
LONGEST_VALUE = 1000
MEASURE = 'tolerance near share'
PROGRAM = 'package executable'


class CheckKind(NamedTuple):
    """A kind of check: its function, its fields, its required fields, and the sentence that the student reads."""

    function: Function
    fields: tuple[str, ...]
    required: tuple[str, ...]
    sentence: str


KINDS: dict[str, CheckKind] = {}


def kind(sentence: str, needs: str = '', may: str = '') -> Callable[[Function], Function]:
    """Return a decorator that registers a function as a kind of check.

    :param sentence: the sentence that the student reads, with the names of fields in braces.
    :param needs: the required fields, separated by spaces.
    :param may: the optional fields, separated by spaces.
    """

    def make(function: Function) -> Function:
        KINDS[function.__name__] = CheckKind(function, (*needs.split(), *may.split()), tuple(needs.split()), sentence)
        return function

    return make


@kind('The launch argument {name} is declared and has a default', 'name', 'default shows')
def argument(run: Evidence, wanted: Wanted) -> None:
    """Require a declared launch argument with a default. The runs without the argument must use this default."""
    default = str(wanted['default']) if 'default' in wanted else None
    try:
        require_default(run, wanted['name'], default, wanted.shows)
    except Missing as failure:
        failure.try_ = wanted.try_ if isinstance(wanted.try_, str) else failure.try_
        raise


@kind('The launch file starts {executable} of {package}', 'package executable')
def process(run: Evidence, wanted: Wanted) -> None:
    """Require that the launch file starts a program."""
    require_process(run, wanted['package'], wanted['executable'])


@kind('No node dies before the end')
def alive(run: Evidence, wanted: Wanted) -> None:
    """Require that no process ends with an error before the end of the run, and that endless programs run until then."""
    refuse_dead(run)
    if not wanted.may_end:
        refuse_gone(run)


@kind('There is a node {name} of the package {package}', 'name package', 'executable absent')
def node(run: Evidence, wanted: Wanted) -> None:
    """Require a node of a package with this name. In the runs that `absent` lists, no node may have this name."""
    for one in wanted.of_each(run):
        name, package = one.text('name'), wanted['package']
        if one.scenario in wanted['absent']:
            if any(each.name == name for each in one.recording.nodes):
                asked, advice = f'no node {name} in the run with {one.words}', f'check the condition of {name}'
                words = {**one.advice, 'try_': wanted.try_ or advice}
                raise Failure(f'{name} starts in the run with {one.words}', expected=asked, seen=name, **words)
            continue
        require_node(one.alone, name, package, wanted.try_ or _name_advice(one), wanted['executable'] or None)


def _name_advice(one: OfRun, key: str = 'name') -> str:
    """Return advice to start the program of a node, or to give the node its namespace and its name. Parts that depend on launch
    arguments are named by these.
    """
    namespace, _, name = str(one.wanted[key]).strip('/').rpartition('/')
    package, executable = one.program()
    program = executable or package or ''
    if package is not None and not nodes_of(one.recording, package, executable):
        for position in processes_of(one.recording, package, executable):
            return f'read what {one.recording.processes[position].name} prints before it ends, because it creates no node'
        return f'start {program} with {one.words}: add its Node, or check its condition and its event'
    argument = ARGUMENT.fullmatch(namespace)
    if argument is not None:
        return argument_as_namespace(one.run, argument[1], program)
    advice = name_of_node(one.run, one.filled(namespace), '' if name == program else one.filled(name), program)
    return f'{advice}, and check its condition' if one.wanted['absent'] else advice


@kind('Only these nodes run: {are}', 'are', 'package')
def nodes(run: Evidence, wanted: Wanted) -> None:
    """Require exactly these nodes. `package` is the package of all nodes, or a table of packages by node name."""
    names, package = [str(name) for name in wanted['are']], wanted['package'] or None
    packages = package if isinstance(package, dict) else dict.fromkeys(names, package) if package else None
    for scenario in run:
        require_nodes(run, scenario, names, wanted.try_, packages)


@kind('{node} subscribes to {topic}', 'node topic', PROGRAM)
def hears(run: Evidence, wanted: Wanted) -> None:
    """Require that a node subscribes to a topic that has messages."""
    for one in wanted.of_each(run):
        node, topic = one.text('node'), one.text('topic')
        require_topic(
            run, one.scenario, topic, try_='check the name, the namespace and the remappings of the node that publishes'
        )
        name = own_name_of_topic(one.recording, *_own_node(one), topic)
        require_listener(run, one.scenario, node, topic, wanted.try_ or remapping_to(run, topic, name), *one.program())


def _own_node(one: OfRun) -> tuple[int, NodeRecord]:
    """Return (position in the recording, node) for the field `node`.

    :raises Missing: with advice to start or to rename it, because advice of the rubric about this node would not help.
    """
    package, executable = one.program()
    try:
        return require_node(one.alone, one.text('node'), package, _name_advice(one, 'node'), executable)[one.scenario]
    except Failure as failure:
        failure.fits_rubric = False
        raise


@kind('{node} starts at the right time', 'node at', f'after {PROGRAM} {MEASURE}')
def starts(run: Evidence, wanted: Wanted) -> None:
    """Require that a node starts at a given time, or at a given time after the start of another node."""
    one = next(wanted.of_each(run))
    other = one.other('after')[0]
    action = (
        f'start {one.text("node")}' if not one.number('at') else f'put {one.text("node")} into a TimerAction({one.code("at")})'
    )
    steps = 'check which action and which event start this node', f'check whether this node waits for {other or "a timer"}'
    last = f'{action} in an event handler for the start of {other}' if other else action
    _happens(run, wanted.advising([*steps, last]), 'start', require_started)


@kind('{node} ends at the right time', 'node at', f'after {PROGRAM} {MEASURE}')
def ends(run: Evidence, wanted: Wanted) -> None:
    """Require that a node ends at a given time, or at a given time after the start of another node."""
    _happens(run, wanted.advising('check what ends this node, and when'), 'end', require_ended)


@kind('The launch shuts down at the right time', 'at', MEASURE)
def shuts_down(run: Evidence, wanted: Wanted) -> None:
    """Require that launch itself ends at a given time, before the end of the run."""
    for one in wanted.of_each(run):
        ended = [
            process.ended_s for process in one.recording.processes if process.name == 'launch' and process.ended_s is not None
        ]
        if not ended:
            raise Failure(
                f'the launch does not shut down in the run with {one.words}',
                expected=f'the launch shuts down after {one.number("at"):g} s',
                seen='the launch continues until the end of the run',
                **one.advice,
            )
        one.require_close('the end of the launch', ended[0], one.number('at'), 0.3, unit='s after its start')


def _happens(run: Evidence, wanted: Wanted, what: str, require: Callable[..., float]) -> None:
    for one in wanted.of_each(run):
        if _waits_in_vain(one):
            continue
        time_s = require(run, one.scenario, one.text('node'), _start_advice(one), *one.program())
        (since_s, words), thing = _moment(one), f'the {what} of {one.text("node")}'
        if words and time_s < since_s - one.tolerance(0.3) and one.number('at') >= 0.0:
            raise Mismatch(thing, words.strip(), f'{since_s - time_s:.2f} s before that', **one.advice)
        unit = f's{words or " after the start of the launch"}'
        one.require_close(thing, time_s - since_s, one.number('at'), 0.3, unit=unit)
        other, *program = one.other('after')
        if other and _place(one, other, *program) > _place(one, one.text('node'), *one.program()):
            raise Mismatch(thing, f'after the start of {other}', f'before the start of {other}', **one.advice)


def _waits_in_vain(one: OfRun) -> bool:
    """Return whether the node is absent because the node of `after` could not start.

    :raises Mismatch: if the node started nevertheless.
    """
    other, *program = one.other('after')
    if not other or not one.run.scenario(one.scenario).fails or _has_node(one, other, *program):
        return False
    if not _has_node(one, one.text('node'), *one.program()):
        return True
    node = one.text('node')
    raise Failure(
        f'{node} starts without {other} in the run with {one.words}',
        expected=f'{node} starts only after the start of {other}',
        seen=f'{node} starts, although {other} does not start',
        **one.advice,
    )


def _start_advice(one: OfRun) -> Advice:
    """Return the advice of the rubric, or advice to correct the name of the node if its program starts."""
    package, executable = one.program()
    is_there = package is not None and executable is not None and nodes_of(one.recording, package, executable)
    return _name_advice(one, 'node') if is_there else one.wanted.try_


def _has_node(one: OfRun, node: str, package: str | None = None, executable: str | None = None) -> bool:
    try:
        require_node(one.alone, node, package, one.wanted.try_, executable)
    except Failure:
        return False
    return True


def _moment(one: OfRun) -> tuple[float, str]:
    """Return the time that `after` names, and words for a sentence. Without `after`, return (0.0, '').

    The time is that of the start of a node, or of the first message on a topic.
    """
    after = one.wanted['after']
    if isinstance(after, dict) and 'topic' in after:
        topic = require_topic(one.alone, one.scenario, one.filled(after['topic']), None, after.get('package'), one.wanted.try_)
        first_s = min(time_s for time_s, _ in one.recording.messages(topic.name))
        return first_s, f' after the first message on {topic.name}'
    other, *program = one.other('after')
    if not other:
        return 0.0, ''
    return require_started(one.run, one.scenario, other, one.wanted.try_, *program), f' after the start of {other}'


def _place(one: OfRun, node: str, package: str | None, executable: str | None) -> int:
    """Return the position of a node's program among the programs of its run, in the order in which they started."""
    (_, found) = require_node(one.alone, node, package, one.wanted.try_, executable)[one.scenario]
    return next(place for place, process in enumerate(one.recording.processes) if process.name == found.process)


@kind('A node publishes on {name}', 'name', f'type package rate {MEASURE}')
def topic(run: Evidence, wanted: Wanted) -> None:
    """Require messages on a topic. Optional fields require a type, a package that publishes the messages, and a rate."""
    for one in wanted.of_each(run):
        found = require_topic(run, one.scenario, wanted['name'], wanted['type'] or None, wanted['package'] or None, wanted.try_)
        if 'rate' in wanted:
            rate = found.count / one.recording.duration_s
            one.require_close(f'the rate of {found.name}', rate, wanted['rate'], 0.2 * wanted['rate'], unit='Hz')


@kind('The parameter {name} of {executable} has the right value', 'package executable name value')
def parameter(run: Evidence, wanted: Wanted) -> None:
    """Require the value of a parameter of an executable's node."""
    require_process(run, wanted['package'], wanted['executable'])
    values = {one.scenario: one.same_type('value') for one in wanted.of_each(run)}
    code = next(wanted.of_each(run)).code('value')
    advice = wanted.try_ or parameter_of_node(run, wanted['name'], code)
    require_parameter(run, wanted['package'], wanted['executable'], wanted['name'], values, advice, code=code)


@kind('The parameter {name} of {node} has the right value', 'node package name value', 'origin')
def node_parameter(run: Evidence, wanted: Wanted) -> None:
    """Require the value of a parameter of a node and, optionally, its origin."""
    for one, found, advice in _parameters(run, wanted):
        asked, origin = one.same_type('value'), str(wanted['origin'])
        is_right = found is not None and found.value == asked and isinstance(found.value, bool) == isinstance(asked, bool)
        if found is None or not is_right or origin not in found.origin:
            refuse_missing_file(one.alone, [found], wanted['package'])
            seen = value_and_origin(found)
            thing, words = f'{wanted["name"]} of {one.text("node")}', f'{asked} (from {origin})' if origin else str(asked)
            is_default = found is None or found.origin == 'default'
            where = run.source.place_in(origin, wanted['name']) if origin and is_default else run.source.place
            raise Mismatch(thing, words, seen, where=where, try_=advice, during=one.words)


@kind('The parameter {name} of {node} has the right value', 'node package name', 'at_least at_most origin')
def measured_parameter(run: Evidence, wanted: Wanted) -> None:
    """Require that a parameter of a node is between limits and, optionally, has an origin."""
    for one, found, advice in _parameters(run, wanted):
        low, high = wanted.get('at_least', -inf), wanted.get('at_most', inf)
        value = None if found is None else found.value
        is_number = isinstance(value, (int, float)) and not isinstance(value, bool)
        if found is None or not (is_number and low <= value <= high and str(wanted['origin']) in found.origin):
            refuse_missing_file(one.alone, [found], wanted['package'])
            seen = value_and_origin(found)
            bounds = [f'at least {low:g}'] * ('at_least' in wanted) + [f'at most {high:g}'] * ('at_most' in wanted)
            asked = ' and '.join(bounds + [f'from {wanted["origin"]}'] * ('origin' in wanted))
            raise Mismatch(f'{wanted["name"]} of {one.text("node")}', asked, seen, where=run.source.place, try_=advice)


def _parameters(run: Evidence, wanted: Wanted) -> Iterator[tuple[OfRun, Parameter | None, Advice]]:
    """Yield (values of the check, parameter or None, advice) for each run. The node must exist."""
    for one in wanted.of_each(run):
        node, name = one.text('node'), wanted['name']
        _own_node(one)
        code = one.code('value') if 'value' in wanted else 'another value'
        where = f'check which parameter file, argument or Node sets {name} of {node}'
        advice = wanted.try_ or (
            'check the value that the launch file gives this parameter',
            where,
            f'set {name} of {node} to {code}',
        )
        asked = one.same_type('value') if 'value' in wanted else None
        found = read_parameter(one.recording, node, wanted['package'], name, asked)
        if found is not None and 'origin' in wanted:
            found = found._replace(origin=named_origin(run, found, node, name))
        yield one, found, advice


@kind('{name} has the right value', 'name is')
def defined(run: Evidence, wanted: Wanted) -> None:
    """Require that a cell defines this name with this value."""
    name, asked = wanted['name'], wanted['is']
    if name not in run.names:
        raise Missing(name, expected=f'{name} = ...', try_=wanted.try_ or f'run the cell that defines {name}')
    if run.names[name] != asked:
        raise Mismatch(name, repr(asked), shortened(repr(run.names[name]), LONGEST_VALUE), try_=wanted.try_)
