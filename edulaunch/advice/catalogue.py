"""Update the catalogues of all languages: `python -m edulaunch.advice.catalogue`.

The English sentence is the key of its translation. In `locale/LANGUAGE/LC_MESSAGES/advice.po`, new sentences have no
translation. Changed sentences are marked `fuzzy`, so users read them in English. To add a language, create its folder. The
command needs Babel (`pip install '.[dev]'`).
"""

from __future__ import annotations

import ast
import os
import re
from collections.abc import Iterator
from datetime import datetime, timezone
from typing import TYPE_CHECKING

from edulaunch.advice.reader import LOCALE, catalogue_file
from edulaunch.advice.rule import all_rules

if TYPE_CHECKING:
    from babel.messages.catalog import Catalog

HOUSE = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
GRADER = os.path.join(os.path.dirname(HOUSE), 'grader')
ROOMS = ('advice', 'desk')
"""Folders of edulaunch that are searched for `says('...')`."""
REPORTS = (
    'checks',
    'edugrade/library',
    *(f'edugrade/rubrics/{name}.py' for name in ('yaml_behaviour', 'yaml_checks', 'yaml_movement')),
    *(
        f'edugrade/{name}.py'
        for name in ('attempts', 'evidence', 'faults', 'grading', 'judging', 'repeated', 'results', 'verdicts')
    ),
    *(f'edugrade/reports/{name}.py' for name in ('terminal', 'wording')),
)
"""Folders of the grader in which every string that is a sentence may be shown to a student."""
_FIELD, _WORD = re.compile(r'\{\w*\}'), re.compile(r'(?<![\w/.{])[A-Za-z][a-z]+(?![\w(=])')
_CODE = re.compile(r'^[\w=]*\w+\(.*\)$|^\w+\.[\w-]+$|^\n|\(\?!|\\')
"""A call to be written unchanged, the name of a rule, or a regular expression."""
_FIXED = datetime(2026, 1, 1, tzinfo=timezone.utc)


def messages() -> dict[str, str]:
    """Return every sentence with its origin, which is the name of a rule or a module."""
    found: dict[str, str] = {}
    for rule in all_rules().values():
        for text in (*rule.what, *rule.why, *rule.do):
            found.setdefault(text, rule.name)
    for folder in ROOMS:
        for path in _python_files(os.path.join(HOUSE, folder)):
            for text in _given_to_says(_tree(path)):
                found.setdefault(text, f'edulaunch/{os.path.relpath(path, HOUSE)}')
    for place in REPORTS:
        for path in _python_files(os.path.join(GRADER, place)):
            for text in _sentences(_tree(path)):
                found.setdefault(text, f'grader/{os.path.relpath(path, GRADER)}')
    for name in sorted(os.listdir(os.path.join(GRADER, 'checks'))):
        if name.endswith('.yaml'):
            for text in _of_rubric(os.path.join(GRADER, 'checks', name)):
                found.setdefault(text, f'grader/checks/{name}')
    return found


def _of_rubric(path: str) -> Iterator[str]:
    """Yield the title of a YAML rubric, and the sentences of its checks that students read."""
    import yaml

    with open(path, encoding='utf-8') as file:
        rubric = yaml.safe_load(file)
    texts = [rubric['title']]
    for check in rubric['checks']:
        advice = check.get('try', ())
        texts += [check.get('say'), *([advice] if isinstance(advice, str) else advice)]
    yield from (text.replace('{', '{{').replace('}', '}}') for text in texts if text)


def _given_to_says(tree: ast.AST) -> Iterator[str]:
    """Yield the strings that are arguments of `says(...)`."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr == 'says':
            yield from (value.value for value in node.args if isinstance(value, ast.Constant) and isinstance(value.value, str))


def _sentences(tree: ast.AST) -> Iterator[str]:
    """Yield the strings that consist of several words, and the first line of each check's docstring.

    F-strings become templates.
    """
    inner = {id(part) for node in ast.walk(tree) if isinstance(node, ast.JoinedStr) for part in node.values}
    inner |= {id(node.value) for node in ast.walk(tree) if isinstance(node, ast.Expr)}
    for node in ast.walk(tree):
        if isinstance(node, ast.FunctionDef) and any(map(_is_check, node.decorator_list)):
            yield (ast.get_docstring(node) or '').partition('\n')[0]
        # a kind of check in YAML; its fields are not sentences
        if isinstance(node, ast.Call) and ast.unparse(node.func) == 'kind':
            yield str(ast.literal_eval(node.args[0]))
            inner |= {id(part) for part in ast.walk(node)}
        # these tables contain names of fields
        if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) in ('MEASURE', 'PROGRAM'):
            inner |= {id(part) for part in ast.walk(node.value)}
        if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) in ('WORDS', 'KINDS'):
            yield from ast.literal_eval(node.value)
            inner |= {id(part) for part in ast.walk(node.value)}
        text = template_of(node) if id(node) not in inner else ''
        if len(_WORD.findall(_FIELD.sub('', text))) >= (1 if _FIELD.search(text) else 2) and not _CODE.search(text):
            yield text


def _is_check(decorator: ast.expr) -> bool:
    return ast.unparse(decorator).startswith('check(')


def template_of(node: ast.AST) -> str:
    """Return the string in a syntax node as a template, or an empty string if the node is not a string."""
    if isinstance(node, ast.Constant):
        return str(node.value).replace('{', '{{').replace('}', '}}') if isinstance(node.value, str) else ''
    if not isinstance(node, ast.JoinedStr):
        return ''
    names: set[str] = set()
    parts = []
    for part in node.values:
        if isinstance(part, ast.FormattedValue):
            name = re.sub(r'\W+', '_', ast.unparse(part.value)).strip('_')[:24] or 'value'
            while name in names:
                name += '_'
            names.add(name)
            parts.append(f'{{{name}}}')
        else:
            parts.append(template_of(part))
    return ''.join(parts)


def _python_files(folder: str) -> Iterator[str]:
    if not os.path.exists(folder):
        raise FileNotFoundError(f'{folder}: it has moved, and its sentences would be lost')
    if os.path.isfile(folder):
        yield folder
    for place, _, names in sorted(os.walk(folder)):
        yield from (os.path.join(place, name) for name in sorted(names) if name.endswith('.py'))


def _tree(path: str) -> ast.AST:
    with open(path, encoding='utf-8') as file:
        return ast.parse(file.read())


def languages() -> list[str]:
    """Return the languages that have a folder, sorted."""
    return sorted(name for name in os.listdir(LOCALE) if os.path.isdir(os.path.join(LOCALE, name)))


def missing(language: str) -> list[str]:
    """Return the names of the rules without a translation, from the file `missing.txt` of the language.

    Return an empty list if that file does not exist.
    """
    path = os.path.join(LOCALE, language, 'missing.txt')
    if not os.path.isfile(path):
        return []
    with open(path, encoding='utf-8') as file:
        return [line.strip() for line in file if line.strip() and not line.startswith('#')]


def read(language: str) -> Catalog:
    """Return the catalogue of a language. The catalogue of a new language is empty."""
    from babel.messages.catalog import Catalog
    from babel.messages.pofile import read_po

    if not os.path.isfile(catalogue_file(language)):
        return Catalog(language)
    with open(catalogue_file(language), 'rb') as file:
        return read_po(file, language)


def update(language: str) -> tuple[int, int]:
    """Write the catalogue of a language. Return the number of sentences, and the number of sentences without a translation."""
    from babel.messages.catalog import Catalog
    from babel.messages.pofile import write_po

    template = Catalog(project='edulaunch', creation_date=_FIXED)
    for text, where in messages().items():
        template.add(text, auto_comments=[where])
    catalogue = read(language)
    catalogue.update(template)
    catalogue.revision_date, catalogue.fuzzy = _FIXED, False
    catalogue.project, catalogue.version = 'edulaunch', '1'
    catalogue.msgid_bugs_address = catalogue.last_translator = catalogue.language_team = 'edulaunch'
    catalogue.header_comment = (
        f'# The sentences of edulaunch in the language {language!r}; `python -m edulaunch.advice.catalogue`'
    )
    with open(catalogue_file(language), 'wb') as file:
        write_po(file, catalogue, width=0, ignore_obsolete=True)
    lacking = [message for message in catalogue if message.id and (message.fuzzy or not message.string)]
    return len(catalogue), len(lacking)


def main() -> None:
    """Update the catalogue of every language, and print the number of missing translations."""
    for language in languages():
        print('{}: {} sentences, {} of them not translated'.format(language, *update(language)))


if __name__ == '__main__':
    main()
