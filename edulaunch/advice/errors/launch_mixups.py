"""Rules about similar things in launch files: two classes with the name Node, and a set instead of a dictionary."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator

from edulaunch.advice.errors.about import report
from edulaunch.advice.rule import Failure, Finding, rule
from edulaunch.advice.run_sources import script_of


@rule(
    'launch.other-node',
    what=(
        'Node in this launch file is the class of {of_program}, which creates a node inside a program',
        'Node in this program is the action of {of_launch}, with which a launch file starts a program',
    ),
    why='rclpy.node and launch_ros.actions both have a class with the name Node',
    do='write: {line}',
    lesson='01_first_launch',
    level='error',
    hides=('launch.fails', 'launch.keyword', 'launch.positional', 'programs.wrong-call', 'programs.died'),
)
def other_node(failure: Failure) -> Iterator[Finding]:
    """Report a launch file that imports the Node of rclpy, and a program that imports the Node of launch_ros."""
    wrong, right = ('rclpy', 'launch_ros.actions') if failure.process is None else ('launch_ros', 'rclpy.node')
    tree = script_of(failure.file) if failure.type == 'TypeError' and 'Node.__init__()' in failure.message else None
    for node in [] if tree is None else ast.walk(tree):
        is_node = isinstance(node, ast.ImportFrom) and any(name.name == 'Node' and not name.asname for name in node.names)
        if is_node and isinstance(node, ast.ImportFrom) and (node.module or '').partition('.')[0] == wrong:
            of = {'of_program' if failure.process is None else 'of_launch': node.module}
            yield report(failure._replace(line=node.lineno), line=f'from {right} import Node', **of)
            return


@rule(
    'launch.set-for-dictionary',
    what='{given} is a set of values, because it has a comma instead of a colon, and a set has no items()',
    why='in Python, only a dictionary has pairs: each name, a colon, and its value',
    do='write {meant}',
    lesson='01_first_launch',
    level='error',
    hides=('launch.fails',),
    edits=(('{given}', '{meant}'),),
)
def set_for_dictionary(failure: Failure) -> Iterator[Finding]:
    """Report a set in place of a dictionary, as in `launch_arguments={'red', '200'}.items()`."""
    is_set = failure.process is None and failure.message == "'set' object has no attribute 'items'"
    for node in ast.walk(script_of(failure.file) or ast.Module([], [])) if is_set else ():
        value = node.value if isinstance(node, ast.Attribute) and node.attr == 'items' else None
        if isinstance(value, ast.Set) and len(value.elts) % 2 == 0:
            words = list(map(ast.unparse, value.elts))
            pairs = ', '.join(f'{name}: {one}' for name, one in zip(words[::2], words[1::2], strict=True))
            yield report(failure._replace(line=value.lineno), given=ast.unparse(value), meant=f'{{{pairs}}}')


@rule(
    'launch.opaque-no-context',
    what='{function}() has no parameter, but OpaqueFunction calls it with the context of the launch',
    why='the context has the values of the launch arguments',
    do='write def {function}(context):',
    lesson='13_large_project',
    level='error',
    hides=('launch.fails',),
)
def opaque_no_context(failure: Failure) -> Iterator[Finding]:
    """Report a function without parameters that is passed to OpaqueFunction."""
    match = re.match(r'(\w+)\(\) takes 0 positional arguments but 1 was given', failure.message)
    tree = script_of(failure.file) if match is not None and failure.process is None else None
    nodes = [] if tree is None else list(ast.walk(tree))
    passed = {
        word.value.id
        for word in nodes
        if isinstance(word, ast.keyword) and word.arg == 'function' and isinstance(word.value, ast.Name)
    }
    for node in nodes:
        if match is not None and isinstance(node, ast.FunctionDef) and node.name == match[1] and node.name in passed:
            yield report(failure._replace(line=node.lineno), function=node.name)
            return
