from crane_msgs.msg import Twist
