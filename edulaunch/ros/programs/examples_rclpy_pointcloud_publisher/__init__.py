"""examples_rclpy_pointcloud_publisher: A node that publishes a moving surface as a point cloud."""
