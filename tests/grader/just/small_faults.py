"""Small faults in right solutions: (exercise, the checks that lose their points, text). All other checks keep theirs."""

from __future__ import annotations

from right import CIRCLE, STATIC
from texts import ALL, SOLUTIONS, changed, solution

HALL = ", remappings=[('chatter', '/hall/chatter')]"


def with_all(name: str) -> str:
    """The text of a solution without its docstring, with everything imported that a change may need."""
    return ALL + solution(name).split('"""', 2)[2]


IN_ORDER, CAREFUL, FENCE, LOST, REQUEST, SILENT, TOWER, POOLS, TWO_ROOMS, VISITORS, WATER, MAST, BOX = map(
    with_all,
    [
        'in_order',
        'careful',
        'fence',
        'lost_carrot',
        'on_request',
        'silent_listener',
        'tower',
        'two_pools',
        'two_rooms',
        'visitors',
        'water',
        'mast',
        'black_box',
    ],
)
ROOMS = (SOLUTIONS / 'rooms.launch.xml').read_text()

FAULTS: dict[str, tuple[str, tuple[str, ...], str]] = {
    'circle: a calculated default of 2.0': (
        'circle',
        ('default_is_one_metre',),
        changed(CIRCLE, ("'1.0'", "PythonExpression(['1.0 * 2'])")),
    ),
    'static_frame: the camera hangs at the base': (
        'static_frame',
        ('camera_is_on_tf', 'camera_is_in_its_place'),
        changed(STATIC, ("'--frame-id', 'laser'", "'--frame-id', 'base_link'")),
    ),
    'water: another default': ('water', ('green',), changed(WATER, ("default_value='86'", "default_value='85'"))),
    'water: no default': ('water', ('blue',), changed(WATER, ("'blue', default_value='255'", "'blue'"))),
    'water: a calculated default': (
        'water',
        ('green',),
        changed(WATER, ("default_value='86'", "default_value=PythonExpression(['80 + 7'])")),
    ),
    'water: a fixed red': (
        'water',
        ('red_water',),
        changed(WATER, ("for colour in ('red', 'green', 'blue')}]", "for colour in ('green', 'blue')}, {'background_r': 69}]")),
    ),
    'in_order: a fixed delay': ('in_order', ('after_driver',), changed(IN_ORDER, ('period=delay', 'period=2.0'))),
    'in_order: a driver that is late': (
        'in_order',
        ('after_sim',),
        changed(IN_ORDER, ('on_start=[driver]', 'on_start=[TimerAction(period=0.5, actions=[driver])]')),
    ),
    'careful: when the echo starts': (
        'careful',
        ('after_word',),
        changed(CAREFUL, ('OnProcessExit(target_action=echo, on_exit=', 'OnProcessStart(target_action=echo, on_start=')).replace(
            '\n\n\ndef', '\nfrom launch.event_handlers import OnProcessStart\n\n\ndef', 1
        ),
    ),
    'careful: a fixed end': ('careful', ('ends', 'all'), changed(CAREFUL, ('period=end', 'period=4.0'))),
    'fence: a dark day': (
        'fence',
        ('usual_water',),
        changed(FENCE, ("namespace='day'", "namespace='day', parameters=[{'background_b': blue}]")),
    ),
    'lost_carrot: behind the turtle': ('lost_carrot', ('carrot', 'there'), changed(LOST, ("'--y', side", "'--x', side"))),
    'on_request: nobody drives in a crowd': (
        'on_request',
        ('crowd', 'moves'),
        changed(
            REQUEST, ('IfCondition(drive)', "IfCondition(PythonExpression(['\"', drive, '\" == \"true\" and ', worlds, ' < 2']))")
        ),
    ),
    'silent_listener: a misspelt remapping': (
        'silent_listener',
        ('first_hears',),
        changed(SILENT, ("name='radio', remappings=[('chatter', '/news", "name='radio', remappings=[('chatter', '/new")),
    ),
    'silent_listener: the other side of the rule': (
        'silent_listener',
        ('second_hears',),
        changed(SILENT, ("namespace=house, remappings=[('chatter'", "namespace=house, remappings=[('/chatter'")),
    ),
    'tower: a low lamp': ('tower', ('lamp_place',), changed(TOWER, ("'--z', '0.4'", "'--z', '0.3'"))),
    'tower: a fixed height': ('tower', ('table_place',), changed(TOWER, ("'--z', height", "'--z', '0.75'"))),
    'tower: the lamp on the floor': ('tower', ('lamp', 'lamp_place'), changed(TOWER, ("frame('table'", "frame('floor'"))),
    'two_pools: commands for nobody': (
        'two_pools',
        ('copies',),
        changed(POOLS, ("'/second/turtle1/cmd_vel'", "'/turtle1/cmd_vel'")),
    ),
    'two_pools: a pose of nobody': (
        'two_pools',
        ('listens', 'copies'),
        changed(POOLS, ("'/first/turtle1/pose'", "'/turtle1/pose'")),
    ),
    'two_pools: too wide': ('two_pools', ('circle', 'copies'), changed(POOLS, ('angular: {z: 1.0}', 'angular: {z: 0.5}'))),
    'two_rooms: nobody in the hall': (
        'two_rooms',
        ('first_listener', 'first_heard'),
        changed(TWO_ROOMS, ("        Node(package='demo_nodes_py', executable='listener', namespace='hall'),\n", '')),
    ),
    'two_rooms: deaf': ('two_rooms', ('heard',), changed(TWO_ROOMS, (HALL, ''))),
    'visitors: bert beside the place': ('visitors', ('visitor_one',), changed(VISITORS, ('x: 9.0', 'x: 8.5'))),
    'visitors: a fixed place': ('visitors', ('visitor_two',), changed(VISITORS, ("LaunchConfiguration('x')", "'3.0'"))),
    'mast: the other way round': ('mast', ('angle',), changed(MAST, ('<axis xyz="0 0 1"/>', '<axis xyz="0 0 -1"/>'))),
    'mast: a low camera': ('mast', ('camera_place',), changed(MAST, ('xyz="0 0 0.3"', 'xyz="0 0 0.2"'))),
    'black_box: commands only': (
        'black_box',
        ('poses',),
        changed(BOX, ("'/turtle1/cmd_vel'], ['/', robot, '/turtle1/pose']]", "'/turtle1/cmd_vel']]")),
    ),
    'rooms: another default': ('rooms', ('argument',), changed(ROOMS, ('default="kitchen"', 'default="cellar"'))),
    'rooms: deaf': ('rooms', ('hears',), changed(ROOMS, ('to="/hall/chatter"', 'to="/chatter"'))),
}
