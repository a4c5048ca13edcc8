from geometry_msgs.msg import Twist

Twist().linear.x = 1.0
