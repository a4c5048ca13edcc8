"""`ros2 pkg xml`: the manifest of a package."""

from __future__ import annotations

import argparse
import os

from edulaunch.cli.ros2.output import say, with_help
from edulaunch.nearest import did_you_mean
from edulaunch.processes.current import current_process


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 pkg xml`."""
    parser.add_argument('package_name', help='The package name')
    parser.add_argument('-t', '--tag', help='The XML tag to output, e.g. version')


def main(arguments: argparse.Namespace) -> str | None:
    """Print the file, or the text of a tag."""
    from xml.etree import ElementTree

    index, package = current_process().index, arguments.package_name
    share = index.share(package)
    if share is None:
        return with_help('Package not found', did_you_mean(package, index.packages()))
    path = os.path.join(share, 'package.xml')
    if not os.path.isfile(path):
        return with_help(f"Package '{package}' has no package.xml", 'it is built into edulaunch')
    if arguments.tag is None:
        with open(path, encoding='utf-8') as file:
            say(file.read())
        return None
    found = ElementTree.parse(path).getroot().findall(arguments.tag)
    if not found:
        return f"No element found for '{arguments.tag}' in the package manifest of '{package}'"
    for element in found:
        say(element.text or '')
    return None
