"""Which `ros2` commands there are. A command has verbs, or does its work itself (no verbs listed)."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from importlib import import_module
from typing import Any, NamedTuple

COMMANDS: dict[str, tuple[str, dict[str, str]]] = {
    'action': (
        'Various action related sub-commands',
        {
            'info': 'Print information about an action',
            'list': 'Output a list of action names',
            'send_goal': 'Send an action goal',
            'type': "Print a action's type",
        },
    ),
    'bag': (
        'Various rosbag related sub-commands',
        {
            'info': 'Print information about a bag to the screen',
            'play': 'Play back ROS data from a bag',
            'record': 'Record ROS data to a bag',
        },
    ),
    'component': (
        'Various component related sub-commands',
        {
            'list': 'Output a list of running containers and components',
            'load': 'Load a component into a container node',
            'standalone': 'Run a component into its own standalone container node',
            'types': 'Output a list of components registered in the ament index',
            'unload': 'Unload a component from a container node',
        },
    ),
    'daemon': (
        'Various daemon related sub-commands',
        {
            'start': "Start the daemon if it isn't running",
            'status': 'Output the status of the daemon',
            'stop': 'Stop the daemon if it is running',
        },
    ),
    'doctor': ('Check ROS setup and other potential issues', {}),
    'interface': (
        'Show information about ROS interfaces',
        {
            'list': 'List all interface types available',
            'package': 'Output a list of available interface types within one package',
            'packages': 'Output a list of packages that provide interfaces',
            'proto': 'Output an interface prototype',
            'show': 'Output the interface definition',
        },
    ),
    'launch': ('Run a launch file', {}),
    'lifecycle': (
        'Various lifecycle related sub-commands',
        {
            'get': 'Get lifecycle state for one or more nodes',
            'list': 'Output a list of available transitions',
            'nodes': 'Output a list of nodes with lifecycle',
            'set': 'Trigger lifecycle state transition',
        },
    ),
    'multicast': (
        'Various multicast related sub-commands',
        {'receive': 'Receive a single UDP multicast packet', 'send': 'Send a single UDP multicast packet'},
    ),
    'node': (
        'Various node related sub-commands',
        {'info': 'Output information about a node', 'list': 'Output a list of available nodes'},
    ),
    'param': (
        'Various param related sub-commands',
        {
            'delete': 'Delete parameter',
            'describe': 'Show descriptive information about declared parameters',
            'dump': 'Show all of the parameters of a node in a YAML file format',
            'get': 'Get parameter',
            'list': 'Output a list of available parameters',
            'load': 'Load parameter file for a node',
            'set': 'Set parameter',
        },
    ),
    'pkg': (
        'Various package related sub-commands',
        {
            'create': 'Create a new ROS 2 package',
            'executables': 'Output a list of package specific executables',
            'list': 'Output a list of available packages',
            'prefix': 'Output the prefix path of a package',
            'xml': 'Output the XML of the package manifest or a specific tag',
        },
    ),
    'run': ('Run a package specific executable', {}),
    'service': (
        'Various service related sub-commands',
        {
            'call': 'Call a service',
            'echo': 'Echo a service',
            'find': 'Output a list of available services of a given type',
            'info': 'Print information about a service',
            'list': 'Output a list of available services',
            'type': "Output a service's type",
        },
    ),
    'topic': (
        'Various topic related sub-commands',
        {
            'bw': 'Display bandwidth used by topic',
            'delay': 'Display delay of topic from timestamp in header',
            'echo': 'Output messages from a topic',
            'find': 'Output a list of available topics of a given type',
            'hz': 'Print the average publishing rate to screen',
            'info': 'Print information about a topic',
            'list': 'Output a list of available topics',
            'pub': 'Publish a message to a topic',
            'type': "Print a topic's type",
        },
    ),
    'wtf': ('Use `wtf` as alias to `doctor`', {}),
}
MODULES = {
    'action send_goal': 'action_send_goal',
    'service call': 'service_call',
    'service echo': 'service_echo',
    'topic bw': 'topic_measuring',
    'topic delay': 'topic_measuring',
    'topic echo': 'topic_echo',
    'topic hz': 'topic_measuring',
    'topic pub': 'topic_pub',
    'bag info': 'bag.info',
    'bag play': 'bag.play',
    'bag record': 'bag.record',
    'wtf': 'doctor',
}
"""Verbs that have a file beside that of their command, and commands that have another name."""
NOT_HERE = {
    'control': 'ros2_control is not here',
    'plugin': 'plugins are C++ libraries, which cannot run here',
    'security': 'a simulated machine has no network to protect',
    'trace': 'every run is recorded: see `edulaunch recording`',
}
"""Commands that ROS 2 has on many machines, and why they are not here."""


class Verb(NamedTuple):
    """What a verb (or a command without verbs) takes, and what it does."""

    add_arguments: Callable[[argparse.ArgumentParser], None]
    main: Callable[[argparse.Namespace], Any]


def load(command: str, verb: str | None) -> Verb:
    """The functions `VERB_arguments` and `VERB_verb` of the command's file; of a file for one verb, or for verbs that differ in
    nothing else, `add_arguments` and `main`.
    """
    home = MODULES.get(f'{command} {verb}') or MODULES.get(command, command)
    names = vars(import_module(f'edulaunch.cli.ros2.{home}'))
    return Verb(names.get(f'{verb}_arguments') or names['add_arguments'], names.get(f'{verb}_verb') or names['main'])
