"""The documents name what is there: files, pages and parts of the reference. `.ci/run` builds the pages and checks their links."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
import yaml

from tests.house import ROOT, modules, tree

DOCS = ROOT / 'docs'
ENGINE = ROOT / 'edulaunch' / 'engine'
PAGES = sorted(path.relative_to(DOCS).as_posix() for path in DOCS.rglob('*.md'))


def test_every_page_is_in_the_navigation() -> None:
    text = (ROOT / 'mkdocs.yml').read_text('utf-8')
    nav = yaml.safe_load(text)['nav']
    named = [page for entry in nav for page in ([entry] if isinstance(entry, str) else next(iter(entry.values())))]
    assert sorted(named) == PAGES


@pytest.mark.parametrize('page', PAGES)
def test_links_between_pages_lead_somewhere(page: str) -> None:
    links = re.findall(r'\]\(([\w./-]+\.md)', (DOCS / page).read_text('utf-8'))
    assert [link for link in links if not (DOCS / page).parent.joinpath(link).is_file()] == []


def test_the_files_of_the_three_walks_are_there() -> None:
    text = (DOCS / 'architecture.md').read_text('utf-8')
    walks = text[text.index('## Three walks') :].split('\n### ')[1:]
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
    ways = text[text.index('## The way') : text.index('## What to read next')].split('\n### ')[1:]
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
