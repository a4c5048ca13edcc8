import pytest

from edulaunch.interfaces.naming import module_name
from edulaunch.nearest import did_you_mean, nearest


@pytest.mark.parametrize(
    ('name', 'module'),
    [
        ('TransformStamped', 'transform_stamped'),
        ('TFMessage', 'tf_message'),
        ('TF2Error', 'tf2_error'),
        ('Pose2D', 'pose2_d'),
        ('ColorRGBA', 'color_rgba'),
        ('UUID', 'uuid'),
        ('Int32MultiArray', 'int32_multi_array'),
    ],
)
def test_modules_are_named_as_ros_names_them(name, module):
    assert module_name(name) == module


def test_the_nearest_name_disregards_case_and_far_names_are_none():
    assert nearest('twist', ['Pose', 'Twist']) == 'Twist'
    assert did_you_mean('xyz', ['Pose', 'Twist']) is None
