"""Launch files of the different formats."""

from .._lazy import lazy_exports

_EXPORTS = {
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
}
__all__ = list(_EXPORTS)
__getattr__, __dir__ = lazy_exports(__name__, _EXPORTS)
