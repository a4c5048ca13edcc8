"""Systems as scenes: one, and two with the same layout."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

from matplotlib.figure import Figure

from edulaunch.canvas import plot_system
from edulaunch.canvas.system_scene import Panel, system_scene


def node(name: str, *ends: tuple[str, str], unknown: tuple[str, ...] = (), source: str = 'source', **parameters: Any) -> Any:
    return SimpleNamespace(
        name=name, ends=[(kind, end, '') for kind, end in ends], unknown=list(unknown), source=source, parameters=parameters
    )


def system(title: str, *nodes: Any, frames: tuple[tuple[str, str], ...] = ()) -> Any:
    made = [SimpleNamespace(parent=parent, child=child, is_static=True, by=['/tf']) for parent, child in frames]
    return SimpleNamespace(title=title, nodes=list(nodes), frames=made)


TALKER, LISTENER = node('/talker', ('publisher', '/news')), node('/listener', ('subscription', '/news'))


def places(panel: Panel) -> dict[str, tuple[float, float]]:
    return {box.name: (box.left, box.top) for box in panel.boxes}


def signs(panel: Panel) -> dict[str, str]:
    return {box.name: box.sign for box in panel.boxes if box.sign}


def test_what_is_not_known_is_drawn_as_such() -> None:
    scene = system_scene(system('plan', TALKER, node('/other', unknown=('endpoints not known',))))
    boxes = {box.name: box for box in scene.panels[0].boxes}
    assert boxes['/other'].unknown and boxes['/other'].notes == ['? endpoints not known']
    assert boxes['/news'].unknown and boxes['/news'].notes == ['no subscription known']
    assert not boxes['/talker'].unknown
    assert scene.caption() == 'plan: 2 nodes, 1 topics; /other: ? endpoints not known; /news: no subscription known'


def test_a_run_knows_its_ends() -> None:
    scene = system_scene(system('run', node('/talker', ('publisher', '/news'), source='run')))
    assert scene.panels[0].boxes[1].notes == ['no subscription']


def test_two_systems_have_equal_places_and_signs() -> None:
    before, after = system('a', TALKER, node('/old')), system('b', TALKER, LISTENER, frames=(('map', 'odom'),))
    first, second = system_scene(before, after, {'/talker': ['rate']}).panels
    assert places(first)['/talker'] == places(second)['/talker']
    assert signs(first) == {'/talker': '~', '/old': '-'}
    assert signs(second) == {'/talker': '~', '/listener': '+', 'map': '+', 'odom': '+'}
    assert second.signs == ['', '+', '+']
    assert [box.notes for box in second.boxes if box.name in ('/talker', 'odom')] == [['rate = not set'], ['static', 'by /tf']]


def test_services_are_shown_on_request() -> None:
    both = system('a', node('/server', ('service', '/add')), node('/asker', ('client', '/add')))
    assert [box.name for box in system_scene(both).panels[0].boxes] == ['/server', '/asker']
    panel = system_scene(both, services=True).panels[0]
    assert [(panel.boxes[a].name, panel.boxes[b].name) for a, b in panel.arrows] == [('/asker', '/add'), ('/add', '/server')]


def test_it_is_drawn_on_as_many_axes_as_there_are_systems() -> None:
    first, second = Figure().subplots(1, 2)
    assert plot_system(system('a', TALKER), system('b', TALKER, LISTENER), ax=[first, second]) == [first, second]
    texts = [text.get_text() for text in second.texts]
    assert '+ /listener' in texts and any('+ only in this one' in text for text in texts)
    wide = system('a', *(node(f'/node_with_a_long_name_{number}') for number in range(3)))
    assert plot_system(wide, wide).png().startswith(b'\x89PNG')
