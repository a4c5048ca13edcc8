#!/usr/bin/env python3
import rclpy
from rclpy.node import Node
from robot_lib.maths import squares
from cmake_robot.msg import Leg
from cmake_robot.srv import Plan


class Planner(Node):
    def __init__(self):
        super().__init__('planner')
        self.create_service(Plan, 'plan', self.plan)

    def plan(self, request, response):
        for i in range(request.legs):
            leg = Leg(kind=Leg.TURN if i % 2 else Leg.STRAIGHT)
            leg.cell = [i, i + 1]
            leg.profile = squares(i)
            leg.target.x = float(i)
            leg.note = 'leg %d' % i
            response.plan.append(leg)
        response.ok = True
        return response


if __name__ == '__main__':
    rclpy.init()
    rclpy.spin(Planner())
