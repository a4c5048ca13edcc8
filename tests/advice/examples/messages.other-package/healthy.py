from geometry_msgs.msg import Twist
