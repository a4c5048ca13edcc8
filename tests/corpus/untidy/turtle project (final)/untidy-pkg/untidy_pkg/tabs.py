# -*- coding: utf-8 -*-
# Grüße von der Schildkröte: läuft im Kreis
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

class Schildkröte(Node):
	def __init__(self):
		super().__init__("schildkroete")
		self.größe = 3
		self.create_timer(1.0, self.grüßen)

	def grüßen(self):
		self.get_logger().info("Grüß Gott №%d → 🐢" % self.größe)

def main(args=None):
	rclpy.init(args=args)
	rclpy.spin(Schildkröte())
