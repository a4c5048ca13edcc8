import rclpyy
