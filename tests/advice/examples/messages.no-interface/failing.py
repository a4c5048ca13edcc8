from std_msgs.msg import Twist
