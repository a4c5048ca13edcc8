"""The messages that ROS derives from a service or an action."""

from __future__ import annotations

from edulaunch.interfaces.spec import ActionSpec, Field, FieldType, MessageSpec, ServiceSpec

_GOAL_ID = Field('goal_id', FieldType('unique_identifier_msgs/msg/UUID'))


def event_of(service: ServiceSpec) -> MessageSpec:
    """The introspection event of a service."""
    return MessageSpec(
        f'{service.type}_Event',
        (
            Field('info', FieldType('service_msgs/msg/ServiceEventInfo')),
            Field('request', FieldType(service.request.type, None, 'bounded', 1)),
            Field('response', FieldType(service.response.type, None, 'bounded', 1)),
        ),
        (),
        service.request.file,
    )


def send_goal_of(action: ActionSpec) -> ServiceSpec:
    """The service that carries a goal to an action server."""
    name, file = f'{action.type}_SendGoal', action.goal.file
    return ServiceSpec(
        name,
        MessageSpec(f'{name}_Request', (_GOAL_ID, Field('goal', FieldType(action.goal.type))), (), file),
        MessageSpec(
            f'{name}_Response',
            (Field('accepted', FieldType('bool')), Field('stamp', FieldType('builtin_interfaces/msg/Time'))),
            (),
            file,
        ),
    )


def get_result_of(action: ActionSpec) -> ServiceSpec:
    """The service that answers with the result once a goal has ended."""
    name, file = f'{action.type}_GetResult', action.goal.file
    return ServiceSpec(
        name,
        MessageSpec(f'{name}_Request', (_GOAL_ID,), (), file),
        MessageSpec(
            f'{name}_Response', (Field('status', FieldType('int8')), Field('result', FieldType(action.result.type))), (), file
        ),
    )


def feedback_message_of(action: ActionSpec) -> MessageSpec:
    """The message of the feedback topic."""
    return MessageSpec(
        f'{action.type}_FeedbackMessage', (_GOAL_ID, Field('feedback', FieldType(action.feedback.type))), (), action.goal.file
    )


def parts_of(spec: MessageSpec | ServiceSpec | ActionSpec) -> dict[str, MessageSpec | ServiceSpec | ActionSpec]:
    """The interface itself and everything derived from it, by full type name."""
    if isinstance(spec, MessageSpec):
        return {spec.type: spec}
    if isinstance(spec, ServiceSpec):
        return {part.type: part for part in (spec, spec.request, spec.response, event_of(spec))}
    parts: dict[str, MessageSpec | ServiceSpec | ActionSpec] = {
        part.type: part for part in (spec, spec.goal, spec.result, spec.feedback, feedback_message_of(spec))
    }
    return parts | parts_of(send_goal_of(spec)) | parts_of(get_result_of(spec))
