"""Point clouds go into messages and come out again."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from sensor_msgs.msg import PointField
from sensor_msgs_py import point_cloud2
from std_msgs.msg import Header

POINTS = [(1.0, 2.0, 3.0), (4.0, float('nan'), 6.0), (7.0, 8.0, 9.0)]


def cloud() -> Any:
    return point_cloud2.create_cloud_xyz32(Header(frame_id='map'), POINTS)


def test_a_cloud_of_floats_has_twelve_bytes_for_each_point() -> None:
    made = cloud()
    assert (made.height, made.width, made.point_step, made.row_step, len(made.data)) == (1, 3, 12, 36, 36)
    assert [(field.name, field.offset) for field in made.fields] == [
        ('x', 0),
        ('y', 4),
        ('z', 8),
    ] and made.header.frame_id == 'map'


def test_points_come_out_as_they_went_in() -> None:
    points = point_cloud2.read_points(cloud(), skip_nans=True)
    assert points.dtype.names == ('x', 'y', 'z') and points.tolist() == [POINTS[0], POINTS[2]]
    assert point_cloud2.read_points_numpy(cloud(), ['z', 'x'])[2].tolist() == [9.0, 7.0]
    assert point_cloud2.read_points_list(cloud(), ['x'], uvs=[2])[0].x == 7.0


def test_fields_of_several_types_and_padding() -> None:
    fields = [
        PointField(name='range', offset=0, datatype=PointField.FLOAT64, count=1),
        PointField(name='', offset=8, datatype=PointField.UINT16, count=2),
    ]
    made = point_cloud2.create_cloud(Header(), fields, [(1.5, (1, 2)), (2.5, (3, 4))], step=16)
    points = point_cloud2.read_points(made)
    assert made.point_step == 16 and points.dtype.names == ('range', 'unnamed_field_1')
    assert points['unnamed_field_1'].tolist() == [[1, 2], [3, 4]]
    with pytest.raises(AssertionError, match='same datatype'):
        point_cloud2.read_points_numpy(made)


def test_an_organized_cloud_keeps_its_rows() -> None:
    grid = np.arange(18, dtype=np.float32).reshape(2, 3, 3)
    made = point_cloud2.create_cloud_xyz32(Header(), grid)
    assert (made.height, made.width) == (2, 3)
    assert point_cloud2.read_points(made, reshape_organized_cloud=True).shape == (2, 3)
    assert point_cloud2.read_points(made, uvs=[(2, 1)])['x'].tolist() == [15.0]


def test_a_field_that_is_not_there_is_refused() -> None:
    with pytest.raises(AssertionError, match='not in the fields'):
        point_cloud2.read_points(cloud(), ['intensity'])
