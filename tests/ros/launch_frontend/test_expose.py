"""Registering elements and substitutions."""

import pytest
from launch.frontend import expose, expose_action, expose_substitution
from launch.frontend.expose import action_parse_methods, substitution_parse_methods
from launch.frontend.parse_substitution import parse_substitution
from launch.substitutions import TextSubstitution

expose_impl = expose.__dict__['__expose_impl']


class Exposed:
    @classmethod
    def parse(cls, *_):
        return cls, {}


def test_a_class_is_registered_by_its_parse_method():
    register = {}
    assert expose_impl('it', register, 'action')(Exposed) is Exposed
    assert register['it'] == Exposed.parse


def test_a_function_is_registered_itself():
    register = {}

    def parse(*_):
        return Exposed, {}

    assert expose_impl('it', register, 'action')(parse) is parse
    assert register['it'] is parse


def test_a_class_without_parse_is_refused():
    with pytest.raises(RuntimeError, match="Did not find a method called 'parse' in the class being decorated"):
        expose_impl('it', {}, 'action')(int)


def test_what_cannot_be_called_is_refused():
    message = 'Exposed action parser for it is not a callable or a class containing a parse method'
    with pytest.raises(RuntimeError, match=message):
        expose_impl('it', {}, 'action')(5)


def test_a_name_is_given_once():
    register = {}
    expose_impl('it', register, 'action')(Exposed)
    with pytest.raises(RuntimeError, match=r'Two action parsing methods exposed with the same name: \[it\]'):
        expose_impl('it', register, 'action')(lambda *_: None)


def test_the_same_code_run_again_is_not_a_second_one():
    def define():
        def parse(*_):
            return Exposed, {}

        return parse

    register = {}
    expose_impl('it', register, 'action')(define())
    again = define()
    expose_impl('it', register, 'action')(again)
    assert register['it'] is again


def test_built_in_names_are_taken():
    assert 'node' in action_parse_methods
    assert 'var' in substitution_parse_methods
    with pytest.raises(RuntimeError, match=r'\[node\]'):
        expose_action('node')(lambda *_: None)


def test_an_exposed_substitution_can_be_written(monkeypatch):
    @expose_substitution('shout')
    def parse(arguments):
        return TextSubstitution, {'text': arguments[0][0].text.upper()}

    try:
        assert parse_substitution('$(shout abc)')[0].text == 'ABC'
    finally:
        del substitution_parse_methods['shout']
