"""Reading launch files in XML."""
from __future__ import annotations

import os
from typing import TextIO

from launch.frontend import hints
from launch.frontend.parser import Parser as BaseParser

from .entity import Entity
from .reader import read


class Parser(BaseParser):
    """Reads launch files in XML."""

    @classmethod
    def load(cls, file: str | os.PathLike[str] | TextIO) -> tuple[Entity, Parser]:
        """The root element of a file (its path, or an open text stream) and a parser for it.

        :raises xml.etree.ElementTree.ParseError: when the text is not well-formed XML.
        :raises ValueError: when it declares entities or is nested too deep.
        """
        if isinstance(file, (str, os.PathLike)):
            with open(file, encoding='utf-8') as stream:
                return cls.load(stream)
        parser = cls()
        parser.file = str(getattr(file, 'name', ''))
        try:
            return Entity(read(file.read())), parser
        except Exception as error:
            hints.complete_unreadable(error, parser.file)
            raise

    @classmethod
    def get_file_extensions(cls) -> set[str]:
        """Extensions of XML launch files."""
        return {'launch.xml', 'xml', 'launch'}
