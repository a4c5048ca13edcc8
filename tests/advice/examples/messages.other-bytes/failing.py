from geometry_msgs.msg import Twist
from rclpy.serialization import deserialize_message, serialize_message
from std_msgs.msg import Bool

print(deserialize_message(serialize_message(Bool()), Twist).linear.x)
