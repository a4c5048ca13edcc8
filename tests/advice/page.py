"""`docs/advice.md`: every rule with its failing example and what is told of it. `python -m tests.advice.page` writes it anew."""

from __future__ import annotations

import difflib
import json
import sys
from collections.abc import Iterator
from pathlib import Path

import edulaunch
from edulaunch.advice.rule import GROUPS, Rule, all_rules, rules_over
from tests.advice.harness import EXAMPLES, WITHOUT, example

PAGE = Path(__file__).parents[2] / 'docs' / 'advice.md'
HEAD = """# Advice

The commonest mistakes in ROS 2 raise no error: nothing happens, and nobody says why. edulaunch looks at each run, launch file and
package by the rules on this page and says what is wrong, where, and what to do. It says so

- at the end of `ros2 launch`, `ros2 run`, `edulaunch launch` and `edulaunch.run` (the worst five; `--quiet` is silent), also under a
  notebook's cell, and as `recording.warnings`; `recording.advice` has the findings as data,
- on the live view and the replay: a mark on the node, topic or frame opens the sentence,
- in the feedback of `edugrade`, as the likely cause of a check that failed,
- when asked: `ros2 doctor` for what runs, `edulaunch doctor FILE|FOLDER|RECORDING|PACKAGE [--json]` for everything else.

A rule *states* what it is sure of, and *asks* where it cannot know what was meant. `LANG`, `LC_ALL` and `LANGUAGE` choose the language as for other programs, and `EDULAUNCH_LANG=de` chooses German anywhere;
recordings have no sentences in them, and are the same in every language.

This page is made from the rules and their examples, which are tests (`tests/advice/examples`): `python -m tests.advice.page`.
"""
SHOWN = Path(edulaunch.__file__).parent / 'advice' / 'examples.json'
KINDS = {
    'workspaces': 'a workspace',
    'errors': 'an error',
    'plans': 'a launch file',
    'recordings': 'a run',
    'scripts': 'a launch file and its runs',
    'sources': "a package's files",
}
LANGUAGES = {'.py': 'python', '.xml': 'xml', '.yaml': 'yaml', '.txt': 'cmake', '.md': 'text'}


def page() -> str:
    """The text of the page."""
    rules = all_rules()
    kinds = {rule.name: kind for kind in KINDS for rule in rules_over(kind)}
    counted = {group: [rule for rule in rules.values() if rule.group == group] for group in GROUPS}
    lines = [
        HEAD,
        f'There are {len(rules)} rules: ' + ', '.join(f'{len(of)} on {group}' for group, of in counted.items() if of) + '.',
    ]
    for group, of_group in counted.items():
        if of_group:
            lines += ['', f'## {group}']
            for rule in of_group:
                lines += ['', *_section(rule, kinds[rule.name])]
    return '\n'.join(lines) + '\n'


def examples() -> str:
    """What `edulaunch explain RULE` shows: of each rule the difference between the failing and the healthy example."""
    found = {name: text for name in all_rules() if name not in WITHOUT and (text := _difference(name))}
    return json.dumps(found, indent=0, ensure_ascii=False) + '\n'


def _difference(rule: str) -> str:
    failing, healthy = example(rule, 'failing'), example(rule, 'healthy')
    pairs = [(failing, healthy)]
    if failing.is_dir():
        names = {file.relative_to(place) for place in (failing, healthy) for file in place.rglob('*') if file.is_file()}
        pairs = [(failing / name, healthy / name) for name in sorted(names) if '__pycache__' not in name.parts]
    lines: list[str] = []
    for one, other in pairs:
        texts = [_text(file).splitlines() if file.is_file() else [] for file in (one, other)]
        changed = list(difflib.unified_diff(*texts, n=2, lineterm=''))[2:]
        lines += [f'{one.name}:', *(line for line in changed if not line.startswith('@@'))] if changed else []
    return '\n'.join(lines[:60])


def _section(rule: Rule, kind: str) -> Iterator[str]:
    yield f'### {rule.name}'
    yield ''
    lesson = f', lesson `lessons/{rule.lesson}.ipynb`' if rule.lesson else ''
    yield f'Looks at {KINDS[kind]}; {rule.level}, {rule.confidence}{lesson}.'
    if rule.name in WITHOUT:
        yield ''
        yield f'> {rule.what[0]}'
        return
    yield from _example(example(rule.name, 'failing'))
    yield ''
    yield '```text'
    yield (EXAMPLES / rule.name / 'told.txt').read_text(encoding='utf-8').partition('\n\n')[0].rstrip()
    yield '```'


def _example(path: Path) -> Iterator[str]:
    """The file of an example; of a folder those that differ from the healthy one, and the names of the others."""
    if path.is_file():
        yield from _shown(path, path.name)
        return
    healthy = path.with_name('healthy')
    files = [file for file in sorted(path.rglob('*')) if file.is_file() and '__pycache__' not in file.parts]
    names = {file: file.relative_to(path).as_posix() for file in files}
    same = [file for file in files if (twin := healthy / names[file]).is_file() and twin.read_bytes() == file.read_bytes()]
    for file in files:
        if file not in same:
            yield from _shown(file, names[file])
    gone = [twin.relative_to(healthy).as_posix() for twin in sorted(healthy.rglob('*')) if twin.is_file()]
    missing = [name for name in gone if name not in names.values() and '__pycache__' not in name]
    for heading, others in (('Beside it', [names[file] for file in same]), ('The healthy one has', missing)):
        if others:
            yield ''
            yield f'{heading}: {", ".join(f"`{name}`" for name in others)}.'


def _shown(file: Path, name: str) -> Iterator[str]:
    text = _text(file)
    yield ''
    yield f'`{name}`' + ('' if text.strip() else ' (empty)')
    if text.strip():
        yield ''
        yield f'```{LANGUAGES.get(file.suffix, "text")}'
        yield text.rstrip()
        yield '```'


def _text(file: Path) -> str:
    try:
        return file.read_text(encoding='utf-8')
    except UnicodeDecodeError:
        return f'(not UTF-8: begins with the bytes {file.read_bytes()[:8].hex(" ")})'


if __name__ == '__main__':
    edulaunch.source()
    PAGE.write_text(page(), encoding='utf-8')
    SHOWN.write_text(examples(), encoding='utf-8')
    sys.stdout.write(f'{PAGE.name}: {len(all_rules())} rules\n')
