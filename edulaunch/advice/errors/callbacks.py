"""Callbacks, and what they return."""

from __future__ import annotations

import re
from collections.abc import Iterator

from edulaunch.advice.errors.about import about, speak
from edulaunch.advice.failure import Failure
from edulaunch.advice.finding import Finding
from edulaunch.advice.rule import rule

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
    said = re.match(r'\w+\.(\w+)\(\) takes 0 positional arguments but \d+ (was|were) given', failure.message)
    if said is not None and failure.type == 'TypeError':
        yield speak(failure, method=said[1])


@rule(
    'programs.called-too-early',
    what='{method}() was called without {argument}',
    do='give the function itself, without brackets: self.{method}',
    level='error',
    confidence='asked',
)
def called_too_early(failure: Failure) -> Iterator[Finding]:
    """`create_subscription(String, 'chatter', self.heard(), 10)`. ROS 2's own functions were meant to be called."""
    said = re.match(r"\w+\.(\w+)\(\) missing 1 required positional argument: '(\w+)'", failure.message)
    if said is not None and failure.process is not None and not said[1].startswith(('__', 'create_')):
        yield speak(failure, method=said[1], argument=said[2])


@rule(
    'programs.no-depth',
    what='{method}() was given no queue depth',
    do='write how many messages may wait as its last argument: 10',
    level='error',
)
def no_depth(failure: Failure) -> Iterator[Finding]:
    """`create_subscription(String, 'chatter', self.heard)`."""
    said = re.match(r"Node\.(\w+)\(\) missing 1 required positional argument: 'qos_profile'", failure.message)
    if said is not None and failure.process is not None:
        yield speak(failure, method=said[1])
