"""rclcpp_components: Containers: programs that nodes are loaded into while they run."""
