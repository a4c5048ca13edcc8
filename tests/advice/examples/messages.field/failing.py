from geometry_msgs.msg import Twist

print(Twist().linaer.x)
