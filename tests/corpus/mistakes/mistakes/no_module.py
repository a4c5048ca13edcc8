import rclpy
from gazebo_msgs.srv import SpawnEntity


def main():
    rclpy.init()
