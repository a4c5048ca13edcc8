"""Each element makes its action with the right arguments."""

import pytest
from launch import LaunchContext
from launch.frontend.expose import action_parse_methods
from launch.utilities import perform_substitutions

from edulaunch.engine.facts import facts_of


def text_of(substitutions, **configurations):
    context = LaunchContext()
    context.launch_configurations.update(configurations)
    return perform_substitutions(context, substitutions)


def test_arg(actions_of):
    plain, full = actions_of(
        '<arg name="a"/><arg name="b" default="$(var a)x" description="d"><choice value="1"/><choice value="2"/></arg>'
    )
    assert (plain.name, plain.default_value, plain.choices) == ('a', None, None)
    assert text_of(full.default_value, a='v') == 'vx'
    assert (full.choices, full.description) == (['1', '2'], "d. Valid choices are: ['1', '2']")


def test_let(actions_of):
    (it,) = actions_of('<let name="a" value="$(var b)"/>')
    assert (text_of(it.name), text_of(it.value, b='v')) == ('a', 'v')


def test_log_and_shutdown(actions_of):
    log, shutdown = actions_of('<log message="hi $(var b)"/><shutdown reason="done"/>')
    assert text_of(log.msg, b='you') == 'hi you'
    assert type(shutdown).__name__ == 'Shutdown'


def test_environment(actions_of):
    set_env, unset, append, reset = actions_of(
        '<set_env name="A" value="b"/><unset_env name="A"/>'
        '<append_env name="A" value="c" prepend="true" separator=","/><reset_env/>'
    )
    assert (text_of(set_env.name), text_of(set_env.value)) == ('A', 'b')
    assert text_of(unset.name) == 'A'
    context = LaunchContext()
    context.environment['A'] = 'b'
    try:
        append.visit(context)
        assert context.environment['A'] == 'c,b'
    finally:
        del context.environment['A']
    assert type(reset).__name__ == 'ResetEnvironment'


def test_include(actions_of):
    (it,) = actions_of('<include file="$(var d)/a.launch.py"><arg name="x" value="$(var y)"/></include>')
    ((name, value),) = it.launch_arguments
    assert (text_of(name), text_of(value, y='1')) == ('x', '1')


@pytest.mark.parametrize(
    ('attributes', 'names'),
    [
        ('', ['PushLaunchConfigurations', 'PushEnvironment', 'LogInfo', 'PopEnvironment', 'PopLaunchConfigurations']),
        ('scoped="false"', ['LogInfo']),
        (
            'forwarding="false"',
            [
                'PushLaunchConfigurations',
                'PushEnvironment',
                'ResetEnvironment',
                'ResetLaunchConfigurations',
                'LogInfo',
                'PopEnvironment',
                'PopLaunchConfigurations',
            ],
        ),
    ],
)
def test_group(actions_of, attributes, names):
    (it,) = actions_of(f'<group {attributes}><log message="a"/></group>')
    assert [type(entity).__name__ for entity in it.get_sub_entities()] == names


def test_group_keeps_configurations(actions_of):
    (it,) = actions_of('<group scoped="false"><keep name="a" value="b"/><log message="a"/></group>')
    assert [type(entity).__name__ for entity in it.get_sub_entities()] == ['SetLaunchConfiguration', 'LogInfo']


def test_group_s_scope_takes_no_substitution(failure_of):
    failure_of('<launch><group scoped="$(var x)"/></launch>', raises=TypeError)


def test_reset_keeps_configurations(actions_of):
    (it,) = actions_of('<reset><keep name="a" value="$(var b)"/></reset>')
    context = LaunchContext()
    context.launch_configurations.update(a='1', b='2', c='3')
    it.visit(context)
    assert dict(context.launch_configurations) == {'a': '2'}


def test_timer(actions_of, yaml_actions_of):
    (from_xml,) = actions_of('<timer period="5"><log message="a"/></timer>')
    (from_yaml,) = yaml_actions_of('- timer:\n    period: 5.0\n    children:\n    - log: {message: a}')
    for timer in (from_xml, from_yaml):
        assert timer.period == 5.0
        assert [type(action).__name__ for action in timer.actions] == ['LogInfo']


def test_timer_with_a_period_to_be_found_out(actions_of):
    (it,) = actions_of('<ros_timer period="$(var p)"><log message="a"/></ros_timer>')
    assert text_of(it.period, p='2.5') == '2.5'


def test_executable(actions_of):
    (it,) = actions_of(
        '<executable cmd="ls $(var d)" cwd="/c" name="n" output="screen" shell="true" respawn="true" '
        'respawn_delay="2" launch-prefix="time"><env name="A" value="$(var d)"/></executable>'
    )
    assert [text_of(word, d='x') for word in it.cmd] == ['ls', 'x']
    ((name, value),) = it.additional_env
    assert (text_of(name), text_of(value, d='x')) == ('A', 'x')
    assert text_of(it.cwd) == '/c'
    assert it.shell is True


def test_on_exit_is_shutdown_or_nothing(actions_of, failure_of):
    actions_of('<executable cmd="ls" on_exit="shutdown"/>')
    error = failure_of('<launch><executable cmd="ls" on_exit="restart"/></launch>', raises=ValueError)
    assert 'expected to be shutdown but got `restart`' in str(error)


@pytest.mark.parametrize(
    ('attribute', 'holds'), [('if="true"', True), ('if="0"', False), ('unless="1"', False), ('unless="$(var f)"', True)]
)
def test_every_action_can_have_a_condition(actions_of, attribute, holds):
    context = LaunchContext()
    context.launch_configurations['f'] = 'false'
    for text in ('<log message="a" {}/>', '<let name="a" value="b" {}/>', '<group {}/>', '<arg name="a" {}/>'):
        (it,) = actions_of(text.format(attribute))
        assert it.condition.evaluate(context) is holds


def test_node(actions_of):
    (it,) = actions_of(
        '<node pkg="p" exec="e" name="n" namespace="/s" args="a $(var b)" ros_args="--log-level info" '
        'output="$(var o)"><remap from="x" to="$(var b)"/></node>'
    )
    words = [text_of(word, b='v') for word in it.cmd[1:] if 'LocalVar' not in word[0].describe()]
    assert words[:4] == ['a', 'v', '--ros-args', '--log-level']
    ((source, target),) = it._Node__remappings
    assert (text_of(source), text_of(target, b='v')) == ('x', 'v')


PARAMETERS = [
    ('<param name="p" value="1"/>', {'p': 1}),
    ('<param name="p" value="1.5"/>', {'p': 1.5}),
    ('<param name="p" value="true"/>', {'p': True}),
    ('<param name="p" value="abc"/>', {'p': 'abc'}),
    ('<param name="p" value="$(var i)"/>', {'p': 7}),
    ('<param name="p" value="$(var i)" type="str"/>', {'p': '7'}),
    ('<param name="p" value="1" type="float"/>', {'p': 1.0}),
    ('<param name="p" value="1" type="str"/>', {'p': '1'}),
    ("""<param name="p" value="'1'"/>""", {'p': '1'}),
    ('<param name="p" value="1,2" value-sep=","/>', {'p': [1, 2]}),
    ('<param name="p" value="a;b" value-sep=";"/>', {'p': ['a', 'b']}),
    ('<param name="p" value="[1.0, 2.0]" type="list_of_float"/>', {'p': [1.0, 2.0]}),
    (
        ('<param name="g"><param name="a" value="1"/><param name="b"><param name="c" value="x"/></param></param>'),
        {'g.a': 1, 'g.b.c': 'x'},
    ),
]


def evaluated(node):
    from launch_ros.utilities import evaluate_parameters

    context = LaunchContext()
    context.launch_configurations['i'] = '7'
    parameters = evaluate_parameters(context, node._Node__parameters)
    return [one if isinstance(one, dict) else str(one) for one in parameters]


@pytest.mark.parametrize(('text', 'parameters'), PARAMETERS)
def test_param_values_have_types(actions_of, text, parameters):
    (it,) = actions_of(f'<node exec="e">{text}</node>')
    assert repr(evaluated(it)) == repr([parameters])


def test_each_param_is_a_source_of_its_own_in_the_order_of_the_file(actions_of, yaml_actions_of):
    (it,) = actions_of(
        '<node exec="e"><param name="p" value="1"/><param from="a/$(var i).yaml"/><param name="q$(var i)" value="2"/></node>'
    )
    assert evaluated(it) == [{'p': 1}, 'a/7.yaml', {'q7': 2}]
    (it,) = actions_of('<node exec="e"><param name="p" value="1"/><param name="q$(var i)" value="2"/></node>')
    assert evaluated(it) == [{'p': 1}, {'q7': 2}]
    params = [{'name': 'p', 'value': 1}, {'name': 'p', 'value': 2}]
    (it,) = yaml_actions_of(f'- node: {{exec: e, param: {params}}}')
    assert evaluated(it) == [{'p': 1}, {'p': 2}]


def test_respawn_is_a_text_and_seconds_are_numbers(actions_of, yaml_actions_of, failure_of):
    (it,) = actions_of('<executable cmd="ls" respawn="$(var r)" respawn_delay="2" sigterm_timeout="3" sigkill_timeout=".5"/>')
    assert (text_of(it.respawn, r='false'), it.respawn_delay) == ('false', 2.0)
    assert (text_of(it.sigterm_timeout), text_of(it.sigkill_timeout)) == ('3.0', '0.5')
    (it,) = yaml_actions_of("- executable: {cmd: ls, respawn: 'false', sigterm_timeout: 3.0}")
    assert (text_of(it.respawn), text_of(it.sigterm_timeout)) == ('false', '3.0')
    error = failure_of('launch:\n- executable: {cmd: ls, respawn: false}', 'a.launch.yaml', TypeError)
    assert str(error) == (
        "Attribute 'respawn' of Entity 'executable' expected to be of type '<class 'str'>', got '<class 'bool'>'"
    )


@pytest.mark.parametrize('name', ['respawn_delay', 'sigterm_timeout', 'sigkill_timeout'])
def test_seconds_are_neither_negative_nor_substitutions(failure_of, name):
    error = failure_of(f'<launch><executable cmd="ls" {name}="-1"/></launch>', raises=ValueError)
    assert str(error) == f'Attribute {name} of Entity node expected to be a non-negative value but got `-1.0`'
    error = failure_of(f'<launch><executable cmd="ls" {name}="$(var d)"/></launch>', raises=TypeError)
    assert str(error) == "'<' not supported between instances of 'str' and 'float'"
    assert (facts_of(error)['about'], facts_of(error)['attribute']) == ('launch.number-only', name)


@pytest.mark.parametrize(
    ('text', 'parameters'),
    [
        ('{name: p, value: 1}', {'p': 1}),
        ('{name: p, value: "1"}', {'p': '1'}),
        ('{name: p, value: [a, b]}', {'p': ['a', 'b']}),
        ('{name: p, value: $(var i)}', {'p': 7}),
        ('{name: g, param: [{name: a, value: true}]}', {'g.a': True}),
    ],
)
def test_param_values_in_yaml_keep_their_types(yaml_actions_of, text, parameters):
    (it,) = yaml_actions_of(f'- node:\n    exec: e\n    param:\n    - {text}')
    assert repr(evaluated(it)) == repr([parameters])


@pytest.mark.parametrize(
    ('text', 'error', 'message'),
    [
        ('<param value="1"/>', ValueError, 'param Entity should have name or from attribute'),
        ('<param name="a" from="b"/>', RuntimeError, 'name and from attributes are mutually exclusive'),
        ('<param name="a"/>', RuntimeError, 'either a value attribute or nested params are needed'),
        (
            '<param name="a" value="1"><param name="b" value="1"/></param>',
            RuntimeError,
            'nested parameters and value attributes are mutually exclusive',
        ),
        (
            '<param name="a" value="1" allow_substs="true"/>',
            RuntimeError,
            "'allow_substs' can only be used together with 'from' attribute",
        ),
        ('<param name="a" value="1" type="bogus"/>', ValueError, "Got invalid type identifier 'bogus'"),
        ('<param from="a" value="1"/>', ValueError, "Unexpected attribute(s) found in `param`: {'value'}"),
    ],
)
def test_param_attributes_must_go_together(failure_of, text, error, message):
    assert str(failure_of(f'<launch><node exec="e">{text}</node></launch>', raises=error)) == message


def test_composition(actions_of):
    nodes = (
        '<composable_node pkg="p" plugin="p::P" name="n" namespace="s" if="true"><param name="a" value="1"/>'
        '<remap from="x" to="y"/><extra_arg name="use_intra_process_comms" value="true"/></composable_node>'
    )
    container, load = actions_of(
        f'<node_container pkg="rclcpp_components" exec="component_container" name="c" namespace="">{nodes}'
        f'</node_container><load_composable_node target="/c">{nodes}</load_composable_node>'
    )
    for descriptions in (
        container._ComposableNodeContainer__composable_node_descriptions,
        load._LoadComposableNodes__composable_node_descriptions,
    ):
        (it,) = descriptions
        assert [text_of(value) for value in (it.package, it.node_plugin, it.node_name, it.node_namespace)] == [
            'p',
            'p::P',
            'n',
            's',
        ]
        assert it.condition() is not None


@pytest.mark.parametrize(
    ('text', 'name'),
    [
        ('<push_ros_namespace namespace="a"/>', 'PushROSNamespace'),
        ('<push-ros-namespace namespace="a"/>', 'PushROSNamespace'),
        ('<set_parameter name="a" value="1"/>', 'SetParameter'),
        ('<set_parameters_from_file filename="a"/>', 'SetParametersFromFile'),
        ('<set_remap from="a" to="b"/>', 'SetRemap'),
        ('<set_use_sim_time value="true"/>', 'SetUseSimTime'),
        ('<set_ros_log_dir new_log_dir="a"/>', 'SetROSLogDir'),
    ],
)
def test_settings_for_nodes(actions_of, text, name):
    assert [type(action).__name__ for action in actions_of(text)] == [name]


def test_a_group_in_yaml_is_a_list_of_actions(yaml_actions_of):
    (it,) = yaml_actions_of('- group:\n  - push-ros-namespace: {namespace: a}\n  - log: {message: b}')
    assert [type(entity).__name__ for entity in it.get_sub_entities()][2:4] == ['PushROSNamespace', 'LogInfo']


@pytest.mark.parametrize(
    ('text', 'message'),
    [
        ('<executable cmd="ls" env="a"/>', "Unexpected attribute(s) found in `executable`: {'env'}"),
        ('<executable cmd="ls"><name/></executable>', "Unexpected nested tag(s) found in `executable`: {'name'}"),
        ('<node exec="e" param="a.yaml"/>', "Unexpected attribute(s) found in `node`: {'param'}"),
        ('<node exec="e"><param name="a" value="b" param="c"/></node>', "Unexpected attribute(s) found in `param`: {'param'}"),
        ('<log message="a"><if/></log>', "Unexpected nested tag(s) found in `log`: {'if'}"),
        ('<include file="a" arg="b"/>', "Unexpected attribute(s) found in `include`: {'arg'}"),
        ('<arg name="a" choice="b"/>', "Unexpected attribute(s) found in `arg`: {'choice'}"),
    ],
)
def test_an_attribute_is_no_child_and_a_child_no_attribute(failure_of, text, message):
    assert str(failure_of(f'<launch>{text}</launch>', raises=ValueError)) == message


@pytest.mark.parametrize('name', sorted(action_parse_methods))
def test_every_element_refuses_what_it_does_not_know(failure_of, name):
    error = failure_of(f'<launch><{name} bogus_attribute="1"/></launch>', raises=(ValueError, AttributeError))
    assert 'bogus_attribute' in str(error) or 'not found in Entity' in str(error)
