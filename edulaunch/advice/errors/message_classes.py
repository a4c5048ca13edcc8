"""Classes and fields of messages, services and actions."""

from __future__ import annotations

from edulaunch.advice.errors.about import about

FIELD = about(
    'messages.field',
    what=('a {type} has no field {field}; its fields are: {fields}', 'a {type} has no field {field}; it has no fields at all'),
    do=('write {near}', 'choose one of its fields; `ros2 interface show` shows them', 'take this out'),
)
FIELD_VALUE = about(
    'messages.field-value',
    what=(
        'the field {field} takes {size} values, and was given {count}',
        'the field {field} was given {value}, which is outside its range',
        'the field {field} is of type {wanted}, and was given {given}',
    ),
    do=(
        'write {write}',
        'set its fields ({fields}), or assign a {wanted}(...)',
        'give it {size} values',
        'write a decimal point: the comma made {commas} values of it',
        'give it a value inside its range; `ros2 interface show` shows its type',
        'give it a {wanted}',
    ),
)
CONSTANT = about(
    'messages.constant',
    what='{constant} is a constant of {type}, which cannot be set',
    do='give a variable of your own another value',
)
NO_INTERFACE = about(
    'messages.no-interface',
    what='{module} has no {interface}',
    do=('import it from {homes}', 'write {near}', 'choose another one: `ros2 interface package` lists them'),
)
CLASS_GIVEN = about(
    'messages.class-given', what='{wanted} is a class; an object of it is needed', do='write {wanted}(), with its brackets'
)
OTHER_CLASS = about(
    'messages.other-class', what='an object of {wanted} is needed, not of {given}', do='make one: {wanted}(), and set its fields'
)
OTHER_BYTES = about(
    'messages.other-bytes',
    what='these bytes are no {wanted}: {reason}',
    do='read them with the class that they were written with',
)
TWO_TYPES = about(
    'messages.two-types',
    what="{node} of this program uses the {end} '{used_name}' with {used}, so {wanted} cannot go there",
    do='use one type for it, or another name',
)
QOS_OVERRIDE = about(
    'messages.qos-override', what="'{value}' is no value of the QoS policy {policy}", do='choose one of: {allowed}'
)
