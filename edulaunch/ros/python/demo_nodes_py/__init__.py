"""demo_nodes_py: small rclpy programs for first steps."""
