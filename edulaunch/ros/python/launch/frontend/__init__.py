"""Launch files in formats other than Python: code that XML and YAML share, and functions to extend both formats."""

from typing import TYPE_CHECKING

from .._late import late_names

if TYPE_CHECKING:
    from . import parse_substitution as parse_substitution
    from . import type_utils as type_utils
    from .entity import Entity as Entity
    from .expose import expose_action as expose_action
    from .expose import expose_substitution as expose_substitution
    from .invalid_frontend_launch_file_error import InvalidFrontendLaunchFileError as InvalidFrontendLaunchFileError
    from .parser import Parser as Parser
else:
    __all__, __getattr__, __dir__ = late_names(
        __name__,
        {
            'Entity': 'entity',
            'InvalidFrontendLaunchFileError': 'invalid_frontend_launch_file_error',
            'Parser': 'parser',
            'expose_action': 'expose',
            'expose_substitution': 'expose',
        },
        modules=('parse_substitution', 'type_utils'),
    )
