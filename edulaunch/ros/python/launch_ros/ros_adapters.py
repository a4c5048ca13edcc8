"""Launch's own ROS node, for actions that call services or subscribe to topics."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from launch._bases import ReadOnly

if TYPE_CHECKING:
    import asyncio

    from launch.launch_context import LaunchContext
    from rclpy.node import Node

_KEY = 'ros_adapter'


class ROSAdapter:
    """A private rclpy context with the node `launch_ros_<pid>`, which runs in a thread of its own.

    :param argv: command line arguments for rclpy.
    :param autostart: whether to call :meth:`start` immediately.
    """

    def __init__(self, *, argv: list[str] | None = None, autostart: bool = True) -> None:
        self.__argv = [] if argv is None else argv
        self.__ros_context: Any = None
        self.__ros_node: Any = None
        self.__ros_executor: Any = None
        self.__thread: Any = None
        if autostart:
            self.start()

    def start(self) -> None:
        """Create the node, and start the thread that spins it.

        :raises RuntimeError: when the adapter is already running.
        """
        if self.__ros_context is not None:
            raise RuntimeError('Cannot start a ROS adapter that is already running')
        import rclpy
        from rclpy.executors import SingleThreadedExecutor

        from edulaunch.engine.processes import current_process

        process = current_process()
        self.__ros_context = rclpy.context.Context()
        rclpy.init(args=self.__argv, context=self.__ros_context)
        self.__ros_node = rclpy.create_node(f'launch_ros_{process.pid}', context=self.__ros_context)
        self.__ros_executor = SingleThreadedExecutor(context=self.__ros_context)
        self.__ros_executor.add_node(self.__ros_node)
        self.__thread = process.start_thread(self._run, 'launch_ros', daemon=True)

    def _run(self) -> None:
        from rclpy.executors import ExternalShutdownException

        try:
            self.__ros_executor.spin()
        except (ExternalShutdownException, KeyboardInterrupt):
            return  # launch is shutting down

    def shutdown(self) -> None:
        """Stop spinning and destroy the node.

        :raises RuntimeError: when the adapter is not running.
        """
        if self.__ros_context is None:
            raise RuntimeError('Cannot shutdown a ROS adapter that is not running')
        import rclpy

        self.__ros_executor.shutdown(0)
        self.__ros_node.destroy_node()
        rclpy.shutdown(context=self.__ros_context)
        self.__ros_context = None

    argv: ReadOnly[list[str]] = ReadOnly('The command line arguments for rclpy.')
    ros_context: ReadOnly[Any] = ReadOnly('The rclpy context.')

    @property
    def ros_node(self) -> Node:
        """The node."""
        node: Node = self.__ros_node
        return node

    ros_executor: ReadOnly[Any] = ReadOnly('The executor that spins the node.')


def get_ros_adapter(context: LaunchContext) -> ROSAdapter:
    """Return the adapter of a launch. The first call creates the adapter, and the shutdown of the launch also shuts it down."""
    if _KEY not in context.get_locals_as_dict():
        from launch.event_handlers.on_shutdown import OnShutdown

        adapter = ROSAdapter(argv=list(context.argv or ()))
        context.extend_globals({_KEY: adapter})
        context.register_event_handler(OnShutdown(on_shutdown=lambda *_: adapter.shutdown()))
    found: ROSAdapter = getattr(context.locals, _KEY)
    return found


def get_ros_node(context: LaunchContext) -> Node:
    """Return the node of :func:`get_ros_adapter`."""
    return get_ros_adapter(context).ros_node


async def call_service(context: LaunchContext, service_type: Any, name: str, request: Any) -> Any:
    """Send the request when the service is available, and return the reply. Return None if launch shuts down first."""
    if context.is_shutdown:  # it was announced before this subscription existed, so no message would arrive here
        return None
    from launch.event_handlers.on_shutdown import OnShutdown

    from edulaunch.engine.processes import current_process

    loop = context.asyncio_loop
    node = get_ros_node(context)
    client = node.create_client(service_type, name)
    answer: asyncio.Future[Any] = loop.create_future()

    def ask() -> None:
        client.wait_for_service()
        future = client.call_async(request)
        future.add_done_callback(lambda done: loop.call_soon_threadsafe(_settle, answer, done.result()))

    abandon = OnShutdown(on_shutdown=lambda *_: _settle(answer, None))
    context.register_event_handler(abandon)
    thread = current_process().start_thread(ask, name, daemon=True)
    try:
        return await answer
    finally:
        thread.kill()
        node.destroy_client(client)
        context.unregister_event_handler(abandon)


def _settle(answer: asyncio.Future[Any], value: Any) -> None:
    if not answer.done():
        answer.set_result(value)
