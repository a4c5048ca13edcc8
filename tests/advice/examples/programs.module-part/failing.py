from rclpy.nod import Node
