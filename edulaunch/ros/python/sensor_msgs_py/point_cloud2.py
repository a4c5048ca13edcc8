"""Functions that convert point clouds to numpy arrays (`read_points` and similar functions) and back (`create_cloud`)."""

from __future__ import annotations

import array
import sys
from collections import namedtuple
from collections.abc import Iterable
from typing import Any

import numpy as np
from sensor_msgs.msg import PointCloud2, PointField

_DATATYPES: dict[int, Any] = {
    PointField.INT8: np.dtype(np.int8),
    PointField.UINT8: np.dtype(np.uint8),
    PointField.INT16: np.dtype(np.int16),
    PointField.UINT16: np.dtype(np.uint16),
    PointField.INT32: np.dtype(np.int32),
    PointField.UINT32: np.dtype(np.uint32),
    PointField.FLOAT32: np.dtype(np.float32),
    PointField.FLOAT64: np.dtype(np.float64),
}
DUMMY_FIELD_PREFIX = 'unnamed_field'


def read_points(
    cloud: Any,
    field_names: list[str] | None = None,
    skip_nans: bool = False,
    uvs: Iterable[Any] | None = None,
    reshape_organized_cloud: bool = False,
) -> Any:
    """Return the points as a structured array with one entry for each field.

    :param field_names: the fields to read; None means all fields in the order of the message.
    :param skip_nans: whether to leave out points with a NaN in one of these fields.
    :param uvs: the points to read: indices, or (column, row) pairs of an organized cloud. None means all points.
    :param reshape_organized_cloud: whether to return rows and columns (height, width). This cannot be combined with `uvs`.
    :raises AssertionError: for a field that the cloud does not have.
    """
    points = np.ndarray((cloud.width * cloud.height,), dtype_from_fields(cloud.fields, cloud.point_step), bytes(cloud.data))
    if field_names is not None:
        assert all(name in points.dtype.names for name in field_names), 'Requests field is not in the fields of the PointCloud!'
        points = points[list(field_names)]
    if bool(cloud.is_bigendian) != (sys.byteorder == 'big'):
        points = points.byteswap()
    if skip_nans and not cloud.is_dense:
        points = points[~_has_nan(points)]
    if uvs is not None:
        chosen = np.asarray(list(uvs), dtype=int)
        points = points[chosen if chosen.ndim == 1 else chosen[:, 1] * cloud.width + chosen[:, 0]]
    if reshape_organized_cloud and cloud.height > 1:
        points = points.reshape(cloud.height, cloud.width)
    return points


def _has_nan(points: Any) -> Any:
    found = np.zeros(points.shape, dtype=bool)
    for name in points.dtype.names:
        values = np.isnan(points[name])
        found |= values if values.ndim == 1 else values.any(axis=1)
    return found


def read_points_numpy(
    cloud: Any,
    field_names: list[str] | None = None,
    skip_nans: bool = False,
    uvs: Iterable[Any] | None = None,
    reshape_organized_cloud: bool = False,
) -> Any:
    """Return the points as a plain array with one column for each field. All fields must have the same type. The parameters are
    those of :func:`read_points`.
    """
    assert all(
        field.datatype == cloud.fields[0].datatype for field in cloud.fields if field_names is None or field.name in field_names
    ), 'All fields need to have the same datatype. Use `read_points()` otherwise.'
    from numpy.lib.recfunctions import structured_to_unstructured

    return structured_to_unstructured(read_points(cloud, field_names, skip_nans, uvs, reshape_organized_cloud))


def read_points_list(
    cloud: Any, field_names: list[str] | None = None, skip_nans: bool = False, uvs: Iterable[Any] | None = None
) -> list[Any]:
    """Return the points as named tuples. The parameters are those of :func:`read_points`."""
    points = read_points(cloud, field_names, skip_nans, uvs)
    kind = namedtuple('Point', points.dtype.names)  # type: ignore[misc]
    return [kind._make(point) for point in points]


def dtype_from_fields(fields: Iterable[Any], point_step: int | None = None) -> Any:
    """Return the numpy type of one point. Fields without a name are called `unnamed_field_0` and so on."""
    names, formats, offsets = [], [], []
    for number, field in enumerate(fields):
        kind = _DATATYPES[field.datatype]
        names.append(field.name or f'{DUMMY_FIELD_PREFIX}_{number}')
        formats.append((kind, (field.count,)) if field.count > 1 else kind)
        offsets.append(field.offset)
    description: dict[str, Any] = {'names': names, 'formats': formats, 'offsets': offsets}
    if point_step is not None:
        description['itemsize'] = point_step
    made: Any = np.dtype
    return made(description)


def create_cloud(header: Any, fields: Iterable[Any], points: Any, step: int | None = None) -> Any:
    """Return a point cloud for a structured array, a plain array, or a list with a row for each point.

    A structured array with two dimensions, or a plain array with three, makes an organized cloud.

    :param step: the size of one point in bytes, including padding.
    """
    fields = list(fields)
    kind = dtype_from_fields(fields, step)
    values = points if isinstance(points, np.ndarray) else np.array([tuple(point) for point in points], dtype=kind)
    if values.dtype.names is None:
        from numpy.lib.recfunctions import unstructured_to_structured

        packed = np.dtype([(name, kind.fields[name][0]) for name in kind.names])
        values = unstructured_to_structured(values, dtype=packed)
    made = np.zeros(values.shape, dtype=kind)
    for name in kind.names:
        made[name] = values[name]
    height, width = made.shape if made.ndim == 2 else (1, made.shape[0])
    cloud = PointCloud2(
        header=header,
        height=height,
        width=width,
        is_dense=False,
        is_bigendian=sys.byteorder != 'little',
        fields=fields,
        point_step=kind.itemsize,
        row_step=kind.itemsize * width,
    )
    cloud.data = array.array('B', made.tobytes())
    return cloud


def create_cloud_xyz32(header: Any, points: Any) -> Any:
    """Return a cloud with the fields x, y and z as 32-bit floats."""
    fields = [PointField(name=name, offset=4 * number, datatype=PointField.FLOAT32, count=1) for number, name in enumerate('xyz')]
    return create_cloud(header, fields, points)
