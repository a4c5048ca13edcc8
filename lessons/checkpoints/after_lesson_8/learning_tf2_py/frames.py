"""Making the message that says where one frame is in another."""
from math import cos, sin

from geometry_msgs.msg import Quaternion, TransformStamped, Vector3


def turned(roll, pitch, yaw):
    """The rotation by roll about x, then pitch about y, then yaw about z (radians)."""
    (sr, cr), (sp, cp), (sy, cy) = ((sin(a / 2), cos(a / 2)) for a in (roll, pitch, yaw))
    return Quaternion(
        x=sr * cp * cy - cr * sp * sy, y=cr * sp * cy + sr * cp * sy,
        z=cr * cp * sy - sr * sp * cy, w=cr * cp * cy + sr * sp * sy,
    )


def placed(node, parent, child, x, y, z, rotation):
    """The frame `child` at (x, y, z) metres in the frame `parent`, from now on."""
    t = TransformStamped(child_frame_id=child)
    t.header.stamp = node.get_clock().now().to_msg()
    t.header.frame_id = parent
    t.transform.translation = Vector3(x=x, y=y, z=z)
    t.transform.rotation = rotation
    return t
