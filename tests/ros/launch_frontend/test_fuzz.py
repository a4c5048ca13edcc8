"""No text of a launch file, however broken, gives anything but a description or one of launch's errors."""

import io
from xml.sax.saxutils import quoteattr

from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from launch import LaunchDescription
from launch.frontend import InvalidFrontendLaunchFileError, Parser
from launch.frontend.expose import action_parse_methods
from launch.frontend.parse_substitution import SubstitutionSyntaxError

from edulaunch.engine.facts import facts_of

ERRORS = (InvalidFrontendLaunchFileError, SubstitutionSyntaxError, RuntimeError, ValueError, TypeError, AttributeError)
quickly = settings(max_examples=80, deadline=None, suppress_health_check=list(HealthCheck))

tags = st.sampled_from(
    [*sorted(action_parse_methods), 'param', 'remap', 'env', 'keep', 'choice', 'composable_node', 'extra_arg', 'bogus']
)
names = st.sampled_from(
    [
        'name',
        'value',
        'pkg',
        'exec',
        'from',
        'to',
        'if',
        'unless',
        'type',
        'args',
        'cmd',
        'file',
        'message',
        'namespace',
        'output',
        'respawn',
        'scoped',
        'period',
        'default',
        'value-sep',
    ]
)
texts = st.sampled_from(
    [
        'a',
        '1',
        'true',
        '',
        '$(var x)',
        '$(var',
        '$(find x)',
        "'a",
        '1.5',
        '[1, 2]',
        '/n',
        'a b',
        '$(eval "1")',
        'screen',
        'shutdown',
        'int',
    ]
) | st.text('a$()\\ "\'1', max_size=12)
elements = st.recursive(
    st.tuples(tags, st.dictionaries(names, texts, max_size=4), st.just([])),
    lambda inner: st.tuples(tags, st.dictionaries(names, texts, max_size=4), st.lists(inner, max_size=3)),
    max_leaves=6,
)
values = st.recursive(
    texts | st.none() | st.integers(-2, 9) | st.booleans() | st.floats(allow_nan=False),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(tags | names, inner, max_size=3),
    max_leaves=8,
)


def as_xml(element):
    tag, attributes, children = element
    written = ''.join(f' {name}={quoteattr(value)}' for name, value in attributes.items())
    return f'<{tag}{written}>{"".join(map(as_xml, children))}</{tag}>'


def parses_or_explains(text, name):
    stream = io.StringIO(text)
    stream.name = name
    try:
        root, parser = Parser.load(stream)
        description = parser.parse_description(root)
    except ERRORS as error:
        assert facts_of(error)['about'] and error.edulaunch_file == name
    else:
        assert isinstance(description, LaunchDescription)


@quickly
@given(elements)
def test_any_xml_elements(element):
    parses_or_explains(f'<launch>{as_xml(element)}</launch>', 'x.launch.xml')


@quickly
@given(st.lists(st.dictionaries(tags, values, max_size=1), max_size=3))
def test_any_yaml_values(children):
    import yaml

    parses_or_explains(yaml.safe_dump({'launch': children}), 'x.launch.yaml')


@quickly
@given(
    st.sampled_from(['x.launch.xml', 'x.launch.yaml', 'x.launch']),
    st.binary(max_size=60) | st.text('<>/&;!-?"= abclaunch[]:{}*#\n', max_size=60).map(str.encode),
)
def test_any_bytes(tmp_path, name, content):
    path = tmp_path / name
    path.write_bytes(content)
    try:
        root, parser = Parser.load(str(path))
        parser.parse_description(root)
    except ERRORS as error:
        assert error.edulaunch_file == str(path)
