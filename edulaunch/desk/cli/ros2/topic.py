"""`ros2 topic echo|find|info|list|pub|type`. The module `topic_measuring` contains the other verbs."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

from edulaunch.desk.cli.ros2 import cli_node, graph_names, listening
from edulaunch.desk.cli.ros2.fill_message import FillError, fill_message, interface_class, parse_values
from edulaunch.desk.cli.ros2.output import complain, positive_float, say, with_help
from edulaunch.engine.nearest import did_you_mean
from edulaunch.engine.processes.current import current_process
from edulaunch.errors import InterfaceError

if TYPE_CHECKING:
    from rclpy.node import Node
    from rclpy.publisher import Publisher
    from rclpy.qos import QoSProfile


def find_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options and arguments of `ros2 topic find`."""
    graph_names.add_find_arguments(parser, 'topic', 'std_msgs/msg/String')


def find_verb(arguments: argparse.Namespace) -> None:
    """Print the topics that have a type, or only their number."""
    with cli_node.cli_node(arguments) as node:
        topics = graph_names.visible(node.get_topic_names_and_types(), arguments.include_hidden_topics)
    graph_names.say_found(topics, arguments.topic_type, arguments.count)


def info_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options and arguments of `ros2 topic info`."""
    graph_names.add_name_arguments(parser, 'topic', 'get info', '/chatter')
    parser.add_argument(
        '-v', '--verbose', action='store_true', help='Print each endpoint with its node, type and quality of service'
    )


def info_verb(arguments: argparse.Namespace) -> str | None:
    """Print the type of the topic, and the numbers of its publishers and subscriptions. With `-v`, also print each of them."""
    topic, end = arguments.topic_name, '\n\n' if arguments.verbose else '\n'
    with cli_node.cli_node(arguments) as node:
        topics = node.get_topic_names_and_types()
        types = graph_names.types_of(topic, topics)
        if not types:
            return with_help(f"Unknown topic '{topic}'", did_you_mean(topic, [name for name, _ in topics]))
        say(f'Type: {types[0] if len(types) == 1 else types}', end)
        for side, endpoints in (
            ('Publisher', node.get_publishers_info_by_topic(topic)),
            ('Subscription', node.get_subscriptions_info_by_topic(topic)),
        ):
            say(f'{side} count: {len(endpoints)}', end)
            for endpoint in endpoints if arguments.verbose else ():
                say(str(endpoint), end)
    return None


def list_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options and arguments of `ros2 topic list`."""
    graph_names.add_list_arguments(parser, 'topic')
    graph_names.add_hidden(parser, 'topic')
    parser.add_argument('-v', '--verbose', action='store_true', help='List full details about each topic')


def list_verb(arguments: argparse.Namespace) -> None:
    """Print the names of the topics. With `-v`, print the published topics, then the subscribed topics, with their counts."""
    with cli_node.cli_node(arguments) as node:
        topics = graph_names.visible(node.get_topic_names_and_types(), arguments.include_hidden_topics)
        if not arguments.verbose or arguments.count:
            graph_names.say_names(topics, arguments)
            return
        _say_details(node, topics, 'Published topics:', 'publisher')
        _say_details(node, topics, 'Subscribed topics:', 'subscriber')


def _say_details(node: Node, topics: graph_names.NamesAndTypes, heading: str, side: str) -> None:
    say(heading)
    for topic, types in topics:
        count = node.count_publishers(topic) if side == 'publisher' else node.count_subscribers(topic)
        if count:
            say(f' * {topic} [{", ".join(types)}] {count} {side}{"s" if count > 1 else ""}')
    say()


def type_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options and arguments of `ros2 topic type`."""
    graph_names.add_name_arguments(parser, 'topic', 'get type', '/chatter')


def type_verb(arguments: argparse.Namespace) -> int:
    """Print the type of the topic. As in ROS 2, return 1 without a message if there is no such topic."""
    with cli_node.cli_node(arguments) as node:
        return graph_names.say_types(arguments.topic_name, node.get_topic_names_and_types())


def echo_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options and arguments of `ros2 topic echo`."""
    graph_names.add_name_arguments(parser, 'topic', 'listen to', '/chatter')
    parser.add_argument('message_type', nargs='?', help="Type of the ROS message (e.g. 'std_msgs/msg/String')")
    listening.add_printing_arguments(parser)
    parser.add_argument('--once', action='store_true', help='Print the first message received and then exit')
    parser.add_argument('--timeout', metavar='N', type=float, help='Set a timeout in seconds for waiting')
    graph_names.add_hidden(parser, 'topic')
    listening.add_qos_arguments(parser, 'sensor_data')


def echo_verb(arguments: argparse.Namespace) -> str | int | None:
    """Print each message of the topic until Ctrl-C is pressed. With `--once`, stop after the first."""
    import rclpy

    with cli_node.cli_node(arguments) as node:
        cls = listening.topic_class(node, arguments.topic_name, arguments.message_type, verb='echo')
        if isinstance(cls, str):
            return cls
        topic = node.resolve_topic_name(arguments.topic_name)
        done = rclpy.task.Future()
        printer = listening.Printer(arguments, done)
        node.create_subscription(cls, topic, printer.on_message, _suitable_profile(node, topic, arguments), raw=arguments.raw)
        rclpy.spin_until_future_complete(node, done, timeout_sec=arguments.timeout)
    return None


def _suitable_profile(node: Node, topic: str, arguments: argparse.Namespace) -> QoSProfile:
    """Return the QoS profile for `ros2 topic echo`. Its reliability and durability match all publishers if possible.

    If only some publishers offer a policy, print a warning.
    """
    from rclpy.qos import DurabilityPolicy, ReliabilityPolicy

    profile = listening.qos_profile(arguments)
    offered = [endpoint.qos_profile for endpoint in node.get_publishers_info_by_topic(topic)]
    if listening.is_qos_chosen(arguments) or not offered:
        return profile
    reliable = sum(each.reliability == ReliabilityPolicy.RELIABLE for each in offered)
    kept = sum(each.durability == DurabilityPolicy.TRANSIENT_LOCAL for each in offered)
    for count, policy, falls_back in (
        (reliable, 'ReliabilityPolicy.RELIABLE', 'ReliabilityPolicy.BEST_EFFORT'),
        (kept, 'DurabilityPolicy.TRANSIENT_LOCAL', 'DurabilityPolicy.VOLATILE'),
    ):
        if 0 < count < len(offered):
            complain(
                f'Some, but not all, publishers are offering {policy}. '
                f'Falling back to {falls_back} as it will connect to all publishers'
            )
    profile.reliability = ReliabilityPolicy.RELIABLE if reliable == len(offered) else ReliabilityPolicy.BEST_EFFORT
    profile.durability = DurabilityPolicy.TRANSIENT_LOCAL if kept == len(offered) else DurabilityPolicy.VOLATILE
    return profile


def pub_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options and arguments of `ros2 topic pub`."""
    graph_names.add_name_arguments(parser, 'topic', 'publish to', '/chatter')
    parser.add_argument('message_type', help="Type of the ROS message (e.g. 'std_msgs/String')")
    group = parser.add_mutually_exclusive_group()
    group.add_argument('values', nargs='?', default='{}', help='Values to fill the message with in YAML format')
    group.add_argument('--stdin', action='store_true', help='Read values from standard input')
    parser.add_argument('-r', '--rate', metavar='N', type=positive_float, default=1.0, help='Publishing rate in Hz (default: 1)')
    parser.add_argument(
        '-p', '--print', metavar='N', type=int, default=1, help='Only print every N-th published message (default: 1)'
    )
    _add_times(parser)


def _add_times(parser: argparse.ArgumentParser) -> None:
    """Add the options for the number of messages, and for the subscriptions to wait for."""
    times = parser.add_mutually_exclusive_group()
    times.add_argument('-1', '--once', action='store_true', help='Publish one message and exit')
    times.add_argument('-t', '--times', type=int, default=0, help='Publish this number of times and then exit')
    parser.add_argument(
        '-w',
        '--wait-matching-subscriptions',
        type=int,
        default=None,
        help='Wait until finding the specified number of matching subscriptions (default: 1 when using -1 or -t, else 0)',
    )
    parser.add_argument('--max-wait-time-secs', type=positive_float, default=None, help='Longest wait for matching subscriptions')
    parser.add_argument(
        '--keep-alive', metavar='N', type=float, default=0.1, help='Keep publishing node alive for N seconds after the last msg'
    )
    parser.add_argument('-n', '--node-name', help='Name of the created publishing node')
    listening.add_qos_arguments(parser, 'default')


def pub_verb(arguments: argparse.Namespace) -> str | None:
    """Publish the message once, a given number of times, or until Ctrl-C."""
    try:
        cls = interface_class(arguments.message_type, 'msg')
    except InterfaceError as error:
        return with_help('The passed message type is invalid', error.help)
    with cli_node.cli_node(arguments, arguments.node_name) as node:
        message = cls()
        try:
            values = parse_values(current_process().streams.stdin.read() if arguments.stdin else arguments.values)
            stamps = fill_message(message, values, stamps=True)
        except FillError as error:
            return str(error)
        publisher = node.create_publisher(cls, arguments.topic_name, listening.qos_profile(arguments))
        times = 1 if arguments.once else arguments.times
        problem = _wait_for_subscriptions(node, publisher, arguments, default=1 if times else 0)
        if problem is None:
            _publish(node, publisher, message, stamps, arguments, times)
    return problem


def _wait_for_subscriptions(node: Node, publisher: Publisher, arguments: argparse.Namespace, default: int) -> str | None:
    """Wait until the publisher has enough subscriptions. Check every 0.1 s, and print a line each second.

    :return: an error message if the maximum wait time is over, otherwise None.
    """
    wanted = default if arguments.wait_matching_subscriptions is None else arguments.wait_matching_subscriptions
    looks = 0
    while publisher.get_subscription_count() < wanted:
        if looks % 10 == 0:
            say(f'Waiting for at least {wanted} matching subscription(s)...')
        if arguments.max_wait_time_secs is not None and looks / 10 >= arguments.max_wait_time_secs:
            return (
                f'Timed out waiting for subscribers: Expected {wanted} subcribers but only got '
                f'{publisher.get_subscription_count()} subscribers'
            )
        looks += 1
        if not cli_node.pause(node, 0.1):
            break
    return None


def _publish(
    node: Node, publisher: Publisher, message: Any, stamps: list[Any], arguments: argparse.Namespace, times: int
) -> None:
    say('publisher: beginning loop')
    period_ns, count = round(1e9 / arguments.rate), 0
    start_ns = current_process().sim.now_ns
    while node.context.ok():
        count += 1
        for stamp in stamps:
            stamp(node.get_clock().now().to_msg())
        if arguments.print and count % arguments.print == 0:
            say(f'publishing #{count}: {message!r}\n')
        publisher.publish(message)
        if count == times:
            cli_node.pause(node, arguments.keep_alive)
            return
        cli_node.pause_until(node, start_ns + count * period_ns)
