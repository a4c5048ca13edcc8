"""Programs that open a window in ROS 2, and what shows the same here."""

WINDOWS = {
    'rqt': 'graph',
    'rqt_console': 'log',
    'rqt_graph': 'graph',
    'rqt_plot': 'plot',
    'rqt_publisher': 'terminal',
    'rqt_reconfigure': 'parameters',
    'rqt_service_caller': 'terminal',
    'rqt_tf_tree': 'tree',
    'rviz2': 'frames',
}
"""Command or package, and the tab of the live page."""


def shown_by(name: str) -> str:
    """The sentence that says where to look."""
    return f'{name} opens a window, and there is none here: `edulaunch view --tab {WINDOWS[name]}` shows it in a browser'
