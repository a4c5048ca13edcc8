"""The check of lesson 17: everything that one follower needs."""

from __future__ import annotations

from edugrade import Evidence, Mismatch, Missing, Rubric, Scenario, check
from edugrade.library.identity import nodes_of
from edugrade.library.parameters import parameter_of


def given(run: Evidence, scenario: str, name: str, node: str) -> list[object]:
    """Return the values of a parameter in the nodes of a program, given as ``EXECUTABLE of PACKAGE``."""
    executable, package = node.split(' of ')
    found = (parameter_of(run[scenario], position, name) for position in nodes_of(run[scenario], package, executable))
    return [each.value for each in found if each is not None]


def require(run: Evidence, name: str, prefix: str, argument: str, node: str) -> None:
    for scenario in run:
        wanted, seen = prefix + run.scenario(scenario).arguments[argument], given(run, scenario, name, node)
        if not seen:
            raise Missing(
                f'the parameter {name}',
                seen=f'no node of the program {node.split(" of ")[0]} has this parameter',
                where=run.source.place,
                try_=f'start {node} with its parameters',
            )
        if wanted not in seen:
            words = f'{name} in the run with {run.scenario(scenario).words}'
            raise Mismatch(
                words, wanted, ', '.join(map(str, seen)), where=run.source.place, try_=f'check the parameters of {node}'
            )


@check(points=1)
def it_knows_its_target(run: Evidence) -> None:
    """The parameter target of the follower is the carrot of its leader"""
    require(run, 'target', 'carrot_', 'leader', 'follower of fleet')


@check(points=1)
def it_knows_itself(run: Evidence) -> None:
    """The parameter me of the follower is its own turtle"""
    require(run, 'me', '', 'me', 'follower of fleet')


@check(points=1)
def its_turtle_is_broadcast(run: Evidence) -> None:
    """The parameter turtlename of a broadcaster is the turtle of the follower"""
    require(run, 'turtlename', '', 'me', 'turtle_tf2_broadcaster of turtle_tf2_py')


@check(points=1, needs=[it_knows_its_target])
def names_differ(run: Evidence) -> None:
    """The nodes of two followers have different names"""
    one, two = ({node.name for node in run[scenario].nodes if 'ros2' not in node.name} for scenario in run)
    if one & two:
        raise Mismatch(
            'the names of the nodes',
            'different names for different turtles',
            f'both followers have {", ".join(sorted(one & two))}',
            where=run.source.place,
            try_="write name=['follower_', me]",
        )


RUBRIC = Rubric(
    title='One follower',
    of='my_ws/src/fleet/launch/follower.launch.py',
    scenarios=lambda random: [
        Scenario('second', {'me': 'turtle2', 'leader': 'turtle1'}, 1.0),
        Scenario('third', {'me': 'turtle3', 'leader': 'turtle2'}, 1.0),
    ],
    checks=[it_knows_its_target, it_knows_itself, its_turtle_is_broadcast, names_differ],
)
