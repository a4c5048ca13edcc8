import threading
import rclpy


def main():
    rclpy.init()
    node = rclpy.create_node('simple_node')

    # Spin in a separate thread
    thread = threading.Thread(target=rclpy.spin, args=(node, ), daemon=True)
    thread.start()

    rate = node.create_rate(2)

    count = 0
    try:
        while rclpy.ok() and count < 3:
            print('Help me body, you are my only hope')
            rate.sleep()
            count += 1
    except KeyboardInterrupt:
        pass

    rclpy.shutdown()
    thread.join()
    print('joined')


if __name__ == '__main__':
    main()
