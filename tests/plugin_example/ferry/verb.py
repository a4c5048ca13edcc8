"""The verb `edulaunch ferry`."""

import edulaunch


def ferry_arguments(parser):
    """The options of the verb."""
    parser.add_argument('--speed', type=float, default=1.0, help='in m/s (default: 1.0)')


def ferry_verb(arguments):
    """Run the world for ten simulated seconds, and return the exit code."""
    recording = edulaunch.run('ferry_world', 'ferry.launch.py', arguments={'speed': arguments.speed}, duration_s=10)
    print(f'the ferry is at {recording.messages("/position")[-1][1].data:.1f} m')
    return 0
