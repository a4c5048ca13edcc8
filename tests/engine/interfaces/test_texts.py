"""Interfaces kept as text."""

from __future__ import annotations

from pathlib import Path

import pytest

from edulaunch.engine.interfaces.registry import Registry, underlay_registry
from edulaunch.engine.interfaces.texts import TextRegistry, texts_of
from edulaunch.errors import InterfaceError

TEXTS = {
    'robo/action/Go.action': 'robo/Part part\n---\nbool done\n---\nint32 left\n',
    'robo/msg/Part.msg': 'string name\nother/Size size\n',
    'robo/msg/Unused.msg': 'int8 x\n',
    'other/msg/Size.msg': 'geometry_msgs/Point place\n',
}


@pytest.fixture
def registry(tmp_path: Path) -> Registry:
    for name, text in TEXTS.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return Registry([tmp_path], underlay_registry())


@pytest.mark.parametrize('used', ['robo/action/Go', 'robo/action/Go_FeedbackMessage', 'robo/action/Go_SendGoal'])
def test_the_texts_of_a_type_and_of_all_in_it_but_the_bases(registry: Registry, used: str) -> None:
    found = texts_of(registry, [used, 'std_msgs/msg/String', 'no/msg/Such'])
    assert list(found) == ['other/msg/Size', 'robo/action/Go', 'robo/msg/Part']


def test_classes_from_texts_are_those_from_files(registry: Registry) -> None:
    again = TextRegistry(texts_of(registry, ['robo/msg/Part']), underlay_registry())
    first, second = registry.get('robo/msg/Part'), again.get('robo/msg/Part')
    assert repr(first(name='x')) == repr(second(name='x')) and first.to_wire(first()) == second.to_wire(second())
    assert again.has('robo', 'msg') and not again.has('robo', 'action') and again.has('turtlesim')


def test_a_type_without_a_text_is_unknown(registry: Registry) -> None:
    again = TextRegistry(texts_of(registry, ['robo/msg/Part']), underlay_registry())
    with pytest.raises(InterfaceError, match="unknown interface 'robo/msg/Prat'"):
        again.get('robo/msg/Prat')


def test_packages_can_be_left_to_the_base(tmp_path: Path, registry: Registry) -> None:
    assert Registry([tmp_path], underlay_registry(), leave=['robo']).owns('other')
    assert not Registry([tmp_path], underlay_registry(), leave=['robo']).has('robo')


def test_texts_are_those_of_the_files_in_order_of_their_names(registry: Registry) -> None:
    found = texts_of(registry, ['robo/msg/Unused', 'robo/action/Go'])
    assert list(found.items()) == [
        (path.rpartition('.')[0], TEXTS[path])
        for path in ('other/msg/Size.msg', 'robo/action/Go.action', 'robo/msg/Part.msg', 'robo/msg/Unused.msg')
    ]
    assert texts_of(registry, []) == {}
