"""Names of nodes, topics and services: validation, expansion and remapping. Invalid names are reported with the reasons
of ROS 2.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

Problem = tuple[str, int]
"""The reason for rejecting a name, in ROS 2's words, and the index of the invalid character."""

MAX_NODE_NAME = 255
MAX_NAMESPACE = 245
MAX_TOPIC_NAME = 247

_DIGITS = frozenset('0123456789')
_WORD = frozenset('abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_')
_PATH = _WORD | {'/'}


def _is_plain(path: str) -> bool:
    """Return whether all tokens of a path without leading slash are valid. This quick check accepts most names."""
    return path.isascii() and all(map(str.isidentifier, path.split('/')))


def _first_outside(name: str, allowed: frozenset[str]) -> int:
    return next((index for index, character in enumerate(name) if character not in allowed), -1)


def _digit_token(name: str) -> int:
    """Return the index of the first digit that directly follows a slash, or -1."""
    return next((index for index in range(1, len(name)) if name[index] in _DIGITS and name[index - 1] == '/'), -1)


def node_name_problem(name: str) -> Problem | None:
    """Return why a node name (without namespace) is invalid and the index of the wrong character, or None if the name is
    valid.
    """
    if not name:
        return 'node name must not be empty', 0
    if name.isascii() and name.isidentifier() and len(name) <= MAX_NODE_NAME:
        return None
    bad = _first_outside(name, _WORD)
    if bad >= 0:
        return "node name must not contain characters other than alphanumerics or '_'", bad
    if name[0] in _DIGITS:
        return 'node name must not start with a number', 0
    if len(name) > MAX_NODE_NAME:
        return f"node name length should not exceed '{MAX_NODE_NAME}'", MAX_NODE_NAME - 1
    return None


def _absolute_path_problem(kind: str, name: str, limit: int, too_long: str) -> Problem | None:
    if len(name) <= limit and _is_plain(name[1:]):
        return None
    bad = _first_outside(name, _PATH)
    if bad >= 0:
        return f"{kind} must not contain characters other than alphanumerics, '_', or '/'", bad
    double = name.find('//')
    if double >= 0:
        return f"{kind} must not contain repeated '/'", double + 1
    digit = _digit_token(name)
    if digit >= 0:
        return f'{kind} must not have a token that starts with a number', digit
    return (too_long, limit - 1) if len(name) > limit else None


def namespace_problem(namespace: str) -> Problem | None:
    """Return why an absolute namespace is invalid and the index of the wrong character, or None if the namespace is valid."""
    if not namespace:
        return 'namespace must not be empty', 0
    if namespace[0] != '/':
        return "namespace must be absolute, it must lead with a '/'", 0
    if namespace == '/':
        return None
    if namespace[-1] == '/':
        return "namespace must not end with a '/', unless only a '/'", len(namespace) - 1
    too_long = "namespace should not exceed 'RMW_NAMESPACE_MAX_NAME_LENGTH'"
    return _absolute_path_problem('namespace', namespace, MAX_NAMESPACE, too_long)


def full_topic_name_problem(name: str) -> Problem | None:
    """Return why an expanded topic or service name is invalid and the index of the wrong character, or None if the name is
    valid.
    """
    if not name:
        return 'topic name must not be empty', 0
    if name[0] != '/':
        return "topic name must be absolute, it must lead with a '/'", 0
    if name[-1] == '/':
        return "topic name must not end with a '/'", len(name) - 1
    return _absolute_path_problem('topic name', name, MAX_TOPIC_NAME, "topic length should not exceed '255U - 8U'")


def topic_name_problem(name: str) -> Problem | None:
    """Return why a topic or service name is invalid and the index of the wrong character, or None if the name is valid.

    The name is checked as a program writes it, before expansion.
    """
    if not name:
        return 'topic name must not be empty string', 0
    if _is_plain(name):
        return None
    if name[0] in _DIGITS:
        return 'topic name token must not start with a number', 0
    if name[-1] == '/':
        return 'topic name must not end with a forward slash', len(name) - 1
    problem = _character_problem(name)
    if problem is not None:
        return problem
    digit = _digit_token(name)
    return ('topic name token must not start with a number', digit) if digit >= 0 else None


def _character_problem(name: str) -> Problem | None:
    opened = -1
    for index, character in enumerate(name):
        if character == '{' and opened >= 0:
            return "substitution name must not contain characters other than alphanumerics or '_'", index
        if character in '{}':
            if character == '}' and opened < 0:
                return "topic name must not have unmatched (unbalanced) curly braces '{}'", index
            opened = index if character == '{' else -1
        elif character in _WORD:
            if opened == index - 1 >= 0 and name[opened] == '{' and character in _DIGITS:
                return 'substitution name must not start with a number', index
        elif opened >= 0:
            return "substitution name must not contain characters other than alphanumerics or '_'", index
        elif character == '~':
            if index:
                return "topic name must not have tilde '~' unless it is the first character", index
        elif character != '/':
            return "topic name must not contain characters other than alphanumerics, '_', '~', '{', or '}'", index
    if opened >= 0:
        return "topic name must not have unmatched (unbalanced) curly braces '{}'", opened
    return None


def caret_text(kind: str, name: str, problem: Problem) -> str:
    """Return the three lines with which ROS 2 rejects a name: the reason, the name, and a caret under the invalid character."""
    reason, index = problem
    return f"Invalid {kind}: {reason}:\n  '{name}'\n   {' ' * index}^"


def absolute_namespace(namespace: str) -> str:
    """Return `namespace` with the leading slash that ROS 2 adds; '' becomes '/'."""
    return namespace if namespace.startswith('/') else '/' + namespace


def fully_qualified_name(namespace: str, name: str) -> str:
    """Return the absolute name of a node, or of a relative topic, in `namespace`."""
    return f'/{name}' if namespace == '/' else f'{namespace}/{name}'


def plain_name(name: str, namespace: str) -> str | None:
    """Return the absolute form of a valid relative name in a valid namespace, or None for any other name.

    None does not mean that the name is invalid.
    """
    if name.__class__ is str and name and _is_plain(name) and len(name) + len(namespace) < MAX_TOPIC_NAME:
        return fully_qualified_name(namespace, name)
    return None


class UnknownSubstitution(ValueError):
    """A name contains a substitution in braces that does not exist in ROS 2. Programs receive this error as a ValueError."""


UnknownSubstitution.__name__ = UnknownSubstitution.__qualname__ = ValueError.__name__
UnknownSubstitution.__module__ = ValueError.__module__


def expand_name(name: str, node_name: str, namespace: str) -> str:
    """Return the absolute form of a topic or service name.

    The function expands relative names, `~`, and the substitutions `{node}`, `{ns}` and `{namespace}`.

    :raises UnknownSubstitution: for a substitution that does not exist in ROS 2.
    """
    if '{' in name:
        name = _substituted(name, node_name, namespace)
    if name.startswith('/'):
        return name
    if name.startswith('~'):
        return fully_qualified_name(namespace, node_name) + name[1:]
    return fully_qualified_name(namespace, name)


def _substituted(name: str, node_name: str, namespace: str) -> str:
    values = {'node': node_name, 'ns': namespace, 'namespace': namespace}
    head, *parts = name.split('{')
    for part in parts:
        key, _, rest = part.partition('}')
        if key not in values:
            raise UnknownSubstitution(f"topic name '{name}' is invalid: unknown substitution: {{{key}}}")
        head += values[key] + rest
    return head


class RemapRule(NamedTuple):
    """One `from:=to` rule.

    :ivar kind: 'topic', 'service', 'any' (topics and services), 'node' or 'namespace'.
    :ivar node_name: the only node that the rule applies to, or None for all nodes.
    :ivar match: the name to replace, as written; unused for 'node' and 'namespace'.
    """

    kind: str
    node_name: str | None
    match: str
    replacement: str


def remapped_node_name(rules: Iterable[RemapRule], name: str) -> str:
    """Return the node name that the first matching `__node` rule sets, or `name` if no rule matches."""
    return _replacement(rules, 'node', name) or name


def remapped_namespace(rules: Iterable[RemapRule], node_name: str, namespace: str) -> str:
    """Return the namespace that the first matching `__ns` rule sets, or `namespace` if no rule matches.

    :param node_name: the name of the node after remapping.
    """
    return _replacement(rules, 'namespace', node_name) or namespace


def _replacement(rules: Iterable[RemapRule], kind: str, node_name: str) -> str | None:
    for rule in rules:
        if rule.kind == kind and rule.node_name in (None, node_name):
            return rule.replacement
    return None


def remapped_name(rules: Sequence[RemapRule], kind: str, name: str, node_name: str, namespace: str) -> str:
    """Apply the first matching remapping rule to an expanded topic or service name, and return the result.

    The result is not remapped again.

    :param kind: 'topic' or 'service'.
    """
    for rule in rules:
        if (
            rule.kind in (kind, 'any')
            and rule.node_name in (None, node_name)
            and expand_name(rule.match, node_name, namespace) == name
        ):
            return expand_name(rule.replacement, node_name, namespace)
    return name


def is_hidden(name: str) -> bool:
    """Return whether tools hide this name. A name is hidden if one of its tokens begins with an underscore."""
    return name.startswith('_') or '/_' in name
