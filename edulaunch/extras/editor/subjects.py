"""Find the subject at the cursor, such as a package, an executable, a launch argument, a launch file, a topic or a frame."""

from __future__ import annotations

import re
from typing import NamedTuple

from edulaunch.advice.texts import Span, Text

REACH = 1500
"""The number of characters before the cursor that are examined."""


class Subject(NamedTuple):
    """The subject at the cursor.

    :ivar kind: 'package', 'executable', 'argument', 'launch file', 'parameter', 'topic', 'frame', 'interface', 'interface
        module', 'element' or 'keyword'.
    :ivar name: the whole name. For an unfinished name, the part up to the cursor is `text[span.start:cursor]`.
    :ivar owner: the package of an executable or launch file, or 'package/executable' of a parameter or topic. For an interface,
        it is the module, and for a keyword, the action.
    """

    kind: str
    name: str
    span: Span
    owner: str = ''


_SHARE = r'(?:FindPackageShare|FindPackagePrefix|get_package_share_directory|get_package_prefix|get_package_share_path)'
_BEFORE = [
    (re.compile(r'\bpackage\s*=\s*$'), 'package'),
    (re.compile(_SHARE + r'\(\s*(?:package\s*=\s*)?$'), 'package'),
    (re.compile(r'\b(?:executable|node_executable)\s*=\s*$'), 'executable'),
    (re.compile(r'\b(?:DeclareLaunchArgument|(?:Set)?LaunchConfiguration(?:(?:Not)?Equals)?)\(\s*$'), 'argument'),
    (re.compile(r'\bparameters\s*=\s*\[(?:[^\[\]]|\[[^\[\]]*\])*\{(?:[^{}]*,)?\s*$'), 'parameter'),
    (re.compile(r'\bremappings\s*=\s*\[(?:[^\]]*,)?\s*\(\s*$'), 'topic'),
    (re.compile(r'\bcreate_(?:publisher|subscription)\(\s*[\w.]+\s*,\s*$'), 'topic'),
    (re.compile(r'\b(?:lookup_transform|can_transform)\((?:[^,()]*,)?\s*$'), 'frame'),
    (re.compile(r'\bframe_id\s*=\s*$'), 'frame'),
    (re.compile(_SHARE + r'\(\s*["\'](?P<owner>[\w-]+)["\']\s*\)\s*,\s*(?:["\']launch["\']\s*,\s*)?$'), 'launch file'),
]  # fmt: skip
"""The kinds of subjects, by the text before the string under the cursor."""
_MARKUP = [
    (re.compile(r'\$\(var\s+(?P<name>[\w.-]*)$'), 'argument'),
    (re.compile(r'\$\(find-pkg-(?:share|prefix)\s+(?P<name>[\w-]*)$'), 'package'),
    (re.compile(r'\$\(find-pkg-share\s+(?P<owner>[\w-]+)\)/(?:launch/)?(?P<name>[\w.-]*)$'), 'launch file'),
    (re.compile(r'\bpkg\s*[=:]\s*["\']?(?P<name>[\w-]*)$'), 'package'),
    (re.compile(r'\bexec\s*[=:]\s*["\']?(?P<name>[\w.-]*)$'), 'executable'),
    (re.compile(r'<(?:arg|let)\b[^<>]*\bname\s*=\s*["\'](?P<name>[\w.-]*)$'), 'argument'),
    (re.compile(r'\b(?:arg|let)\s*:[^:]*\bname\s*:\s*["\']?(?P<name>[\w.-]*)$'), 'argument'),
    (re.compile(r'<param\b[^<>]*\bname\s*=\s*["\'](?P<name>[\w.-]*)$'), 'parameter'),
    (re.compile(r'<remap\b[^<>]*\bfrom\s*=\s*["\'](?P<name>[\w/~.-]*)$'), 'topic'),
    (re.compile(r'<(?P<name>[\w-]*)$'), 'element'),
    (re.compile(r'^\s*-\s*(?P<name>[\w-]*)$', re.MULTILINE), 'element'),
]
"""The kinds of subjects in XML and YAML, by the text before the cursor, including the beginning of the name."""
_MODULE = re.compile(r'^from\s+(?P<name>[\w.]*)$', re.MULTILINE)
_IMPORT = re.compile(
    r'^from\s+(?P<owner>\w+\.(?:msg|srv|action))\s+import\s+(?:\(?[\w\s,]*,\s*|\(\s*)?(?P<name>\w*)$', re.MULTILINE
)
_CALL = re.compile(r'\b(?P<owner>[A-Z]\w+)\((?P<inner>(?:[^()]|\([^()]*\))*)$')


def subject_at(text: Text, offset: int) -> Subject | None:
    """Return the subject at an offset of the file, or None if the subject is unknown."""
    found = _in_python(text, offset) if text.path.endswith('.py') else _in_markup(text, offset)
    if found is None:
        return None
    if not found.owner and found.kind in ('executable', 'parameter', 'topic'):
        found = found._replace(owner=owner_of(text, found))
    return found


def _in_markup(text: Text, offset: int) -> Subject | None:
    before = text.text[max(0, offset - REACH) : offset]
    for pattern, kind in _MARKUP:
        match = pattern.search(before)
        if match is not None:
            start = offset - len(match['name'])
            return Subject(
                kind, *_whole(text, start, r'[\w./~-]*' if kind == 'topic' else r'[\w.-]*'), match.groupdict().get('owner') or ''
            )
    return None


def _in_python(text: Text, offset: int) -> Subject | None:
    start = _string_start(text, offset)
    if start is not None:
        before = text.text[max(0, start - REACH) : start - 1].removesuffix('f').removesuffix('r')
        for pattern, kind in _BEFORE:
            match = pattern.search(before)
            if match is not None:
                return Subject(kind, *_whole(text, start, r'[^"\'\n]*'), match.groupdict().get('owner') or '')
        return None
    before = text.text[max(0, offset - REACH) : offset]
    for pattern, kind in ((_IMPORT, 'interface'), (_MODULE, 'interface module')):
        match = pattern.search(before)
        if match is not None:
            return Subject(kind, *_whole(text, offset - len(match['name']), r'[\w.]*'), match.groupdict().get('owner') or '')
    word = re.search(r'\w*$', before)
    begin = offset - len(word[0] if word else '')
    call = _CALL.search(text.text[max(0, begin - REACH) : begin])
    if call is not None and (not call['inner'].strip() or call['inner'].rstrip().endswith(',')):
        return Subject('keyword', *_whole(text, begin, r'\w*'), call['owner'])
    return None


def _whole(text: Text, start: int, pattern: str) -> tuple[str, Span]:
    """Return the whole name that begins at an offset, and the place of this name."""
    match = re.compile(pattern).match(text.text, start)
    end = start if match is None else match.end()
    return text.text[start:end], Span(start, end)


def _string_start(text: Text, offset: int) -> int | None:
    """Return the offset after the opening quotation mark of the string around an offset. Return None outside strings.

    A string ends at the end of its line.
    """
    start = text.whole_line(text.place(offset).line).start
    quote, begin = '', 0
    for place in range(start, offset):
        character = text.text[place]
        if quote:
            quote = '' if character == quote else quote
        elif character in '"\'':
            quote, begin = character, place + 1
        elif character == '#':
            return None
    return begin if quote else None


def owner_of(text: Text, subject: Subject) -> str:
    """Return the package of an executable, or 'package/executable' of a parameter or topic, from the call or element around
    it."""
    start = max(text.text.rfind(opening, 0, subject.span.start) for opening in ('Node(', '<node', 'node:', 'ComposableNode('))
    if start < 0:
        return ''
    later = [place for ending in ('Node(', '<node', 'node:') if (place := text.text.find(ending, start + 5)) > 0]
    part = text.text[start : min([*later, start + REACH])]
    package = re.search(r'\b(?:package|pkg)\s*[=:]\s*["\']?([\w-]+)', part)
    executable = re.search(r'\b(?:executable|exec)\s*[=:]\s*["\']?([\w.-]+)', part)
    if subject.kind == 'executable':
        return package[1] if package else ''
    return f'{package[1]}/{executable[1]}' if package and executable else ''
