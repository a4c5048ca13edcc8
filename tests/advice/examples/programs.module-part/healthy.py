from rclpy.node import Node
