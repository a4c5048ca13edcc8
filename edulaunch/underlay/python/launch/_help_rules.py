"""What is said about which error. Each rule gets the error and its text, and gives one line or None."""

from __future__ import annotations

import os
import re
from collections.abc import Callable
from typing import NamedTuple

from edulaunch.nearest import nearest
from edulaunch.packages.absent import absent_module_kind

from ._absent_packages import absent_file
from ._engine import running_process
from ._help import frames_of, launch_origin, local_of
from ._known_names import class_named, home_of, import_line, keywords_of, names_in, nearest_anywhere
from .launch_description_entity import LaunchDescriptionEntity

Advice = Callable[[BaseException, str], str | None]

OLD_KEYWORDS = {
    'node_name': 'name',
    'node_executable': 'executable',
    'node_namespace': 'namespace',
    'pkg': 'package',
    'exec': 'executable',
    'args': 'arguments',
    'params': 'parameters',
    'remap': 'remappings',
    'ns': 'namespace',
    'default': 'default_value',
    'message': 'msg',
    'text': 'msg',
    'delay': 'period',
    'launch_args': 'launch_arguments',
    'command': 'cmd',
    'func': 'function',
}


class Rule(NamedTuple):
    """Help for errors of one type."""

    error_type: type[BaseException] | tuple[type[BaseException], ...]
    advise: Advice


def _match(pattern: str, text: str) -> re.Match[str] | None:
    return re.search(pattern, text, re.DOTALL)


def _import_of_name(error: BaseException, text: str) -> str | None:
    found = _match(r"cannot import name '(\w+)' from '([\w.]+)'", text) or _match(
        r"(?:partially initialized )?module '([\w.]+)' has no attribute '(\w+)'", text
    )
    if found is None:
        return None
    name, module = found.groups() if text.startswith('cannot') else found.groups()[::-1]
    home = home_of(name)
    if home is not None and home != module:
        return f'{name} lives in {home}'
    near = nearest(name, names_in(module))
    if near is not None:
        return f"did you mean '{near}'?"
    elsewhere = nearest_anywhere(name)
    return f"did you mean '{elsewhere}' from {home_of(elsewhere)}?" if elsewhere is not None else None


def _relative_import(error: BaseException, text: str) -> str | None:
    if not text.startswith('attempted relative import'):
        return None
    return (
        'a launch file belongs to no package: put the shared code into your Python package, '
        'and write from my_package.module import ... without the leading dot'
    )


def _missing_module(error: BaseException, text: str) -> str | None:
    from ._known_names import MODULES

    found = _match(r"No module named '([\w.]+)'", text)
    if found is None:
        return None
    place = launch_origin(error)
    if place is not None and os.path.isfile(os.path.join(os.path.dirname(place[0]), f'{found[1]}.py')):
        return f"the launch file's own folder is not searched: move {found[1]}.py into your Python package"
    top = found[1].partition('.')[0]
    kind = absent_module_kind(top)
    if kind is not None:
        return f'the module {top!r} ({kind}) is not here'
    near = nearest(found[1], MODULES)
    if near is not None and near != found[1]:
        return f"did you mean 'from {near} import ...'?"
    own = f'if {top!r} is a package of yours, go to its workspace or name that with --workspace DIR'
    return f'{own}; if it is not, try: pip install {top}'


def _unknown_name(error: BaseException, text: str) -> str | None:
    found = _match(r"name '(\w+)' is not defined", text)
    if found is None:
        return None
    name = found[1]
    if _raised_in_expression(error):
        return (
            f'the text {name} stands bare in a PythonExpression: put quotes around the substitution, '
            "as in [\"'\", LaunchConfiguration('x'), \"' == 'text'\"]"
        )
    if name in ('true', 'false', 'null', 'none'):
        return f'Python writes {({"null": "None", "none": "None"}).get(name, name.capitalize())}'
    line = import_line(name)
    if line is not None:
        return f'add the line: {line}'
    near = nearest_anywhere(name)
    return f"did you mean '{near}' ({import_line(near)})?" if near is not None else None


def _raised_in_expression(error: BaseException) -> bool:
    frames = [frame for frame, _ in frames_of(error)]
    return len(frames) > 1 and frames[-1].f_code.co_filename == '<string>' and 'substitutions' in frames[-2].f_code.co_filename


def _bad_expression(error: BaseException, text: str) -> str | None:
    from .substitutions.python_expression import PythonExpression

    if isinstance(local_of(error, 'self'), PythonExpression):
        expression = local_of(error, 'self').describe()
        return f'the expression is {expression}: check quotes and spaces where its parts meet'
    return None


def _unexpected_keyword(error: BaseException, text: str) -> str | None:
    found = _match(r"(\w+)\.__init__\(\) got an unexpected keyword argument '(\w+)'", text)
    if found is None:
        return None
    made = next((frame.f_locals.get('self') for frame, _ in frames_of(error) if frame.f_code.co_name == '__init__'), None)
    cls = type(made) if made is not None else class_named(found[1])
    if cls is None:
        return None
    keywords, name = keywords_of(cls), found[2]
    near = OLD_KEYWORDS.get(name) if OLD_KEYWORDS.get(name) in keywords else nearest(name, keywords)
    if near is not None:
        return f'{cls.__name__} has no {name}=; did you mean {near}=?'
    return f'{cls.__name__} knows {", ".join(f"{keyword}=" for keyword in keywords)}'


def _positional(error: BaseException, text: str) -> str | None:
    found = _match(r'(\w+)\.__init__\(\) takes \d+ positional arguments? but \d+ were given', text)
    cls = class_named(found[1]) if found is not None else None
    if cls is None:
        return None
    if 'actions' in keywords_of(cls):
        return f'one list is expected: {cls.__name__}([..., ...])'
    code = cls.__init__.__code__
    first = code.co_varnames[code.co_argcount : code.co_argcount + code.co_kwonlyargcount]
    return f'give the arguments by name: {cls.__name__}({first[0]}=...)' if first else None


def _missing_keyword(error: BaseException, text: str) -> str | None:
    """A misspelt one is taken for one of the many that an action passes on, so that only its absence is seen."""
    found = _match(r"(\w+)\.__init__\(\) missing \d+ required (?:keyword-only|positional) arguments?: '(\w+)'", text)
    place = launch_origin(error)
    if found is None or place is None:
        return None
    import linecache

    text = ''.join(linecache.getline(place.file, line) for line in range(place.line, place.line + 8))
    calls = re.split(rf'\b{found[1]}\(', text, flags=re.IGNORECASE)  # the class PushROSNamespace has a second spelling
    cls = class_named(found[1])
    known = keywords_of(cls) if cls is not None else ()
    given = [name for name in re.findall(r'(\w+)\s*=', calls[1]) if name not in known] if len(calls) > 1 else []
    near = nearest(found[2], given)
    return f'{found[1]} needs {found[2]}=...' + (f'; did you mean that by {near}=?' if near is not None else '')


def _not_a_text(error: BaseException, text: str) -> str | None:
    """A number, boolean or path where texts and substitutions are expected."""
    if _match(r"'(int|float|bool|PosixPath|WindowsPath)' object is not iterable", text):
        value = local_of(error, 'subs')
    elif text.startswith('Failed to normalize given item of type'):
        value = local_of(error, 'item')
    else:
        return None
    keyword = _keyword_with(error, value)
    if isinstance(value, (int, float)):
        shown = str(value).lower()
        return f"{keyword}{value!r} must be a text: write {keyword}'{shown}'"
    if isinstance(value, os.PathLike):
        return f'a path must be a text here: write {keyword}str(...)'
    if isinstance(value, (list, tuple)):
        return 'a list inside a list of substitutions: take the inner brackets away'
    return f'only texts and substitutions can stand here, not {type(value).__name__}'


def _keyword_with(error: BaseException, value: object) -> str:
    for frame, _ in reversed(list(frames_of(error))):
        if frame.f_code.co_name == '__init__':
            for name, known in frame.f_locals.items():
                if known is value:
                    return f'{name}='
    return ''


def _wrong_type(error: BaseException, text: str) -> str | None:
    found = _match(r"xpected '(\w+)' to be one of \[(.*)\], but got '(.*)' of type '<class '(.*)'>'", text)
    if found is None:
        return None
    name, expected, value, actual = found.groups()
    if expected in ("<class 'list'>", "<class 'collections.abc.Iterable'>"):
        return f'put it into a list: {name}=[...]'
    if actual == 'int' and 'float' in expected:
        return f'write {name}={value}.0'
    if name == 'remap_rule':
        return "each remapping is a pair in round brackets: ('from', 'to')"
    return None


def _no_pairs(error: BaseException, text: str) -> str | None:
    from .actions.include_launch_description import IncludeLaunchDescription

    if 'values to unpack' in text and isinstance(local_of(error, 'self'), IncludeLaunchDescription):
        return 'launch_arguments needs (name, value) pairs: add .items() to the dictionary'
    return None


def _not_a_list(error: BaseException, text: str) -> str | None:
    found = _match(r"'(\w+)' object is not iterable", text)
    cls = class_named(found[1]) if found is not None else None
    if isinstance(cls, type) and issubclass(cls, LaunchDescriptionEntity):
        return f'a list is expected: put the {cls.__name__} into [ ]'
    return None


def _missing_comma(error: BaseException, text: str) -> str | None:
    found = _match(r"'(\w+)' object is not (callable|subscriptable)", text)
    if found is None:
        return None
    cls = class_named(found[1])
    if cls is None and found[1] not in ('dict', 'tuple', 'list', 'str'):
        return None
    item = 'an item of a list' if cls is None else f'{cls.__name__}(...)'
    return f'perhaps a comma is missing after {item}'


def _not_an_entity(error: BaseException, text: str) -> str | None:
    found = _match(r"'(\w+)' object has no attribute '(\w+)'", text)
    if found is None:
        return None
    kind, attribute = found.groups()
    if attribute.startswith('get_launch_arguments') and kind == 'NoneType':
        return 'generate_launch_description() returned nothing: end it with "return LaunchDescription([...])"'
    if attribute.startswith('get_launch_arguments'):
        return f'generate_launch_description() returned a {kind}: end it with "return LaunchDescription([...])"'
    if attribute == 'evaluate':
        return f'a condition is expected: put IfCondition(...) or UnlessCondition(...) around the {kind}'
    if attribute in ('visit', 'describe_sub_entities'):
        return f'among the entities is a {kind}: a list of actions holds only actions and launch descriptions'
    return None


def _no_generate(error: BaseException, text: str) -> str | None:
    if 'does not contain the required function' not in text:
        return None
    near = getattr(error, 'edulaunch_near', None)
    if near is not None:
        return f'rename {near}() to generate_launch_description()'
    return 'a launch file needs: def generate_launch_description(): return LaunchDescription([...])'


def _too_deep(error: BaseException, text: str) -> str | None:
    if not text.startswith('maximum recursion depth'):
        return None
    return 'actions, includes or calls are nested too deep: is there one that leads to itself?'


def _missing_configuration(error: BaseException, text: str) -> str | None:
    found = _match(r"launch configuration '(.*)' does not exist", text)
    if found is None:
        return None
    context = local_of(error, 'context')
    near = nearest(found[1], context.launch_configurations) if context is not None else None
    if near is not None:
        return f"did you mean '{near}'?"
    if any(argument.name == found[1] for argument in running_process().state.get('launch.declared', ())):
        return (
            f"'{found[1]}' was set inside a GroupAction that is over by now (events and timers come later): "
            'give the group scoped=False, or take the value in an OpaqueFunction inside it'
        )
    return f"put DeclareLaunchArgument('{found[1]}', default_value='...') before its use"


def _missing_argument(error: BaseException, text: str) -> str | None:
    found = _match(r"missing required argument '(.*?)' .*given: \[(.*)\]", text)
    if found is None:
        return None
    near = nearest(found[1], [name for name in found[2].split(', ') if name])
    if near is not None:
        return f"'{near}' was given; did you mean '{found[1]}'?"
    return f'pass {found[1]}:=..., or give its DeclareLaunchArgument a default_value'


def _missing_environment(error: BaseException, text: str) -> str | None:
    found = _match(r"environment variable '(.*)' does not exist", text)
    if found is None:
        return None
    context = local_of(error, 'context')
    near = nearest(found[1], context.environment) if context is not None else None
    start = f"did you mean '{near}'? Or " if near is not None else ''
    return f"{start}give it a default: EnvironmentVariable('{found[1]}', default_value='...')"


def _no_actions(error: BaseException, text: str) -> str | None:
    if not text.startswith("expected all items in 'on_event' iterable"):
        return None
    return 'what is to happen then is an action, or a list of actions, such as Shutdown()'


def _bad_namespace(error: BaseException, text: str) -> str | None:
    if not text.startswith('The resulting namespace is invalid'):
        return None
    return "a namespace has letters, digits, '_' and '/' only, and no part of it begins with a digit"


def _executed_twice(error: BaseException, text: str) -> str | None:
    if 'executed more than once' not in text:
        return None
    return 'one action object starts one process: make a new one for each use'


def _condition(error: BaseException, text: str) -> str | None:
    if not text.startswith('invalid condition expression'):
        return None
    return 'conditions take true, 1, false or 0; compare texts with EqualsSubstitution(left, right)'


def _not_installed(error: BaseException, path: str) -> str | None:
    """A file that a package has in its source only. Kept with the error, for it may be told again after the run."""
    known: str | None = getattr(error, 'edulaunch_hint', None)
    if known is None:
        from edulaunch.workspace.hints import installed_file_hint

        from ._engine import running_process

        known = installed_file_hint(running_process().index, path)
        error.edulaunch_hint = known  # type: ignore[attr-defined]
    return known


def _missing_file(error: BaseException, text: str) -> str | None:
    path = getattr(error, 'filename', None)
    if not isinstance(path, str):
        return None
    not_installed = _not_installed(error, path)
    if not_installed is not None:
        return not_installed
    folder = os.path.dirname(path) or '.'
    absent = absent_file(path)
    if absent is not None:
        return absent
    if not os.path.isdir(folder):
        return f'there is no folder {folder}'
    near = nearest(os.path.basename(path), os.listdir(folder))
    return f"did you mean '{near}'?" if near is not None else None


RULES = (
    Rule(ModuleNotFoundError, _missing_module),
    Rule((ImportError, AttributeError), _import_of_name),
    Rule(ImportError, _relative_import),
    Rule(NameError, _unknown_name),
    Rule((NameError, SyntaxError, TypeError), _bad_expression),
    Rule(AttributeError, _not_an_entity),
    Rule(TypeError, _unexpected_keyword),
    Rule(TypeError, _positional),
    Rule(TypeError, _missing_keyword),
    Rule(TypeError, _not_a_text),
    Rule(TypeError, _wrong_type),
    Rule((TypeError, ValueError), _no_pairs),
    Rule(TypeError, _not_a_list),
    Rule(TypeError, _missing_comma),
    Rule(TypeError, _no_actions),
    Rule(RuntimeError, _bad_namespace),
    Rule(RecursionError, _too_deep),
    Rule(RuntimeError, _missing_configuration),
    Rule(RuntimeError, _missing_argument),
    Rule(RuntimeError, _executed_twice),
    Rule(Exception, _missing_environment),
    Rule(ValueError, _condition),
    Rule(FileNotFoundError, _missing_file),
    Rule(Exception, _no_generate),
)
