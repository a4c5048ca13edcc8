"""Convert ROS 2 names to DDS names: '/chatter' becomes 'rt/chatter', and std_msgs/msg/String becomes
std_msgs::msg::dds_::String_.
"""

from __future__ import annotations

from edulaunch.extras.network.network_link import CLIENT, PUBLISHER, SERVICE, SUBSCRIPTION

TOPIC, REQUEST, REPLY = 'rt', 'rq', 'rr'
SUFFIX = {TOPIC: '', REQUEST: 'Request', REPLY: 'Reply'}
LONGEST = 512


def topic_name(prefix: str, name: str) -> str:
    """Return the DDS topic of a ROS topic, or of the requests or replies of a service."""
    return f'{prefix}{name}{SUFFIX[prefix]}'


def dds_type(type_name: str) -> str:
    """Return the DDS name of a type, such as 'geometry_msgs::msg::dds_::Twist_' for 'geometry_msgs/msg/Twist'."""
    package, kind, name = type_name.split('/')
    return f'{package}::{kind}::dds_::{name}_'


def remote_name(topic: str, type_name: str, is_writer: bool) -> tuple[str, str, str] | None:
    """Return (kind, name, type name) in ROS 2 for a DDS endpoint, or None if it is not a topic or service of ROS 2.

    The reader of requests identifies a service, and the writer of requests identifies a client.
    """
    prefix, slash, rest = topic.partition('/')
    parts = type_name.split('::')
    if not slash or prefix not in (TOPIC, REQUEST) or len(parts) != 4 or parts[2] != 'dds_' or len(topic) > LONGEST:
        return None
    package, middle, _, name = parts
    name, suffix = name.removesuffix('_'), SUFFIX[prefix]
    if prefix == TOPIC:
        return (PUBLISHER if is_writer else SUBSCRIPTION), f'/{rest}', f'{package}/{middle}/{name}'
    if not (rest.endswith(suffix) and name.endswith('_Request')):
        return None
    service = f'{package}/{middle}/{name.removesuffix("_Request")}'
    return (CLIENT if is_writer else SERVICE), f'/{rest.removesuffix(suffix)}', service
