"""Predict errors of launch and rcl in XML and YAML launch files and in parameter files. No code is executed."""

from __future__ import annotations

import io
import re
from collections.abc import Iterator
from typing import Any

from edulaunch.advice.rule import Failure
from edulaunch.advice.texts.around import Around
from edulaunch.advice.texts.syntax import Foreseen
from edulaunch.advice.texts.text import Span, Text
from edulaunch.engine.facts import facts_of
from edulaunch.engine.graph.parameter_files import ParameterFileError, read_parameter_file
from edulaunch.engine.nearest import nearest_spelling
from edulaunch.ros.sourcing import source

_LINE = re.compile(r'(?:at|near) line (\d+)')
_PAIR = {
    'xml': re.compile(r'\b(?P<key>pkg|exec|plugin)\s*=\s*["\'](?P<value>[\w.-]+)["\']'),
    'yaml': re.compile(r'\b(?P<key>pkg|exec)\s*:\s*["\']?(?P<value>[\w.-]+)["\']?\s*(?:$|[,}#])', re.MULTILINE),
}
_SHARE = re.compile(r'\$\(find-pkg-(?:share|prefix) ([\w-]+)\)')
_VARIABLE = re.compile(r'\$\(var ([\w.-]+)\)')
_DECLARED = {
    'xml': re.compile(r'<(?:arg|let|set_launch_configuration)\b[^>]*?\bname\s*=\s*["\']([\w.-]+)["\']'),
    'yaml': re.compile(r'\b(?:arg|let)\s*:[^:]*?\bname\s*:\s*["\']?([\w.-]+)'),
}


def foreseen_in_markup(text: Text, around: Around) -> Iterator[Foreseen]:
    """Yield the errors of launch in an XML or YAML launch file, at most one for each element of the outermost level."""
    source()
    format = 'xml' if text.path.endswith('.xml') else 'yaml'
    if format == 'xml':
        from launch_xml import Parser
    else:
        from launch_yaml import Parser  # type: ignore[assignment]
    stream = io.StringIO(text.text)
    stream.name = text.path
    try:
        root, parser = Parser.load(stream)
        root_of_another_kind = root.type_name != 'launch'
        children = [] if root_of_another_kind else list(root.children)
        if root_of_another_kind:
            parser.parse_description(root)
    except Exception as error:
        yield _of_error(text, error)
        return
    for child in children:
        try:
            parser.parse_action(child)
        except Exception as error:
            yield _of_error(text, error)
    yield from _names(text, format, around)


def _of_error(text: Text, error: Exception) -> Foreseen:
    line = getattr(error, 'edulaunch_line', None) or 1
    failure = Failure(type(error).__name__, str(error), text.path, line, facts=facts_of(error))
    return Foreseen(failure, _span(text, failure, line))


def _span(text: Text, failure: Failure, line: int) -> Span | None:
    """Return the span of the attribute, element or substitution that the facts name, or None."""
    extent = text.extent(line)
    for name in ('attribute', 'call', 'element'):
        word = failure.facts.get(name)
        at = text.found(f'$({word}' if name == 'call' else str(word), extent) if word else None
        if at is not None:
            return at
    return None


def _names(text: Text, format: str, around: Around) -> Iterator[Foreseen]:
    """Yield errors for misspelt packages, executables and launch arguments."""
    package: str | None = None
    for pair in _PAIR[format].finditer(text.text):
        span = Span(*pair.span('value'))
        if pair['key'] == 'pkg':
            package = pair['value']
            yield from _package(text, package, span, around)
        elif pair['key'] == 'exec' and package is not None:
            facts = around.unknown_executable(package, pair['value'])
            if facts is not None:
                yield _misspelt(text, span, f"executable '{pair['value']}' not found on the libexec directory", facts)
    for share in _SHARE.finditer(text.text):
        yield from _package(text, share[1], Span(*share.span(1)), around)
    declared = set(_DECLARED[format].findall(text.text))
    for variable in _VARIABLE.finditer(text.text):
        near = nearest_spelling(variable[1], declared) if variable[1] not in declared else None
        if near is not None and near.rstrip('0123456789') != variable[1].rstrip('0123456789'):
            facts = {'about': 'launch.no-configuration', 'configuration': variable[1], 'near': near}
            message = f"launch configuration '{variable[1]}' does not exist"
            yield _misspelt(text, Span(*variable.span(1)), message, facts)


def _package(text: Text, name: str, span: Span, around: Around) -> Iterator[Foreseen]:
    facts = around.unknown_package(name)
    if facts is not None:
        yield _misspelt(text, span, f"package '{name}' not found, searching: []", facts)


def _misspelt(text: Text, span: Span, message: str, facts: dict[str, Any]) -> Foreseen:
    return Foreseen(Failure('SubstitutionFailure', message, text.path, text.place(span.start).line, facts=facts), span)


def foreseen_in_parameters(text: Text) -> Iterator[Foreseen]:
    """Yield the first error of rcl in a parameter file. rcl stops reading at this error."""
    try:
        read_parameter_file(text.text)
    except ParameterFileError as error:
        facts = facts_of(error)
        matched = _LINE.search(str(error))
        line = facts.get('at') or (int(matched[1]) if matched else 1)
        failure = Failure('ParameterFileError', str(error), text.path, line, facts=facts)
        word = facts.get('found')
        yield Foreseen(failure, text.found(str(word), Span(0, len(text.text))) if word else None)
