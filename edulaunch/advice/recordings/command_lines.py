"""Rules about command lines and lines of programs that Python and ROS 2 accept without a message, but that have no effect."""

from __future__ import annotations

import ast
import os
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from edulaunch.advice.rule import Finding, found, rule
from edulaunch.advice.run_sources import program_scripts
from edulaunch.advice.runs import fact_place

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording

FEWEST = 5
"""With at least this many one-letter words, a command line is suspicious, because programs rarely receive five of them."""
ROS_FLAGS = ('-p', '--param', '--params-file')
"""Options that need --ros-args. A remapping without it is deprecated, but ROS 2 applies it and logs how to write it."""


@rule(
    'launch.arguments-of-letters',
    what="arguments is the string '{text}', and {process} receives each letter of it as a separate word",
    why='arguments= needs a list, and Python reads a string as a list of letters',
    do='write a list: arguments=[{words}]',
    lesson='08_static_broadcaster',
    level='error',
    hides=('programs.died',),
)
def arguments_of_letters(recording: Recording) -> Iterator[Finding]:
    """Report a Node whose `arguments` are one string, as in `arguments='--x 1 --frame-id world'`."""
    for process in recording.processes:
        words = process.argv[1 : process.argv.index('--ros-args')] if '--ros-args' in process.argv else process.argv[1:]
        if process.package and len(words) >= FEWEST and all(len(word) == 1 for word in words):
            text = ''.join(words)
            entries = ', '.join(map(repr, text.split()))
            yield found('process', process.name, file=process.file, line=process.line, text=text[:80], words=entries)


@rule(
    'programs.no-ros-args',
    what="{process} receives '{flag} {value}' without --ros-args before it, so ROS 2 ignores the option",
    why='ROS 2 reads only the arguments after --ros-args, and the program reads the others',
    do='write --ros-args {flag} {value}',
    lesson='02_names',
    level='error',
    confidence='asked',
    hides=('messages.nobody-listens', 'messages.nobody-publishes', 'messages.other-topic'),
)
def no_ros_args(recording: Recording) -> Iterator[Finding]:
    """Report ROS arguments without `--ros-args` on the command line of a node."""
    with_node = {node.process for node in recording.nodes}
    for process in recording.processes:
        words = process.argv[: process.argv.index('--ros-args')] if '--ros-args' in process.argv else process.argv
        if process.name in with_node and os.path.basename(process.argv[0]) != 'ros2':
            for flag, value in zip(words[1:], words[2:], strict=False):
                if flag in ROS_FLAGS and (':=' in value or flag == '--params-file'):
                    yield found('process', process.name, file=process.file, line=process.line, flag=flag, value=value)
                    break


@rule(
    'launch.parameter-as-argument',
    what="{process} receives the word '{word}', which sets neither a parameter nor a remapping",
    why='arguments=[...] are the words of a command line, and ROS 2 reads only the words after --ros-args',
    do=('write {written} in place of arguments=[...]', 'write --ros-args -p {word} in place of {word}'),
    lesson='03_parameters',
    level='error',
    hides=('messages.nobody-listens', 'messages.nobody-publishes', 'messages.other-topic'),
)
def parameter_as_argument(recording: Recording) -> Iterator[Finding]:
    """Report a word such as `speed:=2` on the command line of a node that is not after `--ros-args`."""
    with_node = {node.process for node in recording.nodes}
    for process in recording.processes:
        words = process.argv[: process.argv.index('--ros-args')] if '--ros-args' in process.argv else process.argv
        if process.name not in with_node or os.path.basename(process.argv[0]) == 'ros2':
            continue
        for flag, word in zip(words, words[1:], strict=False):
            match = re.fullmatch(r'(/?[A-Za-z_~][\w/.~]*):=(.*)', word)
            if match is not None and flag not in (*ROS_FLAGS, '-r', '--remap'):
                is_name = '/' in match[1] or '/' in match[2]
                written = (
                    f"remappings=[('{match[1]}', '{match[2]}')]" if is_name else f"parameters=[{{'{match[1]}': {match[2]}}}]"
                )
                own = process.origin is not None and '__' not in match[1]
                facts: dict[str, Any] = {'word': word, 'written': written if own else None}
                yield found('process', process.name, file=process.file, line=process.line, **facts)
                break


@rule(
    'programs.main-misspelt',
    what="__name__ is compared with '{word}', so main() is never called and the program ends at once",
    why="Python sets __name__ to '__main__' in the file that it runs",
    do="write if __name__ == '__main__':",
    level='error',
)
def main_misspelt(recording: Recording) -> Iterator[Finding]:
    """Report a script whose test for the main program is misspelt, as in `if __name__ == 'main':`."""
    run = {os.path.basename(word) for process in recording.own_processes for word in process.argv[:2]}
    for file, tree in program_scripts(recording):
        tests = [node.test for node in tree.body if isinstance(node, ast.If) and os.path.basename(file) in run]
        for test in tests:
            match = re.fullmatch(r"__name__ == '(\w+)'", ast.unparse(test))
            if match is not None and match[1] != '__main__' and 'main' in match[1].lower():
                yield found('file', os.path.basename(file), file=file, line=test.lineno, word=match[1])


@rule(
    'programs.parameter-callback',
    what='{callback}() returned no SetParametersResult, so rclpy rejected the new value of the parameter',
    why='rclpy asks each callback that you pass to add_on_set_parameters_callback() whether a change is allowed',
    do='end {callback}() with: return SetParametersResult(successful=True)',
    lesson='03_parameters',
    level='error',
    hides=('programs.parameter-refused',),
)
def parameter_callback(recording: Recording) -> Iterator[Finding]:
    """Report a callback for changed parameters that returned None, True or False."""
    for fact in recording.facts:
        if fact.kind == 'no parameter result':
            file, line = fact_place(recording, fact)
            yield found('process', fact.process or '', file=file, line=line, callback=fact.data['callback'])


@rule(
    'messages.argument-ignored',
    what=(
        '{type}() ignored {field}=..., because {type} has no field {field}',
        '{type}() ignored {field}=..., because {type} has no fields',
    ),
    why='in ROS 2 Jazzy, the constructor of a message ignores unknown names, so the message keeps its default value',
    do=('write {near}', 'use one of its fields ({fields})', 'remove {field}=...'),
    lesson='09_broadcaster_and_listener',
    level='error',
    edits=(('{field}=', '{near}=', 'near'),),
)
def argument_ignored(recording: Recording) -> Iterator[Finding]:
    """Report a keyword argument of a message, a request or a goal that is not one of its fields."""
    for fact in recording.facts:
        if fact.kind == 'argument ignored':
            file, line = fact_place(recording, fact)
            names = ('type', 'near', 'fields')
            facts = {name: fact.data[name] or None for name in names}
            yield found('field', fact.data['field'], file=file, line=line, time_s=fact.time_s, **facts)
