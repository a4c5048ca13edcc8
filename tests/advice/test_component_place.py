"""The line of a component that a container cannot load, in launch files of all three languages."""

from __future__ import annotations

from pathlib import Path

import pytest

import edulaunch

XML = """<launch>
  <node_container pkg="rclcpp_components" exec="component_container" name="box" namespace="">
    <composable_node pkg="composition" plugin="composition::Talkr" name="talker"/>
  </node_container>
</launch>
"""
YAML = """launch:
- node_container:
    pkg: rclcpp_components
    exec: component_container
    name: box
    namespace: ""
    composable_node:
    - pkg: composition
      plugin: composition::Talkr
      name: talker
"""


@pytest.mark.parametrize(('name', 'text', 'line'), [('c.launch.xml', XML, 3), ('c.launch.yaml', YAML, 9)])
def test_a_component_that_is_not_loaded_is_reported_at_its_line(tmp_path: Path, name: str, text: str, line: int) -> None:
    file = tmp_path / name
    file.write_text(text, encoding='utf-8')
    warnings = edulaunch.run(file, duration_s=2.0, console=lambda *_: None).warnings
    assert len(warnings) == 1 and f'{name}:{line}' in warnings[0] and 'write composition::Talker' in warnings[0]
