import logging
from functools import partial

import rclpy
from callables.base import BaseNode, announced
from std_msgs.msg import String
from std_srvs.srv import Trigger


class Counter:
    """An object that can be called."""

    def __init__(self):
        self.count = 0

    def __call__(self, msg):
        self.count += 1
        print('counter', self.count, msg.data)


class Everything(BaseNode):
    WORDS = ('one', 'two', 'three')

    def set_up(self):
        self.pub = self.create_publisher(msg_type=String, topic='words', qos_profile=10)
        self.subs = [
            self.create_subscription(msg_type=String, topic='words', callback=callback, qos_profile=10)
            for callback in (self.on_word, self.plain, Counter(), partial(self.tagged, 'tag'), self.__hidden,
                             lambda msg, me='lambda': print(me, msg.data), self.with_info, print)]
        self.words = iter(self.WORDS)
        self.create_service(srv_type=Trigger, srv_name='~/reset', callback=self.reset)
        self.timer = self.create_timer(timer_period_sec=1, callback=self.tick)

    @announced
    def on_word(self, msg):
        self.last = msg.data

    @staticmethod
    def plain(msg):
        print('static', msg.data)

    def tagged(self, tag, msg):
        print(tag, msg.data)

    def __hidden(self, msg):
        print('hidden', msg.data)

    def with_info(self, msg, info):
        print('info', sorted(info)[-1], msg.data)

    @announced
    def reset(self, request, response):
        self.words = iter(self.WORDS)
        response.success = True
        return response

    def tick(self):
        word = next(self.words, None)
        if word is None:
            self.timer.cancel()
            self.create_timer(0.5, self.stop)
            return
        self.pub.publish(String(data=word))
        if word == 'two':
            for subscription in self.subs[4:]:
                self.destroy_subscription(subscription)

    def stop(self):
        raise KeyboardInterrupt


def main():
    logging.basicConfig(level=logging.INFO, format='%(levelname)s %(name)s: %(message)s')
    logging.getLogger(__name__).info('the standard logging')
    rclpy.init()
    node = Everything('everything', namespace='all')
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        node.get_logger().info('stopped')
    client = node.create_client(Trigger, '~/reset')
    future = client.call_async(Trigger.Request())
    while rclpy.ok() and not future.done():
        rclpy.spin_once(node)
    node.get_logger().info(f'reset: {future.result().success}')
    node.destroy_node()
    try:
        print(node.get_name())
    except Exception as error:
        print(type(error).__name__, error)
    rclpy.shutdown()
