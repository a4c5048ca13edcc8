from launch import LaunchDescripton


def generate_launch_description():
    return LaunchDescripton([])
