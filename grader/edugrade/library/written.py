"""Formats parts of a launch file for advice, in the format of the submission: Python, XML or YAML."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ..evidence import Evidence


def written(run: Evidence, python: str, xml: str, yaml: str) -> str:
    """Return the one of three strings that fits the format of the submitted launch file: Python, XML or YAML."""
    file = run.source.file.lower()
    if file.endswith('.xml'):
        return xml
    return yaml if file.endswith(('.yaml', '.yml')) else python


def value_of(run: Evidence, argument: str) -> str:
    """Return the code for the value of a launch argument."""
    return written(run, f"LaunchConfiguration('{argument}')", f'$(var {argument})', f'$(var {argument})')


def default_of(run: Evidence, value: str) -> str:
    """Return the code for the default value of a launch argument."""
    return written(run, f"default_value='{value}'", f'default="{value}"', f'default: "{value}"')


def declaration_of(run: Evidence, name: str, default: str) -> str:
    """Return the code that declares a launch argument with a default."""
    return written(
        run,
        f"DeclareLaunchArgument('{name}', default_value='{default}', description='...')",
        f'<arg name="{name}" default="{default}" description="..."/>',
        f'- arg: {{name: "{name}", default: "{default}", description: "..."}}',
    )


def remapping_to(run: Evidence, topic: str, name: str = '...') -> str:
    """Return advice to remap the topic `name` of a node to `topic`."""
    return written(
        run,
        f"write remappings=[('{name}', '{topic}')] in the Node",
        f'write <remap from="{name}" to="{topic}"/> in the node',
        f'write remap: [{{from: "{name}", to: "{topic}"}}] in the node',
    )


def argument_as_namespace(run: Evidence, argument: str, program: str) -> str:
    """Return advice to use a launch argument as the namespace of a program."""
    value = value_of(run, argument)
    words = written(run, f'namespace={value}', f'namespace="{value}"', f'namespace: "{value}"')
    return f'write {words} in the Node of {program}'


def name_of_node(run: Evidence, namespace: str, name: str, program: str) -> str:
    """Return advice to give the node of a program its namespace and its name. One of the two may be ''."""
    parts = {key: value for key, value in (('namespace', namespace), ('name', name)) if value}
    words = [written(run, f"{key}='{value}'", f'{key}="{value}"', f'{key}: "{value}"') for key, value in parts.items()]
    return f'write {" and ".join(words)} in the Node of {program}' if words else f'add a Node of {program}'


def parameter_of_node(run: Evidence, name: str, value: str) -> str:
    """Return advice to set a parameter of a node to the code of a value."""
    return written(
        run,
        f"add parameters=[{{'{name}': {value}}}] to the Node",
        f'add <param name="{name}" value="{value}"/> to the node',
        f'add param: [{{name: "{name}", value: "{value}"}}] to the node',
    )


def node_of(run: Evidence, package: str, executable: str) -> str:
    """Return the code that starts a program of a package as a node."""
    return written(
        run,
        f"Node(package='{package}', executable='{executable}')",
        f'<node pkg="{package}" exec="{executable}"/>',
        f'- node: {{pkg: "{package}", exec: "{executable}"}}',
    )
