"""Where tf2 says that it has refused a transform: the unnamed logger at the root of all loggers."""

from __future__ import annotations

from edulaunch.tf.rejection import Rejection


def report(rejections: tuple[Rejection, ...]) -> None:
    """Log each line with its severity."""
    from rclpy.impl.rcutils_logger import RcutilsLogger
    from rclpy.logging import LoggingSeverity

    logger = RcutilsLogger('')
    for severity, text in rejections:
        logger.log(text, LoggingSeverity.ERROR if severity == 'error' else LoggingSeverity.WARN)
