"""`ros2 service ...` in the simulation."""

from __future__ import annotations

SPAWN = 'ros2 service call /spawn turtlesim/srv/Spawn'


def test_list_is_sorted(machine) -> None:
    lines = machine.read('ros2 service list').splitlines()
    assert lines == sorted(lines) and {'/clear', '/kill', '/reset', '/spawn', '/sim/set_parameters'} <= set(lines)
    assert not any('_action' in line for line in lines)


def test_type_find_and_info(machine) -> None:
    assert machine.read('ros2 service type /clear') == 'std_srvs/srv/Empty\n'
    assert machine.read('ros2 service find std_srvs/srv/Empty') == '/clear\n/reset\n'
    assert machine.read('ros2 service info /clear') == 'Type: std_srvs/srv/Empty\nClients count: 0\nServices count: 1\n'
    assert machine.fails('ros2 service info /clea') == "Unknown service '/clea'\n  help: did you mean '/clear'?\n"


def test_call_prints_request_and_response(machine) -> None:
    typed = machine.run(f'{SPAWN} \'{{x: 2, y: 2, theta: 0.2, name: ""}}\'')
    assert typed.writes == [
        (1.0, "requester: making request: turtlesim.srv.Spawn_Request(x=2.0, y=2.0, theta=0.2, name='')\n\n"),
        (1.008, "response:\nturtlesim.srv.Spawn_Response(name='turtle2')\n\n"),
    ]
    assert typed.code == 0


def test_call_takes_relative_names_and_the_short_type(machine) -> None:
    assert 'std_srvs.srv.Empty_Response()' in machine.read('ros2 service call clear std_srvs/Empty')


def test_call_waits_for_the_service_and_says_what_may_be_wrong(machine) -> None:
    typed = machine.run('ros2 service call /spwan turtlesim/srv/Spawn', 6)
    assert typed.writes == [
        (1.0, 'waiting for service to become available...\n'),
        (6.0, "still waiting for /spwan [turtlesim/srv/Spawn]\n  help: did you mean '/spawn'?\n"),
    ]


def test_call_of_the_wrong_type_names_the_right_one(machine) -> None:
    typed = machine.run('ros2 service call /spawn std_srvs/srv/Empty', 6)
    assert typed.err.endswith('help: /spawn has the type turtlesim/srv/Spawn\n')


def test_call_repeats_at_a_rate(machine) -> None:
    typed = machine.run('ros2 service call -r 4 /clear std_srvs/srv/Empty', 0.6)
    assert [time for time, text in typed.writes if text.startswith('requester')] == [1.0, 1.25, 1.5]


def test_call_refuses_what_does_not_fit(machine) -> None:
    assert machine.fails('ros2 service call /spawn turtlesim/srv/Spwan') == (
        "The passed service type is invalid\n  help: did you mean 'turtlesim/srv/Spawn'?\n"
    )
    assert machine.fails(f'{SPAWN} "{{x: far}}"') == (
        "Failed to populate field: could not convert string to float: 'far'\n  help: 'x' is float32\n"
    )
    assert machine.fails(f'{SPAWN} "x: {{}}"').startswith('Failed to populate field: ')
    assert machine.fails(f'{SPAWN} "{{x: "').startswith('The passed value is not valid YAML')


def test_echo_prints_the_events_of_a_service_whose_introspection_is_on(machine) -> None:
    (machine.folder / 'adder.py').write_text(
        'import rclpy\n'
        'from example_interfaces.srv import AddTwoInts\n'
        'from rclpy.qos import qos_profile_system_default\n'
        'from rclpy.service_introspection import ServiceIntrospectionState\n'
        'rclpy.init()\nnode = rclpy.create_node("adder")\n'
        'def add(request, response):\n    response.sum = request.a + request.b\n    return response\n'
        'service = node.create_service(AddTwoInts, "add_two_ints", add)\n'
        'service.configure_introspection(node.get_clock(), qos_profile_system_default, ServiceIntrospectionState.CONTENTS)\n'
        'rclpy.spin(node)\n'
    )
    machine.run('python3 adder.py')
    echo = machine.run('ros2 service echo --flow-style /add_two_ints')
    machine.run("ros2 service call /add_two_ints example_interfaces/srv/AddTwoInts '{a: 2, b: 3}'", 1.0)
    documents = echo.out.split('---\n')[:-1]
    assert len(documents) == 2 and 'event_type: 1' in documents[0] and 'event_type: 2' in documents[1]
    assert 'request: [{a: 2, b: 3}]' in documents[0] and 'response: [{sum: 5}]' in documents[1]


def test_echo_of_a_service_without_introspection_says_so(machine) -> None:
    said = machine.fails('ros2 service echo /spawn')
    assert said.startswith("No publishers on topic '/spawn/_service_event'; is service introspection on the client or server ")
    assert "did you mean '/spawn'?" in machine.fails('ros2 service echo /spwan')
