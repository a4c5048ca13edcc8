"""Reads launch files in YAML."""

from __future__ import annotations

import os
from typing import Any, TextIO

from launch.frontend.entity import Entity as BaseEntity
from launch.frontend.parser import Parser as BaseParser
from launch.utilities.yaml_reader import read_file

from edulaunch.engine.facts import with_facts

from .entity import Entity
from .plain_reader import NotPlain, read_plain


class Parser(BaseParser):
    """Reads launch files in YAML."""

    @classmethod
    def load(cls, file: str | os.PathLike[str] | TextIO) -> tuple[BaseEntity, BaseParser]:
        """Return the root element of a file (a path, or an open text stream) and a parser for it.

        :raises yaml.YAMLError: when the text is not YAML.
        :raises RuntimeError: when there is more than one root element.
        """
        name = str(file) if isinstance(file, (str, os.PathLike)) else getattr(file, 'name', '<file>')
        return cls.load_with(file, lambda text: cls._root_of(text, name))

    @staticmethod
    def _root_of(text: str, name: str) -> Entity:
        tree = _read(text, name)
        try:
            if len(tree) != 1:
                raise RuntimeError('Expected only one root')
            (type_name,) = tree.keys()
        except (TypeError, AttributeError, RuntimeError) as error:
            at_margin = [str(key) for key in tree] if isinstance(tree, dict) else []
            with_facts(error, 'launch.yaml-root' if tree else 'launch.empty-file', at_margin=at_margin)
            raise
        return Entity(tree[type_name], type_name, line=tree.line)

    @classmethod
    def get_file_extensions(cls) -> set[str]:
        """Return the extensions of YAML launch files."""
        return {'launch.yaml', 'launch.yml', 'yaml', 'yml', 'launch'}


def _read(text: str, name: str) -> Any:
    try:
        return read_plain(text)
    except NotPlain:
        return read_file(text, name)
