from action_msgs.msg import GoalStatus

STATUS_SUCCEEDED = 3
