"""`rclpy.init()`, `spin` and `shutdown`: too early, too late, twice, or with the wrong thing."""

from __future__ import annotations

from edulaunch.advice.errors.about import about

NO_INIT = about(
    'programs.no-init',
    what='ROS 2 does not run here: rclpy.init() was not called before this, or rclpy.shutdown() was',
    why='nodes and spin() need the context that rclpy.init() makes',
    do='call rclpy.init() first in main(), and rclpy.shutdown() last',
    types=('NotInitializedException',),
)
AFTER_SHUTDOWN = about(
    'programs.after-shutdown',
    what='ROS 2 has been shut down already (by rclpy.shutdown() or Ctrl-C)',
    why='after that no node can be made or used',
    do='move this line before rclpy.shutdown(), or ask rclpy.ok() first',
)
SHUTDOWN_TWICE = about(
    'programs.shutdown-twice',
    what='rclpy.shutdown() has nothing to shut down: it was called before, or Ctrl-C came, or rclpy.init() never ran',
    do='call rclpy.try_shutdown() instead',
    texts=('Context must be initialized before it can be shutdown',),
)
DESTROYED_NODE = about(
    'programs.destroyed-node',
    what="node '{node}' was destroyed before, by destroy_node()",
    do='move this line before destroy_node()',
)
NO_SUPER_INIT = about(
    'programs.no-super-init',
    what='{node} is used as a node before it is one: super().__init__() has not run',
    do="write super().__init__('node_name') as the first line of __init__",
)
OWN_PROPERTY = about(
    'programs.own-property',
    what='every node has its own {attribute}, which cannot be set',
    do='choose another name, such as self.{attribute}_',
)
SPIN_CLASS = about(
    'programs.spin-class', what='{given} is a class, not a node', do='make a node of it: {given}(), with its brackets'
)
SPIN_NO_NODE = about(
    'programs.spin-no-node', what='a node is needed here, not a {given}', do='give the node itself: rclpy.spin(node)'
)
NO_FUTURE = about(
    'programs.no-future',
    what='a future is needed here, not a {given}',
    do='give what client.call_async(request) returns: future = client.call_async(request)',
)
BARE_TIMEOUT = about(
    'programs.bare-timeout',
    what='the number {value} stands where an executor is expected',
    do='write the name of the argument: timeout_sec={value}',
)
NO_EXECUTOR = about(
    'programs.no-executor',
    what='an executor is needed here, not a {given}',
    do='leave it out, or make one: SingleThreadedExecutor()',
)
ENDED_EXECUTOR = about(
    'programs.ended-executor', what='this executor was shut down', do='make a new one: SingleThreadedExecutor()'
)
TWO_SPINNERS = about(
    'programs.two-spinners',
    what='another thread spins this executor already',
    do='give this thread its own: rclpy.spin(node, rclpy.executors.SingleThreadedExecutor())',
)
STOP_ITERATION = about(
    'programs.stop-iteration',
    what='next() found nothing more, and rclpy lets no StopIteration out of a callback',
    do='write next(values, None), and look whether it is None',
)
WAIT_SET = about(
    'programs.wait-set',
    what='the entities of a node wake its executor by themselves here',
    do='leave add_to_wait_set() empty and let is_ready() return True when there is something to do',
)
DOMAIN_ID = about(
    'programs.domain-id',
    what="the environment variable ROS_DOMAIN_ID is '{value}', which is no number",
    do='set it to a number from 0 to 101, or unset it',
)
RUNAWAY = about(
    'programs.runaway',
    what='a loop goes on and on and never waits, so nobody else gets a turn',
    do='let it wait in each round: time.sleep(), rclpy.spin_once(), rate.sleep(); or make a timer of it',
)
WITH_INIT = about(
    'programs.with-init',
    what='in ROS 2 Jazzy rclpy.init() gives nothing for `with`; later versions do',
    do='call rclpy.init() on a line of its own',
)
WITH_ENTITY = about(
    'programs.with-entity',
    what='in ROS 2 Jazzy a {thing} is not for `with`',
    do='make it on a line of its own, and call its {ending} at the end',
)
