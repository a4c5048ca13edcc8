"""Rules about wrong classes, fields and values of messages, services and actions, and about undefined names in programs of
nodes.
"""

from __future__ import annotations

import ast
import linecache
import re
from collections.abc import Iterator
from typing import Any

from edulaunch.advice.errors.about import about, report
from edulaunch.advice.rule import Failure, Finding, found, rule
from edulaunch.advice.run_sources import script_of
from edulaunch.engine.nearest import nearest_spelling


@rule(
    'messages.field',
    what=('{type} has no field {field}; its fields are {fields}', '{type} has no field {field}, because it has no fields at all'),
    do=(
        'pass the whole stamped message, which has a header, to {transform}()',
        'write {clock}.now().to_msg(), because this message has no time of its own',
        'write {near}',
        'use one of its fields; `ros2 interface show` prints them',
        'remove this field',
    ),
    level='error',
    edits=(('.{field}', '.{near}', 'near'),),
)
def field(failure: Failure) -> Iterator[Finding]:
    """Report a field that a message does not have.

    If `do_transform_point()` raises the error, the caller has passed only a part of the message.
    """
    if failure.facts.get('about') == 'messages.field':
        called = re.search(r'\b(do_transform_\w+)\(', linecache.getline(failure.file or '', failure.line or 0))
        is_feedback = str(failure.facts.get('type')).endswith('_FeedbackMessage')
        inner = {'near': f'feedback.{failure.facts.get("field")}'} if is_feedback else {}
        is_stamp = failure.facts.get('field') == 'header' and '.header.stamp' in linecache.getline(
            failure.file or '', failure.line or 0
        )
        clock = 'self.get_clock()' if is_stamp else None
        yield report(failure, transform=called[1] if called else None, clock=clock, **inner)


FIELD_VALUE = about(
    'messages.field-value',
    what=(
        'the field {field} needs {size} values, but you set {count}',
        'the value {value} of the field {field} is out of range',
        'the field {field} is of type {wanted}, but the value is of type {given}',
    ),
    do=(
        'write {write}',
        'convert it to a message with self.get_clock().now().{convert}()',
        'set its fields ({fields}), or assign a {wanted}(...)',
        'assign {size} values',
        'write a decimal point, because the comma splits the number into {commas} values',
        'replace {value} with a value in the range of the field; `ros2 interface show` prints its type',
        'assign a value of type {wanted}',
    ),
)
CONSTANT = about(
    'messages.constant',
    what='{constant} is a constant of {type}, so you cannot set it',
    do='store the value in a variable of your program',
)
NO_INTERFACE = about(
    'messages.no-interface',
    what='{module} has no interface {interface}',
    do=('import it from {homes}', 'write {near}', 'use one of the interfaces that `ros2 interface package` lists'),
    edits=(('{interface}', '{near}', 'near'),),
)
CLASS_GIVEN = about(
    'messages.class-given', what='{wanted} is a class, but an object is needed here', do='write {wanted}(), with parentheses'
)
OTHER_CLASS = about(
    'messages.other-class',
    what='an object of class {wanted} is needed here, not of class {given}',
    do=('create an object with {wanted}(), and set its fields'),
)
OTHER_BYTES = about(
    'messages.other-bytes',
    what='these bytes are not a valid {wanted}: {reason}',
    do='deserialize the bytes with the class that serialized them',
)
TWO_TYPES = about(
    'messages.two-types',
    what=(
        "{node} in this program already uses the {end} '{used_name}' with the type {used}, so the type {wanted} is not possible"
    ),
    do='use the same type for both, or a different name',
)
QOS_OVERRIDE = about(
    'messages.qos-override', what="'{value}' is not a value of the QoS policy {policy}", do='use one of these values: {allowed}'
)

_SAID = re.compile(r"Expected <class '(?P<module>[\w.]+)\.(?P<wanted>\w+)'>, got <class '(?:[\w.]+\.)?(?P<got>\w+)'>")


@rule(
    'messages.published-no-message',
    what=(
        'publish() was called with the class {klass}, because the parentheses after {klass} are missing',
        'publish() was called with a {got}, but this publisher sends {wanted} messages',
    ),
    why='all messages of a topic have the same type, and Python does not convert a {got} to a message',
    do=(
        'write {klass}() with parentheses, which creates a message',
        'create a message with msg = {wanted}(), set its fields, and call publisher.publish(msg)',
    ),
    level='error',
)
def published_no_message(failure: Failure) -> Iterator[Finding]:
    """Report an object of a wrong class that is passed to publish(). The TypeError of rclpy names both classes."""
    match = _SAID.search(failure.message) if failure.type == 'TypeError' else None
    if match is not None:
        place: dict[str, Any] = {'file': failure.file, 'line': failure.line, 'time_s': failure.time_s}
        groups: dict[str, Any] = match.groupdict()
        klass = match['wanted'] if match['got'] == 'ConstantsStay' else None  # the class of every message class
        yield found('process', failure.process or '', **place, klass=klass, **groups)


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
"""Names that tutorials import, by module. `Pose` is the one of geometry_msgs: users of turtlesim's notice the difference."""
_HOME_OF = {name: home for home, names in HOMES.items() for name in names.split()}


def _class_with(file: str | None, method: str) -> ast.ClassDef | None:
    """Return the last class in a program that defines a method with this name, or None."""
    classes = [node for node in ast.walk(script_of(file) or ast.Module([], [])) if isinstance(node, ast.ClassDef)]
    with_method = [one for one in classes if any(isinstance(node, ast.FunctionDef) and node.name == method for node in one.body)]
    return with_method[-1] if with_method else None


@rule(
    'programs.unknown-name',
    what='the name {missing} is not defined',
    do=(
        'add this line: {line}',
        'move `def {inner}` to the left margin, because its indentation makes it a method of the class {klass}',
        'write self.{method}: it is a method of the class',
        'check the spelling of the name, and whether its definition is inside another function',
    ),
    level='error',
    edits=(('', '{line}', 'import'), ('{missing}', '{near_bound}')),
)
def unknown_name(failure: Failure) -> Iterator[Finding]:
    """Report an undefined name in a node's program that is misspelt or has no import."""
    match = re.match(r"name '(\w+)' is not defined", failure.message)
    if match is not None and failure.process is not None and failure.type == 'NameError':
        home = 'rclpy' if match[1] == 'rclpy' else _HOME_OF.get(match[1])
        line = None if home is None else 'import rclpy' if match[1] == 'rclpy' else f'from {home} import {match[1]}'
        klass = None if line else _class_with(failure.file, match[1])
        is_inside = klass is not None and klass.lineno <= (failure.line or 0) <= (klass.end_lineno or 0)
        method = match[1] if klass is not None and is_inside else None
        inner, name = (match[1], klass.name) if klass is not None and not is_inside else (None, None)
        near_bound = None if line or klass else nearest_spelling(match[1], failure.facts.get('bound') or ())
        yield report(failure, missing=match[1], line=line, method=method, inner=inner, klass=name, near_bound=near_bound)


@rule(
    'time.no-number',
    what=('{made}(...) needs its seconds as a named argument', 'Python cannot add, subtract or compare a {left} and a {right}'),
    do=(
        'write {made}(seconds=...)',
        'call {callee}: write parentheses after its name, as in now()',
        'write a Duration in place of {number}: Duration(seconds={number})',
        'write a Duration, as in now - Duration(seconds=0.5); time.nanoseconds / 1e9 is a Time in seconds',
    ),
    level='error',
)
def no_number(failure: Failure) -> Iterator[Finding]:
    """Report arithmetic with a plain number where rclpy expects a Duration or Time, as in `now - 0.5`."""
    made = re.match(r'(Duration|Time)\.__init__\(\) takes 1 positional argument', failure.message)
    match = re.match(
        r"(?:unsupported operand type\(s\) for \S+:|'[<>]=?' not supported between instances of) '(\w+)' and '(\w+)'",
        failure.message,
    )
    if (
        failure.process is None
        or failure.facts.get('about')
        or made is None
        and (match is None or not {'Time', 'Duration'} & set(match.groups()))
    ):
        return
    left, right = match.groups() if match is not None else (None, None)
    callee = next(iter({'method', 'function'}.intersection((left, right))), None)
    number = (
        re.search(r'[<>]=?\s*(\d[\d.]*)', linecache.getline(failure.file or '', failure.line or 0))
        if left == 'Duration'
        else None
    )
    facts = {'made': made and made[1], 'left': left, 'right': right, 'callee': callee, 'number': number and number[1]}
    yield report(failure, **facts)


@rule(
    'programs.no-period',
    what='create_timer() needs a period and a function, but it received only one argument',
    do='pass the period in seconds, and then the function without parentheses: self.create_timer(1.0, self.on_timer)',
    level='error',
)
def no_period(failure: Failure) -> Iterator[Finding]:
    """Report a timer without a period or without a callback."""
    if failure.process is not None and re.match(r'Node\.create_timer\(\) missing 1 required positional', failure.message):
        yield report(failure)
