import copy
import math
import pickle
from array import array

import pytest

from edulaunch.engine.interfaces.generator import module_of
from edulaunch.engine.interfaces.registry import Registry

EVERYTHING = """
byte LEVEL=2
uint8 MODE=7
string NAME=robot
bool flag true
byte level
char letter
int8 small -3
float32 third 0.1
string<=5 short "abc"
wstring wide
float64[3] fixed
uint8[2] id [1, 2]
int32[] many [4, 5]
float64[<=2] few
string[] words ["a", "b"]
bool[2] pair
byte[] raw
geometry_msgs/Point[2] ends
geometry_msgs/Point[<=1] middle
geometry_msgs/Quaternion turn
"""


@pytest.fixture
def everything(define):
    return define('Everything.msg', EVERYTHING)


def test_a_class_is_named_as_ros_names_it(get):
    cls = get('geometry_msgs/msg/TransformStamped')
    assert (cls.__module__, cls.__name__, cls.TYPE) == (
        'geometry_msgs.msg._transform_stamped',
        'TransformStamped',
        'geometry_msgs/msg/TransformStamped',
    )
    assert module_of('turtlesim/srv/Spawn_Request') == 'turtlesim.srv._spawn'


def test_fields_start_with_their_defaults(everything):
    msg = everything()
    assert (msg.flag, msg.level, msg.letter, msg.small, msg.third, msg.short) == (True, b'\0', 0, -3, 0.1, 'abc')
    assert (msg.many, msg.few, msg.words, msg.pair, msg.raw) == (array('i', [4, 5]), array('d'), ['a', 'b'], [False] * 2, [])
    assert (msg.fixed.tolist(), msg.id.tolist(), str(msg.id.dtype)) == ([0.0] * 3, [1, 2], 'uint8')
    assert (len(msg.ends), msg.middle, msg.turn.w) == (2, [], 1.0)


def test_constants_and_defaults_are_on_the_class(everything):
    assert (everything.LEVEL, everything.MODE, everything.NAME) == (b'\2', 7, 'robot')
    assert (True, array('i', [4, 5]), ['a', 'b']) == (
        everything.FLAG__DEFAULT,
        everything.MANY__DEFAULT,
        everything.WORDS__DEFAULT,
    )
    assert everything.ID__DEFAULT.tolist() == [1, 2]


def test_two_messages_never_share_a_default(everything):
    first = everything()
    first.many.append(6)
    first.words.append('c')
    first.fixed[0] = 1.0
    first.ends[0].x = 1.0
    assert everything() == everything() != first


def test_slots_and_field_types_are_those_of_ros(get):
    cls = get('geometry_msgs/msg/Twist')
    assert cls.__slots__ == ['_linear', '_angular', '_check_fields']
    assert cls.get_fields_and_field_types() == {'linear': 'geometry_msgs/Vector3', 'angular': 'geometry_msgs/Vector3'}


def test_a_constant_cannot_be_assigned_to(get):
    cls = get('action_msgs/msg/GoalStatus')
    with pytest.raises(AttributeError, match="^property 'STATUS_ABORTED' of 'Metaclass_GoalStatus' object has no setter"):
        cls.STATUS_ABORTED = 3
    assert cls.STATUS_ABORTED == cls().STATUS_ABORTED == 6


@pytest.mark.parametrize('how', [copy.deepcopy, lambda msg: pickle.loads(pickle.dumps(msg))], ids=['deepcopy', 'pickle'])
def test_a_copy_is_equal_and_shares_nothing(get, how):
    msg = get('geometry_msgs/msg/PoseWithCovariance')()
    msg.pose.position.x = 0.1
    msg.covariance[3] = 2.0
    other = how(msg)
    assert other == msg
    other.covariance[3] = 0.0
    other.pose.position.x = 0.2
    assert (msg.covariance[3], msg.pose.position.x) == (2.0, 0.1)


def test_copy_shares_what_the_original_holds(get):
    msg = get('geometry_msgs/msg/Twist')()
    assert copy.copy(msg).linear is msg.linear


def test_messages_are_equal_by_class_and_fields(get):
    point, vector = get('geometry_msgs/msg/Point'), get('geometry_msgs/msg/Vector3')
    assert point(x=1.0) == point(x=1.0) != point(x=2.0)
    assert point() != vector()
    with pytest.raises(TypeError):
        hash(point())


def test_a_misspelt_field_cannot_be_assigned(get):
    with pytest.raises(AttributeError, match="^'Twist' object has no attribute 'linaer'"):
        get('geometry_msgs/msg/Twist')().linaer = 1.0


def test_an_array_is_kept_and_a_list_is_copied(everything):
    msg, mine, listed = everything(), array('i', [1]), [1]
    msg.many = mine
    assert msg.many is mine
    msg.many = listed
    listed.append(2)
    assert msg.many == array('i', [1])


def test_a_numpy_array_is_kept(everything):
    import numpy

    msg, mine = everything(), numpy.ones(3)
    msg.fixed = mine
    assert msg.fixed is mine


def test_positional_arguments_are_refused(get):
    with pytest.raises(TypeError, match='takes 1 positional argument but 2 were given'):
        get('std_msgs/msg/String')('hello')


def test_a_field_may_have_the_name_of_a_generated_variable(define):
    cls = define('Names.msg', 'float64 m\nfloat64 wire\nfloat64 self\nfloat64 type\nfloat64 kwargs\nint8 property\nfloat32 f0')
    assert cls(m=1.0, self=2.0, kwargs=3.0).to_wire(cls.from_wire((1.0, 2.0, 3.0, 4.0, 5.0, 6, 0.5)))[2:4] == (3.0, 4.0)


def test_a_default_may_be_no_number(tmp_path):
    (tmp_path / 'p/msg').mkdir(parents=True)
    (tmp_path / 'p/msg/Gap.msg').write_text('float64[] q [nan, -inf]\nfloat32[<=3] r [1.5, inf]\n')
    gap = Registry([tmp_path]).get('p/msg/Gap')()
    assert repr(gap) == 'p.msg.Gap(q=[nan, -inf], r=[1.5, inf])'


def test_a_twist_is_flat_on_the_wire(get):
    twist = get('geometry_msgs/msg/Twist')
    msg = twist()
    msg.linear.x, msg.angular.z = 2.0, 1.8
    assert twist.to_wire(msg) == (2.0, 0.0, 0.0, 0.0, 0.0, 1.8)


def test_float32_values_are_rounded_on_the_wire(get):
    pose = get('turtlesim/msg/Pose')
    assert pose.to_wire(pose(x=5.5444445, theta=0.1)) == (5.544444561004639, 0.0, 0.10000000149011612, 0.0, 0.0)
    scan = get('sensor_msgs/msg/LaserScan')
    assert scan.to_wire(scan(angle_min=0.1, ranges=[0.1]))[3::7] == (0.10000000149011612, (0.10000000149011612,))


def test_repeated_messages_are_tuples_of_flat_tuples(get):
    cls, stamped = get('tf2_msgs/msg/TFMessage'), get('geometry_msgs/msg/TransformStamped')
    wire = cls.to_wire(cls(transforms=[stamped(child_frame_id='a')]))
    assert wire == (((0, 0, '', 'a', 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0),),)


def test_bytes_travel_as_bytes(get):
    image, uuid, octets = (
        get('sensor_msgs/msg/Image'),
        get('unique_identifier_msgs/msg/UUID'),
        get('std_msgs/msg/ByteMultiArray'),
    )
    assert image.to_wire(image(data=[1, 2]))[-1] == b'\1\2'
    assert uuid.to_wire(uuid(uuid=list(range(16)))) == (bytes(range(16)),)
    assert octets.from_wire(octets.to_wire(octets(data=[b'a', b'b']))).data == [b'a', b'b']


def test_a_snapshot_does_not_change_with_the_message(get):
    cls = get('sensor_msgs/msg/JointState')
    msg = cls(name=['a'], position=[1.0])
    wire = cls.to_wire(msg)
    msg.name.append('b')
    msg.position.append(2.0)
    assert wire[3:5] == (('a',), (1.0,))


def test_a_received_message_can_be_changed(get):
    cls = get('sensor_msgs/msg/JointState')
    msg = cls.from_wire((0, 0, '', ('a',), (1.0,), (), ()))
    msg.name.append('b')
    msg.position.append(2.0)
    assert (msg.name, msg.position) == (['a', 'b'], array('d', [1.0, 2.0]))


def test_every_class_gives_back_the_wire_it_was_made_from(message_classes, some_wires):
    for cls in message_classes:
        for wire in some_wires(cls):
            msg = cls.from_wire(wire)
            assert cls.to_wire(msg) == wire, cls.TYPE
            assert msg == cls.from_wire(wire), cls.TYPE


def test_reading_and_assigning_every_field_changes_nothing(message_classes, some_wires):
    for cls in message_classes:
        wire = some_wires(cls)[-1]
        msg, other = cls.from_wire(wire), cls()
        for name in cls.get_fields_and_field_types():
            setattr(other, name, getattr(msg, name))
        assert cls.to_wire(other) == wire, cls.TYPE


def test_every_class_starts_as_its_own_default_wire(message_classes):
    for cls in message_classes:
        assert cls.from_wire(cls.to_wire(cls())) == cls(), cls.TYPE


@pytest.mark.parametrize('value', [math.inf, -math.inf])
def test_infinity_is_a_float_of_both_sizes(get, value):
    for name in ('Float32', 'Float64'):
        cls = get(f'std_msgs/msg/{name}')
        assert cls.to_wire(cls(data=value)) == (value,)


def test_a_wire_of_another_length_is_refused(get):
    with pytest.raises(ValueError):
        get('geometry_msgs/msg/Point').from_wire((1.0, 2.0))


@pytest.mark.parametrize(
    ('type_name', 'field', 'wrong', 'words'),
    [
        ('geometry_msgs/msg/Polygon', 'points', 'x', "each value of type 'Point32'"),
        ('sensor_msgs/msg/JointState', 'name', 5, "each value of type 'str'"),
        ('std_msgs/msg/ByteMultiArray', 'data', 5, "each value of type 'bytes'"),
    ],
)
def test_something_wrong_appended_to_a_list_is_refused_when_sent(get, type_name, field, wrong, words):
    cls = get(type_name)
    msg = cls()
    getattr(msg, field).append(wrong)
    with pytest.raises(AssertionError, match=f"The '{field}' field must be a set or sequence and {words}"):
        cls.to_wire(msg)


def test_a_bounded_sequence_that_grew_too_long_is_refused_when_sent(get):
    cls = get('shape_msgs/msg/SolidPrimitive')
    msg = cls(dimensions=[1.0, 2.0, 3.0])
    msg.dimensions.append(4.0)
    with pytest.raises(AssertionError, match=r"The 'dimensions' array.array\(\) must have a size <= 3"):
        cls.to_wire(msg)
