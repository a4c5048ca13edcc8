"""Predict errors of launch in Python launch files from the syntax tree. No code of the file is executed."""

from __future__ import annotations

import ast
import io
import tokenize
from collections.abc import Iterator
from typing import Any

from edulaunch.advice.launch_names import class_named, keywords_of
from edulaunch.advice.rule import Failure, Finding, found
from edulaunch.advice.run_sources import keyword_of
from edulaunch.advice.texts.around import Around
from edulaunch.advice.texts.bound_names import (
    OF_LAUNCH,
    full_name,
    imported,
    inside_quotes,
    launch_imports,
    text_of,
    unknown_names,
)
from edulaunch.advice.texts.edits import inserted
from edulaunch.advice.texts.syntax import Foreseen
from edulaunch.advice.texts.text import Span, Text
from edulaunch.engine.nearest import nearest, nearest_spelling

GENERATE, TEST = 'generate_launch_description', 'generate_test_description'
NODES = ('ComposableNode', 'LifecycleNode', 'Node')
SHARES = ('FindPackageShare', 'FindPackagePrefix', 'get_package_share_directory', 'get_package_prefix', 'get_package_share_path')
DECLARING = ('DeclareLaunchArgument', 'SetLaunchConfiguration')


def foreseen_in_launch(text: Text, tree: ast.Module, around: Around) -> Iterator[Foreseen]:
    """Yield the errors that launch would raise, in any order."""
    yield from launch_imports(text, tree)
    yield from unknown_names(text, tree)
    yield from _entry(text, tree)
    names = imported(tree)
    calls = [node for node in ast.walk(tree) if isinstance(node, ast.Call)]
    declared = _declared(calls, names)
    for call in calls:
        yield from _of_call(text, call, names, around)
        yield from _configuration(text, call, names, declared)


def _entry(text: Text, tree: ast.Module) -> Iterator[Foreseen]:
    """Yield errors about generate_launch_description(), which every launch file needs, and about its return value."""
    functions = {node.name: node for node in tree.body if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef))}
    others = {
        name.id for node in tree.body for name in ast.walk(node) if isinstance(name, ast.Name) and isinstance(name.ctx, ast.Store)
    }
    others |= {alias.asname or alias.name for node in tree.body if isinstance(node, ast.ImportFrom) for alias in node.names}
    if not tree.body or TEST in functions or not text.path.endswith('launch.py') or '*' in others:
        return
    if GENERATE not in functions and GENERATE not in others:
        near = nearest(GENERATE, functions)
        line = functions[near].lineno if near else 1
        message = f"launch file at '{text.path}' does not contain the required function '{GENERATE}()'"
        span = text.found(near, text.whole_line(line)) if near else None
        yield Foreseen(
            Failure('InvalidPythonLaunchFileError', message, text.path, line, facts={'near': near}),
            span and Span(span.start - 4, span.end),
        )
    elif GENERATE in functions and tree.body:
        function = functions[GENERATE]
        if not any(isinstance(node, (ast.Return, ast.Raise, ast.Yield)) for node in ast.walk(function)):
            message = "'NoneType' object has no attribute 'get_launch_arguments'"
            span = text.found(GENERATE, text.whole_line(function.lineno))
            yield Foreseen(Failure('AttributeError', message, text.path, function.lineno), span)


def _of_call(text: Text, call: ast.Call, names: dict[str, str], around: Around) -> Iterator[Foreseen]:
    name = full_name(call.func, names)
    if name is None:
        if isinstance(call.func, ast.Call):
            yield from _called_item(text, call, names)
        return
    top, leaf = name.partition('.')[0], name.rpartition('.')[2]
    if top not in OF_LAUNCH:
        return
    if leaf in SHARES:
        yield from _package(text, call.args[0] if call.args else keyword_of(call, 'package'), around)
        return
    cls = class_named(leaf)
    if isinstance(cls, type):
        yield from _arguments(text, call, cls)
    if leaf in NODES:
        yield from _package(text, keyword_of(call, 'package'), around)
        yield from _executable(text, keyword_of(call, 'package'), keyword_of(call, 'executable'), around)


def _called_item(text: Text, call: ast.Call, names: dict[str, str]) -> Iterator[Foreseen]:
    """Yield an error for two items of a list without a comma between them. Python reads them as a call."""
    inner: Any = call.func
    name = (full_name(inner.func, names) or '').rpartition('.')[2]
    if name and isinstance(class_named(name), type):
        span = text.of_node(inner)
        failure = Failure('TypeError', f"'{name}' object is not callable", text.path, text.place(span.end).line)
        yield Foreseen(failure, Span(span.end - 1, span.end), (inserted(text, span.end, ','),))


def _arguments(text: Text, call: ast.Call, cls: Any) -> Iterator[Foreseen]:
    """Yield errors for unknown arguments, missing arguments, and too many positional arguments."""
    known = keywords_of(cls)
    if not known or any(isinstance(one, ast.Starred) for one in call.args):
        return
    keywords = [keyword.arg for keyword in call.keywords if keyword.arg]
    unknown = [keyword for keyword in call.keywords if keyword.arg and keyword.arg not in known]
    for keyword in unknown:
        message = f"{cls.__name__}.__init__() got an unexpected keyword argument '{keyword.arg}'"
        facts = {'class': cls.__name__, 'keywords': known}
        start = text.of_node(keyword).start
        yield Foreseen(
            Failure('TypeError', message, text.path, call.lineno, facts=facts), Span(start, start + len(keyword.arg or '') + 1)
        )
    has_all = all(keyword.arg for keyword in call.keywords)
    needed, most = _needed(cls, len(call.args))
    if len(call.args) > most:
        message = f'{cls.__name__}.__init__() takes {most + 1} positional arguments but {len(call.args) + 1} were given'
        yield Foreseen(Failure('TypeError', message, text.path, call.lineno), text.of_node(call.args[most]))
        return
    for name in needed:
        if has_all and name not in keywords and not nearest(name, [one.arg or '' for one in unknown]):
            message = f"{cls.__name__}.__init__() missing 1 required keyword-only argument: '{name}'"
            failure = Failure('TypeError', message, text.path, call.lineno, facts={'given_names': keywords})
            yield Foreseen(failure, text.of_node(call.func))


def _needed(cls: Any, positional: int) -> tuple[list[str], int]:
    """Return the arguments that a constructor still requires, and the number of positional arguments that it accepts."""
    function = cls.__init__
    code = getattr(function, '__code__', None)
    if code is None or code.co_flags & 0x04:  # *args
        return [], positional
    places = code.co_varnames[1 : code.co_argcount]
    named = code.co_varnames[code.co_argcount : code.co_argcount + code.co_kwonlyargcount]
    free = len(places) - len(function.__defaults__ or ())
    return [*places[positional:free], *(name for name in named if name not in (function.__kwdefaults__ or {}))], len(places)


def _package(text: Text, node: ast.expr | None, around: Around) -> Iterator[Foreseen]:
    package = text_of(node)
    facts = around.unknown_package(package) if package else None
    if facts is not None and node is not None:
        message = f'"package \'{package}\' not found, searching: []"'
        yield Foreseen(Failure('PackageNotFoundError', message, text.path, node.lineno, facts=facts), inside_quotes(text, node))


def _executable(text: Text, package: ast.expr | None, node: ast.expr | None, around: Around) -> Iterator[Foreseen]:
    name, executable = text_of(package), text_of(node)
    facts = around.unknown_executable(name, executable) if name and executable else None
    if facts is not None and node is not None:
        message = f"executable '{executable}' not found on the libexec directory"
        yield Foreseen(Failure('SubstitutionFailure', message, text.path, node.lineno, facts=facts), inside_quotes(text, node))


def _declared(calls: list[ast.Call], names: dict[str, str]) -> set[str]:
    """Return the launch arguments and launch configurations that the file itself defines."""
    found = set()
    for call in calls:
        if (full_name(call.func, names) or '').rpartition('.')[2] in DECLARING and call.args:
            found.add(text_of(call.args[0]) or '')
    return found - {''}


def _configuration(text: Text, call: ast.Call, names: dict[str, str], declared: set[str]) -> Iterator[Foreseen]:
    """Yield an error for an undeclared launch configuration whose name resembles a declared one."""
    if (full_name(call.func, names) or '').rpartition('.')[2] != 'LaunchConfiguration' or not call.args:
        return
    name = text_of(call.args[0])
    near = nearest_spelling(name, declared) if name and name not in declared else None
    if near is not None and near.rstrip('0123456789') != (name or '').rstrip('0123456789'):
        facts = {'about': 'launch.no-configuration', 'configuration': name, 'near': near}
        failure = Failure(
            'SubstitutionFailure', f"launch configuration '{name}' does not exist", text.path, call.lineno, facts=facts
        )
        yield Foreseen(failure, inside_quotes(text, call.args[0]))


def joined_in_lists(text: Text, tree: ast.Module) -> Iterator[tuple[Finding, Span]]:
    """Yield a finding for two adjacent strings on one line of a list or tuple, which Python joins."""
    for node in ast.walk(tree):
        for item in node.elts if isinstance(node, (ast.List, ast.Tuple)) else ():
            if text_of(item) is None or item.lineno != item.end_lineno:
                continue
            span = text.of_node(item)
            parts = _literals(text.text[span.start : span.end])
            if len(parts) == 2 and all(part and ' ' not in part for part in parts):
                facts: dict[str, Any] = {'first': parts[0], 'second': parts[1], 'joined': ''.join(parts)}
                finding = found('text', ''.join(parts), file=text.path, line=item.lineno, **facts)
                yield finding._replace(rule='programs.joined-strings'), span


def _literals(written: str) -> list[str]:
    try:
        tokens = list(tokenize.generate_tokens(io.StringIO(written).readline))
        return [str(ast.literal_eval(token.string)) for token in tokens if token.type == tokenize.STRING]
    except (tokenize.TokenError, SyntaxError, ValueError):
        return []
