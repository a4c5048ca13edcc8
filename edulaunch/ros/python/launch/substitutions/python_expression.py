"""The substitution `PythonExpression`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from edulaunch.engine.facts import with_facts

from .._bases import ReadOnly
from .._engine import import_for_expression
from ..substitution import SomeSubstitutionsType, Substitution
from ..utilities.texts import normalize_to_list_of_substitutions, perform_substitutions
from .text_substitution import describe_all

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class PythonExpression(Substitution):
    """The result of `str(eval(text))`, where `text` is the joined expression.

    Names of the `math` module need no prefix. Names of other modules need the name of their module as a prefix. Put values of
    launch configurations in quotation marks inside the expression. Otherwise, Python reads them as names.

    :param python_modules: the modules that the expression may use.
    :raises Exception: on evaluation, any exception that the expression raises, such as NameError or SyntaxError.
    """

    def __init__(self, expression: SomeSubstitutionsType, python_modules: SomeSubstitutionsType = ('math',)) -> None:
        self.__expression = normalize_to_list_of_substitutions(expression)
        self.__python_modules = normalize_to_list_of_substitutions(python_modules)

    expression: ReadOnly[list[Substitution]] = ReadOnly('The expression, as substitutions.')
    python_modules: ReadOnly[list[Substitution]] = ReadOnly('The modules that the expression may use, as substitutions.')

    def describe(self) -> str:
        """Return a description such as `PythonExpr('1+1', ['math'])`."""
        modules = ', '.join(module.describe() for module in self.__python_modules)
        return f'PythonExpr({describe_all(self.__expression)}, [{modules}])'

    def perform(self, context: LaunchContext) -> str:
        """Return the value as a string."""
        names: dict[str, Any] = {}
        for substitution in self.__python_modules:
            module = import_for_expression(perform_substitutions(context, [substitution]))
            if module.__name__ == 'math':
                names.update(vars(module))
            names[module.__name__] = module
        expression = perform_substitutions(context, self.__expression)
        try:
            return str(eval(expression, {}, names))
        except (NameError, SyntaxError, TypeError) as error:
            with_facts(error, 'launch.expression', expression=expression)
            raise
