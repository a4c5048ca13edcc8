"""Rules about replies that a program reads before they have arrived."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import TYPE_CHECKING

from edulaunch.advice.rule import Finding, found, rule
from edulaunch.advice.run_sources import name_of_call, program_scripts, walked

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording

FUNCTIONS = (ast.FunctionDef, ast.AsyncFunctionDef)
SENDING = ('call_async', 'send_goal_async', 'get_result_async')
WAITING = ('done', 'sleep', 'wait', 'is_set', 'add_done_callback', 'result_timeout')


@rule(
    'programs.result-before-reply',
    what='{future}.result() returns None here, because {sent}() on line {at} only sends the request',
    why='the reply arrives later, while the node spins, and this function does not wait for it',
    do=(
        'in main(), call rclpy.spin_until_future_complete(node, {future}) before this line; in a callback, write '
        '{future}.add_done_callback(self.on_answer), and read the result there'
    ),
    lesson='14_services',
    level='error',
    hides=('messages.reply-not-taken',),
)
def result_before_reply(recording: Recording) -> Iterator[Finding]:
    """Report a function that reads the result of an asynchronous call without waiting for the reply."""
    for file, tree in program_scripts(recording):
        for function in walked(tree):
            if not isinstance(function, FUNCTIONS):
                continue
            nodes = list(_own(function))
            calls = [node for node in nodes if isinstance(node, ast.Call)]
            names = {name_of_call(call) for call in calls}
            waits = any(name in WAITING or name.startswith('spin') for name in names)
            if waits or not names & {*SENDING} or any(isinstance(node, (ast.Await, ast.Yield)) for node in nodes):
                continue
            asked = [node for node in nodes if isinstance(node, ast.Assign) and name_of_call(node.value) in SENDING]
            futures = {ast.unparse(node.targets[0]): node for node in asked}
            handed = {ast.unparse(one) for call in calls for one in call.args}  # a helper may wait for such a future
            for call in calls:
                holder = (
                    ast.unparse(call.func.value) if isinstance(call.func, ast.Attribute) and call.func.attr == 'result' else ''
                )
                made = None if holder in handed else futures.get(holder)
                if made is not None and call.lineno > made.lineno:
                    sent = name_of_call(made.value)
                    yield found('variable', holder, file=file, line=call.lineno, future=holder, sent=sent, at=made.lineno)
                    return


def _own(function: ast.FunctionDef | ast.AsyncFunctionDef) -> Iterator[ast.AST]:
    """Yield the syntax nodes of a function. Skip the functions inside it, because they run later."""
    todo: list[ast.AST] = list(function.body)
    while todo:
        node = todo.pop(0)
        yield node
        if not isinstance(node, (*FUNCTIONS, ast.Lambda)):
            todo += ast.iter_child_nodes(node)
