import tkinter as tk
import rclpy


def main():
    rclpy.init()
    root = tk.Tk()
