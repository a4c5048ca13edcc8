"""A room imports only rooms below it, and no file imports in a circle (layers.toml, house.py)."""

from __future__ import annotations

import sys

import pytest

from tests.house import FACES, PACKAGE, ROOT, circles, every_import, imports, modules, room, wing

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

LAYERS = tomllib.loads((ROOT / 'tests' / 'layers.toml').read_text(encoding='utf-8'))
HEIGHT = {name: -index for index, line in enumerate(LAYERS['order']) for name in line}
WING_HEIGHT = {name: -index for index, line in enumerate(LAYERS['wings']['order']) for name in line}
NEIGHBOURS: dict[str, list[str]] = LAYERS['neighbours']
ROOMS = ('sim', 'interfaces', 'tf', 'worlds', 'packages', 'graph', 'processes', 'recording')
LARGEST_TYPE_CIRCLE = 3
"""How many files outside of the engine may need each other's names for their types."""
REAL_CLOCK = {
    'sim/pacing.py',
    'sim/real_pace.py',
    'sim/real_threads.py',
    'processes/module_views/time_views.py',
    'processes/watchdog.py',
}


def wrong_wings() -> dict[str, list[str]]:
    """Arrows between wings that do not lead downwards, with the files that draw them."""
    wrong: dict[str, list[str]] = {}
    for module, path in modules().items():
        for target in sorted(imports(module)):
            above, below = wing(module), wing(target)
            if above != below and WING_HEIGHT[above] <= WING_HEIGHT[below]:
                wrong.setdefault(f'{above} -> {below}', []).append(f'{path.relative_to(ROOT)} imports {target}')
    return wrong


def test_a_wing_imports_only_wings_below() -> None:
    wrong = wrong_wings()
    standing = LAYERS['standing']['wings']
    assert [text for arrow, texts in wrong.items() if arrow not in standing for text in texts] == []
    assert [arrow for arrow in standing if arrow not in wrong] == [], 'mended: take it out of tests/layers.toml'


def wrong_arrows() -> dict[str, list[str]]:
    """Arrows that do not lead downwards, or to a neighbour that a room may not know, with the files that draw them."""
    wrong: dict[str, list[str]] = {}
    for module, path in modules().items():
        above = room(module)
        for target in sorted(imports(module)):
            below = room(target)
            if above != below and not is_allowed(above, below):
                wrong.setdefault(f'{above} -> {below}', []).append(f'{path.relative_to(ROOT)} imports {target}')
    return wrong


def is_allowed(above: str, below: str) -> bool:
    return HEIGHT[above] > HEIGHT[below] and below in [*NEIGHBOURS.get(above, [below]), *LAYERS['order'][-1]]


def test_every_room_has_its_place() -> None:
    missing = {room(module) for module in modules()} - set(HEIGHT)
    assert not missing, f'give {sorted(missing)} a line in tests/layers.toml'


def test_a_room_imports_only_from_below() -> None:
    wrong = wrong_arrows()
    standing = set(LAYERS['standing']['arrows'])
    new = [text for arrow, texts in wrong.items() if arrow not in standing for text in texts]
    assert new == [], 'arrows that lead up or sideways (tests/layers.toml)'
    assert standing <= set(wrong), f'mended: take {sorted(standing - set(wrong))} out of tests/layers.toml'


def test_no_file_imports_in_a_circle() -> None:
    found = circles({name: imports(name, with_types=False) for name in modules()})
    standing = LAYERS['standing']['file_circles']
    assert [group for group in found if not any(set(group) <= set(old) for old in standing)] == []
    mended = [old for old in standing if not any(set(group) <= set(old) for group in found)]
    assert mended == [], 'take these out of tests/layers.toml'


def too_large(groups: list[list[str]]) -> dict[str, list[list[str]]]:
    """Circles by types that no wing may have, by the room of their first file, the largest first: of any size in the engine, of
    more than three files elsewhere.
    """
    found: dict[str, list[list[str]]] = {}
    for group in sorted(groups, key=len, reverse=True):
        if len(group) > LARGEST_TYPE_CIRCLE or any(wing(module) == 'edulaunch.engine' for module in group):
            found.setdefault(room(group[0]), []).append(group)
    return found


def test_circles_by_types_only_shrink() -> None:
    found = too_large(circles({name: imports(name) for name in modules()}))
    sizes = {name: [len(group) for group in groups] for name, groups in found.items()}
    standing = LAYERS['standing']['type_circles']
    changed = {name: found.get(name, []) for name in {*sizes, *standing} if sizes.get(name) != standing.get(name)}
    assert changed == {}, 'break the circle; where it has shrunk, write its size today into tests/layers.toml'


def test_a_circle_by_types_is_too_large_from_two_files_in_the_engine_and_from_four_elsewhere() -> None:
    engine, three = ['edulaunch.engine.sim.a', 'edulaunch.engine.sim.b'], ['rclpy.a', 'rclpy.b', 'rclpy.c']
    assert too_large([engine, three]) == {'edulaunch.engine.sim': [engine]}
    assert too_large([three, [*three, 'rclpy.d']]) == {'rclpy': [[*three, 'rclpy.d']]}


def test_a_circle_is_seen() -> None:
    assert circles({'a': {'b'}, 'b': {'c'}, 'c': {'b'}, 'd': {'a'}}) == [['b', 'c']]


def test_an_import_in_a_function_and_a_name_in_a_text_are_seen() -> None:
    assert 'edulaunch.runtime.session' in imports('edulaunch')
    assert 'edulaunch.desk.machine.serving' in imports('edulaunch.desk.machine.starting')
    assert 'rclpy.executors' not in imports('rclpy.impl.waiting'), 'the `__module__` of a class is a name only'


@pytest.mark.parametrize('layer', ROOMS)
def test_engine_rooms_know_no_ros_package(layer: str) -> None:
    wrong = [f'{name} imports {item}' for name, item in engine_imports(layer) if item.split('.')[0] in FACES]
    assert wrong == []


def test_only_pacing_and_real_programs_look_at_the_real_clock() -> None:
    found = {name for layer in ROOMS for name, item in engine_imports(layer) if item.split('.')[0] == 'time'}
    assert found <= REAL_CLOCK


def engine_imports(layer: str) -> list[tuple[str, str]]:
    """(file, what it imports) of an engine room."""
    return [
        (str(path.relative_to(PACKAGE / 'engine')), item)
        for path in sorted((PACKAGE / 'engine' / layer).rglob('*.py'))
        for item in every_import(path)
    ]
