"""The functions behind `ros2 launch`."""

from .api import (
    MultipleLaunchFilesError,
    get_share_file_path_from_package,
    is_launch_file,
    launch_a_launch_file,
    parse_launch_arguments,
    print_a_launch_file,
    print_arguments_of_launch_file,
)

__all__ = [
    'MultipleLaunchFilesError',
    'get_share_file_path_from_package',
    'is_launch_file',
    'launch_a_launch_file',
    'parse_launch_arguments',
    'print_a_launch_file',
    'print_arguments_of_launch_file',
]
