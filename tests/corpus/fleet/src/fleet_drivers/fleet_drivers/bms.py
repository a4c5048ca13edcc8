#!/usr/bin/env python3
# battery management
import math

import rclpy
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus, KeyValue
from rclpy.node import Node
from sensor_msgs.msg import BatteryState


class Bms(Node):
    def __init__(self):
        super().__init__('bms')
        self.soc = 1.0
        self.pub = self.create_publisher(BatteryState, 'battery', 10)
        self.diag = self.create_publisher(DiagnosticArray, '/diagnostics', 10)
        self.create_timer(0.6, self.tick)

    def tick(self):
        self.soc -= 0.31
        m = BatteryState(voltage=12.0 * self.soc, percentage=self.soc, temperature=math.nan, present=True)
        m.power_supply_status = BatteryState.POWER_SUPPLY_STATUS_DISCHARGING
        m.cell_voltage = [3.7] * 4
        self.pub.publish(m)
        level = DiagnosticStatus.OK
        if self.soc < 0.5: level = DiagnosticStatus.WARN
        if self.soc < 0.2: level = DiagnosticStatus.ERROR
        st = DiagnosticStatus(level=level, name=self.get_namespace() + ': battery', message='%.0f%%' % (100 * self.soc))
        st.values.append(KeyValue(key='soc', value=str(round(self.soc, 2))))
        self.diag.publish(DiagnosticArray(status=[st]))
        if level == DiagnosticStatus.ERROR:
            self.get_logger().error('battery empty: %s' % st.level)
            raise SystemExit(7)


def main():
    rclpy.init()
    n = Bms()
    rclpy.spin(n)
