"""What may be given wherever launch entities are expected."""

from __future__ import annotations

import collections.abc
from collections.abc import Iterable

from .launch_description_entity import LaunchDescriptionEntity

SomeEntitiesType = LaunchDescriptionEntity | Iterable[LaunchDescriptionEntity]
"""One entity or several."""

SomeEntitiesType_types_tuple = (LaunchDescriptionEntity, collections.abc.Iterable)
