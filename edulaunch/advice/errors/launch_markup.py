"""Launch files in XML and YAML."""

from __future__ import annotations

from collections.abc import Iterator

from edulaunch.advice.errors.about import about, report
from edulaunch.advice.rule import Failure, Finding, rule
from edulaunch.engine.nearest import nearest

HOMES = {
    # elements that stand inside others: (where, and what does it for everything that follows)
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
    # (element, what people write there): what it is called; many are names of ROS 1 or of the Python classes
    ('node', 'type'): 'exec',
    ('node', 'ns'): 'namespace',
    ('node', 'required'): 'on_exit',
    ('node', 'executable'): 'exec',
    ('node', 'package'): 'pkg',
    ('node', 'parameters'): 'param',
    ('node', 'arguments'): 'args',
    ('node', 'remappings'): 'remap',
    ('group', 'ns'): '<push_ros_namespace namespace="..."/>',
    ('include', 'ns'): '<push_ros_namespace namespace="..."/> in a <group>',
    ('arg', 'doc'): 'description',
    ('arg', 'value'): 'default',
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
    return INSTEAD.get((str(failure.facts.get('element')).replace('-', '_'), name))


@rule(
    'launch.unknown-element',
    what=(
        '{ros_1} is an element of ROS 1',
        '{shown} stands here by itself, and belongs inside {inside}',
        '{shown} is no launch element',
    ),
    do=(
        'write {near}',
        'put it inside {inside}, or write {for_all} for everything that follows',
        'put it inside {inside}',
        'take it out: ROS 2 has nothing like {ros_1}',
        'choose another one, such as node, include, arg, group, let, log, timer or executable',
    ),
    level='error',
)
def unknown_element(failure: Failure) -> Iterator[Finding]:
    """An element that no action has, or not here."""
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
        "{shown} has no element '{as_attribute}': that is an attribute of it",
        "{shown} has no attribute '{as_element}': that is an element inside it",
        "{shown} knows no '{attribute}'",
    ),
    do=(
        'write {markup}',
        "write '{near}'",
        'write it as an attribute: {as_attribute}="..."',
        'write it as an element inside {shown}',
        'take it out, or look at the spelling',
    ),
    level='error',
    edits=(('{attribute}', '{near_name}'),),
)
def unknown_attribute(failure: Failure) -> Iterator[Finding]:
    """An attribute, key or child that the element does not have."""
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
    do=("write '{needed}' where you wrote '{near}'", "add '{needed}'"),
    level='error',
    edits=(('{near}', '{needed}'),),
)
def missing_attribute(failure: Failure) -> Iterator[Finding]:
    """What an element cannot do without."""
    if failure.facts.get('about') == 'launch.missing-attribute':
        needed, given = str(failure.facts.get('needed')), list(failure.facts.get('given_names') or ())
        near = next((one for one in given if _instead(failure, one) == needed), None) or nearest(needed, given)
        yield report(failure, near=near)


@rule(
    'launch.call',
    what=(
        '$({call} ...) is of ROS 1; here it is {instead}',
        '$({unknown} ...) is no substitution',
        '$({call} ...) is not written as it has to be',
    ),
    do=(
        'write {instead}',
        "put the whole expression into quotes: $({evaluated} '...')",
        'write $({near} ...)',
        'look at the arguments of $({written} ...): one space before each, quotes where it has spaces',
        'choose another one, such as $(var ...), $(env ...), $(find-pkg-share ...) or $(eval ...)',
    ),
    level='error',
    edits=(('$({call} ', '$({ros_2} '), ('$({call}', '$({near}')),
)
def call(failure: Failure) -> Iterator[Finding]:
    """A `$(name ...)` that is unknown or has the wrong arguments."""
    if failure.facts.get('about') == 'launch.call':
        name, is_known = str(failure.facts.get('call')), bool(failure.facts.get('is_known'))
        instead = ROS_1_CALLS.get(name)
        near = None if is_known else failure.facts.get('near')
        evaluated = name if name == 'eval' else None
        unknown, written = (None, name) if is_known else (name, None)
        ros_2 = {'arg': 'var', 'find': 'find-pkg-share'}.get(name)
        yield report(failure, instead=instead, near=near, evaluated=evaluated, unknown=unknown, written=written, ros_2=ros_2)


CALL_SYNTAX = about(
    'launch.call-syntax',
    what="'{text}' cannot be read: at column {column} comes something else than {expected_there}",
    do='look there: brackets closed, one space before each argument, quotes in pairs',
)
OPEN_QUOTE = about('launch.open-quote', what="in '{text}' a quote is not closed", do='close it before a $(...) begins')
ONLY_VALUE = about('launch.only-value', what="'{attribute}' cannot have this value", do='choose one of: {allowed}')
NUMBER_ONLY = about(
    'launch.number-only',
    what="'{attribute}' is a number in ROS 2, so a $(...) is not evaluated there",
    do='write the number itself, or this part in Python',
)
PARAM_ELEMENT = about(
    'launch.param-element', what='{shown} has neither a name nor a file', do="give it name and value, or from='a file'"
)
ELEMENT = about('launch.element', what='the mistake is in {shown}', do='compare it with the page about launch files of ROS 2')
ROOT = about(
    'launch.root', what="the outermost element is {shown}, not 'launch'", do='put everything into one element called launch'
)
EMPTY_FILE = about(
    'launch.empty-file', what='the launch file is empty', do="begin it with <launch>, or in YAML with 'launch:' and a list below"
)
NOT_CLOSED = about('launch.not-closed', what='<{tag}> of line {opened} is not closed', do='write </{tag}> where it ends')
UNREADABLE = about(
    'launch.unreadable',
    what='the file cannot be read: {problem}',
    do='look at that line and the one above it: brackets, quotes, indentation',
)
YAML_TAB = about('launch.yaml-tab', what='a tab stands in the indentation', do='indent with spaces: YAML takes no tabs')
YAML_ROOT = about(
    'launch.yaml-root',
    what=("at the left margin stand {at_margin}; only 'launch' may stand there", "the file does not begin with 'launch:'"),
    do="begin the file with 'launch:' and put everything else below it",
)
YAML_CHILDREN = about(
    'launch.yaml-children',
    what='{shown} has its actions without a list',
    do=('begin each of them with a dash: - {first_element}: ...', "put them into a list below 'children:'"),
)
YAML_LIST = about('launch.yaml-list', what='{shown} needs a list', do='put a list below it, each item with a dash: - node: ...')
YAML_ITEM = about(
    'launch.yaml-item',
    what=('{several} stand in one item of {shown}', 'an item of {shown} is no element'),
    do=(
        'write a dash for each of {several}, and its keys two columns further',
        "write the element's name with a colon, and below it what it has: - node: ...",
    ),
)
YAML_DASHES = about('launch.yaml-dashes', what='the keys of {shown} stand in a list', do='take the dashes away: {key}: ...')
YAML_BARE = about(
    'launch.yaml-bare', what="{shown} has a bare value, and needs the key '{key}'", do="write {element}: {{{key}: '{value}'}}"
)
YAML_TYPE = about(
    'launch.yaml-type',
    what="the value of '{key}' is of another type than {shown} takes",
    do=('write {key}: {write}', 'look into the page about launch files for its type'),
)
YAML_LIST_OF = about('launch.yaml-list-of', what="'{key}' of {shown} needs a list", do='begin each item with a dash: - {{...}}')
YAML_NOTHING = about(
    'launch.yaml-nothing', what='{shown} has nothing behind its colon', do='write {element}: {{}} when it has no keys'
)
