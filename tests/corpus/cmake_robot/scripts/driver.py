#!/usr/bin/env python3
import rclpy
from rclpy.node import Node
from cmake_robot.msg import Leg
from cmake_robot.srv import Plan


def main():
    rclpy.init()
    node = Node('driver')
    client = node.create_client(Plan, 'plan')
    client.wait_for_service()
    future = client.call_async(Plan.Request(legs=3))
    rclpy.spin_until_future_complete(node, future)
    for leg in future.result().plan:
        print(leg)
    print(Leg.get_fields_and_field_types())
    try:
        Leg(note='far too long a note')
    except AssertionError as e:
        print('refused:', str(e).splitlines()[0])
    try:
        Leg(lenght=3.0, check_fields=True)
    except AssertionError as e:
        print('refused:', str(e).splitlines()[0])


if __name__ == '__main__':
    main()
