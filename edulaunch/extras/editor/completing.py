"""Compute the completions at the cursor."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from edulaunch.advice.launch_names import class_named, keywords_of
from edulaunch.advice.texts import Around, Span, Text
from edulaunch.extras.editor.pointing import declarations
from edulaunch.extras.editor.programs import frames, interface_of
from edulaunch.extras.editor.subjects import Subject, subject_at
from edulaunch.ros.sourcing import source


class Choice(NamedTuple):
    """A completion with a short description."""

    label: str
    detail: str = ''


def choices(text: Text, offset: int, around: Around) -> tuple[list[Choice], Span] | None:
    """Return the completions at an offset, and the string that they replace. Return None if no completions are known."""
    subject = subject_at(text, offset)
    if subject is None:
        return None
    found = _CHOICES[subject.kind](subject, text, around)
    return found, Span(subject.span.start, max(offset, subject.span.end))


def _packages(subject: Subject, text: Text, around: Around) -> list[Choice]:
    return [Choice(name, 'your package' if around.index.source_folder(name) else 'built-in package') for name in around.packages]


def _executables(subject: Subject, text: Text, around: Around) -> list[Choice]:
    return [Choice(name, f'executable of {subject.owner}') for name in around.executables(subject.owner)] if subject.owner else []


def _launch_files(subject: Subject, text: Text, around: Around) -> list[Choice]:
    return [Choice(name, f'in {path}') for name, path in around.launch_files(subject.owner).items()]


def _arguments(subject: Subject, text: Text, around: Around) -> list[Choice]:
    return [Choice(one.name, f'default: {one.default}' if one.default else 'no default') for one in declarations(text)]


def _parameters(subject: Subject, text: Text, around: Around) -> list[Choice]:
    package, _, executable = subject.owner.partition('/')
    known = interface_of(around, package, executable).parameters if executable else {}
    return [Choice(name, f'default: {value}') for name, value in known.items()]


def _topics(subject: Subject, text: Text, around: Around) -> list[Choice]:
    package, _, executable = subject.owner.partition('/')
    if executable:
        return [Choice(name, kind) for name, kind in interface_of(around, package, executable).topics.items()]
    known = {
        name: kind
        for package in around.packages
        if around.index.source_folder(package)
        for executable in around.executables(package)
        for name, kind in interface_of(around, package, executable).topics.items()
    }
    for name, kind in interface_of(around, 'turtlesim', 'turtlesim_node').topics.items():
        known.setdefault(name, kind)
    return [Choice(name, kind) for name, kind in known.items()]


def _frames(subject: Subject, text: Text, around: Around) -> list[Choice]:
    return [Choice(name, 'frame') for name in frames(around, text.text)]


def _interfaces(subject: Subject, text: Text, around: Around) -> list[Choice]:
    package, _, kind = subject.owner.partition('.')
    has = around.registry.has(package, kind)
    return [Choice(name, subject.owner) for name in around.registry.names(package, kind)] if has else []


def _interface_modules(subject: Subject, text: Text, around: Around) -> list[Choice]:
    kinds = ('msg', 'srv', 'action')
    return [Choice(f'{name}.{kind}') for name in around.registry.packages() for kind in kinds if around.registry.has(name, kind)]


def _elements(subject: Subject, text: Text, around: Around) -> list[Choice]:
    source()
    from launch.frontend.expose import action_parse_methods
    from launch.frontend.parser import Parser

    Parser.load_launch_extensions()
    return [Choice(name) for name in sorted(action_parse_methods)]


def _keywords(subject: Subject, text: Text, around: Around) -> list[Choice]:
    cls = class_named(subject.owner)
    return [Choice(f'{name}=', f'argument of {subject.owner}') for name in keywords_of(cls)] if isinstance(cls, type) else []


_CHOICES: dict[str, Callable[[Subject, Text, Around], list[Choice]]] = {
    'package': _packages,
    'executable': _executables,
    'launch file': _launch_files,
    'argument': _arguments,
    'parameter': _parameters,
    'topic': _topics,
    'frame': _frames,
    'interface': _interfaces,
    'interface module': _interface_modules,
    'element': _elements,
    'keyword': _keywords,
}
