from rclpy.logging import get_logging_severity_from_string

print(get_logging_severity_from_string('INFO'))
