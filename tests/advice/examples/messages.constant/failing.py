from action_msgs.msg import GoalStatus

GoalStatus.STATUS_SUCCEEDED = 3
