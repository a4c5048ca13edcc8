from launch.action_s import LogInfo


def generate_launch_description():
    return LaunchDescription([LogInfo(msg='hello')])
