import launch
import launch_ros.actions


def generate_launch_description():
    return launch.LaunchDescription([
        launch_ros.actions.Node(package='thread_rate', executable='rate_main', name='my_rate', output='screen'),
        launch_ros.actions.Node(package='thread_rate', executable='worker', output='screen'),
    ])
