import json
import math

import pytest

from edulaunch.errors import InterfaceError
from edulaunch.interfaces.plain import Forms, forms_of


def test_forms_name_every_type_that_a_wire_holds(get):
    forms = forms_of(get('tf2_msgs/msg/TFMessage'))
    assert forms['tf2_msgs/msg/TFMessage'] == (('transforms', 'geometry_msgs/msg/TransformStamped[]'),)
    assert sorted(forms) == ['geometry_msgs/msg/TransformStamped', 'tf2_msgs/msg/TFMessage']


def test_every_wire_survives_json_with_its_forms(message_classes, some_wires):
    for cls in message_classes:
        forms = Forms(json.loads(json.dumps(forms_of(cls))))
        for wire in some_wires(cls):
            text = json.dumps(forms.to_json(cls.TYPE, wire))
            assert forms.wire(cls.TYPE, json.loads(text)) == wire, cls.TYPE


def test_wires_become_columns(get):
    forms = Forms(forms_of(get('geometry_msgs/msg/Point')))
    assert forms.columns('geometry_msgs/msg/Point', [(1.0, 2.0, 3.0), (4.0, 5.0, 6.0)]) == {
        'x': (1.0, 4.0),
        'y': (2.0, 5.0),
        'z': (3.0, 6.0),
    }
    assert forms.columns('geometry_msgs/msg/Point', []) == {'x': (), 'y': (), 'z': ()}


def test_float32_values_of_a_stranger_are_rounded(get):
    forms = Forms(forms_of(get('turtlesim/msg/Pose')))
    assert forms.wire('turtlesim/msg/Pose', [0.1, math.inf, 0.0, 0.0, 0.0])[:2] == (0.10000000149011612, math.inf)


@pytest.mark.parametrize(
    ('type_name', 'data', 'text'),
    [
        ('geometry_msgs/msg/Point', [1.0, 2.0], 'geometry_msgs/msg/Point: expected 3 values, not [1.0, 2.0]'),
        ('geometry_msgs/msg/Point', 7, 'geometry_msgs/msg/Point: expected 3 values, not 7'),
        ('geometry_msgs/msg/Point', [1.0, 2, 3.0], 'geometry_msgs/msg/Point: y: expected float64, not 2'),
        ('std_msgs/msg/Int8', [True], 'std_msgs/msg/Int8: data: expected int8, not True'),
        ('std_msgs/msg/Int8', [128], 'std_msgs/msg/Int8: data: expected int8, not 128'),
        ('std_msgs/msg/Byte', ['ab'], "std_msgs/msg/Byte: data: expected byte, not b'ab'"),
        ('std_msgs/msg/Byte', ['\u0101'], "std_msgs/msg/Byte: data: expected bytes, not '\u0101'"),
        ('unique_identifier_msgs/msg/UUID', ['a'], "unique_identifier_msgs/msg/UUID: uuid: expected uint8[16], not 'a'"),
        ('geometry_msgs/msg/Polygon', [5], 'geometry_msgs/msg/Polygon: points: expected geometry_msgs/msg/Point32[], not 5'),
        ('geometry_msgs/msg/Polygon', [[[1]]], 'geometry_msgs/msg/Point32: expected 3 values, not [1]'),
    ],
)
def test_what_no_message_could_have_sent_is_refused(get, type_name, data, text):
    with pytest.raises(InterfaceError) as caught:
        Forms(forms_of(get(type_name))).wire(type_name, data)
    assert str(caught.value) == text


def test_a_damaged_form_is_an_interface_error():
    with pytest.raises(InterfaceError, match="^'int8\\[' is no type of a wire form$"):
        Forms({'p/msg/A': [('a', 'int8[')]})
    with pytest.raises(InterfaceError, match="^the form of 'p/msg/B' is missing$"):
        Forms({'p/msg/A': [('b', 'p/msg/B[]')]}).wire('p/msg/A', [[[1]]])
