"""The corpus: which idiom each package stands for, and how it is run. Numbers are repositories of 56 (reference: api in the wild)."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple

CORPUS = Path(__file__).resolve().parents[1] / 'corpus'


class Case(NamedTuple):
    """One launch of a corpus package.

    :ivar idiom: what students do here.
    :ivar file: the launch file. `package`: of which package, when the folder holds several.
    :ivar topics: what to watch besides output: (topic, field, field ...), a line for each change.
    :ivar random: whether the seed decides what happens.
    """

    idiom: str
    file: str
    duration_s: float
    package: str | None = None
    arguments: Mapping[str, str] = {}
    stdin: Mapping[str, str] = {}
    topics: tuple[tuple[str, ...], ...] = ()
    random: bool = False


CASES: dict[str, Case] = {
    'first_steps': Case('a talker and a listener, spin, bound-method callbacks, depth 10 (54)', 'both.launch.py', 2.2),
    'late_server': Case('while not wait_for_service(1.0) in __init__ and main, the server comes late (38)', 'add.launch.py', 5.0),
    'pen_changer': Case('a client made on the spot in a subscription callback, add_done_callback (14)', 'pen.launch.py', 8.0),
    'catch_them_all': Case(
        'spawn and kill with random positions, own messages, CMake bringup, parameter file (32)',
        'zoo.launch.py',
        12.0,
        package='turtle_zoo_bringup',
        random=True,
    ),
    'deadlocks': Case('waiting in a callback for what only another callback brings (2 to 11)', 'stuck.launch.py', 5.0),
    'goodbyes': Case(
        'ways of leaving on Ctrl-C: except KeyboardInterrupt, finally, signal handlers (15)', 'goodbye.launch.py', 10.0
    ),
    'thread_rate': Case(
        'create_rate beside a spinning thread; a worker thread with queue and lock (6)', 'threads.launch.py', 3.0
    ),
    'groups': Case('MultiThreadedExecutor and callback groups: what runs at the same time (7)', 'groups.launch.py', 5.0),
    'sync_client': Case('client.call() with threads: own group, or main beside a spinning thread (2)', 'sync.launch.py', 3.0),
    'sleepers': Case(
        'time.sleep in callbacks and __init__: queues overflow, servers answer meanwhile (17)', 'sleep.launch.py', 4.5
    ),
    'own_loop': Case(
        'while rclpy.ok(): spin_once, time.time() loops that never block (15)',
        'loop.launch.py',
        6.0,
        topics=(('/turtle1/cmd_vel', 'linear.x', 'angular.z'),),
    ),
    'fibonacci': Case('action server and client, feedback, result (10)', 'fib.launch.py', 6.0),
    'count_down': Case(
        'own action: reject, cancel, abort; ReentrantCallbackGroup (8)', 'count.launch.py', 11.0, package='count_down'
    ),
    'tunable': Case('parameter callbacks, ranges, ros2 param set, wrong types (27)', 'tunable.launch.py', 5.0),
    'yaml_params': Case('parameter files: wildcards, nested names, who wins (12)', 'yaml.launch.py', 1.0),
    'lifecycle_talker': Case('a lifecycle node, steered by the launch file (1)', 'lifecycle.launch.py', 6.0),
    'qos_zoo': Case('QoSProfile objects, transient local, incompatible endpoints (4)', 'qos.launch.py', 2.5),
    'frames': Case('static and moving tf frames, lookups with timeout, spin_thread (7)', 'frames.launch.py', 2.5),
    'go_to_goal': Case(
        'a P controller to a goal from the command line, raise SystemExit to end spin (20)',
        'goal.launch.py',
        10.0,
        arguments={'y': '8.0'},
    ),
    'random_walk': Case('unseeded random and numpy.random decide (26)', 'walk.launch.py', 3.5, random=True),
    'guess_game': Case(
        'input() games, prefix xterm -e (8)',
        'game.launch.py',
        5.0,
        stdin={'game-2': 'Ada\n3\nx\n9\n7\n', 'menu-3': 'w\na\nx\nq\n'},
        topics=(('/turtle1/cmd_vel', 'linear.x', 'angular.z'),),
    ),
    'chatty': Case('logging: levels, throttle, once, skip_first, --log-level in XML args (54)', 'chatty.launch.xml', 2.0),
    'team': Case('several nodes in a program, base class in a sub-package, relative imports (25)', 'team.launch.py', 2.5),
    'no_classes': Case('create_node, globals and functions; a script that runs at import (3)', 'plain.launch.py', 3.5),
    'async_nodes': Case('async callbacks, await call_async, executor.create_task (1)', 'async.launch.py', 3.0),
    'launch_options': Case(
        'launch arguments, namespaces, remappings, conditions, includes, OpaqueFunction (35)',
        'options.launch.py',
        1.5,
        arguments={'word': 'shout'},
    ),
    'front_ends': Case('XML and YAML launch files: let, group, include, param from (13)', 'all.launch.xml', 1.0),
    'one_shots': Case(
        'timers cancelled in their own callback, made in done callbacks, reset, destroyed (44)', 'timers.launch.py', 6.0
    ),
    'own_executor': Case('an executor of ones own, exceptions out of spin (2)', 'own.launch.py', 5.0),
    'mistakes': Case('what beginners get wrong, each with its error and a line of help (all)', 'mistakes.launch.py', 3.5),
    'arguments': Case('argparse, remove_ros_args, sys.argv (9)', 'arguments.launch.py', 1.0),
    'reuse': Case('one message object published again and again, receivers that change theirs (14)', 'reuse.launch.py', 1.2),
    'discovery': Case(
        'subscriptions found while running, destroyed in their callback; graph queries (2)', 'watch.launch.py', 2.5
    ),
    'quitters': Case('rclpy.shutdown() and destroy_node() inside callbacks, init again (9)', 'quit.launch.py', 3.0),
    'sim_clock': Case('use_sim_time, /clock, Time and Duration arithmetic (19)', 'clock.launch.py', 4.0),
    'pairing': Case('message_filters: exact and approximate (1)', 'pair.launch.py', 1.1),
    'cmake_robot': Case(
        'Python in a CMake package: own interfaces, install(PROGRAMS), helper library (25)', 'robot.launch.py', 1.0
    ),
    'cli_calls': Case('ros2 service call, topic pub, action send_goal, param set in launch files (9)', 'cli.launch.py', 5.0),
    'untidy': Case(
        'a repository as it is pushed: doubles, build output, tabs, umlauts, shadowing names (14)',
        'untidy.launch.py',
        1.5,
        package='untidy_pkg',
    ),
    'lives': Case('respawn, on_exit=Shutdown, OnShutdown (1)', 'lives.launch.py', 5.0),
    'supervisor': Case('nodes that set others parameters, read /rosout and /parameter_events (2)', 'supervise.launch.py', 3.5),
    'no_spin': Case('publish and sleep without spin, wait_for_message, spin(self) in __init__ (11)', 'no_spin.launch.py', 3.5),
    'chase': Case(
        'spawn from main with spin_until_future_complete, f-string topics, kill when near (19)',
        'chase.launch.py',
        30.0,
        random=True,
    ),
    'measuring': Case('numpy in the loop, numpy scalars in messages (13)', 'measuring.launch.py', 1.0),
    'own_names': Case('self.timers and the like, mixins, dataclasses, enums (all)', 'names.launch.py', 2.0),
    'heartbeat': Case('deadlines and leases: PublisherEventCallbacks, SubscriptionEventCallbacks (4)', 'ward.launch.py', 6.5),
    'preempting': Case(
        'one action goal at a time: a new goal ends the old one; own action, cancel, refuse (8)',
        'axis.launch.py',
        8.0,
        package='axis',
    ),
    'conductor': Case('a lifecycle node steered by another node; failing and broken transitions (1)', 'concert.launch.py', 3.0),
    'tape': Case('whatever topics there are, raw; messages by name, as dictionaries and CSV (2)', 'tape.launch.py', 4.0),
    'patrol': Case(
        'waypoints from YAML in share, a state machine, client.call() in a timer of another group (7)', 'patrol.launch.py', 13.0
    ),
    'swarm': Case(
        'turtles spawned by an OpaqueFunction, a namespace for each, OnProcessExit (1)',
        'swarm.launch.py',
        4.0,
        arguments={'size': '3'},
    ),
    'battery': Case(
        'own interfaces with constants, array parameters, a panel that comes late; time measured by hand (24)',
        'battery.launch.py',
        11.0,
        package='battery_panel',
    ),
    'callables': Case(
        'callbacks of all kinds: static, private, partial, objects, lambdas, decorated (all)', 'all.launch.py', 5.0
    ),
    'vacuum': Case(
        'cmd_vel to odometry, a laser and a map as numpy arrays, sensor QoS, a shell line with && (13)',
        'vacuum.launch.py',
        6.0,
        topics=(('/cmd_vel', 'linear.x', 'angular.z'),),
    ),
    'own_parts': Case(
        'substitutions, actions and conditions of ones own; every event handler; ros2 lifecycle (1)', 'parts.launch.py', 6.0
    ),
    'fleet': Case(
        'a company: a robot for each entry of a YAML file, groups, choices, $(var) in parameter files, bounded messages (1)',
        'fleet.launch.py',
        3.0,
        package='fleet_bringup',
    ),
    'gazebo_robot': Case(
        'URDF, Gazebo, SLAM, ros2_control, OpenCV: what is not here is told, the rest goes on (4)', 'sim.launch.py', 2.5
    ),
    'nobody_there': Case(
        'requests without waiting, misspelt services, a wrong type, the wrong node spun', 'nobody.launch.py', 12.0
    ),
    'drawing': Case(
        'own action, service and messages in each other: constants, defaults, bounds; client.call() in an action (8)',
        'draw.launch.py',
        25.0,
        package='turtle_draw',
    ),
    'lab_book': Case('csv, json and pickle files written at exit; dataclasses; AsyncParameterClient (2)', 'lab.launch.py', 4.0),
    'event_loops': Case('asyncio.run around spin_once, asyncio beside an executor thread (1)', 'loops.launch.py', 3.0),
    'shell_calls': Case(
        'os.system, os.popen and subprocess with ros2 commands in a node; > /dev/null and & (3)', 'shell.launch.py', 8.0
    ),
}
