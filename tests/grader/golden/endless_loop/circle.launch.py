from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    turtles = 0
    while turtles < 3: turtle = turtles + 1
    return LaunchDescription([])
