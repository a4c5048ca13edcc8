"""Message, service and action classes made from .msg, .srv and .action text; wire tuples; CDR bytes.

Reading order: `spec` and `kinds` (what an interface is), `parser` (from text), `layout` (flattened fields), `generator`
(the class), `registry` (finds files, makes each class once), `importer` (`import geometry_msgs.msg`), `cdr` and
`description` (bytes and type hashes, as on a real ROS network), `plain` (wire tuples as JSON, without any class).
"""
