"""Rules about errors in XML and YAML launch files."""

from __future__ import annotations

import re
from collections.abc import Iterator
from linecache import getline

from edulaunch.advice.errors.about import about, report
from edulaunch.advice.rule import Failure, Finding, rule
from edulaunch.engine.nearest import nearest

HOMES = {
    # Elements that belong inside others: (the outer elements, the element that has the same effect on everything after it).
    'param': (('node',), 'set_parameter'),
    'remap': (('node',), 'set_remap'),
    'env': (('node', 'executable'), 'set_env'),
    'choice': (('arg',), None),
    'keep': (('group', 'reset'), None),
    'extra_arg': (('composable_node',), None),
    'composable_node': (('node_container', 'load_composable_node'), None),
}
ROS_1_ELEMENTS = {'rosparam': 'param', 'test': 'node', 'machine': None}
INSTEAD = {
    # (element, attribute that people write): its correct name. Many of these names come from ROS 1 or from the Python classes.
    ('node', 'type'): 'exec',
    ('node', 'ns'): 'namespace',
    ('node', 'required'): 'on_exit',
    ('node', 'executable'): 'exec',
    ('node', 'package'): 'pkg',
    ('node', 'parameters'): 'param',
    ('node', 'param_file'): '<param from="..."/>',
    ('node', 'params_file'): '<param from="..."/>',
    ('node', 'arguments'): 'args',
    ('node', 'remappings'): 'remap',
    ('group', 'ns'): '<push_ros_namespace namespace="..."/>',
    ('include', 'ns'): '<push_ros_namespace namespace="..."/> in a <group>',
    ('arg', 'doc'): 'description',
    ('arg', 'value'): 'default',
    ('arg', 'default'): 'value',
    ('push_ros_namespace', 'ns'): 'namespace',
    ('include', 'param'): 'arg',
    ('include', 'path'): 'file',
    ('let', 'default'): 'value',
    ('param', 'file'): 'from',
    ('remap', 'name'): 'from',
    ('remap', 'value'): 'to',
    ('set_remap', 'src'): 'from',
    ('set_remap', 'dst'): 'to',
    ('timer', 'delay'): 'period',
    ('timer', 'actions'): 'children',
    ('log', 'msg'): 'message',
    ('log', 'text'): 'message',
    ('executable', 'command'): 'cmd',
    ('set_parameters_from_file', 'file'): 'filename',
}
ROS_1_CALLS = {
    'arg': '$(var ...)',
    'find': '$(find-pkg-share ...)',
    'optenv': '$(env NAME DEFAULT)',
    'any': '$(or ... ...)',
    'all': '$(and ... ...)',
}


def _instead(failure: Failure, name: str) -> str | None:
    return INSTEAD.get((str(failure.facts.get('element')).replace('-', '_'), name.replace('-', '_')))


@rule(
    'launch.unknown-element',
    what=(
        'ROS 1 had the element {ros_1}, but ROS 2 does not',
        '{shown} must be inside {inside}, not on its own',
        '{shown} is not an element of launch files',
    ),
    do=(
        'write {near}',
        'move it into {inside}, or write {for_all} to apply it to everything that follows',
        'move it into {inside}',
        'remove it: ROS 2 has no equivalent of {ros_1}',
        'use another element, such as node, include, arg, group, let, log, timer or executable',
    ),
    level='error',
)
def unknown_element(failure: Failure) -> Iterator[Finding]:
    """Report an element that is unknown, or that is not allowed at this place."""
    if failure.facts.get('about') != 'launch.unknown-element':
        return
    name, shown = str(failure.facts.get('element')), str(failure.facts.get('shown'))
    near, inside, for_all = failure.facts.get('near'), None, None
    if name in ROS_1_ELEMENTS:
        near = ROS_1_ELEMENTS[name]
    elif name in HOMES:
        near = None
        inside = [shown.replace(name, place) for place in HOMES[name][0]]
        for_all = shown.replace(name, HOMES[name][1] or '') if HOMES[name][1] else None
    yield report(
        failure,
        ros_1=shown if name in ROS_1_ELEMENTS else None,
        near=shown.replace(name, str(near)) if near else None,
        inside=inside,
        for_all=for_all,
    )


@rule(
    'launch.unknown-attribute',
    what=(
        "'{as_attribute}' is an attribute of {shown}, not an element inside it",
        "'{as_element}' is an element inside {shown}, not an attribute",
        "{shown} has no attribute or element '{attribute}'",
    ),
    do=(
        'write {markup}',
        "write '{near}'",
        'write it as an attribute: {as_attribute}="..."',
        'write it as an element inside {shown}',
        'remove it, or correct its spelling',
    ),
    level='error',
    edits=(('{attribute}', '{near_name}'),),
)
def unknown_attribute(failure: Failure) -> Iterator[Finding]:
    """Report an attribute, key or child that the element does not have."""
    if failure.facts.get('about') != 'launch.unknown-attribute':
        return
    name, kind = str(failure.facts.get('attribute')), failure.facts.get('kind_of')
    instead = _instead(failure, name)
    near = None if kind else instead or failure.facts.get('near')
    markup = near if near and near.startswith('<') else None
    yield report(
        failure,
        markup=markup,
        near=near,
        near_name=None if markup else near,
        as_attribute=name if kind == 'attribute' else None,
        as_element=name if kind == 'element' else None,
    )


@rule(
    'launch.missing-attribute',
    what="{shown} needs '{needed}'",
    do=("replace '{near}' with '{needed}'", "add '{needed}'"),
    level='error',
    edits=(('{near}', '{needed}'),),
)
def missing_attribute(failure: Failure) -> Iterator[Finding]:
    """Report an element without a required attribute."""
    if failure.facts.get('about') == 'launch.missing-attribute':
        needed, given = str(failure.facts.get('needed')), list(failure.facts.get('given_names') or ())
        near = next((one for one in given if _instead(failure, one) == needed), None) or nearest(needed, given)
        yield report(failure, near=near)


@rule(
    'launch.call',
    what=(
        '$({call} ...) is a substitution of ROS 1; in ROS 2 it is {instead}',
        '$({unknown} ...) is not a substitution of ROS 2',
        'the syntax of $({call} ...) is not valid',
    ),
    do=(
        'write {instead}',
        "put the whole expression in quotes: $({evaluated} '...')",
        'write $({near} ...)',
        'check the arguments of $({written} ...): write one space before each, and quotes around an argument with spaces',
        'use another substitution, such as $(var ...), $(env ...), $(find-pkg-share ...) or $(eval ...)',
    ),
    level='error',
    edits=(('$({call} ', '$({ros_2} '), ('$({call}', '$({near}')),
)
def call(failure: Failure) -> Iterator[Finding]:
    """Report a `$(name ...)` that is unknown or has the wrong arguments."""
    if failure.facts.get('about') == 'launch.call':
        name, is_known = str(failure.facts.get('call')), bool(failure.facts.get('is_known'))
        instead = ROS_1_CALLS.get(name)
        near = None if is_known else failure.facts.get('near')
        evaluated = name if name == 'eval' else None
        unknown, written = (None, name) if is_known else (name, None)
        ros_2 = {'arg': 'var', 'find': 'find-pkg-share'}.get(name)
        yield report(failure, instead=instead, near=near, evaluated=evaluated, unknown=unknown, written=written, ros_2=ros_2)


@rule(
    'launch.path-as-package',
    what="$({call} ...) needs only the name of a package, but '{given}' is a path",
    do='close the parenthesis after the name: $({call} {package})/{rest}',
    level='error',
    edits=(('{given})', '{package})/{rest}'),),
)
def path_as_package(failure: Failure) -> Iterator[Finding]:
    """Report a path in place of a package name, as in `$(find-pkg-share robo/config/robo.yaml)`."""
    match = re.fullmatch(r"'([\w-]+)/(.+)' is not a valid package name", failure.message)
    if match is not None and failure.process is None and (failure.file or '').endswith(('.xml', '.yaml', '.yml', '.launch')):
        yield report(failure, call='find-pkg-share', given=f'{match[1]}/{match[2]}', package=match[1], rest=match[2])


CALL_SYNTAX = about(
    'launch.call-syntax',
    what="launch cannot read '{text}': at column {column}, it expects {expected_there}",
    do='check that brackets are closed, that quotes come in pairs, and that one space precedes each argument',
)
OPEN_QUOTE = about('launch.open-quote', what="a quote in '{text}' is not closed", do='close the quote before a $(...) begins')
ONLY_VALUE = about('launch.only-value', what="'{attribute}' does not accept this value", do='use one of these values: {allowed}')
NUMBER_ONLY = about(
    'launch.number-only',
    what="'{attribute}' must be a number, and ROS 2 does not evaluate a $(...) there",
    do='write the number itself, or write this part of the launch file in Python',
)
PARAM_ELEMENT = about(
    'launch.param-element', what='{shown} needs a name and a value, or a file', do="add name and value, or from='a file'"
)
ELEMENT = about(
    'launch.element',
    what=('{shown} has both {one} and {other}, but only one of the two is allowed', '{shown} is not valid here'),
    do=('remove {one} or {other} from this {shown}', 'remove {shown}, or correct it as the error message says'),
)
ROOT = about(
    'launch.root', what="the outermost element is {shown}, not 'launch'", do="put everything into one element named 'launch'"
)
EMPTY_FILE = about(
    'launch.empty-file',
    what='this launch file is empty',
    do=("start the file with <launch>, or in YAML with 'launch:' and a list below it"),
)
NOT_CLOSED = about(
    'launch.not-closed',
    what='the element <{tag}> that starts on line {opened} is not closed',
    do=('write </{tag}> where the element ends'),
)


@rule(
    'launch.unreadable',
    what='launch cannot read this file: {problem}',
    do=(
        'replace {dashes} in the comment with another character: XML allows it only at the start and the end of a comment',
        'write &amp; in place of each {ampersand} in that line, because & begins an entity in XML',
        'check brackets, quotes and indentation in that line and in the line above',
    ),
    level='error',
)
def unreadable(failure: Failure) -> Iterator[Finding]:
    """Report a file that is not valid XML or YAML. In XML, an ampersand or two dashes in a comment are common causes."""
    if failure.facts.get('about') == 'launch.unreadable':
        line = getline(failure.file or '', failure.line or 0)
        is_xml = not (failure.file or '').endswith(('.yaml', '.yml'))
        inside = re.search('<!--(.*)', line) if is_xml else None
        has_dashes = inside is not None and re.search('--(?!>)', inside[1]) is not None
        has_ampersand = is_xml and not has_dashes and re.search(r'&(?!#?\w+;)', line) is not None
        yield report(failure, dashes='--' if has_dashes else None, ampersand='&' if has_ampersand else None)


YAML_TAB = about(
    'launch.yaml-tab', what='this line is indented with a tab', do=('indent with spaces, because YAML does not allow tabs')
)
YAML_ROOT = about(
    'launch.yaml-root',
    what=(
        "the top level of the file has {at_margin}, but only 'launch' is allowed there",
        "the file does not begin with 'launch:'",
    ),
    do="start the file with 'launch:' and indent everything else below it",
)
YAML_CHILDREN = about(
    'launch.yaml-children',
    what='the actions in {shown} must be a list',
    do=('start each action with a dash, as in `- {first_element}: ...`', "put the actions into a list below 'children:'"),
)
YAML_LIST = about(
    'launch.yaml-list',
    what='{shown} must contain a list',
    do=('write a list below it, and start each item with a dash, as in `- node: ...`'),
)
YAML_ITEM = about(
    'launch.yaml-item',
    what=(
        "{below} is not below '{opened}', because it is not indented further than '{opened}'",
        'one item of {shown} contains several elements: {several}',
        'an item of {shown} is not an element',
    ),
    do=(
        'indent {below} by two columns more than {opened}',
        'write a dash before each of {several}, and indent the keys below each by two more spaces',
        'write the name of the element with a colon and its content below it, as in `- node: ...`',
    ),
)
YAML_DASHES = about(
    'launch.yaml-dashes', what='the keys of {shown} are written as a list', do='remove the dashes, as in `{key}: ...`'
)
YAML_BARE = about(
    'launch.yaml-bare', what="{shown} has a value without a key; the key is '{key}'", do="write {element}: {{{key}: '{value}'}}"
)
YAML_TYPE = about(
    'launch.yaml-type',
    what="the value of '{key}' has the wrong type for {shown}",
    do=('write {key}: {write}', "look up the type in ROS 2's documentation on launch files"),
)
YAML_LIST_OF = about(
    'launch.yaml-list-of', what="'{key}' of {shown} must be a list", do=('start each item with a dash, as in `- {{...}}`')
)
YAML_NOTHING = about(
    'launch.yaml-nothing', what='{shown} has no value after its colon', do='write {element}: {{}} if the element has no keys'
)
