"""Classes and fields of messages, services and actions; names and values in the programs of nodes that Python itself refuses."""

from __future__ import annotations

import re
from collections.abc import Iterator

from edulaunch.advice.errors.about import about, report
from edulaunch.advice.rule import Failure, Finding, found, rule
from edulaunch.engine.nearest import nearest_spelling

FIELD = about(
    'messages.field',
    what=('a {type} has no field {field}; its fields are: {fields}', 'a {type} has no field {field}; it has no fields at all'),
    do=('write {near}', 'choose one of its fields; `ros2 interface show` shows them', 'take this out'),
    edits=(('.{field}', '.{near}', 'near'),),
)
FIELD_VALUE = about(
    'messages.field-value',
    what=(
        'the field {field} takes {size} values, and was given {count}',
        'the field {field} was given {value}, which is outside its range',
        'the field {field} is of type {wanted}, and was given {given}',
    ),
    do=(
        'write {write}',
        'turn it into a message: self.get_clock().now().{convert}()',
        'set its fields ({fields}), or assign a {wanted}(...)',
        'give it {size} values',
        'write a decimal point: the comma made {commas} values of it',
        'give it a value inside its range in place of {value}; `ros2 interface show` shows its type',
        'give it a {wanted}',
    ),
)
CONSTANT = about(
    'messages.constant',
    what='{constant} is a constant of {type}, which cannot be set',
    do='give a variable of your own another value',
)
NO_INTERFACE = about(
    'messages.no-interface',
    what='{module} has no {interface}',
    do=('import it from {homes}', 'write {near}', 'choose another one: `ros2 interface package` lists them'),
    edits=(('{interface}', '{near}', 'near'),),
)
CLASS_GIVEN = about(
    'messages.class-given', what='{wanted} is a class; an object of it is needed', do='write {wanted}(), with its brackets'
)
OTHER_CLASS = about(
    'messages.other-class', what='an object of {wanted} is needed, not of {given}', do='make one: {wanted}(), and set its fields'
)
OTHER_BYTES = about(
    'messages.other-bytes',
    what='these bytes are no {wanted}: {reason}',
    do='read them with the class that they were written with',
)
TWO_TYPES = about(
    'messages.two-types',
    what="{node} of this program uses the {end} '{used_name}' with {used}, so {wanted} cannot go there",
    do='use one type for it, or another name',
)
QOS_OVERRIDE = about(
    'messages.qos-override', what="'{value}' is no value of the QoS policy {policy}", do='choose one of: {allowed}'
)

_SAID = re.compile(r"Expected <class '(?P<module>[\w.]+)\.(?P<wanted>\w+)'>, got <class '(?:[\w.]+\.)?(?P<got>\w+)'>")


@rule(
    'messages.published-no-message',
    what='publish() was given a {got}, but this publisher sends {wanted} messages',
    why='a topic carries messages of one type; Python does not turn a {got} into one',
    do='make a message, set its fields, and publish that: msg = {wanted}(), then publisher.publish(msg)',
    level='error',
)
def published_no_message(failure: Failure) -> Iterator[Finding]:
    """rclpy's own TypeError names both classes."""
    match = _SAID.search(failure.message) if failure.type == 'TypeError' else None
    if match is not None:
        yield found(
            'process', failure.process or '', file=failure.file, line=failure.line, time_s=failure.time_s, **match.groupdict()
        )


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
    edits=(('', '{line}', 'import'), ('{missing}', '{near_bound}')),
)
def unknown_name(failure: Failure) -> Iterator[Finding]:
    """A name without an import, or misspelt, in a program of a node."""
    match = re.match(r"name '(\w+)' is not defined", failure.message)
    if match is not None and failure.process is not None and failure.type == 'NameError':
        home = 'rclpy' if match[1] == 'rclpy' else _HOME_OF.get(match[1])
        line = None if home is None else 'import rclpy' if match[1] == 'rclpy' else f'from {home} import {match[1]}'
        near_bound = None if line else nearest_spelling(match[1], failure.facts.get('bound') or ())
        yield report(failure, missing=match[1], line=line, near_bound=near_bound)


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
    match = re.match(r"unsupported operand type\(s\) for \S+: '(\w+)' and '(\w+)'", failure.message)
    if (
        failure.process is None
        or failure.facts.get('about')
        or made is None
        and (match is None or not {'Time', 'Duration'} & set(match.groups()))
    ):
        return
    left, right = match.groups() if match is not None else (None, None)
    callee = next(iter({'method', 'function'}.intersection((left, right))), None)
    yield report(failure, made=made[1] if made else None, left=left, right=right, callee=callee)


@rule(
    'programs.no-period',
    what='create_timer() was given one thing, and takes two',
    do='write the seconds, and then the function without brackets: self.create_timer(1.0, self.on_timer)',
    level='error',
)
def no_period(failure: Failure) -> Iterator[Finding]:
    """`create_timer(self.on_timer)`, or `create_timer(1.0)`."""
    if failure.process is not None and re.match(r'Node\.create_timer\(\) missing 1 required positional', failure.message):
        yield report(failure)
