import queue
import threading
import time
import rclpy
from rclpy.node import Node
from std_msgs.msg import Int32


class Worker(Node):
    def __init__(self):
        super().__init__('worker')
        self.lock = threading.Lock()
        self.jobs = queue.Queue()
        self.done = 0
        self.pub = self.create_publisher(Int32, 'done', 10)
        self.create_timer(0.25, self.produce)
        self.thread = threading.Thread(target=self.work)
        self.thread.daemon = True
        self.thread.start()

    def produce(self):
        if self.jobs.qsize() < 3:
            self.jobs.put(time.time())

    def work(self):
        while True:
            born = self.jobs.get()
            time.sleep(0.4)
            with self.lock:
                self.done += 1
                age = time.time() - born
                self.get_logger().info('job %d is %.2f s old, %d waiting' % (self.done, age, self.jobs.qsize()))
            self.pub.publish(Int32(data=self.done))


def main():
    rclpy.init()
    node = Worker()
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass
