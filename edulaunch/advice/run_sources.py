"""The student's own Python files in a run: the launch files and the programs. They are parsed, but never executed."""

from __future__ import annotations

import ast
import io
import os
import re
import tokenize
from collections.abc import Iterator
from functools import lru_cache
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording

Script = tuple[str, ast.Module]
LONGEST = 400_000
"""The maximum size, in bytes, of a file that is parsed. Files written by hand are smaller."""
SIDE_BY_SIDE = re.compile(r"""[\w/]['"]{1,3}[ \t]*[A-Za-z]{0,2}['"]{1,3}[\w/]""")
"""Matches a string literal that ends like a name, followed by a literal that starts like a name."""


def launch_scripts(recording: Recording) -> list[Script]:
    """Return the Python launch files of a run with their syntax trees. The file that the user launched comes first."""
    return list(_scripts([*launch_files(recording), *(process.file or '' for process in recording.processes)]))


def launch_files(recording: Recording) -> list[str]:
    """Return the launch file of a run and the files that it includes, and the launch files of each `ros2 launch` of the
    command.
    """
    launch, own = recording.launch, recording.command
    typed = [fact for fact in recording.facts if fact.kind == 'launch files' and (own is None or fact.process in own)]
    return [launch.file, *launch.includes, *(file for fact in typed for file in fact.data['files'])]


def program_scripts(recording: Recording) -> list[Script]:
    """Return the programs of a run, and the modules that created their endpoints, with their syntax trees."""
    words = [word for process in recording.own_processes for word in process.argv[:2]]
    return list(_scripts([*words, *(file for file, _ in recording.lines.values())]))


def script_of(file: str | None) -> ast.Module | None:
    """Return the syntax tree of one file, or None if the file is not a readable Python file of a student."""
    return next((tree for _, tree in _scripts([file or ''])), None)


def _scripts(files: list[str]) -> Iterator[Script]:
    from edulaunch.engine.underlay_place import is_students

    for file in dict.fromkeys(files):
        if file.endswith('.py') and is_students(file):
            try:
                state = os.stat(file)
            except OSError:
                continue
            tree = _parsed(file, state.st_mtime_ns, state.st_size)
            if tree is not None:
                yield file, tree


@lru_cache(maxsize=256)
def _parsed(file: str, changed_ns: int, size: int) -> ast.Module | None:
    """Return the syntax tree of a file, or None. The result is cached for each modification time and size."""
    from edulaunch.ros.sources.source_package import parsed

    return parsed(file) if os.path.isfile(file) and size <= LONGEST else None


@lru_cache(maxsize=256)
def walked(tree: ast.Module) -> tuple[ast.AST, ...]:
    """Return all syntax nodes of a file in the order of `ast.walk`. The result is cached, because all rules need it."""
    return tuple(ast.walk(tree))


def joined_strings(file: str) -> Iterator[tuple[str, str, int]]:
    """Yield two adjacent string literals of one line, which Python joins to one string, and the number of the line."""
    try:
        with open(file, encoding='utf-8') as opened:
            code = opened.read()
        if not SIDE_BY_SIDE.search(code):  # reading the tokens of a file takes 20 times longer
            return
        tokens = list(tokenize.generate_tokens(io.StringIO(code).readline))
    except (OSError, UnicodeDecodeError, SyntaxError, tokenize.TokenError):
        return
    for one, other in zip(tokens, tokens[1:], strict=False):
        if one.type == other.type == tokenize.STRING and one.end[0] == other.start[0]:
            try:
                first, second = ast.literal_eval(one.string), ast.literal_eval(other.string)
            except (SyntaxError, ValueError):
                continue
            if isinstance(first, str) and isinstance(second, str):
                yield first, second, one.start[0]


def name_of_call(node: ast.AST) -> str:
    """Return the last part of a called function's name, such as 'Node' for `launch_ros.actions.Node(...)`.

    Return an empty string for any other syntax.
    """
    if not isinstance(node, ast.Call):
        return ''
    function = node.func
    return function.id if isinstance(function, ast.Name) else function.attr if isinstance(function, ast.Attribute) else ''


def keyword_of(call: ast.Call, name: str) -> ast.expr | None:
    """Return the value of a keyword argument of a call, or None if the call does not have this argument."""
    return next((keyword.value for keyword in call.keywords if keyword.arg == name), None)
