from geometri_msgs.msg import Twist
