import random
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Game(Node):
    def __init__(self):
        super().__init__('game')
        self.pub = self.create_publisher(String, 'score', 10)
        self.secret = 7
        self.tries = 0

    def play(self):
        name = input("Your name: ")
        while True:
            try:
                guess = int(input("Guess a number: "))
            except ValueError:
                print("That is no number!")
                continue
            self.tries += 1
            if guess == self.secret:
                break
            print("too " + ("small" if guess < self.secret else "big"))
        self.pub.publish(String(data=f"{name} needed {self.tries}"))


def main(args=None):
    rclpy.init(args=args)
    game = Game()
    game.play()
    game.destroy_node()
    rclpy.shutdown()
