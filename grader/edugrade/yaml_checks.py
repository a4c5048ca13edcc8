"""The checks that a YAML rubric may ask for, in ROS terms."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from math import inf, isfinite, tau
from typing import Any, NamedTuple

from .arithmetic import calculated
from .evidence import Evidence, Failure, Mismatch, Missing
from .library.arguments import require_argument, require_default
from .library.circle_fit import fit_circle
from .library.close import require_close
from .library.following import require_near, require_pursuit
from .library.frames import numbers, require_frame, transforms, yaw
from .library.launched import find_processes, refuse_dead, require_process
from .library.movement import Track, length, odometry_track, since, turtle_track
from .library.node_graph import require_ended, require_listener, require_node, require_nodes, require_started, require_topic
from .library.parameters import require_parameter

ARGUMENT = re.compile(r'\$\(arg (\w+)\)')


class Wanted(dict[str, Any]):
    """What a check of a rubric asks for; values may have ``$(arg name)`` in them, the launch argument of the run."""

    def __init__(self, given: dict[str, Any], try_: str | None) -> None:
        super().__init__(given)
        self.try_ = try_

    def __missing__(self, key: str) -> str:
        return ''

    @property
    def shown(self) -> Wanted:
        """As a sentence says it: ``$(arg speed)`` is speed, and the parts of a list have commas between them."""
        parts = {key: ', '.join(map(str, value)) if isinstance(value, list) else str(value) for key, value in self.items()}
        return Wanted({key: ARGUMENT.sub(r'\1', text) for key, text in parts.items()}, None)

    def refuse_odd_values(self) -> None:
        """Raise ValueError for a tolerance or another measure that is no number, or a share that is none."""
        for key in ('tolerance', 'within', 'since', 'rate', 'near'):
            if key in self and not (isinstance(self[key], (int, float)) and self[key] >= 0):
                raise ValueError(f'{key} is {self[key]!r}, and no number from 0 on')
        for key in ('at_least', 'radius', 'x', 'y', 'z', 'yaw', 'at'):
            try:
                calculated(ARGUMENT.sub('1', str(self.get(key, 0))))
            except ValueError:
                raise ValueError(f'{key} is {self[key]!r}; a number, $(arg NAME), or such with + - * / between them') from None
        if 'share' in self and not (isinstance(self['share'], (int, float)) and 0 < self['share'] < 1):
            raise ValueError(f'share is {self["share"]!r}, and no number between 0 and 1')
        for key in ('pattern',):
            if key in self:
                try:
                    re.compile(str(self[key]))
                except re.error as error:
                    raise ValueError(f'{key} is no regular expression: {error}') from None

    def text(self, key: str, run: Evidence, scenario: str) -> str:
        """A value as text, for one run."""
        arguments = run.scenario(scenario).arguments
        return ARGUMENT.sub(lambda found: arguments[found[1]], str(self[key]))

    def number(self, key: str, run: Evidence, scenario: str) -> float:
        """A value as a number, for one run; it may have to be calculated."""
        return calculated(self.text(key, run, scenario))

    def same_type(self, key: str, run: Evidence, scenario: str) -> Any:
        """A value as YAML reads it, for one run: ``$(arg radius)`` is 0.5 when radius:=0.5."""
        if not isinstance(self[key], str) or not ARGUMENT.search(self[key]):
            return self[key]
        import yaml

        return yaml.safe_load(self.text(key, run, scenario))


class Kind(NamedTuple):
    """A kind of check: its function, its fields, those it cannot do without, and what the student reads."""

    function: Callable[[Evidence, Wanted], None]
    fields: tuple[str, ...]
    required: tuple[str, ...]
    sentence: str


def _argument(run: Evidence, wanted: Wanted) -> None:
    if 'default' in wanted:
        require_default(run, wanted['name'], str(wanted['default']))
    else:
        require_argument(run, wanted['name'], '...')


def _process(run: Evidence, wanted: Wanted) -> None:
    require_process(run, wanted['package'], wanted['executable'])


def _alive(run: Evidence, wanted: Wanted) -> None:
    refuse_dead(run)


def _node(run: Evidence, wanted: Wanted) -> None:
    for scenario in run:
        name = wanted.text('name', run, scenario)
        require_node(
            run.only([scenario]), name, wanted['package'], wanted.try_ or f'give the Node of {wanted["package"]} {_both(name)}'
        )


def _both(name: str) -> str:
    return 'this namespace and name' if name.strip('/').count('/') else 'this name'


def _nodes(run: Evidence, wanted: Wanted) -> None:
    for scenario in run:
        require_nodes(run, scenario, [str(name) for name in wanted['are']], wanted.try_)


def _hears(run: Evidence, wanted: Wanted) -> None:
    for scenario in run:
        node, topic = (wanted.text(key, run, scenario) for key in ('node', 'topic'))
        require_listener(run, scenario, node, topic, wanted.try_ or f"give the Node remappings=[(..., '{topic}')]")


def _starts(run: Evidence, wanted: Wanted) -> None:
    _happens(run, wanted, 'start', require_started)


def _ends(run: Evidence, wanted: Wanted) -> None:
    _happens(run, wanted, 'end', require_ended)


def _happens(run: Evidence, wanted: Wanted, what: str, require: Callable[[Evidence, str, str, str | None], float]) -> None:
    """A node starts or ends at a time, or so long after the start of another node."""
    for scenario in run:
        time_s = require(run, scenario, wanted.text('node', run, scenario), wanted.try_)
        since_s = require_started(run, scenario, wanted.text('after', run, scenario), wanted.try_) if 'after' in wanted else 0.0
        words = f'the {what} of {wanted["node"]}' + (f' after the start of {wanted["after"]}' if 'after' in wanted else '')
        asked, tolerance = wanted.number('at', run, scenario), _tolerance(wanted, 0.3)
        require_close(run, scenario, f'{words} in s', time_s - since_s, asked, tolerance, *_near(wanted), try_=wanted.try_)


def _topic(run: Evidence, wanted: Wanted) -> None:
    for scenario in run:
        topic = require_topic(run, scenario, wanted['name'], wanted['type'] or None, wanted['package'] or None, wanted.try_)
        if 'rate' in wanted:
            rate = topic.count / run[scenario].duration_s
            require_close(
                run,
                scenario,
                f'the rate of {topic.name} in Hz',
                rate,
                wanted['rate'],
                _tolerance(wanted, 0.2 * wanted['rate']),
                *_near(wanted),
                try_=wanted.try_,
            )


def _parameter(run: Evidence, wanted: Wanted) -> None:
    require_process(run, wanted['package'], wanted['executable'])
    values = {scenario: wanted.same_type('value', run, scenario) for scenario in run}
    advice = wanted.try_ or f"give the Node parameters=[{{'{wanted['name']}': ...}}]"
    require_parameter(run, wanted['package'], wanted['executable'], wanted['name'], values, advice)


def _node_parameter(run: Evidence, wanted: Wanted) -> None:
    for scenario in run:
        node, name = wanted.text('node', run, scenario), wanted['name']
        advice = wanted.try_ or f'ros2 param get {node} {name} shows the value; look in the launch file for what sets it'
        require_node(run.only([scenario]), node, wanted['package'], advice)
        found = run[scenario].parameters(node).get(name)
        asked = wanted.same_type('value', run, scenario)
        if found is None or found.value != asked or isinstance(found.value, bool) != isinstance(asked, bool):
            seen = 'no such parameter' if found is None else f'{found.value}, from {found.origin}'
            words = run.scenario(scenario).words
            raise Mismatch(f'{name} of {node}, when launched with {words}', str(asked), seen, where=run.source.place, try_=advice)


def _measured_parameter(run: Evidence, wanted: Wanted) -> None:
    """A parameter of a node lies between bounds, and comes from where it should."""
    for scenario in run:
        node, name = wanted.text('node', run, scenario), wanted['name']
        advice = wanted.try_ or f'ros2 param get {node} {name} shows the value; look in the launch file for what sets it'
        require_node(run.only([scenario]), node, wanted['package'], advice)
        found = run[scenario].parameters(node).get(name)
        low, high = wanted.get('at_least', -inf), wanted.get('at_most', inf)
        value = None if found is None else found.value
        is_number = isinstance(value, (int, float)) and not isinstance(value, bool)
        if found is None or not (is_number and low <= value <= high and str(wanted['origin']) in found.origin):
            seen = 'no such parameter' if found is None else f'{value!r}, from {found.origin}'
            bounds = [f'at least {low:g}'] * ('at_least' in wanted) + [f'at most {high:g}'] * ('at_most' in wanted)
            asked = ' and '.join(bounds + [f'from {wanted["origin"]}'] * ('origin' in wanted))
            raise Mismatch(f'{name} of {node}', asked, seen, where=run.source.place, try_=advice)


def _defined(run: Evidence, wanted: Wanted) -> None:
    """A cell has defined this name, with this value."""
    name, asked = wanted['name'], wanted['is']
    if name not in run.names:
        raise Missing(name, expected=f'{name} = ...', try_=wanted.try_ or f'run the cell that defines {name}')
    if run.names[name] != asked:
        raise Mismatch(name, repr(asked), repr(run.names[name])[:1000], try_=wanted.try_)


def _logs(run: Evidence, wanted: Wanted) -> None:
    """A node says a line that fits."""
    pattern = re.compile(str(wanted['pattern']))
    for scenario, recording in run.items():
        node = wanted.text('node', run, scenario).strip('/').replace('/', '.')
        said = [log.message for log in recording.logs if log.logger.replace('/', '.') == node]
        if not any(pattern.search(text[:1000]) for text in said):
            raise Missing(
                f'such a line of {wanted["node"]}',
                expected=wanted['example'] or wanted['pattern'],
                seen='\n'.join(text[:200] for text in said[-4:]) or 'it says nothing',
                where=run.source.place,
                try_=wanted.try_,
            )


def _place(run: Evidence, wanted: Wanted) -> None:
    for scenario in run:
        track = turtle_track(run[scenario], f'/{wanted["turtle"].strip("/")}/pose')
        if not track:
            raise Missing(
                f'the turtle {wanted["turtle"]}',
                seen='no pose of it',
                where=run.source.place,
                try_=wanted.try_ or 'who spawns it?',
            )
        for axis, key in enumerate(('x', 'y'), 1):
            if key in wanted:
                asked = wanted.number(key, run, scenario)
                what = f'{key} of {wanted["turtle"]} at the end in m'
                require_close(
                    run, scenario, what, track[-1][axis], asked, _tolerance(wanted, 0.05), *_near(wanted), try_=wanted.try_
                )


def _frame(run: Evidence, wanted: Wanted) -> None:
    child, advice = wanted['child'], wanted.try_ or 'look at what ros2 run tf2_tools view_frames shows'
    require_frame(run, child, wanted['parent'], advice)
    for scenario in run:
        for sent in transforms(run, scenario)[child]:
            tolerance = _tolerance(wanted, 0.01)
            for axis, key in enumerate(('x', 'y', 'z')):
                if key in wanted:
                    asked = wanted.number(key, run, scenario)
                    where = f'{key} of {child} in {sent.frame.parent} (its place is {numbers(sent.frame.translation)})'
                    require_close(
                        run, scenario, where, sent.frame.translation[axis], asked, tolerance, *_near(wanted), try_=advice
                    )
            if 'yaw' in wanted:
                asked = wanted.number('yaw', run, scenario)
                turns = round((asked - yaw(sent.frame)) / tau)  # half a turn is the same to the left and to the right
                require_close(
                    run,
                    scenario,
                    f'the yaw of {child}',
                    yaw(sent.frame) + turns * tau,
                    asked,
                    tolerance,
                    *_near(wanted),
                    try_=advice,
                )


def _travels(run: Evidence, wanted: Wanted) -> None:
    for scenario, track in _tracks(run, wanted):
        way, asked = length(track), wanted.number('at_least', run, scenario)
        if not way >= asked:
            share = way / asked if wanted['share'] and isfinite(way) else 0.0
            raise Failure(
                f'{_who(wanted)} travels too little, when launched with {run.scenario(scenario).words}',
                expected=f'at least {asked:g} m',
                seen=f'{way:.2f} m',
                where=run.source.place,
                try_=wanted.try_,
                share=min(share, wanted['share'] or 0.0),
            )


def _circle(run: Evidence, wanted: Wanted) -> None:
    for scenario, track in _tracks(run, wanted):
        circle = fit_circle([(x, y) for _, x, y in since(track, wanted['since'] or 2.0)])
        radius = wanted.number('radius', run, scenario)
        tolerance = _tolerance(wanted, 0.02 * radius)
        if circle is None or not circle.residual <= max(tolerance, 0.05 * radius):
            raise Failure(
                f'{_who(wanted)} drives no circle, when launched with {run.scenario(scenario).words}',
                expected=f'a circle with a radius of {radius:g} m',
                seen=f'{length(track):.2f} m travelled, on no circle',
                where=run.source.place,
                try_=wanted.try_,
            )
        require_close(
            run,
            scenario,
            f'the radius of the circle of {_who(wanted)}',
            circle.radius,
            radius,
            tolerance,
            *_near(wanted),
            try_=wanted.try_,
        )


def _follows(run: Evidence, wanted: Wanted) -> None:
    advice = wanted.try_ or 'look at the frames that the listener asks tf for'
    for scenario, recording in run.items():
        goal, start = f'/{wanted["goal"].strip("/")}', wanted['since'] or recording.duration_s / 2
        follower = f'/{wanted["follower"].strip("/")}'
        track = turtle_track(recording, f'{goal}/pose')
        require_near(run, scenario, track, follower, wanted['within'], start, advice)
        if length(since(track, start)) > 1.0:
            require_pursuit(run, scenario, goal, follower, start, advice)


def _prints(run: Evidence, wanted: Wanted) -> None:
    pattern = re.compile(str(wanted['pattern']))
    for scenario, recording in run.items():
        names = [process.name for process in find_processes(recording, wanted['package'], wanted['executable'])]
        said = [item.text for item in recording.output if item.process in names]
        if not any(pattern.search(line[:1000]) for text in said for line in text.splitlines()):
            raise Missing(
                f'{wanted["pattern"]} in what {wanted["executable"]} prints, when launched with {run.scenario(scenario).words},',
                seen=''.join(said)[-400:] or 'nothing is printed',
                where=run.source.place,
                try_=wanted.try_,
            )


def _tracks(run: Evidence, wanted: Wanted) -> Iterator[tuple[str, Track]]:
    for scenario, recording in run.items():
        if wanted['turtle']:
            yield scenario, turtle_track(recording, f'/{wanted["turtle"].strip("/")}/pose')
        else:
            yield scenario, odometry_track(recording, wanted['odometry'] or '/odom')


def _who(wanted: Wanted) -> str:
    return str(wanted['turtle'] or 'the robot')


def _tolerance(wanted: Wanted, usual: float) -> float:
    return float(wanted['tolerance']) if 'tolerance' in wanted else usual


def _near(wanted: Wanted) -> tuple[float, float]:
    """The wider tolerance within which a share of the points is given."""
    return float(wanted['near'] or 0.0), float(wanted['share'] or 0.5)


_MEASURE = ('tolerance', 'near', 'share')
KINDS = {
    'argument': Kind(_argument, ('name', 'default'), ('name',), 'The launch argument {name} is declared, with a default'),
    'process': Kind(
        _process, ('package', 'executable'), ('package', 'executable'), 'The launch file starts {executable} of {package}'
    ),
    'alive': Kind(_alive, (), (), 'No node dies before the end'),
    'node': Kind(_node, ('name', 'package'), ('name', 'package'), 'There is a node {name} of the package {package}'),
    'nodes': Kind(_nodes, ('are',), ('are',), 'These nodes run, and no others: {are}'),
    'hears': Kind(_hears, ('node', 'topic'), ('node', 'topic'), '{node} hears what is published on {topic}'),
    'starts': Kind(_starts, ('node', 'at', 'after', *_MEASURE), ('node', 'at'), '{node} starts when it should'),
    'ends': Kind(_ends, ('node', 'at', 'after', *_MEASURE), ('node', 'at'), '{node} ends when it should'),
    'topic': Kind(_topic, ('name', 'type', 'package', 'rate', *_MEASURE), ('name',), 'Somebody publishes on {name}'),
    'parameter': Kind(
        _parameter,
        ('package', 'executable', 'name', 'value'),
        ('package', 'executable', 'name', 'value'),
        'The parameter {name} of {executable} has its value',
    ),
    'node_parameter': Kind(
        _node_parameter,
        ('node', 'package', 'name', 'value'),
        ('node', 'package', 'name', 'value'),
        'The parameter {name} of {node} has its value',
    ),
    'measured_parameter': Kind(
        _measured_parameter,
        ('node', 'package', 'name', 'at_least', 'at_most', 'origin'),
        ('node', 'package', 'name'),
        'The parameter {name} of {node} is as it should be',
    ),
    'defined': Kind(_defined, ('name', 'is'), ('name', 'is'), '{name} has its value'),
    'logs': Kind(_logs, ('node', 'pattern', 'example'), ('node', 'pattern'), '{node} says {pattern}'),
    'place': Kind(_place, ('turtle', 'x', 'y', *_MEASURE), ('turtle',), '{turtle} stands in its place at the end'),
    'frame': Kind(
        _frame,
        ('child', 'parent', 'x', 'y', 'z', 'yaw', *_MEASURE),
        ('child', 'parent'),
        'tf knows the frame {child} in the frame {parent}',
    ),
    'travels': Kind(
        _travels, ('turtle', 'odometry', 'at_least', 'share'), ('at_least',), '{turtle} moves by at least {at_least} m'
    ),
    'circle': Kind(
        _circle,
        ('turtle', 'odometry', 'radius', 'since', *_MEASURE),
        ('radius',),
        '{turtle} drives a circle with the radius {radius}',
    ),
    'follows': Kind(
        _follows,
        ('follower', 'goal', 'within', 'since'),
        ('follower', 'goal', 'within'),
        '{follower} stays close to {goal}, within {within} m',
    ),
    'prints': Kind(
        _prints, ('package', 'executable', 'pattern'), ('package', 'executable', 'pattern'), '{executable} prints {pattern}'
    ),
}
