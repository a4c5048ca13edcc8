"""The stand-in of RViz: honest about pictures, exact about what it listens to."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from edulaunch.engine.underlay_place import underlay_prefix

CONFIG = f'{underlay_prefix()}/share/turtle_tf2_py/rviz/turtle_rviz.rviz'


def listens_to_tf(stage: Any) -> bool:
    return '/tf' in stage.graph.subscriptions and '/tf_static' in stage.graph.subscriptions


def test_the_tutorials_config_shows_tf_from_above(stage: Any) -> None:
    stage.start('rviz2', 'rviz2', '-d', CONFIG, '--ros-args', '-r', '__node:=rviz2')
    stage.until(10)
    assert stage.texts()[:2] == [
        "Loaded display config 'turtle_rviz.rviz'",
        "View: TopDownOrtho, fixed frame 'world', displays: Grid, TF",
    ]
    assert 'pictures come from the recording' in stage.texts()[2]
    assert listens_to_tf(stage)
    assert [node.name for node in stage.graph.nodes if node.name.startswith('rviz')] == ['rviz2']


def test_without_config_it_listens_to_nothing(stage: Any) -> None:
    process = stage.start('rviz2', 'rviz2', '-f', 'map')
    stage.until(10)
    assert not listens_to_tf(stage)
    assert process.returncode is None


def test_a_missing_config_is_an_error_with_its_path(stage: Any) -> None:
    stage.start('rviz2', 'rviz2', '-d', '/no/such.rviz')
    stage.until(10)
    assert stage.texts()[0] == "Could not load display config '/no/such.rviz': No such file or directory"


def test_a_file_that_is_no_config_is_an_error(stage: Any, tmp_path: Path) -> None:
    file = tmp_path / 'x.rviz'
    file.write_text('Panels: [')
    stage.start('rviz2', 'rviz2', '-d', str(file))
    stage.until(10)
    assert stage.texts()[0].startswith(f"Could not load display config '{file}': it is not an RViz config: while parsing")
