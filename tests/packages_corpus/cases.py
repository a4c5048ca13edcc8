"""How each package of the corpus is run."""
from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple

CORPUS = Path(__file__).resolve().parents[1] / 'corpus'


class Case(NamedTuple):
    """One launch of a corpus package.

    :ivar file: the launch file. `package`: of which package, when the folder holds several.
    :ivar topics: what to watch besides output: (topic, field, field ...), a line for each change.
    :ivar random: whether the seed may decide what happens.
    """

    file: str
    duration_s: float
    package: str | None = None
    arguments: Mapping[str, str] = {}
    stdin: Mapping[str, str] = {}
    topics: tuple[tuple[str, ...], ...] = ()
    random: bool = False


CASES: dict[str, Case] = {
    'first_steps': Case('both.launch.py', 2.2),
    'late_server': Case('add.launch.py', 5.0),
    'pen_changer': Case('pen.launch.py', 8.0),
    'catch_them_all': Case('zoo.launch.py', 12.0, package='turtle_zoo_bringup', random=True),
    'deadlocks': Case('stuck.launch.py', 5.0),
    'goodbyes': Case('goodbye.launch.py', 10.0),
    'thread_rate': Case('threads.launch.py', 3.0),
    'groups': Case('groups.launch.py', 5.0),
    'sync_client': Case('sync.launch.py', 3.0),
    'sleepers': Case('sleep.launch.py', 4.5),
    'own_loop': Case('loop.launch.py', 6.0, topics=(('/turtle1/cmd_vel', 'linear.x', 'angular.z'),)),
    'fibonacci': Case('fib.launch.py', 6.0),
    'count_down': Case('count.launch.py', 11.0, package='count_down'),
    'tunable': Case('tunable.launch.py', 5.0),
    'yaml_params': Case('yaml.launch.py', 1.0),
    'lifecycle_talker': Case('lifecycle.launch.py', 6.0),
    'qos_zoo': Case('qos.launch.py', 2.5),
    'frames': Case('frames.launch.py', 2.5),
    'go_to_goal': Case('goal.launch.py', 10.0, arguments={'y': '8.0'}),
    'random_walk': Case('walk.launch.py', 3.5, random=True),
    'guess_game': Case('game.launch.py', 5.0, stdin={'game-2': 'Ada\n3\nx\n9\n7\n', 'menu-3': 'w\na\nx\nq\n'},
                       topics=(('/turtle1/cmd_vel', 'linear.x', 'angular.z'),)),
    'chatty': Case('chatty.launch.xml', 2.0),
    'team': Case('team.launch.py', 2.5),
    'no_classes': Case('plain.launch.py', 3.5),
    'async_nodes': Case('async.launch.py', 3.0),
    'launch_options': Case('options.launch.py', 1.5, arguments={'word': 'shout'}),
    'front_ends': Case('all.launch.xml', 1.0),
    'one_shots': Case('timers.launch.py', 6.0),
    'own_executor': Case('own.launch.py', 5.0),
    'mistakes': Case('mistakes.launch.py', 3.5),
    'arguments': Case('arguments.launch.py', 1.0),
    'reuse': Case('reuse.launch.py', 1.2),
    'discovery': Case('watch.launch.py', 2.5),
    'quitters': Case('quit.launch.py', 3.0),
}
