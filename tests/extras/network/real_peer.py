"""A node on the real rclpy, run by its own Python: does what its arguments say until its input ends, one line of JSON for each thing."""

from __future__ import annotations

import json
import sys
import threading
from contextlib import suppress

import rclpy
import rclpy.executors
from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from std_msgs.msg import String
from std_srvs.srv import Trigger

STAYS = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
LOOSE = QoSProfile(depth=10, reliability=ReliabilityPolicy.BEST_EFFORT)


def tell(what, *values):
    print(json.dumps([what, *values]), flush=True)


class Peer(Node):
    def __init__(self, words):
        super().__init__('real_peer', namespace='/lab')
        for word in words:
            what, _, rest = word.partition('=')
            getattr(self, what)(*rest.split(','))
        tell('begun')

    def say(self, topic, text):
        publisher = self.create_publisher(String, topic, 10)
        self.create_timer(0.05, lambda: publisher.publish(String(data=text)))

    def raw(self, topic, *data):
        publisher = self.create_publisher(String, topic, 10)
        self.create_timer(0.05, lambda: [publisher.publish(bytes.fromhex(each)) for each in data])

    def hear(self, topic, stays=''):
        self.create_subscription(String, topic, lambda message: tell('heard', message.data), STAYS if stays else 10)

    def count(self, topic):
        heard = []
        self.create_subscription(String, topic, lambda message: (heard.append(0), tell('count', len(heard))), 10)

    def hear_log(self, _):
        from rcl_interfaces.msg import Log

        self.create_subscription(Log, '/rosout', lambda message: tell('log', message.name, message.msg), 100)

    def hear_loosely(self, topic):
        events = PublisherEventCallbacks(incompatible_qos=lambda event: tell('incompatible', event.last_policy_kind.name))
        self.create_publisher(String, topic, LOOSE, event_callbacks=events)

    def hear_strictly(self, topic):
        events = SubscriptionEventCallbacks(incompatible_qos=lambda event: tell('incompatible', event.last_policy_kind.name))
        self.create_subscription(String, topic, lambda message: None, 10, event_callbacks=events)

    def look(self, topic):
        def now():
            nodes = sorted('/'.join((namespace.rstrip('/'), name)) for name, namespace in self.get_node_names_and_namespaces())
            ends = [*self.get_publishers_info_by_topic(topic), *self.get_subscriptions_info_by_topic(topic)]
            rows = [
                [end.endpoint_type.name, end.node_name, end.topic_type, str(end.topic_type_hash), end.qos_profile.durability.name]
                for end in ends
            ]
            tell('sees', nodes, rows)

        self.create_timer(0.2, now)

    def want(self, service):
        client = self.create_client(Trigger, service)
        self.create_timer(0.2, lambda: tell('ready', client.service_is_ready()))


def main():
    rclpy.init(args=[])
    peer = Peer(sys.argv[1:])
    threading.Thread(target=lambda: (sys.stdin.read(), rclpy.try_shutdown()), daemon=True).start()
    with suppress(rclpy.executors.ExternalShutdownException, KeyboardInterrupt):
        rclpy.spin(peer)


main()
