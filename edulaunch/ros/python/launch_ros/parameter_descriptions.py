"""Parameters that need more than a plain value: a type, a name, or a file."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

from launch._bases import ReadOnly
from launch._engine import assumptions, inside, state_of
from launch.substitution import SomeSubstitutionsType, SomeSubstitutionsType_types_tuple, Substitution
from launch.utilities.texts import normalize_to_list_of_substitutions, perform_substitutions
from launch.utilities.type_utils import ensure_argument_type, normalize_typed_substitution, perform_typed_substitution

from ._generated_file import GeneratedFile, temporary_path

if TYPE_CHECKING:
    from pathlib import Path

    from launch.launch_context import LaunchContext


_PLAIN = frozenset((str, bool, int, float))


class ParameterValue:
    """A value with a given type, such as a robot description, which is always a string.

    :param value: a literal, a substitution, or a list.
    :param value_type: int, float, bool, str, or `List[...]` of one of these. None means that strings of substitutions are
        converted according to YAML's rules.
    :raises TypeError: when a literal does not have the type.
    """

    line = 0
    """The line of the launch file that sets the parameter, if a frontend created this object."""

    def __init__(self, value: Any, *, value_type: Any = None) -> None:
        plain = value_type is None and type(value) in _PLAIN
        self.__value = value if plain else normalize_typed_substitution(value, value_type)
        self.__value_type = value_type
        self.__evaluated: Any = None

    written: ReadOnly[Any] = ReadOnly('The unevaluated value, which remains after the evaluation.', '__value')

    def __str__(self) -> str:
        return f'launch_ros.description.ParameterValue(value={self.value}, value_type={self.value_type})'

    @property
    def value(self) -> Any:
        """The evaluated value. Before evaluation, it may contain substitutions."""
        return self.__value if self.__evaluated is None else self.__evaluated

    value_type: ReadOnly[Any] = ReadOnly('The given type, or None.')

    def evaluate(self, context: LaunchContext) -> Any:
        """Return the evaluated value.

        :raises ValueError: when the string of a substitution cannot be converted.
        """
        value = self.__value
        self.__evaluated = value if type(value) in _PLAIN else perform_typed_substitution(context, value, self.__value_type)
        return self.__evaluated


class Parameter:
    """One parameter, which is passed to the node as `-p name:=value`."""

    def __init__(self, name: SomeSubstitutionsType, value: Any, *, value_type: Any = None) -> None:
        ensure_argument_type(name, SomeSubstitutionsType_types_tuple, 'name')
        self.__name = normalize_to_list_of_substitutions(name)
        self.__value = ParameterValue(value, value_type=value_type)
        self.__evaluated_name: str | None = None

    def __str__(self) -> str:
        parts = f'name={self.name}, value={self.value}, value_type={self.value_type}'
        return f'launch_ros.description.Parameter({parts})'

    @property
    def name(self) -> list[Substitution] | str:
        """The evaluated name. Before evaluation, it may contain substitutions."""
        return self.__name if self.__evaluated_name is None else self.__evaluated_name

    written: ReadOnly[Any] = ReadOnly('The unevaluated value, which remains after the evaluation.', '__value.written')

    value: ReadOnly[Any] = ReadOnly('The evaluated value; see :attr:`ParameterValue.value`.', '__value.value')

    value_type: ReadOnly[Any] = ReadOnly('The given type, or None.', '__value.value_type')

    def evaluate(self, context: LaunchContext) -> tuple[str, Any]:
        """Return the evaluated name and value."""
        self.__evaluated_name = perform_substitutions(context, self.__name)
        return self.__evaluated_name, self.__value.evaluate(context)


class ParameterFile:
    """A parameter file.

    :param param_file: the path of the file.
    :param allow_substs: whether to evaluate `$(...)` substitutions in the file, and to write the result to a temporary file.
    """

    def __init__(self, param_file: Any, *, allow_substs: Any = False) -> None:
        ensure_argument_type(
            param_file, (*SomeSubstitutionsType_types_tuple, os.PathLike, bytes), 'param_file', 'ParameterFile()'
        )
        if isinstance(param_file, (os.PathLike, bytes)):
            param_file = os.fsdecode(param_file)
        self.__param_file = normalize_to_list_of_substitutions(param_file)
        self.__allow_substs = normalize_typed_substitution(allow_substs, bool)
        self.__evaluated: Path | None = None
        self.__evaluated_allow_substs: bool | None = None
        self.__file: GeneratedFile | None = None

    def __repr__(self) -> str:
        parts = f'param_file={self.param_file}, allow_substs={self.allow_substs}'
        return f'launch_ros.description.ParameterFile({parts})'

    @property
    def param_file(self) -> Path | list[Substitution]:
        """The evaluated path. Before evaluation, it may contain substitutions."""
        return self.__param_file if self.__evaluated is None else self.__evaluated

    @property
    def allow_substs(self) -> Any:
        """Whether the file may contain substitutions."""
        return self.__allow_substs if self.__evaluated_allow_substs is None else self.__evaluated_allow_substs

    def evaluate(self, context: LaunchContext) -> Path:
        """Return the path that the node receives.

        If the file contains substitutions, this is the path of a temporary file. The temporary file exists until :meth:`cleanup`
        is called or this object is deleted.

        :raises SubstitutionFailure: when the result of the substitution is not valid YAML.
        """
        path, file = self.performed(context)
        if file is not None:
            file.write()
            self.__file = file
        return path

    def performed(self, context: LaunchContext) -> tuple[Path, GeneratedFile | None]:
        """Return the path that the node receives, and None.

        If substitutions are allowed, return a temporary path and the generated file, which is not on the disk yet. (edulaunch
        only.)
        """
        from pathlib import Path

        path = Path(perform_substitutions(context, self.__param_file))
        file = None
        self.__evaluated_allow_substs = bool(perform_typed_substitution(context, self.__allow_substs, bool))
        if self.__evaluated_allow_substs:
            text = _substituted(context, path)
            # The source may be a temporary file with a new name each time, so its text is the key.
            file = GeneratedFile(temporary_path(text, state_of(context)), text)
            path = Path(file.path)
        self.__evaluated = path
        return path, file

    def cleanup(self) -> None:
        """Remove the temporary file, if it exists. Afterwards, :attr:`param_file` is unevaluated again."""
        if self.__file is not None:
            self.__file.remove()
            self.__file = self.__evaluated = None


def _substituted(context: LaunchContext, path: Path) -> str:
    """Return the text of the file with evaluated substitutions."""
    import yaml
    from launch.frontend.parse_substitution import parse_substitution
    from launch.substitutions.substitution_failure import SubstitutionFailure

    assumed = assumptions()
    if assumed is not None and assumed.lacks_file(str(path)):
        return ''
    with open(inside(path), encoding='utf-8') as file:
        text = perform_substitutions(context, parse_substitution(file.read()))
    try:
        yaml.safe_load(text)
    except (yaml.YAMLError, ValueError, RecursionError):
        raise SubstitutionFailure('The substituted parameter file is not a valid yaml file') from None
    return text
