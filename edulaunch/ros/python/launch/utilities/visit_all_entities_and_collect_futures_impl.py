"""`visit_all_entities_and_collect_futures`, importable from the same path as in ROS 2."""

from .entities import visit_all_entities_and_collect_futures as visit_all_entities_and_collect_futures
