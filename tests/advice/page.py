"""`docs/advice.md` and `docs/advice/`: every rule with its failing example and what edulaunch reports. `python -m tests.advice.page` writes them."""

from __future__ import annotations

import difflib
import json
import sys
from collections.abc import Iterator
from pathlib import Path

import edulaunch
from edulaunch.advice.reference import PAGES, ReferencePage, anchor_of, page_of
from edulaunch.advice.rule import GROUPS, Rule, all_rules, rules_over
from tests.advice.harness import EXAMPLES, WITHOUT, example

DOCS = Path(__file__).parents[2] / 'docs'
HEAD = """# Advice

Many mistakes in ROS 2 raise no error: nothing happens, and no message explains why. edulaunch checks each run, launch file and package with the rules
on these pages. It reports what is wrong, where, and what to do. You see this advice:

- at the end of `ros2 launch`, `ros2 run`, `edulaunch launch` and `edulaunch.run`, at most five messages (`--quiet` hides them);
- below a notebook's cell, and in `recording.warnings`; `recording.advice` has the findings as data;
- in the live view and the replay, as a mark on the node, topic or frame;
- in reports of `edugrade`, as the likely cause of a failed check;
- from `ros2 doctor` for running programs, and from `edulaunch doctor FILE|FOLDER|RECORDING|PACKAGE` for everything else.

`edulaunch explain RULE` prints a rule with an example and its page. Most rules are certain. If a rule cannot know what you meant, its page says so.
As data, a finding has the `confidence` `stated` or `asked`.

`LANG`, `LC_ALL` and `LANGUAGE` select the language, and `EDULAUNCH_LANG=de` selects German. Recordings are the same in every language.

`python -m tests.advice.page` writes these pages from the rules and their examples, which are tests (`tests/advice/examples`).
"""
SHOWN = Path(edulaunch.__file__).parent / 'advice' / 'examples.json'
KINDS = {
    'workspaces': 'a workspace',
    'errors': 'an error message',
    'plans': 'a launch file',
    'recordings': 'a run',
    'scripts': 'a launch file and its runs',
    'sources': "a package's files",
}
TOPICS = {
    'launch-errors': 'errors of launch files',
    'launch-files': 'launch files before they run',
    'launch-runs': 'launch files that ran',
    'programs-errors': 'errors of programs',
    'programs-runs': 'programs that ran',
    'messages-errors': 'errors of messages and services',
    'messages-runs': 'messages and services of a run',
    'packages-errors': 'errors of packages',
    'packages-files': 'files of a package',
    'packages-workspaces': 'workspaces',
    'tf': 'tf',
    'time': 'time',
    'turtlesim': 'turtlesim',
    'grader': 'the grader',
}
"""What the rules of a page are about, by its name without the letters."""
LANGUAGES = {'.py': 'python', '.xml': 'xml', '.yaml': 'yaml', '.txt': 'cmake', '.md': 'text'}


def documents() -> dict[str, str]:
    """Return the content of each page by its path in docs/."""
    return {'advice.md': _index(), **{f'advice/{page.name}.md': _page(page) for page in PAGES if _rules_of(page)}}


def _rules_of(page: ReferencePage) -> list[Rule]:
    return [rule for rule in all_rules().values() if page_of(rule) == page]


def _index() -> str:
    """Return the page with the names of all rules, by group."""
    lines = [HEAD, f'There are {len(all_rules())} rules. Select one to read what it reports.']
    for group in GROUPS:
        pages = [page for page in PAGES if page.group == group and _rules_of(page)]
        if pages:
            lines += ['', f'## {group}', '']
            for page in pages:
                links = (f'[{rule.name.partition(".")[2]}](advice/{page.name}.md#{anchor_of(rule)})' for rule in _rules_of(page))
                lines += [f'- **{_title(page)}**: ' + ', '.join(links)]
    return '\n'.join(lines) + '\n'


def _title(page: ReferencePage) -> str:
    """Return the title of a page, such as 'errors of launch files: a to e'."""
    topic = max((name for name in TOPICS if page.name.startswith(name)), key=len)
    if page.name == topic:
        return TOPICS[topic]
    ends = [page.first] if page.first == page.last else [page.first, page.last]
    return f'{TOPICS[topic]}: {" to ".join(ends)}'


def _page(page: ReferencePage) -> str:
    """Return the page that describes some rules."""
    kinds = {rule.name: kind for kind in KINDS for rule in rules_over(kind)}
    lines = [f'# Advice on {_title(page)}', '', '[Advice](../advice.md) lists all rules and explains these pages.']
    for rule in _rules_of(page):
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
    yield f'## {rule.name}'
    yield ''
    lesson = f' See `lessons/{rule.lesson}.ipynb`.' if rule.lesson else ''
    doubt = ' It cannot know what you meant.' if rule.confidence == 'asked' else ''
    yield f'This rule checks {KINDS[kind]}. Its level is *{rule.level}*.{doubt}{lesson}'
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
    for heading, others in (('Other files', [names[file] for file in same]), ('The correct package also has', missing)):
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
    (DOCS / 'advice').mkdir(exist_ok=True)
    written = documents()
    for old in (DOCS / 'advice').glob('*.md'):
        if f'advice/{old.name}' not in written:
            old.unlink()
    for name, text in written.items():
        (DOCS / name).write_text(text, encoding='utf-8')
    SHOWN.write_text(examples(), encoding='utf-8')
    sys.stdout.write(f'{len(written)} pages: {len(all_rules())} rules\n')
