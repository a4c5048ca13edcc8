"""examples_rclpy_pointcloud_publisher: A moving surface as a point cloud."""
