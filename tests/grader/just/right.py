"""Unusual right answers: (exercise, ending or '', text) by what is unusual about them."""

from __future__ import annotations

from texts import HEAD, body, changed, package, solution

CIRCLE, STATIC, FOLLOW, CARROT, BROKEN = (
    solution(name) for name in ('circle', 'static_frame', 'follow', 'carrot', 'broken_follow')
)
RADIUS = "parameters=[{'radius': LaunchConfiguration('circle_radius')}],"
WORLD = "IncludeLaunchDescription(AnyLaunchDescriptionSource([FindPackageShare('turtlebot3_gazebo'), '/launch/empty_world.launch.py']))"
PARAM_CIRCLE = "Node(package='part3_beyond_basics', executable='param_circle.py', parameters=[{'radius': LaunchConfiguration('circle_radius')}])"
DECLARED = "DeclareLaunchArgument('circle_radius', default_value='1.0')"
OPAQUE = (
    HEAD
    + '    return LaunchDescription([{declared}, OpaqueFunction(function=setup)])\n\n\ndef setup(context):\n    return {actions}\n'
)
LASER = (
    "'--x', '0.2', '--z', LaunchConfiguration('height'),\n                '--frame-id', 'base_link', '--child-frame-id', 'laser',"
)
CAMERA = "arguments=['--z', '0.1', '--yaw', '1.5708', '--frame-id', 'laser', '--child-frame-id', 'camera'],"
URDF = (
    '\'<robot name="r"><link name="base_link"/><link name="laser"/><link name="camera"/>'
    '<joint name="a" type="fixed"><parent link="base_link"/><child link="laser"/><origin xyz="0.2 0 \', LaunchConfiguration(\'height\'), \'"/></joint>'
    '<joint name="b" type="fixed"><parent link="laser"/><child link="camera"/><origin xyz="0 0 0.1" rpy="0 0 1.5708"/></joint></robot>\''
)
SIM = "        Node(package='turtlesim', executable='turtlesim_node', name='sim'),\n"
SQUARE = "        Node(package='turtlesim', executable='draw_square', condition=IfCondition(move)),\n"
MOVE = "DeclareLaunchArgument('move', default_value='false')"
DEMO = (
    "IncludeLaunchDescription(PythonLaunchDescriptionSource([FindPackageShare('turtle_tf2_py'), '/launch/turtle_tf2_demo.launch.py'])"
    ", launch_arguments={{'target_frame': '{}'}}.items())"
)
TWO_BROADCASTERS = "*[Node(package='turtle_tf2_py', executable='turtle_tf2_broadcaster', name=f'tell_{t}', parameters=[{'turtlename': t}]) for t in ('turtle2', 'turtle1')]"
LISTENER = "Node(package='turtle_tf2_py', executable='turtle_tf2_listener', parameters=[{{'target_frame': '{}'}}])"
CHOICE = "DeclareLaunchArgument('carrot', default_value='fixed')"
PUB = "cmd=['ros2', 'topic', 'pub', '/teacher/turtle1/cmd_vel', 'geometry_msgs/msg/Twist', circle],"

BOXED = '<launch><arg name="height" default="0.5"/><node_container pkg="rclcpp_components" exec="component_container" name="box" namespace="">'
for name, parent, values in (
    ('laser', 'base_link', {'translation.x': '0.2', 'translation.z': '$(var height)'}),
    ('camera', 'laser', {'translation.z': '0.1', 'rotation.z': '0.70710678', 'rotation.w': '0.70710678'}),
):
    BOXED += f'<composable_node pkg="tf2_ros" plugin="tf2_ros::StaticTransformBroadcasterNode" name="{name}_frame">'
    for key, value in {'frame_id': parent, 'child_frame_id': name, **values}.items():
        BOXED += f'<param name="{key}" value="{value}"/>'
    BOXED += '</composable_node>'
BOXED += '</node_container></launch>'

RIGHT: dict[str, tuple[str, str, str]] = {
    'circle: a default of another spelling': ('circle', '', changed(CIRCLE, ("'1.0'", "'1.00'"))),
    'circle: a default in two parts': ('circle', '', changed(CIRCLE, ("default_value='1.0'", "default_value=['1', '.0']"))),
    'circle: a default that is a number with an exponent': ('circle', '', changed(CIRCLE, ("'1.0'", "'1e0'"))),
    'circle: XML': (
        'circle',
        'xml',
        '<launch><arg name="circle_radius" default="1.0"/><include file="$(find-pkg-share turtlebot3_gazebo)/launch/empty_world.launch.py"/>'
        '<node pkg="part3_beyond_basics" exec="param_circle.py"><param name="radius" value="$(var circle_radius)"/></node></launch>',
    ),
    'circle: YAML': (
        'circle',
        'yaml',
        'launch:\n- arg: {name: circle_radius, default: "1.0"}\n- include: {file: $(find-pkg-share turtlebot3_gazebo)/launch/empty_world.launch.py}\n'
        '- node:\n    pkg: part3_beyond_basics\n    exec: param_circle.py\n    param:\n    - {name: radius, value: $(var circle_radius)}\n',
    ),
    'circle: a function': ('circle', '', OPAQUE.format(declared=DECLARED, actions=f'[{WORLD}, {PARAM_CIRCLE}]')),
    'circle: nested groups': (
        'circle',
        '',
        body(f'{DECLARED}, GroupAction([GroupAction([{WORLD}]), GroupAction([{PARAM_CIRCLE}])])'),
    ),
    'circle: the node before the world': ('circle', '', body(f'{DECLARED}, {PARAM_CIRCLE}, {WORLD}')),
    'circle: another node besides': (
        'circle',
        '',
        body(f"Node(package='turtlesim', executable='turtlesim_node'), {DECLARED}, {PARAM_CIRCLE}, {WORLD}"),
    ),
    'circle: add_action': (
        'circle',
        '',
        f'{HEAD}    ld = LaunchDescription()\n    for action in ({DECLARED}, {WORLD}, {PARAM_CIRCLE}):\n        ld.add_action(action)\n    return ld\n',
    ),
    'circle: a radius with its type': (
        'circle',
        '',
        changed(
            CIRCLE,
            (
                RADIUS,
                "parameters=[{'radius': __import__('launch_ros').parameter_descriptions.ParameterValue(LaunchConfiguration('circle_radius'), value_type=float)}],",
            ),
        ),
    ),
    'circle: --ros-args': (
        'circle',
        '',
        changed(CIRCLE, (RADIUS, "ros_arguments=['-p', ['radius:=', LaunchConfiguration('circle_radius')]],")),
    ),
    'circle: ros2 run': (
        'circle',
        '',
        body(
            f"{DECLARED}, {WORLD}, ExecuteProcess(cmd=['ros2', 'run', 'part3_beyond_basics', 'param_circle.py', '--ros-args', '-p', ['radius:=', LaunchConfiguration('circle_radius')]])"
        ),
    ),
    'circle: a second later': ('circle', '', body(f'{DECLARED}, {WORLD}, TimerAction(period=1.0, actions=[{PARAM_CIRCLE}])')),
    'circle: another configuration between': (
        'circle',
        '',
        body(
            f"{DECLARED}, SetLaunchConfiguration('r', LaunchConfiguration('circle_radius')), {WORLD}, "
            + PARAM_CIRCLE.replace('circle_radius', 'r')
        ),
    ),
    'static_frame: XML': (
        'static_frame',
        'xml',
        '<launch><arg name="height" default="0.5"/>'
        '<node pkg="tf2_ros" exec="static_transform_publisher" args="--x 0.2 --z $(var height) --frame-id base_link --child-frame-id laser"/>'
        '<node pkg="tf2_ros" exec="static_transform_publisher" args="--z 0.1 --yaw 1.5708 --frame-id laser --child-frame-id camera"/></launch>',
    ),
    'static_frame: YAML': (
        'static_frame',
        'yaml',
        'launch:\n- arg: {name: height, default: "0.5"}\n'
        '- node: {pkg: tf2_ros, exec: static_transform_publisher, args: --x 0.2 --z $(var height) --frame-id base_link --child-frame-id laser}\n'
        '- node: {pkg: tf2_ros, exec: static_transform_publisher, args: --z 0.1 --yaw 1.5708 --frame-id laser --child-frame-id camera}\n',
    ),
    'static_frame: the old order of arguments': (
        'static_frame',
        '',
        changed(
            STATIC,
            (LASER, "'0.2', '0', LaunchConfiguration('height'), '0', '0', '0', 'base_link', 'laser',"),
            (CAMERA, "arguments='0 0 0.1 1.5708 0 0 laser camera'.split(),"),
        ),
    ),
    'static_frame: a quaternion': (
        'static_frame',
        '',
        changed(STATIC, ("'--yaw', '1.5708'", "'--qz', '0.7071068', '--qw', '0.7071068'")),
    ),
    'static_frame: a full turn more': ('static_frame', '', changed(STATIC, ("'1.5708'", "'7.853982'"))),
    'static_frame: a computed height': (
        'static_frame',
        '',
        changed(
            STATIC,
            ("'--z', LaunchConfiguration('height')", "'--z', PythonExpression([LaunchConfiguration('height'), ' * 2 / 2'])"),
        ),
    ),
    'static_frame: no tf2_echo, camera first': (
        'static_frame',
        '',
        body(
            "DeclareLaunchArgument('height', default_value='3'), Node(package='tf2_ros', executable='static_transform_publisher', "
            + CAMERA
            + '),'
            "Node(package='tf2_ros', executable='static_transform_publisher', arguments=[" + LASER + '])'
        ),
    ),
    'static_frame: ros2 run': (
        'static_frame',
        '',
        changed(
            STATIC,
            (
                "Node(\n            package='tf2_ros',\n            executable='static_transform_publisher',\n            name='camera_frame',\n            "
                + CAMERA
                + '\n        ),',
                "ExecuteProcess(cmd='ros2 run tf2_ros static_transform_publisher --z 0.1 --yaw 1.5708 --frame-id laser --child-frame-id camera'.split()),",
            ),
        ),
    ),
    'static_frame: a robot description': (
        'static_frame',
        '',
        body(
            "DeclareLaunchArgument('height', default_value='0.5'), Node(package='robot_state_publisher', executable='robot_state_publisher', "
            f"parameters=[{{'robot_description': __import__('launch_ros').parameter_descriptions.ParameterValue([{URDF}], value_type=str)}}])"
        ),
    ),
    'static_frame: components in a container': ('static_frame', 'xml', BOXED),
    'mast: a component, and a frame above the robot': (
        'mast',
        '',
        changed(
            solution('mast'),
            (
                "Node(package='robot_state_publisher', executable='robot_state_publisher', parameters=[{'robot_description': CART}]),",
                "ComposableNodeContainer(name='box', namespace='', package='rclcpp_components', executable='component_container',"
                " composable_node_descriptions=[ComposableNode(package='robot_state_publisher',"
                " plugin='robot_state_publisher::RobotStatePublisher', parameters=[{'robot_description': CART}])]),"
                "Node(package='tf2_ros', executable='static_transform_publisher',"
                " arguments=['--frame-id', 'map', '--child-frame-id', 'base_link']),",
            ),
            ('\n\n\ndef generate', '\nfrom launch_ros.descriptions import ComposableNode\n\n\ndef generate'),
        ),
    ),
    'static_frame: a namespace': ('static_frame', '', changed(STATIC, ("name='laser_frame',", "name='any', namespace='mast',"))),
    'follow: turtlesim by ros2 run': (
        'follow',
        '',
        changed(FOLLOW, (SIM, "ExecuteProcess(cmd=['ros2', 'run', 'turtlesim', 'turtlesim_node']),\n")),
    ),
    'follow: turtlesim by a shell': (
        'follow',
        '',
        changed(FOLLOW, (SIM, "ExecuteProcess(cmd=['ros2 run turtlesim turtlesim_node'], shell=True),\n")),
    ),
    'follow: draw_square before turtlesim': ('follow', '', changed(FOLLOW, (SIM, ''), (SQUARE, SQUARE + SIM))),
    'follow: the demo and a square': (
        'follow',
        '',
        body(
            f"{MOVE}, {DEMO.format('turtle1')}, Node(package='turtlesim', executable='draw_square', condition=IfCondition(LaunchConfiguration('move')))"
        ),
    ),
    'follow: XML': (
        'follow',
        'xml',
        '<launch><arg name="move" default="false"/><node pkg="turtlesim" exec="turtlesim_node"/>'
        '<node pkg="turtlesim" exec="draw_square" if="$(var move)"/>'
        '<group><node pkg="turtle_tf2_py" exec="turtle_tf2_broadcaster" name="a"><param name="turtlename" value="turtle1"/></node></group>'
        '<node pkg="turtle_tf2_py" exec="turtle_tf2_broadcaster" name="b"><param name="turtlename" value="turtle2"/></node>'
        '<node pkg="turtle_tf2_py" exec="turtle_tf2_listener"><param name="target_frame" value="turtle1"/></node></launch>',
    ),
    'follow: other names, a loop': (
        'follow',
        '',
        body(
            f"{MOVE}, {TWO_BROADCASTERS}, {LISTENER.format('turtle1')}, {SIM.strip()} GroupAction([Node(package='turtlesim', executable='draw_square')], condition=IfCondition(LaunchConfiguration('move')))"
        ),
    ),
    'follow: an opposite condition': (
        'follow',
        '',
        changed(
            FOLLOW,
            ('condition=IfCondition(move)', 'condition=UnlessCondition(PythonExpression([\'"\', move, \'" == "false"\']))'),
        ),
    ),
    'follow: when turtlesim has started': (
        'follow',
        '',
        changed(
            FOLLOW,
            (
                SIM,
                "        RegisterEventHandler(__import__(\"launch\").event_handlers.OnProcessStart(target_action=sim, on_start=[Node(package='turtlesim', executable='draw_square', condition=IfCondition(move))])), sim,\n",
            ),
            (SQUARE, ''),
            ('    return Launch', "    sim = Node(package='turtlesim', executable='turtlesim_node')\n    return Launch"),
        ),
    ),
    'carrot: no list of choices': ('carrot', '', changed(CARROT, ("            choices=['fixed', 'moving'],\n", ''))),
    'carrot: a function': (
        'carrot',
        '',
        OPAQUE.format(
            declared=CHOICE,
            actions=f"[{DEMO.format('carrot1')}, Node(package='turtle_tf2_py', executable={{'fixed': 'fixed', 'moving': 'dynamic'}}[LaunchConfiguration('carrot').perform(context)] + '_frame_tf2_broadcaster')]",
        ),
    ),
    'carrot: an executable that is computed': (
        'carrot',
        '',
        body(
            f"{CHOICE}, {DEMO.format('carrot1')}, Node(package='turtle_tf2_py', executable=[PythonExpression([\"'dynamic' if '\", LaunchConfiguration('carrot'), \"' == 'moving' else 'fixed'\"]), '_frame_tf2_broadcaster'])"
        ),
    ),
    'carrot: XML': (
        'carrot',
        'xml',
        '<launch><arg name="carrot" default="fixed"/><include file="$(find-pkg-share turtle_tf2_py)/launch/turtle_tf2_demo.launch.py"><arg name="target_frame" value="carrot1"/></include>'
        '<node pkg="turtle_tf2_py" exec="fixed_frame_tf2_broadcaster" if="$(equals $(var carrot) fixed)"/>'
        '<node pkg="turtle_tf2_py" exec="dynamic_frame_tf2_broadcaster" unless="$(equals $(var carrot) fixed)"/></launch>',
    ),
    'carrot: every node by itself': (
        'carrot',
        '',
        body(
            f'{CHOICE}, {SIM.strip()} {TWO_BROADCASTERS}, {LISTENER.format("carrot1")}, '
            "Node(package='turtle_tf2_py', executable='fixed_frame_tf2_broadcaster', condition=LaunchConfigurationEquals('carrot', 'fixed')), "
            "Node(package='turtle_tf2_py', executable='dynamic_frame_tf2_broadcaster', condition=LaunchConfigurationNotEquals('carrot', 'fixed'))"
        ),
    ),
    'carrot: a group with a condition': (
        'carrot',
        '',
        changed(
            CARROT,
            (
                "Node(\n            package='turtle_tf2_py',\n            executable='dynamic_frame_tf2_broadcaster',\n            name='dynamic_broadcaster',\n            condition=IfCondition(EqualsSubstitution(carrot, 'moving')),\n        ),",
                "GroupAction([Node(package='turtle_tf2_py', executable='dynamic_frame_tf2_broadcaster')], condition=IfCondition(NotEqualsSubstitution(carrot, 'fixed'))),",
            ),
        ),
    ),
    'carrot: the carrot first': (
        'carrot',
        '',
        body(
            f"{CHOICE}, Node(package='turtle_tf2_py', executable=['', PythonExpression([\"'dynamic' if '\", LaunchConfiguration('carrot'), \"' == 'moving' else 'fixed'\"]), '_frame_tf2_broadcaster']), {DEMO.format('carrot1')}"
        ),
    ),
    'broken_follow: ten times a second': (
        'broken_follow',
        '',
        changed(BROKEN, ("'pub', '/teacher", "'pub', '-r', '10', '/teacher")),
    ),
    'broken_follow: remappings as arguments': (
        'broken_follow',
        '',
        changed(
            BROKEN,
            (
                "remappings=[\n                ('input/pose', '/teacher/turtle1/pose'),\n                ('output/cmd_vel', '/turtle1/cmd_vel'),\n            ],",
                "arguments=['--ros-args', '-r', 'input/pose:=/teacher/turtle1/pose', '-r', 'output/cmd_vel:=/turtle1/cmd_vel'],",
            ),
        ),
    ),
    'broken_follow: other names of nodes': (
        'broken_follow',
        '',
        changed(
            BROKEN, ("name='mimic'", "name='copycat'"), ("name='broadcaster1'", "name='a'"), ("name='listener'", "name='ear'")
        ),
    ),
    'broken_follow: mimic in a namespace': (
        'broken_follow',
        '',
        changed(BROKEN, ("name='mimic',", "name='mimic', namespace='copies',")),
    ),
    'broken_follow: a loop of broadcasters': (
        'broken_follow',
        '',
        changed(
            BROKEN,
            ('        # Two broadcasters', f'        {TWO_BROADCASTERS},\n        # Two broadcasters'),
            *[
                (
                    f"        Node(\n            package='turtle_tf2_py',\n            executable='turtle_tf2_broadcaster',\n            name='broadcaster{n}',\n            parameters=[{{'turtlename': 'turtle{n}'}}],\n        ),\n",
                    '',
                )
                for n in (1, 2)
            ],
        ),
    ),
}
RIGHT_PACKAGES = {
    'large_project: a head for each node': package(
        (
            'config/turtlesim.yaml',
            '',
            ''.join(
                f'{node}:\n  ros__parameters: {{background_r: 150, background_g: 86, background_b: 255}}\n'
                for node in ('/sim', '/turtlesim2/sim')
            ),
        )
    ),
    'large_project: a head with a star for the namespace': package(('config/turtlesim.yaml', '/**:', '/**/sim:')),
    'large_project: the mimic in the top file': package(
        (
            'launch/large_project.launch.py',
            "include('mimic.launch.py'),",
            "Node(package='turtlesim', executable='mimic', remappings=[('input/pose', '/turtle2/pose'), ('output/cmd_vel', '/turtlesim2/turtle1/cmd_vel')]),",
        )
    ),
    'large_project: the order turned around': package(
        ('launch/large_project.launch.py', "        include('mimic.launch.py'),\n", ''),
        (
            'launch/large_project.launch.py',
            "        include('world.launch.py'),\n        GroupAction",
            "        include('mimic.launch.py'),\n        include('world.launch.py'),\n        GroupAction",
        ),
    ),
    'large_project: the carrot in a group': package(
        (
            'launch/large_project.launch.py',
            "        Node(package='turtle_tf2_py', executable='fixed_frame_tf2_broadcaster', name='fixed_broadcaster'),",
            "        GroupAction([Node(package='turtle_tf2_py', executable='fixed_frame_tf2_broadcaster')]),",
        )
    ),
}
