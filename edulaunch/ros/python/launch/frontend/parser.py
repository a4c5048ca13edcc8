"""Reads launch files in formats other than Python."""

from __future__ import annotations

import os
from collections.abc import Callable
from importlib import import_module
from typing import TYPE_CHECKING, Any, TextIO

from edulaunch.engine.nearest import nearest
from edulaunch.ros.collector_pause import collector_paused

from .._engine import inside
from .._origin import MAKERS
from . import places
from .entity import Entity
from .expose import action_parse_methods
from .extensions import load_launch_extensions, load_parsers
from .invalid_frontend_launch_file_error import InvalidFrontendLaunchFileError
from .parse_substitution import parse_if_substitutions, parse_substitution, replace_escaped_characters

if TYPE_CHECKING:
    from ..action import Action
    from ..launch_description import LaunchDescription

__all__ = ['InvalidFrontendLaunchFileError', 'Parser']

BUILT_IN_PARSERS = {'xml': 'launch_xml', 'yaml': 'launch_yaml'}
"""Format -> the package whose `Parser` reads it, in the order in which they are tried."""


def __getattr__(name: str) -> Any:
    # The upstream module has this name; here, it is imported on first use.
    if name == 'importlib_metadata':
        return import_module('importlib.metadata')
    raise AttributeError(f'module {__name__!r} has no attribute {name!r}')


class Parser:
    """Creates a launch description from the elements of a file. Each format has a subclass that reads the text.

    :cvar extensions_loaded: whether the parser has searched installed packages for launch extensions.
    :cvar frontend_parsers: all formats found so far, by name; None before the first search.
    :ivar file: name of the file, or '' without a file. (edulaunch only.)
    """

    extensions_loaded = False
    frontend_parsers: dict[str, type[Parser]] | None = None
    file = ''

    # -- the description

    def parse_description(self, entity: Entity) -> LaunchDescription:
        """Return the launch description of a root element.

        :raises RuntimeError: when the root element is not `launch`, or an element is unknown.
        """
        with collector_paused():
            return self._parse_root(entity)

    def _parse_root(self, entity: Entity) -> LaunchDescription:
        from ..launch_description import LaunchDescription

        if entity.type_name != 'launch':
            error = RuntimeError("Expected 'launch' as root tag")
            places.at(error, entity, 'launch.root')
            places.complete(error, self.file, entity)
            raise error
        try:
            deprecated = entity.get_attr('deprecated', optional=True)
            actions = [self.parse_action(child) for child in entity.children]
        except Exception as error:
            places.complete(error, self.file, entity)
            raise
        return LaunchDescription(actions, deprecated_reason=deprecated)

    def parse_action(self, entity: Entity) -> Action:
        """Return the action of an element. The action has the file and line of the element.

        :raises RuntimeError: when no action has that name.
        :raises ValueError: when the element has attributes or children that its action does not accept.
        """
        try:
            parse = action_parse_methods.get(entity.type_name) or self._parse_method_of_extension(entity)
            action_type, kwargs = parse(entity, self)
            entity.assert_entity_completely_parsed()
            action: Action = action_type(**kwargs)
        except Exception as error:
            places.complete(error, self.file, entity)
            raise
        if self.file and hasattr(action, 'set_origin'):
            action.set_origin(self.file, entity.line)
        return action

    def _parse_method_of_extension(self, entity: Entity) -> Any:
        self.load_launch_extensions()
        parse = action_parse_methods.get(entity.type_name)
        if parse is None:
            error = RuntimeError(f'Unrecognized entity of the type: {entity.type_name}')
            near = nearest(str(entity.type_name), action_parse_methods)
            raise places.at(error, entity, 'launch.unknown-element', near=near)
        return parse

    MAKERS[id(parse_action.__code__)] = parse_action.__code__

    parse_substitution = staticmethod(parse_substitution)
    parse_if_substitutions = staticmethod(parse_if_substitutions)
    escape_characters = staticmethod(replace_escaped_characters)

    # -- the file

    @classmethod
    def load(cls, file: str | os.PathLike[str] | TextIO) -> tuple[Entity, Parser]:
        """Return the root element of a file (a path, or an open text stream) and the parser for it.

        Formats that match the name of the file are tried first, and then all other formats.

        :raises InvalidFrontendLaunchFileError: when no format can read the file.
        :raises FileNotFoundError: when there is no such file.
        """
        if isinstance(file, (str, os.PathLike)):
            with open(inside(file), encoding='utf-8') as stream:
                return cls._load_stream(stream)
        return cls._load_stream(file)

    @classmethod
    def load_with(cls, file: str | os.PathLike[str] | TextIO, root_of: Callable[[str], Entity]) -> tuple[Entity, Parser]:
        """Load a file with a function of the subclass, as part of the :meth:`load` of the subclass. (edulaunch only.)

        :param root_of: a function that creates the root element from the content of the file. The place in the file is added to
            the errors of this function.
        """
        if isinstance(file, (str, os.PathLike)):
            with open(inside(file), encoding='utf-8') as stream:
                return cls.load_with(stream, root_of)
        parser = cls()
        parser.file = str(getattr(file, 'name', ''))
        try:
            with collector_paused():
                return root_of(file.read()), parser
        except Exception as error:
            places.complete_unreadable(error, parser.file)
            raise

    @classmethod
    def _load_stream(cls, stream: TextIO) -> tuple[Entity, Parser]:
        name = str(getattr(stream, 'name', ''))
        tried: list[type[Parser]] = []
        errors: list[Exception] = []
        for candidates in (cls.get_parsers_from_filename, cls._all_parsers):
            for implementation in candidates(name):
                if implementation in tried:
                    continue
                tried.append(implementation)
                try:
                    return implementation.load(stream)
                except Exception as error:
                    errors.append(error)
                finally:
                    stream.seek(0)
        raise cls._unreadable(name, errors)

    @classmethod
    def _unreadable(cls, name: str, errors: list[Exception]) -> InvalidFrontendLaunchFileError:
        if not cls.is_filename_valid(name):
            return InvalidFrontendLaunchFileError()
        error = InvalidFrontendLaunchFileError(name.rpartition('.')[2], likely_errors=errors)
        for attribute in ('file', 'line', 'tag', 'help'):
            value = getattr(errors[0], f'edulaunch_{attribute}', None)
            if value is not None:
                setattr(error, f'edulaunch_{attribute}', value)
        return error

    # -- the formats

    @classmethod
    def get_file_extensions(cls) -> set[str]:
        """Return the file name extensions, without a leading dot, of this parser's format."""
        return set()

    @classmethod
    def may_parse(cls, filename: str) -> bool:
        """Return whether this parser handles files with such a name."""
        return any(filename.endswith(f'.{extension}') for extension in sorted(cls.get_file_extensions()))

    @classmethod
    def load_launch_extensions(cls) -> None:
        """Import the modules of installed packages that expose actions and substitutions. Later calls have no effect."""
        if not Parser.extensions_loaded:
            Parser.extensions_loaded = True
            load_launch_extensions()

    @classmethod
    def load_parser_implementations(cls) -> None:
        """Find the parsers of installed packages. Later calls have no effect. The parsers for XML and YAML are always present."""
        if Parser.frontend_parsers is None:
            Parser.frontend_parsers = load_parsers(cls._built_in_parsers())

    @classmethod
    def get_available_extensions(cls) -> list[str]:
        """Return the names of the formats."""
        return list(cls._all_parsers_by_name())

    @classmethod
    def get_parsers_from_filename(cls, filename: str) -> list[type[Parser]]:
        """Return the parsers that handle a file with such a name.

        The result includes parsers of installed packages only if neither XML nor YAML matches.
        """
        claiming = [parser for parser in cls._built_in_parsers().values() if parser.may_parse(filename)]
        return claiming or [parser for parser in cls._all_parsers(filename) if parser.may_parse(filename)]

    @classmethod
    def get_file_extensions_from_parsers(cls) -> list[str]:
        """Return the extensions of all formats."""
        return [name for parser in cls._all_parsers() for name in sorted(parser.get_file_extensions())]

    @classmethod
    def is_filename_valid(cls, filename: str) -> bool:
        """Return whether any parser handles such a name."""
        return bool(cls.get_parsers_from_filename(filename))

    @classmethod
    def _built_in_parsers(cls) -> dict[str, type[Parser]]:
        return {name: import_module(package).Parser for name, package in BUILT_IN_PARSERS.items()}

    @classmethod
    def _all_parsers_by_name(cls) -> dict[str, type[Parser]]:
        cls.load_parser_implementations()
        return Parser.frontend_parsers or {}

    @classmethod
    def _all_parsers(cls, filename: str = '') -> list[type[Parser]]:
        return list(cls._all_parsers_by_name().values())
