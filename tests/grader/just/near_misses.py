"""Near misses and claims: (exercise, a check that must not pass, text) by what is wrong with them."""

from __future__ import annotations

from right import (
    BROKEN,
    CAMERA,
    CARROT,
    CIRCLE,
    DECLARED,
    DEMO,
    FOLLOW,
    LASER,
    PARAM_CIRCLE,
    PUB,
    RADIUS,
    SIM,
    SQUARE,
    STATIC,
    WORLD,
)
from texts import body, changed, package

STP = "Node(package='tf2_ros', executable='static_transform_publisher', arguments={})"
HEIGHT = "DeclareLaunchArgument('height', default_value='0.5')"
CAMERA_NODE, LASER_NODE = STP.format(CAMERA.removeprefix('arguments=').rstrip(',')), STP.format(f'[{LASER}]')
TELL = "        Node(\n            package='turtle_tf2_py',\n            executable='turtle_tf2_broadcaster',\n            name='broadcaster{0}',\n            parameters=[{{'turtlename': 'turtle{0}'}}],\n        ),\n"
HEAR = "        Node(\n            package='turtle_tf2_py',\n            executable='turtle_tf2_listener',\n            name='listener',\n            parameters=[{'target_frame': 'turtle1'}],\n        ),\n"
TOPIC = "ExecuteProcess(cmd=['ros2', 'topic', 'pub', {}]),\n"
SPAWN = "ExecuteProcess(cmd=['ros2', 'service', 'call', '/spawn', 'turtlesim/srv/Spawn', '{x: 6.5, y: 6.5, name: turtle2}'])"
TELEPORT = "ExecuteProcess(cmd=['ros2', 'service', 'call', '/turtle2/teleport_absolute', 'turtlesim/srv/TeleportAbsolute', '{x: 5.54, y: 5.54}'])"

WRONG: dict[str, tuple[str, str, str]] = {
    'circle: another name of the argument': ('circle', 'argument_is_declared', changed(CIRCLE, ("'circle_radius'", "'radius'"))),
    'circle: ten metres': ('circle', 'default_is_one_metre', changed(CIRCLE, ("'1.0'", "'10'"))),
    'circle: a default in two parts that is another number': (
        'circle',
        'default_is_one_metre',
        changed(CIRCLE, ("'1.0'", "['1', '1.0']")),
    ),
    'circle: no default': ('circle', 'default_is_one_metre', changed(CIRCLE, ("            default_value='1.0',\n", ''))),
    'circle: a fixed radius': ('circle', 'radius_is_passed', changed(CIRCLE, (RADIUS, "parameters=[{'radius': 0.5}],"))),
    'circle: a fixed radius after the right one': (
        'circle',
        'radius_is_passed',
        changed(CIRCLE, (RADIUS, "parameters=[{'radius': LaunchConfiguration('circle_radius')}, {'radius': 0.5}],")),
    ),
    'circle: a diameter': (
        'circle',
        'radius_is_passed',
        changed(CIRCLE, (RADIUS, "parameters=[{'radius': PythonExpression([LaunchConfiguration('circle_radius'), ' * 2'])}],")),
    ),
    'circle: a large letter': ('circle', 'radius_is_passed', changed(CIRCLE, ("{'radius'", "{'Radius'"))),
    'circle: no world': ('circle', 'world_is_there', body(f'{DECLARED}, {PARAM_CIRCLE}')),
    'circle: no node': ('circle', 'node_is_started', body(f'{DECLARED}, {WORLD}')),
    'circle: a node whose condition is never true': (
        'circle',
        'node_is_started',
        changed(CIRCLE, (RADIUS, RADIUS + " condition=IfCondition('false'),")),
    ),
    'circle: text on the odometry': (
        'circle',
        'world_is_there',
        changed(CIRCLE, ('        Node(\n', TOPIC.format("'/odom', 'std_msgs/msg/String', 'data: x'") + '        Node(\n')),
    ),
    'circle: an odometry of its own': (
        'circle',
        'world_is_there',
        changed(CIRCLE, ('        Node(\n', TOPIC.format("'/odom', 'nav_msgs/msg/Odometry'") + '        Node(\n')),
    ),
    'circle: another program before the node': (
        'circle',
        'node_is_started',
        changed(CIRCLE, ("executable='param_circle.py',", "executable='param_circle.py', prefix='python3 -c pass',")),
    ),
    'circle: somebody else drives too': (
        'circle',
        'circle_is_driven',
        changed(
            CIRCLE,
            (
                '        Node(\n',
                TOPIC.format("'-r', '50', '/cmd_vel', 'geometry_msgs/msg/Twist', '{linear: {x: 0.1}}'") + '        Node(\n',
            ),
        ),
    ),
    'circle: for half of the time': (
        'circle',
        'no_node_dies',
        changed(CIRCLE, (RADIUS, RADIUS + " sigterm_timeout='1',")).replace(
            "        Node(\n            package='part3",
            "        TimerAction(period=8.0, actions=[ExecuteProcess(cmd=['ros2', 'service', 'call', '/reset', 'std_srvs/srv/Empty']), __import__('launch').actions.EmitEvent(event=__import__('launch').events.process.SignalProcess(signal_number='SIGKILL', process_matcher=lambda action: 'param_circle' in str(action.process_details['cmd'])))]),\n        Node(\n            package='part3",
        ),
    ),
    'static_frame: in the last instant': (
        'static_frame',
        'laser_is_on_tf',
        body(f'{HEIGHT}, TimerAction(period=4.9, actions=[{LASER_NODE}, {CAMERA_NODE}])'),
    ),
    'static_frame: right after being wrong': (
        'static_frame',
        'laser_is_in_its_place',
        body(
            f'{HEIGHT}, {CAMERA_NODE}, {STP.format("[" + LASER.replace(chr(39) + "0.2", chr(39) + "0.9") + "]")}, TimerAction(period=1.0, actions=[{LASER_NODE}])'
        ),
    ),
    'static_frame: in the wrong parent at first': (
        'static_frame',
        'camera_is_on_tf',
        body(
            f'{HEIGHT}, {LASER_NODE}, {CAMERA_NODE.replace(chr(39) + "laser" + chr(39), chr(39) + "base_link" + chr(39))}, TimerAction(period=1.0, actions=[{CAMERA_NODE}])'
        ),
    ),
    'static_frame: the camera hangs at the base': (
        'static_frame',
        'camera_is_on_tf',
        changed(STATIC, ("'--frame-id', 'laser'", "'--frame-id', 'base_link'")),
    ),
    'static_frame: to the right': ('static_frame', 'camera_is_in_its_place', changed(STATIC, ("'1.5708'", "'-1.5708'"))),
    'static_frame: degrees': ('static_frame', 'camera_is_in_its_place', changed(STATIC, ("'1.5708'", "'90'"))),
    'static_frame: roll': ('static_frame', 'camera_is_in_its_place', changed(STATIC, ("'--yaw'", "'--roll'"))),
    'static_frame: leaning a little': (
        'static_frame',
        'camera_is_in_its_place',
        changed(STATIC, ("'--yaw', '1.5708'", "'--yaw', '1.5708', '--pitch', '0.1'")),
    ),
    'static_frame: a fixed height': (
        'static_frame',
        'laser_is_in_its_place',
        changed(STATIC, ("'--z', LaunchConfiguration('height')", "'--z', '0.5'")),
    ),
    'static_frame: a centimetre off': ('static_frame', 'laser_is_in_its_place', changed(STATIC, ("'0.2'", "'0.21'"))),
    'static_frame: no number': ('static_frame', 'laser_is_in_its_place', changed(STATIC, ("'0.2'", "'nan'"))),
    'static_frame: frames swapped': (
        'static_frame',
        'laser_is_on_tf',
        changed(STATIC, (LASER, LASER.replace("'base_link'", "'#'").replace("'laser'", "'base_link'").replace("'#'", "'laser'"))),
    ),
    'static_frame: again and again on /tf': (
        'static_frame',
        'frames_are_static',
        body(
            f'{HEIGHT}, {LASER_NODE}, '
            + TOPIC.format(
                "'-r', '10', '/tf', 'tf2_msgs/msg/TFMessage', '{transforms: [{header: {stamp: now, frame_id: laser}, child_frame_id: camera, transform: {translation: {z: 0.1}, rotation: {z: 0.70710678, w: 0.70710678}}}]}'"
            ).rstrip(',\n')
        ),
    ),
    'follow: who follows itself': (
        'follow',
        'standing_leader_is_reached',
        changed(FOLLOW, ("'target_frame': 'turtle1'", "'target_frame': 'turtle2'")),
    ),
    'follow: one broadcaster': ('follow', 'follower_is_on_tf', changed(FOLLOW, (TELL.format(2), ''))),
    'follow: one turtle twice': (
        'follow',
        'follower_is_on_tf',
        changed(FOLLOW, ("{'turtlename': 'turtle2'}", "{'turtlename': 'turtle1'}")),
    ),
    'follow: two nodes of one name': (
        'follow',
        'follower_is_on_tf',
        changed(FOLLOW, ("name='broadcaster2'", "name='broadcaster1'")),
    ),
    'follow: the condition turned around': (
        'follow',
        'leader_moves_when_asked',
        changed(FOLLOW, ('IfCondition(move)', 'UnlessCondition(move)')),
    ),
    'follow: a square without being asked': (
        'follow',
        'leader_moves_when_asked',
        changed(FOLLOW, (', condition=IfCondition(move)', '')),
    ),
    'follow: no square': ('follow', 'leader_moves_when_asked', changed(FOLLOW, (SQUARE, ''))),
    'follow: no listener': ('follow', 'follower_exists', changed(FOLLOW, (HEAR, ''))),
    'follow: a turtle that is parked in the middle': (
        'follow',
        'moving_leader_is_followed',
        changed(FOLLOW, (HEAR, f'        TimerAction(period=3.0, actions=[{SPAWN}]),\n')),
    ),
    'follow: a turtle that is put there': (
        'follow',
        'standing_leader_is_reached',
        changed(
            FOLLOW,
            (
                HEAR,
                f'        TimerAction(period=3.0, actions=[{SPAWN}]),\n        TimerAction(period=16.0, actions=[{TELEPORT}]),\n',
            ),
        ),
    ),
    'follow: a velocity that is not a number': (
        'follow',
        'standing_leader_is_reached',
        changed(FOLLOW, (SIM, SIM + TOPIC.format("'/turtle2/cmd_vel', 'geometry_msgs/msg/Twist', '{linear: {x: .nan}}'"))),
    ),
    'follow: a pose of its own': (
        'follow',
        'standing_leader_is_reached',
        changed(
            FOLLOW,
            (
                HEAR,
                f'        TimerAction(period=3.0, actions=[{SPAWN}]),\n'
                + TOPIC.format("'-r', '50', '/turtle2/pose', 'turtlesim/msg/Pose', '{x: 5.54, y: 5.54}'"),
            ),
        ),
    ),
    'carrot: both at once': (
        'carrot',
        'one_carrot_at_a_time',
        changed(CARROT, ("            condition=IfCondition(EqualsSubstitution(carrot, 'moving')),\n", '')),
    ),
    'carrot: conditions swapped': (
        'carrot',
        'one_carrot_at_a_time',
        changed(CARROT, ("(carrot, 'fixed')", "(carrot, '#')"), ("(carrot, 'moving')", "(carrot, 'fixed')"), ("'#'", "'moving'")),
    ),
    'carrot: moving by default': (
        'carrot',
        'default_is_fixed',
        changed(CARROT, ("default_value='fixed'", "default_value='moving'")),
    ),
    'carrot: the turtle itself is the goal': ('carrot', 'carrot_is_the_target', changed(CARROT, ("'carrot1'", "'turtle1'"))),
    'carrot: a static carrot': (
        'carrot',
        'one_carrot_at_a_time',
        body(
            f"DeclareLaunchArgument('carrot', default_value='fixed'), {DEMO.format('carrot1')}, "
            + STP.format("['--y', '2', '--frame-id', 'turtle1', '--child-frame-id', 'carrot1']")
        ),
    ),
    'carrot: no turtles': (
        'carrot',
        'turtles_are_there',
        body(
            "DeclareLaunchArgument('carrot', default_value='fixed'), Node(package='turtle_tf2_py', executable='fixed_frame_tf2_broadcaster')"
        ),
    ),
    'broken_follow: as it was, at the mimic': (
        'broken_follow',
        'turtle1_copies',
        changed(BROKEN, ("('output/cmd_vel', '/turtle1/cmd_vel')", "('output/cmd_vel', '/cmd_vel')")),
    ),
    'broken_follow: a frame that nobody knows': (
        'broken_follow',
        'target_is_turtle1',
        changed(BROKEN, ("'target_frame': 'turtle1'", "'target_frame': 'turtle_1'")),
    ),
    'broken_follow: a turtle that nobody tells of': (
        'broken_follow',
        'turtle2_is_on_tf',
        changed(BROKEN, ("'turtlename': 'turtle2'", "'turtlename': 'turtle_2'")),
    ),
    'broken_follow: a teacher with a speed of its own': (
        'broken_follow',
        'teacher_drives',
        changed(BROKEN, ("LaunchConfiguration('speed')", "'1.0'")),
    ),
    'broken_follow: turtle1 drives by itself': (
        'broken_follow',
        'turtle1_copies',
        changed(
            BROKEN,
            (
                PUB + '\n        ),',
                PUB
                + '\n        ),\n        '
                + TOPIC.format(
                    "'-r', '10', '/turtle1/cmd_vel', 'geometry_msgs/msg/Twist', '{linear: {x: 1.0}, angular: {z: 0.5}}'"
                ),
            ),
            ("('output/cmd_vel', '/turtle1/cmd_vel')", "('output/cmd_vel', '/nowhere')"),
        ),
    ),
}
WRONG_PACKAGES = {
    'large_project: water for one world': ('water_comes_from_the_file', package(('config/turtlesim.yaml', '/**:', '/sim:'))),
    'large_project: water from the launch file': (
        'water_comes_from_the_file',
        package(
            (
                'launch/world.launch.py',
                'parameters=[config]',
                "parameters=[{'background_r': 150, 'background_g': 86, 'background_b': 255}]",
            )
        ),
    ),
    'large_project: another blue': ('water_comes_from_the_file', package(('config/turtlesim.yaml', '255', '254'))),
    'large_project: a fixed goal': (
        'goal_is_passed_on',
        package(('launch/large_project.launch.py', "target_frame=LaunchConfiguration('goal')", "target_frame='carrot1'")),
    ),
    'large_project: a goal that is not passed on': (
        'goal_is_passed_on',
        package(
            ('launch/large_project.launch.py', ", target_frame=LaunchConfiguration('goal')", ", goal=LaunchConfiguration('goal')")
        ),
    ),
    'large_project: no namespace': (
        'second_world_is_there',
        package(('launch/large_project.launch.py', "            PushRosNamespace('turtlesim2'),\n", '')),
    ),
    'large_project: a mimic of turtle1': (
        'mimic_copies',
        package(('launch/mimic.launch.py', "'/turtle2/pose'", "'/turtle1/pose'")),
    ),
    'large_project: no carrot': (
        'goal_is_reached',
        package(
            (
                'launch/large_project.launch.py',
                "        Node(package='turtle_tf2_py', executable='fixed_frame_tf2_broadcaster', name='fixed_broadcaster'),\n",
                '',
            )
        ),
    ),
}
