from launch import LaunchDescription
from launch.actions import TimerAction
from launch_ros.actions import Node

NAMES = ['wrong_field', 'wrong_slot', 'int_for_float', 'no_return', 'bad_name', 'bad_topic', 'no_qos', 'no_super', 'no_init',
         'wrong_class', 'class_for_object', 'result_too_early', 'called_callback', 'two_arguments', 'no_module', 'message_class', 'not_a_service']


def generate_launch_description():
    ld = LaunchDescription([Node(package='mistakes', executable='healthy')])
    for i, name in enumerate(NAMES):
        ld.add_action(TimerAction(period=0.1 * i, actions=[Node(package='mistakes', executable=name)]))
    return ld
