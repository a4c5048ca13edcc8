"""rclcpp_components: Containers, which are programs that load nodes while they run."""
