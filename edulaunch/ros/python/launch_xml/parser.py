"""Reads launch files in XML."""

from __future__ import annotations

import os
from typing import TextIO

from launch.frontend.entity import Entity as BaseEntity
from launch.frontend.parser import Parser as BaseParser

from .entity import Entity
from .reader import read


class Parser(BaseParser):
    """Reads launch files in XML."""

    @classmethod
    def load(cls, file: str | os.PathLike[str] | TextIO) -> tuple[BaseEntity, BaseParser]:
        """Return the root element of a file (a path, or an open text stream) and a parser for it.

        :raises xml.etree.ElementTree.ParseError: when the text is not well-formed XML.
        :raises ValueError: when the text declares entities or is nested too deeply.
        """
        return cls.load_with(file, lambda text: Entity(read(text)))

    @classmethod
    def get_file_extensions(cls) -> set[str]:
        """Return the extensions of XML launch files."""
        return {'launch.xml', 'xml', 'launch'}
