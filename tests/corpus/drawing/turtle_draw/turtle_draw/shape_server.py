#!/usr/bin/env python3
import rclpy
from rclpy.node import Node
from draw_interfaces.srv import GetShape
from draw_interfaces.msg import Drawing, Stroke
from std_msgs.msg import ColorRGBA
from builtin_interfaces.msg import Duration

from .shapes import polygon


class ShapeServer(Node):
    def __init__(self):
        super().__init__("shape_server")
        self.srv = self.create_service(GetShape, "get_shape", self.cb)
        self.latest = self.create_publisher(Drawing, 'drawing', 10)
        self.get_logger().info("Shape server is up, default name is '%s'" % Stroke.DEFAULT_NAME)

    def cb(self, request, response):
        self.get_logger().info(f"request: {request}")
        if request.sides < 3:
            response.success = False
            response.code = GetShape.Response.BAD
            self.get_logger().warn('can not draw a shape with %d sides' % request.sides)
            return response
        skip = 2 if request.sides == GetShape.Request.STAR else 1
        s = Stroke()
        s.name = f'poly{request.sides}'
        s.points = polygon(request.sides, request.size, skip=skip)
        s.color = ColorRGBA(r=1.0, a=1.0)
        s.tags.append('auto')
        xs = [p.x for p in s.points]
        ys = [p.y for p in s.points]
        s.bbox = [min(xs), min(ys), max(xs), max(ys)]
        d = Drawing()
        d.header.stamp = self.get_clock().now().to_msg()
        d.header.frame_id = 'canvas'
        d.strokes.append(s)
        for o in request.offsets:
            extra = Stroke(name='offset', pen=Stroke.PEN_UP)
            extra.points = [type(s.points[0])(x=p.x + o.x, y=p.y + o.y) for p in s.points]
            d.strokes.append(extra)
        d.took = Duration(sec=0, nanosec=1000)
        response.success = True
        response.code = response.OK
        response.drawing = d
        self.latest.publish(d)
        return response


def main(args=None):
    rclpy.init(args=args)
    node = ShapeServer()
    rclpy.spin(node)
    rclpy.shutdown()


if __name__ == "__main__":
    main()
