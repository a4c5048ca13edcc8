"""The documents name what is there: files, pages and parts of the reference. `.ci/run` builds the pages and checks their links."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path
from typing import Any

import pytest
import yaml

from tests.house import ROOT, modules, tree
from tests.lessons.notebook import ORDER, Lesson

DOCS = ROOT / 'docs'
ENGINE = ROOT / 'edulaunch' / 'engine'
PAGES = sorted(path.relative_to(DOCS).as_posix() for path in DOCS.rglob('*.md'))


def test_every_page_is_in_the_navigation() -> None:
    nav = yaml.safe_load((ROOT / 'mkdocs.yml').read_text('utf-8'))['nav']
    assert [next(iter(entry)) for entry in nav[1:]] == ['Tutorials', 'How-to guides', 'Reference', 'Explanation']
    assert sorted(_pages_of(nav)) == PAGES


def _pages_of(entries: list[Any]) -> list[str]:
    """Return the pages of the navigation, of each level."""
    return [page for entry in entries for page in ([entry] if isinstance(entry, str) else _pages_of(next(iter(entry.values()))))]


@pytest.mark.parametrize('page', PAGES)
def test_no_page_is_long(page: str) -> None:
    """A page has one purpose; a list of rules is split by the first letters of their names."""
    assert len((DOCS / page).read_text('utf-8').split()) <= 1500


@pytest.mark.parametrize('page', PAGES)
def test_anchors_of_links_are_headings(page: str) -> None:
    for name, anchor in re.findall(r'\]\(([\w./-]*\.md)?#([\w-]+)\)', (DOCS / page).read_text('utf-8')):
        target = (DOCS / page).parent / name if name else DOCS / page
        assert anchor in _anchors(target), f'{name}#{anchor}'


@cache
def _anchors(page: Path) -> set[str]:
    """Return the anchors that mkdocs and GitHub make of the headings of a page."""
    headings = re.findall(r'^#+ (.+)$', re.sub(r'```.*?```', '', page.read_text('utf-8'), flags=re.S), re.M)
    return {re.sub(r'\s+', '-', re.sub(r'[^\w\s-]', '', heading).strip().lower()) for heading in headings}


@pytest.mark.parametrize(
    'page',
    [
        'architecture.md',
        'engine_parts.md',
        'confinement.md',
        'contributing.md',
        'how_to_add.md',
        'in_the_browser.md',
        'network_measured.md',
    ],
)
def test_the_files_that_a_page_names_are_there(page: str) -> None:
    text = re.sub(r'```.*?```', '', (DOCS / page).read_text('utf-8'), flags=re.S)
    known = {
        path.relative_to(ROOT).as_posix() for folder in ('edulaunch', 'grader', 'tests') for path in (ROOT / folder).rglob('*.py')
    }
    named = [name for name in re.findall(r'`([\w/]+\.py)`', text) if 'crane' not in name and 'platform_views' not in name]
    assert named
    assert [name for name in named if not any(f'/{path}'.endswith(f'/{name}') for path in known)] == []


def test_the_sample_report_is_what_edugrade_prints() -> None:
    """The golden report of the starter file has each line of the sample, in its order."""
    sample = re.search(r'```\n\$ edugrade exercises/circle.launch.py\n(.*?)```', (DOCS / 'grading.md').read_text('utf-8'), re.S)
    assert sample
    printed = iter((ROOT / 'tests' / 'grader' / 'golden' / 'stub' / 'report.txt').read_text('utf-8').splitlines())
    wanted = [
        line.replace('exercises/', '') for line in sample[1].splitlines()[1:] if line not in ('', '...') and 'try: ' not in line
    ]
    missing = [line for line in wanted if line not in printed]
    assert missing == []


def test_the_times_of_the_first_week_are_those_of_the_lessons() -> None:
    rows = re.findall(r'^\| `(\d\d_\w+)` \| (\d+) \|$', (DOCS / 'first_week.md').read_text('utf-8'), re.M)
    assert [name for name, _ in rows] == [*ORDER]
    for name, minutes in rows:
        text = '\n'.join(cell.source for cell in Lesson(name).cells if cell.kind == 'markdown')
        assert f'about {minutes} minutes' in text, name


@pytest.mark.parametrize('page', PAGES)
def test_links_between_pages_lead_somewhere(page: str) -> None:
    links = re.findall(r'\]\(([\w./-]+\.md)', (DOCS / page).read_text('utf-8'))
    assert [link for link in links if not (DOCS / page).parent.joinpath(link).is_file()] == []


def test_the_files_of_the_three_walks_are_there() -> None:
    walks = (DOCS / 'walks.md').read_text('utf-8').split('\n## ')[1:]
    assert len(walks) == 3
    for walk in walks:
        before = ''
        for cell in re.findall(r'^\| (.*?) \|', walk, re.M):
            for name in re.findall(r'`([\w./]+?\.py|[\w/]+/)`', cell):
                path = _path(name, before)
                assert path.exists(), f'{name}: {path}'
                before = name


def test_the_engine_can_be_read_in_an_hour() -> None:
    text = (DOCS / 'engine.md').read_text('utf-8')
    ways = text[text.index('## Reading order') : text.index('## What to read next')].split('\n### ')[1:]
    steps = [re.findall(r'^\| `([\w/]+\.py)` \| .*\? \|$', way, re.M) for way in ways]
    assert [step[0].partition('/')[0] for step in steps] == ['sim', 'interfaces', 'packages', 'recording', 'tf', 'worlds']
    lines = {name: (ENGINE / name).read_text('utf-8').count('\n') for step in steps for name in step}
    assert {name: count for name, count in lines.items() if count > 200} == {}, 'over 200 lines: split it, or name another'
    others = re.findall(r'`((?:sim|processes|recording|interfaces)/[\w/]*(?:\.py)?)`', text)
    assert [name for name in others if not (ENGINE / name).exists()] == []


def _path(name: str, before: str) -> Path:
    if name.startswith('.../'):
        name = before.rpartition('/')[0] + name[3:]
    if name.startswith('u/'):
        return ROOT / 'edulaunch' / 'ros' / 'python' / name[2:]
    base = ROOT / 'grader' if name.startswith(('edugrade/', 'checks/')) else ROOT / 'edulaunch'
    return base / name


@pytest.mark.parametrize('page', [page for page in PAGES if page.startswith('reference/')])
def test_the_reference_names_what_is_there(page: str) -> None:
    names = re.findall(r'^::: ([\w.]+)$', (DOCS / page).read_text('utf-8'), re.M)
    assert names
    for name in names:
        module, _, part = (name, '', '') if name in modules() else name.rpartition('.')
        assert module in modules(), name
        known = {getattr(node, 'name', '') for node in tree(modules()[module]).body} | _passed_on(module)
        assert not part or part in known, name


def _passed_on(module: str) -> set[str]:
    return set(re.findall(r'\b\w+\b', modules()[module].read_text('utf-8'))) if modules()[module].name == '__init__.py' else set()
