"""Find the objects under the cursor: definitions, all uses of a launch argument, and the content of a hover."""

from __future__ import annotations

import os
import re
from typing import Any, NamedTuple

from edulaunch.advice.launch_names import class_named
from edulaunch.advice.texts import Around, Span, Text
from edulaunch.extras.editor.programs import file_of, interface_of, launch_files_around
from edulaunch.extras.editor.subjects import Subject, subject_at

Values = dict[str, Any]
"""The values from the last dry run: for each launch argument, the steps in the form of `edulaunch.advice.plan.why`."""
_DECLARED = re.compile(
    r"""DeclareLaunchArgument\(\s*(?:name\s*=\s*)?['"](?P<python>[\w.-]+)['"]"""
    r"""(?:\s*,\s*default_value\s*=\s*(?P<value>['"][^'"]*['"]|\w+|\[[^\]]*\]))?"""
    r"""|<arg\b[^>]*?\bname\s*=\s*['"](?P<xml>[\w.-]+)['"](?:[^>]*?\bdefault\s*=\s*['"](?P<default>[^'"]*)['"])?"""
    r"""|\barg\s*:[^:]*?\bname\s*:\s*['"]?(?P<yaml>[\w.-]+)['"]?(?:[^-]*?\bdefault\s*:\s*(?P<given>[^\n,}]+))?"""
)
_USE = r"""(?:LaunchConfiguration(?:(?:Not)?Equals)?\(\s*['"]|\$\(var\s+){name}(?![\w.-])"""
_PASSED = r"""(?:['"]{name}['"]\s*:|\(\s*['"]{name}['"]\s*,|<(?:arg|let)\b[^>]*?\bname\s*=\s*['"]{name}['"])"""


class Declaration(NamedTuple):
    """A launch argument in the file: its name, its default as written in the file, and the place of its name."""

    name: str
    default: str
    span: Span


class Target(NamedTuple):
    """A place in a file."""

    path: str
    line: int
    column: int = 0
    end: int = 0


def declarations(text: Text) -> list[Declaration]:
    """Return the launch arguments that the file declares. The file may be unfinished."""
    found = []
    for match in _DECLARED.finditer(text.text):
        kind = next(name for name in ('python', 'xml', 'yaml') if match[name])
        default = (match['value'] or match['default'] or match['given'] or '').strip()
        found.append(Declaration(match[kind], default.strip('\'"'), Span(*match.span(kind))))
    return found


def definition(text: Text, offset: int, around: Around) -> Target | None:
    """Return the definition of the object at an offset, or None if it is unknown."""
    subject = subject_at(text, offset)
    if subject is None:
        return _relative_file(text, offset)
    if subject.kind == 'argument':
        return next((_target(text, one.span) for one in declarations(text) if one.name == subject.name), None)
    if subject.kind == 'package':
        return _manifest(around, subject.name)
    if subject.kind == 'executable':
        place = file_of(around, subject.owner, subject.name)
        return None if place is None else Target(*place)
    if subject.kind == 'launch file':
        share = around.index.share(subject.owner) if subject.owner in around.packages else None
        inner = around.launch_files(subject.owner).get(os.path.basename(subject.name))
        return Target(os.path.realpath(os.path.join(share, inner)), 1) if share and inner else None
    if subject.kind == 'interface':
        return _interface(around, subject)
    return None


def _manifest(around: Around, package: str) -> Target | None:
    share = around.index.share(package) if package in around.packages else None
    path = os.path.realpath(os.path.join(share or '', 'package.xml'))
    return Target(path, 1) if os.path.isfile(path) else None


def _interface(around: Around, subject: Subject) -> Target | None:
    package, _, kind = subject.owner.partition('.')
    if not around.registry.has(package, kind) or subject.name not in around.registry.names(package, kind):
        return None
    return Target(os.path.realpath(around.registry.path(f'{package}/{kind}/{subject.name}')), 1)


def _relative_file(text: Text, offset: int) -> Target | None:
    """Return the absolute path of a file that a string in the file names relative to the folder of the file."""
    line = text.whole_line(text.place(offset).line)
    for match in re.finditer(r"""['"]([\w./-]+\.(?:py|xml|ya?ml|urdf|xacro|rviz))['"]""", text.text[line.start : line.end]):
        if line.start + match.start() <= offset <= line.start + match.end():
            path = os.path.join(os.path.dirname(text.path), match[1])
            return Target(os.path.realpath(path), 1) if os.path.isfile(path) else None
    return None


def references(text: Text, offset: int, around: Around) -> list[Target]:
    """Return all uses of the launch argument at an offset.

    The uses are in this file, and in launch files that include this file and set the argument.
    """
    subject = subject_at(text, offset)
    if subject is None or subject.kind != 'argument':
        return []
    name = re.escape(subject.name)
    found = [_target(text, one.span) for one in declarations(text) if one.name == subject.name]
    found += _matches(text, _USE.replace('{name}', name), subject.name)
    own = os.path.realpath(text.path)
    for path in launch_files_around(around):
        if os.path.realpath(path) == own:
            continue
        try:
            with open(path, encoding='utf-8') as file:
                other = Text(file.read(), path)
        except (OSError, UnicodeDecodeError):
            continue
        if os.path.basename(text.path) in other.text:
            found += _matches(other, _PASSED.replace('{name}', name), subject.name)
    return list(dict.fromkeys(found))


def _matches(text: Text, pattern: str, name: str) -> list[Target]:
    spans = []
    for match in re.finditer(pattern, text.text):
        at = text.text.rindex(name, match.start(), match.end())
        spans.append(Span(at, at + len(name)))
    return [_target(text, span) for span in spans]


def _target(text: Text, span: Span) -> Target:
    place = text.place(span.start)
    return Target(os.path.realpath(text.path), place.line, place.column, place.column + span.end - span.start)


def hover(text: Text, offset: int, around: Around, values: Values) -> tuple[str, Span] | None:
    """Return a description of the object at an offset, as Markdown, and the place of the object. Return None if there is
    nothing to describe.

    :param values: the values from the last dry run of the file.
    """
    subject = subject_at(text, offset)
    if subject is None or not subject.name:
        return None
    words = {
        'argument': _about_argument,
        'package': _about_package,
        'executable': _about_executable,
        'interface': _about_interface,
        'keyword': _about_keyword,
        'parameter': _about_parameter,
        'topic': _about_topic,
    }.get(subject.kind)
    text_of_hover = '' if words is None else words(subject, text, around, values)
    return (text_of_hover, subject.span) if text_of_hover else None


def _about_argument(subject: Subject, text: Text, around: Around, values: Values) -> str:
    lines = [f'launch argument `{subject.name}`']
    steps = values.get(subject.name) or []
    for step in steps:
        place = f' ({os.path.basename(step["file"])}:{step["line"]})' if step['file'] else ''
        lines.append(
            f'- {"**" if step["counts"] else ""}`{step["value"]}`{"**" if step["counts"] else ""} from {step["origin"]}{place}'
        )
    declared = next((one for one in declarations(text) if one.name == subject.name), None)
    if not steps and declared is not None:
        line = text.place(declared.span.start).line
        lines.append(f'- default `{declared.default}`, line {line}' if declared.default else f'- no default, line {line}')
    return '\n'.join(lines) if len(lines) > 1 else ''


def _about_package(subject: Subject, text: Text, around: Around, values: Values) -> str:
    if subject.name not in around.packages:
        return ''
    folder = around.index.source_folder(subject.name)
    names = around.executables(subject.name)
    where = f'in `{folder}`' if folder else 'built into edulaunch'
    return f'package `{subject.name}`, {where}' + (
        f'\n\nexecutables: {", ".join(f"`{name}`" for name in names[:20])}' if names else ''
    )


def _about_executable(subject: Subject, text: Text, around: Around, values: Values) -> str:
    if subject.name not in around.executables(subject.owner):
        return ''
    place = file_of(around, subject.owner, subject.name)
    found = interface_of(around, subject.owner, subject.name)
    lines = [
        f'executable `{subject.name}` of `{subject.owner}`' + (f', {os.path.basename(place[0])}:{place[1]}' if place else '')
    ]
    lines += [f'- topic `{name}` ({kind})' for name, kind in list(found.topics.items())[:12]]
    lines += [f'- parameter `{name}`, default `{value}`' for name, value in list(found.parameters.items())[:12]]
    return '\n'.join(lines)


def _about_interface(subject: Subject, text: Text, around: Around, values: Values) -> str:
    package, _, kind = subject.owner.partition('.')
    if not around.registry.has(package, kind) or subject.name not in around.registry.names(package, kind):
        return ''
    return f'`{package}/{kind}/{subject.name}`\n```\n{around.registry.text(f"{package}/{kind}/{subject.name}").strip()}\n```'


def _about_keyword(subject: Subject, text: Text, around: Around, values: Values) -> str:
    cls = class_named(subject.owner)
    document = getattr(cls, '__doc__', None) or ''
    found = re.search(rf':param {re.escape(subject.name)}:((?:[^\n]*)(?:\n\s{{8,}}[^\n]*)*)', document)
    return f'`{subject.owner}({subject.name}=...)`: {" ".join(found[1].split())}' if found else ''


def _about_parameter(subject: Subject, text: Text, around: Around, values: Values) -> str:
    package, _, executable = subject.owner.partition('/')
    known = interface_of(around, package, executable).parameters if executable else {}
    default = known.get(subject.name)
    return '' if default is None else f'parameter `{subject.name}` of `{subject.owner}`, default `{default}`'


def _about_topic(subject: Subject, text: Text, around: Around, values: Values) -> str:
    package, _, executable = subject.owner.partition('/')
    kind = interface_of(around, package, executable).topics.get(subject.name.removeprefix('/')) if executable else None
    return '' if kind is None else f'topic `{subject.name}` of `{subject.owner}`: {kind}'
