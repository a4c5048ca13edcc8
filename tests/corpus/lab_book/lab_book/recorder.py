import atexit
import csv
from datetime import datetime
import json
from pathlib import Path
import pickle
import statistics
import tempfile

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float64


class Recorder(Node):
    """Writes a row for each message, and what it makes of them when it is stopped."""

    def __init__(self, folder):
        super().__init__('recorder')
        self.folder = Path(folder) / datetime.now().strftime('run_%Y-%m-%d_%H-%M-%S')
        self.folder.mkdir(parents=True, exist_ok=True)
        self.file = open(self.folder / 'log.csv', 'w', newline='')
        self.writer = csv.DictWriter(self.file, fieldnames=['t', 'temperature'])
        self.writer.writeheader()
        self.start = self.get_clock().now()
        self.values = []
        self.create_subscription(Float64, 'plant/temperature', self.save, 10)
        atexit.register(lambda: print(f'atexit: {len(self.values)} values'))

    def save(self, msg):
        t = (self.get_clock().now() - self.start).nanoseconds / 1e9
        self.writer.writerow({'t': f'{t:.1f}', 'temperature': round(msg.data, 2)})
        self.values.append(msg.data)

    def report(self):
        self.file.close()
        summary = {'n': len(self.values), 'mean': round(statistics.fmean(self.values), 2), 'max': round(max(self.values), 2)}
        (self.folder / 'summary.json').write_text(json.dumps(summary, indent=2))
        with open(self.folder / 'values.pkl', 'wb') as f:
            pickle.dump(self.values, f)
        with open(self.folder / 'log.csv') as f:
            rows = list(csv.DictReader(f))
        print(self.folder.name, sorted(p.name for p in self.folder.iterdir()))
        print(len(rows), rows[0], rows[-1], json.loads((self.folder / 'summary.json').read_text()))
        print(pickle.loads((self.folder / 'values.pkl').read_bytes()) == self.values)


def main():
    rclpy.init()
    with tempfile.TemporaryDirectory() as folder:
        node = Recorder(folder)
        try:
            rclpy.spin(node)
        except KeyboardInterrupt:
            print('Keyboard interrupt, saving...')
        node.report()
        node.destroy_node()
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
