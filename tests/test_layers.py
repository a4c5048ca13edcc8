"""A layer imports only from layers below it, and nothing imports in a circle."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
PACKAGE = ROOT / 'edulaunch'
BELOW = {
    'errors': set(),
    'nearest': set(),
    'underlay_place': set(),
    'sim': {'errors'},
    'interfaces': {'errors', 'underlay_place'},
    'tf': {'errors'},
    'worlds': {'errors'},
    'packages': {'errors', 'interfaces', 'underlay_place'},
    'workspace': {'packages', 'errors', 'underlay_place'},
    'graph': {'sim', 'interfaces', 'errors'},
    'processes': {'sim', 'graph', 'packages', 'interfaces', 'errors', 'underlay_place'},
    'recording': {'graph', 'sim', 'interfaces', 'errors'},
    'canvas': {'recording'},
    'sourcing': {'errors', 'interfaces', 'packages', 'underlay_place'},
    'plan': {'packages', 'processes', 'sim', 'graph', 'errors', 'sourcing', 'underlay_place'},
}
ENGINE = ('sim', 'interfaces', 'tf', 'worlds', 'packages', 'graph', 'processes', 'recording', 'canvas')
FACES = sorted(path.name for path in (PACKAGE / 'underlay' / 'python').iterdir() if path.is_dir())


def files(layer: str) -> list[Path]:
    place = PACKAGE / layer
    return sorted(place.rglob('*.py')) if place.is_dir() else [place.with_suffix('.py')]


def imports(path: Path, *, at_import_time: bool = False) -> Iterator[str]:
    """Absolute names that a file imports; with `at_import_time` only those that loading it loads."""

    def walk(node: ast.AST) -> Iterator[str]:
        for child in ast.iter_child_nodes(node):
            if isinstance(child, ast.If) and 'TYPE_CHECKING' in ast.unparse(child.test) and at_import_time:
                continue
            if isinstance(child, (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda)) and at_import_time:
                continue
            if isinstance(child, ast.Import):
                yield from (alias.name for alias in child.names)
            elif isinstance(child, ast.ImportFrom):
                if child.module and not child.level:
                    yield from (f'{child.module}.{alias.name}' for alias in child.names)
            else:
                yield from walk(child)

    yield from walk(ast.parse(path.read_text(encoding='utf-8')))


@pytest.mark.parametrize('layer', [layer for layer in BELOW if layer != 'plan'])
def test_a_layer_imports_only_from_below(layer: str) -> None:
    allowed = {*BELOW[layer], layer, 'nearest'}
    wrong = [
        f'{path.relative_to(ROOT)} imports {name}'
        for path in files(layer)
        for name in imports(path)
        if name.startswith('edulaunch.')
        and name.split('.')[1] not in allowed
        and not (layer == 'recording' and name.split('.')[1] in ('canvas', 'processes'))
    ]
    assert wrong == []


@pytest.mark.parametrize('layer', ENGINE)
def test_engine_layers_know_no_ros_package(layer: str) -> None:
    wrong = [
        f'{path.relative_to(ROOT)} imports {name}'
        for path in files(layer)
        for name in imports(path)
        if name.split('.')[0] in FACES
    ]
    assert wrong == []


def modules() -> dict[str, Path]:
    found = {}
    for folder, prefix in ((PACKAGE, 'edulaunch'), (ROOT / 'grader' / 'edugrade', 'edugrade')):
        for path in sorted(folder.rglob('*.py')):
            if 'underlay' not in path.relative_to(folder).parts:
                parts = [prefix, *path.relative_to(folder).with_suffix('').parts]
                found['.'.join(parts[:-1] if parts[-1] == '__init__' else parts)] = path
    return found


def test_nothing_imports_in_a_circle_when_it_is_loaded() -> None:
    known = modules()
    graph = {
        name: {item if item in known else item.rpartition('.')[0] for item in imports(path, at_import_time=True)}
        & set(known) - {name}
        for name, path in known.items()
    }
    state: dict[str, int] = {}
    circles: list[str] = []

    def visit(name: str, way: list[str]) -> None:
        state[name] = 1
        for target in sorted(graph[name]):
            if state.get(target) == 1:
                circles.append(' -> '.join([*way, name, target]))
            elif target not in state:
                visit(target, [*way, name])
        state[name] = 2

    for name in sorted(graph):
        if name not in state:
            visit(name, [])
    assert circles == []


def test_only_pacing_and_real_programs_look_at_the_real_clock() -> None:
    allowed = {'sim/pacing.py', 'sim/guests.py', 'processes/real.py', 'processes/views/time_view.py', 'processes/watchdog.py'}
    wrong = [
        f'{path.relative_to(PACKAGE)} imports {name}'
        for layer in ENGINE
        for path in files(layer)
        for name in imports(path)
        if name.split('.')[0] == 'time' and str(path.relative_to(PACKAGE)) not in allowed
    ]
    assert wrong == []
