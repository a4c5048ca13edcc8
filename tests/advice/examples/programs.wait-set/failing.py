import rclpy
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.node import Node
from rclpy.waitable import Waitable


class Watch(Waitable):
    def is_ready(self, wait_set):
        return False

    def take_data(self):
        return None

    async def execute(self, taken):
        pass

    def get_num_entities(self):
        from rclpy.waitable import NumberOfEntities

        return NumberOfEntities()

    def add_to_wait_set(self, wait_set):
        wait_set.add_timer(None)


rclpy.init()
node = Node('robot')
node.add_waitable(Watch(ReentrantCallbackGroup()))
rclpy.spin_once(node, timeout_sec=0.1)
