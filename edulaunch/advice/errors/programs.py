"""Rules about calls of `rclpy.init()`, `spin` and `shutdown` that are too early, too late, repeated, or have a wrong argument."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from linecache import getline

from edulaunch.advice.errors.about import about, report
from edulaunch.advice.rule import Failure, Finding, rule
from edulaunch.advice.run_sources import script_of

NO_INIT = about(
    'programs.no-init',
    what='rclpy is not initialized: rclpy.init() was not called before this line, or rclpy.shutdown() was called too early',
    why='nodes and spin() need the context that rclpy.init() creates',
    do='call rclpy.init() first in main(), and rclpy.shutdown() last',
    types=('NotInitializedException',),
)
AFTER_SHUTDOWN = about(
    'programs.after-shutdown',
    what='rclpy is already shut down, by rclpy.shutdown() or Ctrl-C',
    why='after the shutdown, a program cannot create or use nodes',
    do='move this line before rclpy.shutdown(), or check rclpy.ok() first',
)
SHUTDOWN_TWICE = about(
    'programs.shutdown-twice',
    what='rclpy.shutdown() fails, because it was already called, Ctrl-C was pressed, or rclpy.init() was never called',
    do='call rclpy.try_shutdown() instead',
    texts=('Context must be initialized before it can be shutdown',),
)
DESTROYED_NODE = about(
    'programs.destroyed-node',
    what="destroy_node() has already destroyed the node '{node}'",
    do='move this line before destroy_node()',
)
NO_SUPER_INIT = about(
    'programs.no-super-init',
    what='{node} is used as a node before super().__init__() has run',
    do="write super().__init__('node_name') as the first line of __init__",
)
OWN_PROPERTY = about(
    'programs.own-property',
    what='every node has an attribute {attribute}, which you cannot set',
    do='choose another name, such as self.{attribute}_',
)
OWN_NAME = about(
    'programs.own-name',
    what='{node} defines {attribute}, but rclpy uses that name in every node',
    do='choose another name, such as {attribute}_',
)
SPIN_CLASS = about(
    'programs.spin-class', what='{given} is a class, not a node', do='create a node: write {given}(), with parentheses'
)
SPIN_NO_NODE = about(
    'programs.spin-no-node', what='spin needs a node, but receives {given}', do='pass the node itself: rclpy.spin(node)'
)
NO_FUTURE = about(
    'programs.no-future',
    what='this argument must be a Future, not {given}',
    do='pass the future that client.call_async(request) returns: future = client.call_async(request)',
)
BARE_TIMEOUT = about(
    'programs.bare-timeout',
    what='the second argument is the executor, but here it is the number {value}',
    do='write the name of the argument: timeout_sec={value}',
)
NO_EXECUTOR = about(
    'programs.no-executor',
    what='this argument must be an executor, not {given}',
    do='leave it out, or create one: SingleThreadedExecutor()',
)
ENDED_EXECUTOR = about(
    'programs.ended-executor', what='this executor is already shut down', do='create a new executor: SingleThreadedExecutor()'
)
TWO_SPINNERS = about(
    'programs.two-spinners',
    what='another thread already spins this executor',
    do='use a separate executor in this thread: rclpy.spin(node, rclpy.executors.SingleThreadedExecutor())',
)
STOP_ITERATION = about(
    'programs.stop-iteration',
    what='next() found no further value, and a callback of rclpy must not raise StopIteration',
    do='write next(values, None), and check the result for None',
)
WAIT_SET = about(
    'programs.wait-set',
    what='add_to_wait_set() cannot add entities here: in the simulation, the entities of a node wake its executor automatically',
    do='leave add_to_wait_set() empty, and let is_ready() return True when there is work to do',
)
DOMAIN_ID = about(
    'programs.domain-id',
    what="the environment variable ROS_DOMAIN_ID is '{value}', which is not a number",
    do='set it to a number from 0 to 101, or unset it',
)
RUNAWAY = about(
    'programs.runaway',
    what=(
        '{blocked} waits for something outside the simulation, so no other program can run',
        'this loop never waits, so no other program can run',
    ),
    do=(
        'add a timeout to the wait, such as sock.settimeout(0.1), or leave {blocked} out where nothing answers',
        'wait in each iteration with time.sleep(), rclpy.spin_once() or rate.sleep(), or use a timer instead',
    ),
    hides=('programs.never-spun',),
)
WITH_INIT = about(
    'programs.with-init',
    what='in ROS 2 Jazzy, the result of rclpy.init() does not work in a `with` statement; later versions allow it',
    do='call rclpy.init() on a separate line',
)
WITH_ENTITY = about(
    'programs.with-entity',
    what='in ROS 2 Jazzy, a {thing} does not work in a `with` statement',
    do='create it on a separate line, and call its {ending} at the end',
)

CALLBACK_NONE = about(
    'programs.callback-none',
    what='this subscription has None as its callback',
    why='with parentheses, Python calls the function at once and passes its return value',
    do='pass the function itself, without parentheses: self.heard, not self.heard()',
)
CALLBACK_ARGUMENTS = about(
    'programs.callback-arguments',
    what=(
        "the callback of this subscription is the string '{text}', not a function",
        'the callback of this subscription has no parameter for the message',
    ),
    do=('pass the method itself, without quotes: self.{text}', 'add one parameter after self: def heard(self, msg)'),
)
NO_RESPONSE = about(
    'programs.no-response',
    what="the callback of the service '{service}' returned {returned} instead of the response",
    do='end the callback with `return response`',
)
NO_RESULT = about(
    'programs.no-result',
    what="the execute callback of the action '{action}' returned {returned} instead of a {wanted}.Result",
    do='end the callback with `return result`, where result = {wanted}.Result()',
)
EMPTY_ACTION_NAME = about(
    'programs.empty-action-name', what='the name of the action is empty', do="write a name, such as 'fibonacci'"
)
NO_SUCH_NODE = about(
    'programs.no-such-node',
    what="the node '{node}' is not running",
    do=(
        "write '{near}' as the name and '{space}' as the namespace if you mean that node",
        'start it first; `ros2 node list` prints the nodes that are running',
    ),
)
NO_TRANSITION = about(
    'programs.no-transition',
    what="the transition '{transition}' is not possible while '{node}' is {state}",
    do=('use one of these transitions: {possible}', 'create a new node, because no transition leads out of this state'),
)
LOG_NO_TEXT = about(
    'programs.log-no-text',
    what='a log message must be a string, not {given}',
    do='write str(...) around it, or an f-string: f"{{value}}"',
)
SEVERITY_NAME = about(
    'programs.severity-name', what='this severity does not exist', do='use UNSET, DEBUG, INFO, WARN, ERROR or FATAL'
)
TIMEOUT_NO_DURATION = about(
    'programs.timeout-no-duration',
    what='the timeout must be a Duration here, not {given}',
    do='write Duration(seconds=1.0), and add this line: from rclpy.duration import Duration',
)


@rule(
    'programs.forgotten-self',
    what='the method {method}() has no parameter self, but Python always passes the object',
    do='write the method as: def {method}(self)',
    level='error',
)
def forgotten_self(failure: Failure) -> Iterator[Finding]:
    """Report a method that is defined without `self`. Python before 3.10 does not name the class in the error message."""
    match = re.match(r'\w+\.(\w+)\(\) takes 0 positional arguments but \d+ (was|were) given', failure.message)
    if match is not None and failure.type == 'TypeError':
        yield report(failure, method=match[1])


@rule(
    'programs.called-too-early',
    what='{method}() was called without the argument {argument}',
    do='pass the function itself, without parentheses: self.{method}',
    level='error',
    confidence='asked',
)
def called_too_early(failure: Failure) -> Iterator[Finding]:
    """Report a callback that the program calls instead of passing it.

    An example is `create_subscription(String, 'chatter', self.heard(), 10)`.
    """
    match = re.match(r"\w+\.(\w+)\(\) missing 1 required positional argument: '(\w+)'", failure.message)
    tree = script_of(failure.file) if match is not None and failure.process is not None else None
    own = [node.name for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)] if tree is not None else []
    line = getline(failure.file or '', failure.line or 0)
    if match is not None and match[1] in own and f'.{match[1]}()' in line and not match[1].startswith('__'):
        yield report(failure, method=match[1], argument=match[2])


@rule(
    'programs.no-depth',
    what=('the queue depth must be a number or a QoSProfile, but it is a {given}', '{method}() was called without a queue depth'),
    do=(
        'write the number of messages that may wait, without quotes: {depth}',
        'add the number of messages that may wait as the last argument: 10',
    ),
    level='error',
)
def no_depth(failure: Failure) -> Iterator[Finding]:
    """Report a publisher or subscription without a queue depth, as in `create_subscription(String, 'chatter', self.heard)`."""
    match = re.match(r"Node\.(\w+)\(\) missing 1 required positional argument: 'qos_profile'", failure.message)
    other = re.match(r"Expected QoSProfile or int, but received <class '(\w+)'>", failure.message)
    if failure.process is not None and (match or other):
        yield report(failure, method=match and match[1], given=other and other[1], depth=other and 10)


@rule(
    'programs.rule-failed',
    what="the rule '{rule}' of edulaunch failed: {error}",
    do='report this bug in edulaunch, and attach your file; the other advice is not affected',
    level='info',
)
def rule_failed(failure: Failure) -> Iterator[Finding]:
    """Report nothing. The judge creates this finding when a rule of advice fails, which is never a student's mistake."""
    yield from ()


@rule(
    'programs.sign-in-name',
    what="ROS allows only letters, digits and _ in a name, but '{name}' contains '{sign}'",
    do=("write the namespace separately: namespace='{space}', name='{last}'", "write '{better}'"),
    level='error',
    lesson='02_names',
)
def sign_in_name(failure: Failure) -> Iterator[Finding]:
    """Report an invalid character in a name of a node, namespace or topic, such as a space, a minus sign or an umlaut."""
    match = re.search(r"must not contain characters other than alphanumerics.*:\n  '(.*)'\n( *)\^", failure.message)
    if match is not None:
        name, at = match[1], len(match[2]) - len("  '")
        better = re.sub(r'\{[^{}]*$|[^A-Za-z0-9_/~{}]', lambda part: '_' + re.sub(r'[^A-Za-z0-9_/~]', '', part[0]), name)
        space, slash, last = name.strip('/').rpartition('/')
        is_split = failure.message.startswith('Invalid node name') and bool(slash)
        facts = {'space': space, 'last': last} if is_split else {}
        better = better.strip('/') if failure.message.startswith('Invalid node name') else better
        yield report(failure, name=name, sign=name[at : at + 1], better=better, **facts)
