from launch import LaunchDescription


def generate_launch_descripton():
    return LaunchDescription([])
