"""Launch files as sources of launch descriptions."""

from typing import TYPE_CHECKING

from .._late import late_names

if TYPE_CHECKING:
    from .any_launch_description_source import AnyLaunchDescriptionSource as AnyLaunchDescriptionSource
    from .any_launch_file_utilities import InvalidLaunchFileError as InvalidLaunchFileError
    from .any_launch_file_utilities import (
        get_launch_description_from_any_launch_file as get_launch_description_from_any_launch_file,
    )
    from .frontend_launch_description_source import FrontendLaunchDescriptionSource as FrontendLaunchDescriptionSource
    from .frontend_launch_file_utilities import InvalidFrontendLaunchFileError as InvalidFrontendLaunchFileError
    from .frontend_launch_file_utilities import (
        get_launch_description_from_frontend_launch_file as get_launch_description_from_frontend_launch_file,
    )
    from .python_launch_description_source import PythonLaunchDescriptionSource as PythonLaunchDescriptionSource
    from .python_launch_file_utilities import InvalidPythonLaunchFileError as InvalidPythonLaunchFileError
    from .python_launch_file_utilities import (
        get_launch_description_from_python_launch_file as get_launch_description_from_python_launch_file,
    )
    from .python_launch_file_utilities import load_python_launch_file_as_module as load_python_launch_file_as_module
else:
    __all__, __getattr__, __dir__ = late_names(
        __name__,
        {
            'AnyLaunchDescriptionSource': 'any_launch_description_source',
            'FrontendLaunchDescriptionSource': 'frontend_launch_description_source',
            'InvalidFrontendLaunchFileError': 'frontend_launch_file_utilities',
            'InvalidLaunchFileError': 'any_launch_file_utilities',
            'InvalidPythonLaunchFileError': 'python_launch_file_utilities',
            'PythonLaunchDescriptionSource': 'python_launch_description_source',
            'get_launch_description_from_any_launch_file': 'any_launch_file_utilities',
            'get_launch_description_from_frontend_launch_file': 'frontend_launch_file_utilities',
            'get_launch_description_from_python_launch_file': 'python_launch_file_utilities',
            'load_python_launch_file_as_module': 'python_launch_file_utilities',
        },
    )
