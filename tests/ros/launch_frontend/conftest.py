"""Launch files as texts."""

import io

import pytest
from launch.frontend import Parser


def description_of(text, name='robot.launch.xml'):
    stream = io.StringIO(text)
    stream.name = name
    root, parser = Parser.load(stream)
    return parser.parse_description(root)


@pytest.fixture
def describe():
    """The launch description in a text; XML unless `name` says otherwise."""
    return description_of


@pytest.fixture
def actions_of():
    """The actions between `<launch>` and `</launch>`."""
    return lambda text: description_of(f'<launch>{text}</launch>').entities


@pytest.fixture
def yaml_actions_of():
    """The actions in the list below `launch:`."""
    return lambda text: description_of(f'launch:\n{text}', 'robot.launch.yaml').entities


@pytest.fixture
def failure_of():
    """The error of a broken launch file."""

    def failure(text, name='robot.launch.xml', raises=Exception):
        with pytest.raises(raises) as caught:
            description_of(text, name)
        return caught.value

    return failure
