import pytest

from edulaunch.ros.serialization.type_description import type_description, type_hash


def test_the_hash_of_a_string_is_the_one_of_every_ros(registry):
    assert type_hash('std_msgs/msg/String', registry.spec) == (
        'RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18'
    )


def test_the_hash_of_a_service_is_the_one_that_ros_announces(registry):
    assert type_hash('example_interfaces/srv/AddTwoInts', registry.spec) == (
        'RIHS01_e118de6bf5eeb66a2491b5bda11202e7b68f198d6f67922cf30364858239c81a'
    )


def test_a_description_holds_all_types_that_it_refers_to(registry):
    described = type_description('tf2_msgs/msg/TFMessage', registry.spec)
    assert described['type_description']['fields'] == [
        {
            'name': 'transforms',
            'type': {
                'type_id': 145,
                'capacity': 0,
                'string_capacity': 0,
                'nested_type_name': 'geometry_msgs/msg/TransformStamped',
            },
        }
    ]
    assert [each['type_name'] for each in described['referenced_type_descriptions']] == [
        'builtin_interfaces/msg/Time',
        'geometry_msgs/msg/Quaternion',
        'geometry_msgs/msg/Transform',
        'geometry_msgs/msg/TransformStamped',
        'geometry_msgs/msg/Vector3',
        'std_msgs/msg/Header',
    ]


def test_every_hash_equals_that_of_rosbags(registry):
    """Except for `char`, which rosbags keeps. ROS makes it uint8: AddTwoInts above has one in its event."""
    typesys = pytest.importorskip('rosbags.typesys', reason='rosbags, the oracle, is not installed')
    store = typesys.get_typestore(typesys.Stores.ROS2_JAZZY)
    odd = ('rmw_dds_common/',)  # there a Gid is of char
    names = [name for name in registry.types('msg') if not name.startswith(odd)]
    common = [name for name in names if name in store.fielddefs and 'char' not in registry.text(name)]
    assert len(common) == 154
    differing = [name for name in common if type_hash(name, registry.spec) != store.hash_rihs01(name)]
    assert differing == []
