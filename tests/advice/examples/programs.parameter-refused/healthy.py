import rclpy
from rcl_interfaces.srv import SetParameters
from rclpy.node import Node
from rclpy.parameter import Parameter

rclpy.init()
robot = Node('robot')
robot.declare_parameter('speed', 1.0)
operator = Node('operator')
client = operator.create_client(SetParameters, '/robot/set_parameters')
request = SetParameters.Request(parameters=[Parameter('speed', value=2.0).to_parameter_msg()])
client.call_async(request)
executor = rclpy.executors.SingleThreadedExecutor()
executor.add_node(robot)
executor.add_node(operator)
executor.spin()
