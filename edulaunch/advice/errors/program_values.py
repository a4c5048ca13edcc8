"""Names and values in the programs of nodes that Python itself refuses."""

from __future__ import annotations

import re
from collections.abc import Iterator

from edulaunch.advice.errors.about import speak
from edulaunch.advice.failure import Failure
from edulaunch.advice.finding import Finding
from edulaunch.advice.rule import rule

HOMES = {
    'math': 'acos asin atan2 ceil cos degrees dist exp floor hypot pi radians sin sqrt tan',
    'rclpy.node': 'Node',
    'rclpy.time': 'Time',
    'rclpy.duration': 'Duration',
    'rclpy.executors': 'ExternalShutdownException MultiThreadedExecutor SingleThreadedExecutor',
    'rclpy.callback_groups': 'MutuallyExclusiveCallbackGroup ReentrantCallbackGroup',
    'rclpy.qos': 'DurabilityPolicy HistoryPolicy QoSProfile ReliabilityPolicy qos_profile_sensor_data',
    'rclpy.action': 'ActionClient ActionServer',
    'tf2_ros': 'Buffer StaticTransformBroadcaster TransformBroadcaster TransformException TransformListener',
    'geometry_msgs.msg': 'Point Pose PoseStamped Quaternion TransformStamped Twist Vector3',
    'std_msgs.msg': 'Bool Float32 Float64 Int32 String',
    'sensor_msgs.msg': 'JointState LaserScan PointCloud2',
    'nav_msgs.msg': 'Odometry',
    'turtlesim.srv': 'Kill SetPen Spawn TeleportAbsolute TeleportRelative',
}
"""What tutorials import, by where it is. Pose is that of geometry_msgs: who wants turtlesim's sees at once which one came."""
_HOME_OF = {name: home for home, names in HOMES.items() for name in names.split()}


@rule(
    'programs.unknown-name',
    what='the name {missing} is not known here',
    do=('add the line: {line}', 'look whether it is spelled as where it is made, and whether that is inside another function'),
    level='error',
)
def unknown_name(failure: Failure) -> Iterator[Finding]:
    """A name without an import, or misspelt, in a program of a node."""
    said = re.match(r"name '(\w+)' is not defined", failure.message)
    if said is not None and failure.process is not None and failure.type == 'NameError':
        home = 'rclpy' if said[1] == 'rclpy' else _HOME_OF.get(said[1])
        line = None if home is None else 'import rclpy' if said[1] == 'rclpy' else f'from {home} import {said[1]}'
        yield speak(failure, missing=said[1], line=line)


@rule(
    'time.no-number',
    what=('{made}(...) takes its seconds by name', 'a {left} and a {right} cannot be reckoned with one another'),
    do=(
        'write {made}(seconds=...)',
        'call the {callee}: write brackets behind its name, as in now()',
        'write a Duration: now - Duration(seconds=0.5); the seconds of a Time as a number are time.nanoseconds / 1e9',
    ),
    level='error',
)
def no_number(failure: Failure) -> Iterator[Finding]:
    """`Duration(0.5)`, `now - 0.5`, `get_clock().now - Duration(...)`."""
    made = re.match(r'(Duration|Time)\.__init__\(\) takes 1 positional argument', failure.message)
    said = re.match(r"unsupported operand type\(s\) for \S+: '(\w+)' and '(\w+)'", failure.message)
    if (
        failure.process is None
        or failure.facts.get('about')
        or made is None
        and (said is None or not {'Time', 'Duration'} & set(said.groups()))
    ):
        return
    left, right = said.groups() if said is not None else (None, None)
    callee = next(iter({'method', 'function'}.intersection((left, right))), None)
    yield speak(failure, made=made[1] if made else None, left=left, right=right, callee=callee)


@rule(
    'programs.no-period',
    what='create_timer() was given one thing, and takes two',
    do='write the seconds, and then the function without brackets: self.create_timer(1.0, self.on_timer)',
    level='error',
)
def no_period(failure: Failure) -> Iterator[Finding]:
    """`create_timer(self.on_timer)`, or `create_timer(1.0)`."""
    if failure.process is not None and re.match(r'Node\.create_timer\(\) missing 1 required positional', failure.message):
        yield speak(failure)
