"""`rclpy.init()`, `spin` and `shutdown`: too early, too late, twice, or with the wrong thing; callbacks, and what they return."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator

from edulaunch.advice.errors.about import about, report
from edulaunch.advice.rule import Failure, Finding, rule
from edulaunch.advice.run_sources import script_of

NO_INIT = about(
    'programs.no-init',
    what='ROS 2 does not run here: rclpy.init() was not called before this, or rclpy.shutdown() was',
    why='nodes and spin() need the context that rclpy.init() makes',
    do='call rclpy.init() first in main(), and rclpy.shutdown() last',
    types=('NotInitializedException',),
)
AFTER_SHUTDOWN = about(
    'programs.after-shutdown',
    what='ROS 2 has been shut down already (by rclpy.shutdown() or Ctrl-C)',
    why='after that no node can be made or used',
    do='move this line before rclpy.shutdown(), or ask rclpy.ok() first',
)
SHUTDOWN_TWICE = about(
    'programs.shutdown-twice',
    what='rclpy.shutdown() has nothing to shut down: it was called before, or Ctrl-C came, or rclpy.init() never ran',
    do='call rclpy.try_shutdown() instead',
    texts=('Context must be initialized before it can be shutdown',),
)
DESTROYED_NODE = about(
    'programs.destroyed-node',
    what="node '{node}' was destroyed before, by destroy_node()",
    do='move this line before destroy_node()',
)
NO_SUPER_INIT = about(
    'programs.no-super-init',
    what='{node} is used as a node before it is one: super().__init__() has not run',
    do="write super().__init__('node_name') as the first line of __init__",
)
OWN_PROPERTY = about(
    'programs.own-property',
    what='every node has its own {attribute}, which cannot be set',
    do='choose another name, such as self.{attribute}_',
)
OWN_NAME = about(
    'programs.own-name',
    what='{node} calls something of its own {attribute}, a name under which rclpy needs something else of every node',
    do='choose another name, such as {attribute}_',
)
SPIN_CLASS = about(
    'programs.spin-class', what='{given} is a class, not a node', do='make a node of it: {given}(), with its brackets'
)
SPIN_NO_NODE = about(
    'programs.spin-no-node', what='a node is needed here, not a {given}', do='give the node itself: rclpy.spin(node)'
)
NO_FUTURE = about(
    'programs.no-future',
    what='a future is needed here, not a {given}',
    do='give what client.call_async(request) returns: future = client.call_async(request)',
)
BARE_TIMEOUT = about(
    'programs.bare-timeout',
    what='the number {value} stands where an executor is expected',
    do='write the name of the argument: timeout_sec={value}',
)
NO_EXECUTOR = about(
    'programs.no-executor',
    what='an executor is needed here, not a {given}',
    do='leave it out, or make one: SingleThreadedExecutor()',
)
ENDED_EXECUTOR = about(
    'programs.ended-executor', what='this executor was shut down', do='make a new one: SingleThreadedExecutor()'
)
TWO_SPINNERS = about(
    'programs.two-spinners',
    what='another thread spins this executor already',
    do='give this thread its own: rclpy.spin(node, rclpy.executors.SingleThreadedExecutor())',
)
STOP_ITERATION = about(
    'programs.stop-iteration',
    what='next() found nothing more, and rclpy lets no StopIteration out of a callback',
    do='write next(values, None), and look whether it is None',
)
WAIT_SET = about(
    'programs.wait-set',
    what='the entities of a node wake its executor by themselves here',
    do='leave add_to_wait_set() empty and let is_ready() return True when there is something to do',
)
DOMAIN_ID = about(
    'programs.domain-id',
    what="the environment variable ROS_DOMAIN_ID is '{value}', which is no number",
    do='set it to a number from 0 to 101, or unset it',
)
RUNAWAY = about(
    'programs.runaway',
    what='a loop goes on and on and never waits, so nobody else gets a turn',
    do='let it wait in each round: time.sleep(), rclpy.spin_once(), rate.sleep(); or make a timer of it',
    hides=('programs.never-spun',),
)
WITH_INIT = about(
    'programs.with-init',
    what='in ROS 2 Jazzy rclpy.init() gives nothing for `with`; later versions do',
    do='call rclpy.init() on a line of its own',
)
WITH_ENTITY = about(
    'programs.with-entity',
    what='in ROS 2 Jazzy a {thing} is not for `with`',
    do='make it on a line of its own, and call its {ending} at the end',
)

CALLBACK_NONE = about(
    'programs.callback-none',
    what='the callback of a subscription is None',
    why='with brackets the function is called at once, and what it returns is given',
    do='give the function itself, without brackets: self.heard, not self.heard()',
)
CALLBACK_ARGUMENTS = about(
    'programs.callback-arguments',
    what='the callback of a subscription does not take the message',
    do='write it with one argument beside self: def heard(self, msg)',
)
NO_RESPONSE = about(
    'programs.no-response',
    what="the callback of service '{service}' returned {returned}, not the response",
    do='end it with `return response`',
)
NO_RESULT = about(
    'programs.no-result',
    what="the execute callback of action '{action}' returned {returned}, not a {wanted}.Result",
    do='end it with `return result`, where result = {wanted}.Result()',
)
EMPTY_ACTION_NAME = about(
    'programs.empty-action-name', what='the name of the action is empty', do="give it a name, such as 'fibonacci'"
)
NO_SUCH_NODE = about(
    'programs.no-such-node',
    what="no node '{node}' is running",
    do=("write '{near}', if that is the node you mean", 'start it first; `ros2 node list` shows who is there'),
)
NO_TRANSITION = about(
    'programs.no-transition',
    what="node '{node}' is {state}, and this transition does not start there",
    do=('choose one of: {possible}', 'make a new node: nothing leads out of this state'),
)
LOG_NO_TEXT = about(
    'programs.log-no-text',
    what='a log message must be a text, not a {given}',
    do='write str(...) around it, or an f-string: f"{{value}}"',
)
SEVERITY_NAME = about(
    'programs.severity-name', what='there is no severity of this name', do='choose UNSET, DEBUG, INFO, WARN, ERROR or FATAL'
)
TIMEOUT_NO_DURATION = about(
    'programs.timeout-no-duration',
    what='the timeout is a Duration here, not a {given}',
    do='write Duration(seconds=1.0), after: from rclpy.duration import Duration',
)


@rule(
    'programs.forgotten-self',
    what='the method {method}() has no argument self, and Python always hands it the object',
    do='write it as: def {method}(self)',
    level='error',
)
def forgotten_self(failure: Failure) -> Iterator[Finding]:
    """A method of a class without any argument. Python before 3.10 does not name the class."""
    match = re.match(r'\w+\.(\w+)\(\) takes 0 positional arguments but \d+ (was|were) given', failure.message)
    if match is not None and failure.type == 'TypeError':
        yield report(failure, method=match[1])


@rule(
    'programs.called-too-early',
    what='{method}() was called without {argument}',
    do='give the function itself, without brackets: self.{method}',
    level='error',
    confidence='asked',
)
def called_too_early(failure: Failure) -> Iterator[Finding]:
    """`create_subscription(String, 'chatter', self.heard(), 10)`: a method of the student's own."""
    match = re.match(r"\w+\.(\w+)\(\) missing 1 required positional argument: '(\w+)'", failure.message)
    tree = script_of(failure.file) if match is not None and failure.process is not None else None
    own = [node.name for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)] if tree is not None else []
    if match is not None and match[1] in own and not match[1].startswith('__'):
        yield report(failure, method=match[1], argument=match[2])


@rule(
    'programs.no-depth',
    what='{method}() was given no queue depth',
    do='write how many messages may wait as its last argument: 10',
    level='error',
)
def no_depth(failure: Failure) -> Iterator[Finding]:
    """`create_subscription(String, 'chatter', self.heard)`."""
    match = re.match(r"Node\.(\w+)\(\) missing 1 required positional argument: 'qos_profile'", failure.message)
    if match is not None and failure.process is not None:
        yield report(failure, method=match[1])


@rule(
    'programs.rule-failed',
    what="a rule of edulaunch, '{rule}', could not look at this: {error}",
    do='tell the makers of edulaunch, with your file: it is their mistake, and the rest of the advice holds',
    level='info',
)
def rule_failed(failure: Failure) -> Iterator[Finding]:
    """Nothing that a student writes looks like this."""
    yield from ()


@rule(
    'programs.sign-in-name',
    what="names of ROS have letters, digits and _ only, and '{name}' has '{sign}'",
    do="write '{better}'",
    level='error',
    lesson='02_names',
)
def sign_in_name(failure: Failure) -> Iterator[Finding]:
    """A blank, a minus or a letter with an accent in the name of a node, namespace or topic."""
    match = re.search(r"must not contain characters other than alphanumerics.*:\n  '(.*)'\n( *)\^", failure.message)
    if match is not None:
        name, at = match[1], len(match[2]) - len("  '")
        better = re.sub(r'\{[^{}]*$|[^A-Za-z0-9_/~{}]', lambda part: '_' + re.sub(r'[^A-Za-z0-9_/~]', '', part[0]), name)
        yield report(failure, name=name, sign=name[at : at + 1], better=better)
