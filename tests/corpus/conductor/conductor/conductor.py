import rclpy
from example_interfaces.msg import Int64
from lifecycle_msgs.msg import Transition, TransitionEvent
from lifecycle_msgs.srv import ChangeState, GetAvailableTransitions, GetState
from rclpy.node import Node


class Conductor(Node):

    def __init__(self):
        super().__init__('conductor')
        self.name = self.declare_parameter('node', 'player').value
        self.create_subscription(Int64, 'number', lambda m: print('heard', m.data), 10)
        self.create_subscription(TransitionEvent, f'/{self.name}/transition_event', self.on_event, 10)
        self.change = self.create_client(ChangeState, f'/{self.name}/change_state')
        self.state = self.create_client(GetState, f'/{self.name}/get_state')
        self.transitions = self.create_client(GetAvailableTransitions, f'/{self.name}/get_available_transitions')
        self.change.wait_for_service()

    def on_event(self, event):
        print(f'  {event.start_state.label} -> {event.goal_state.label}')

    def ask(self, client, request):
        future = client.call_async(request)
        rclpy.spin_until_future_complete(self, future)
        return future.result()

    def do(self, **transition):
        done = self.ask(self.change, ChangeState.Request(transition=Transition(**transition)))
        state = self.ask(self.state, GetState.Request()).current_state
        possible = self.ask(self.transitions, GetAvailableTransitions.Request()).available_transitions
        names = ', '.join(each.transition.label for each in possible)
        self.get_logger().info(f'{done.success}: {state.id} {state.label}; now possible: {names}')

    def wait(self, seconds):
        end = self.get_clock().now() + rclpy.duration.Duration(seconds=seconds)
        while self.get_clock().now() < end:
            rclpy.spin_once(self, timeout_sec=0.1)


def main(args=None):
    rclpy.init(args=args)
    node = Conductor()
    node.do(id=Transition.TRANSITION_CONFIGURE)
    node.wait(1.1)
    node.do(id=Transition.TRANSITION_ACTIVATE)
    node.wait(1.1)
    node.do(label='deactivate')
    node.do(label='cleanup')
    node.do(label='configure')
    node.do(label='configure')
    node.do(label='activate')
    node.do(label='deactivate')
    node.do(label='shutdown')
    rclpy.shutdown()
