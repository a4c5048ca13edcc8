"""Functions that fill in the message for a transform."""
from math import cos, sin

from geometry_msgs.msg import Quaternion, TransformStamped, Vector3


def turned(roll, pitch, yaw):
    """Return the rotation by roll about x, then pitch about y, then yaw about z (radians)."""
    (sr, cr), (sp, cp), (sy, cy) = ((sin(a / 2), cos(a / 2)) for a in (roll, pitch, yaw))
    return Quaternion(
        x=sr * cp * cy - cr * sp * sy, y=cr * sp * cy + sr * cp * sy,
        z=cr * cp * sy - sr * sp * cy, w=cr * cp * cy + sr * sp * sy,
    )


def placed(node, parent, child, x, y, z, rotation):
    """Return the transform of `child` at (x, y, z) metres in `parent`, stamped with the current time."""
    t = TransformStamped(child_frame_id=child)
    t.header.stamp = node.get_clock().now().to_msg()
    t.header.frame_id = parent
    t.transform.translation = Vector3(x=x, y=y, z=z)
    t.transform.rotation = rotation
    return t
