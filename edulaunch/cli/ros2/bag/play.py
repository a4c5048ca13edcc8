"""`ros2 bag play`: publish what a bag holds."""

from __future__ import annotations

import argparse

from edulaunch.cli.ros2 import cli_node
from edulaunch.cli.ros2.bag.player import Player
from edulaunch.cli.ros2.numbers import positive

CLOCK_HZ = 40.0


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Which messages, under which names, and how fast."""
    parser.add_argument('bag_path', help='Bag to open')
    parser.add_argument(
        '-r', '--rate', type=positive, default=1.0, help='rate at which to play back messages. Valid range > 0.0.'
    )
    parser.add_argument('--topics', nargs='+', default=None, metavar='topic', help='Space-delimited list of topics to play.')
    parser.add_argument('--exclude-topics', nargs='+', default=[], metavar='topic', help='Topics that are not played.')
    parser.add_argument('-e', '--regex', default='', help='Play only topics and services matching the regular expression.')
    parser.add_argument('-x', '--exclude-regex', default='', help='Do not play topics and services matching it.')
    parser.add_argument('-m', '--remap', nargs='+', default=[], metavar='old:=new', help='Play topics under other names.')
    parser.add_argument('-s', '--storage', metavar='ID', help='accepted; the storage is found out from the bag')
    parser.add_argument('--publish-service-requests', action='store_true', help='Send the recorded requests of services.')
    _add_times(parser)


def _add_times(parser: argparse.ArgumentParser) -> None:
    """From when to when, how often, and under which clock."""
    parser.add_argument(
        '--clock',
        type=positive,
        nargs='?',
        const=CLOCK_HZ,
        metavar='HZ',
        help=f'Publish to /clock at a rate in Hz, as the time of the simulation. (default: {CLOCK_HZ:g} when given)',
    )
    parser.add_argument(
        '--start-offset', type=float, default=0.0, help='Start the playback player this many seconds into the bag file.'
    )
    parser.add_argument('--playback-duration', type=float, default=-1.0, help='Playback duration, in seconds (default: all).')
    parser.add_argument('-l', '--loop', action='store_true', help='enables loop playback when playing a bagfile.')
    parser.add_argument('-d', '--delay', type=float, default=0.0, help='Sleep duration before play (each loop), in seconds.')
    parser.add_argument('-p', '--start-paused', action='store_true', help='Start the playback player in a paused state.')
    parser.add_argument('--disable-keyboard-controls', action='store_true', help='disables keyboard controls for playback.')
    parser.add_argument('--read-ahead-queue-size', type=int, default=1000, help='accepted; the whole bag is read first')


def main(arguments: argparse.Namespace) -> None:
    """Publish each message at its time; ends after the last one unless looping. SPACE pauses and goes on."""
    with cli_node.cli_node(name='rosbag2_player') as node:
        player = Player(node, arguments)
        player.load(arguments.bag_path)
        while player.messages and player.play_once() and arguments.loop:
            pass
