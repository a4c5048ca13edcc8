"""Every language has every sentence, and readers get what translators wrote."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from edulaunch.advice.catalogue import languages, messages, missing
from edulaunch.advice.reader import Reader, fields_of, translations

pytest.importorskip('babel', reason='Babel is only there for those who develop edulaunch')
from edulaunch.advice.catalogue import read  # noqa: E402

LANGUAGES = languages()


def of_people(language: str) -> dict[str, str]:
    return {str(message.id): str(message.string) for message in read(language) if message.id and not message.fuzzy}


def test_german_is_there() -> None:
    assert 'de' in LANGUAGES


@pytest.mark.parametrize('language', LANGUAGES)
def test_the_sentences_are_those_of_today(language: str) -> None:
    assert sorted(of_people(language)) == sorted(messages()), 'python -m edulaunch.advice.catalogue, then translate'


@pytest.mark.parametrize('language', LANGUAGES)
def test_a_reader_gets_what_people_wrote(language: str) -> None:
    assert translations(language) == {english: other for english, other in of_people(language).items() if other}


def test_a_fuzzy_translation_is_not_used_and_lines_and_quotes_are_kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from babel.messages.catalog import Catalog
    from babel.messages.pofile import write_po

    catalogue = Catalog('xx')
    odd = {'a "b"': 'c "d" \\ \t', 'one\ntwo': 'eins\nzwei', 'long ' * 40: 'lang ' * 40, 'later': ''}
    for english, other in odd.items():
        catalogue.add(english, other)
    catalogue.add('changed', 'alt', flags=('fuzzy',))
    catalogue.add('last', 'zuletzt')
    path = tmp_path / 'xx' / 'LC_MESSAGES' / 'advice.po'
    path.parent.mkdir(parents=True)
    with path.open('wb') as file:
        write_po(file, catalogue)
    monkeypatch.setattr('edulaunch.advice.reader.LOCALE', str(tmp_path))
    del odd['later']
    assert translations('xx') == {**odd, 'last': 'zuletzt'}


@pytest.mark.parametrize('language', LANGUAGES)
def test_a_language_is_complete_but_for_the_rules_that_are_marked_as_missing(language: str) -> None:
    where = messages()
    lacking = {where[english] for english, other in of_people(language).items() if not other}
    assert lacking == {*missing(language)}, f'translate, or list the rule in edulaunch/advice/locale/{language}/missing.txt'


@pytest.mark.parametrize('language', LANGUAGES)
def test_a_translation_has_the_facts_of_the_sentence(language: str) -> None:
    wrong = [
        english
        for english, other in of_people(language).items()
        if other and not set(fields_of(other)) <= set(fields_of(english))
    ]
    assert wrong == []


def test_code_stays_as_it_is() -> None:
    """What is to be typed is the same in every language."""
    typed = re.compile(r'--[a-z][\w-]+|\b\w+\(\)')
    wrong = [
        english
        for english, german in of_people('de').items()
        if german and not set(typed.findall(english)) <= set(typed.findall(german))
    ]
    assert wrong == []


def test_a_language_without_a_catalogue_is_told_in_english() -> None:
    assert Reader('tlh').says('and {count} more') == 'and {count} more'
    assert Reader('de_AT').says('and {count} more') == Reader('de').says('and {count} more') != 'and {count} more'


def test_a_place_that_has_moved_is_an_error_and_no_loss(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr('edulaunch.advice.catalogue.REPORTS', ('edugrade/gone.py',))
    with pytest.raises(FileNotFoundError, match='its sentences would be lost'):
        messages()


def test_the_sentences_of_checks_in_yaml_are_in_it_and_names_of_their_fields_are_not() -> None:
    known = messages()
    assert {
        'The parameter {name} of {node} has the right value',
        'the launch continues until the end of the run',
        'A black box',
    } <= set(known)
    assert not {'node package name value', 'tolerance near share', 'package executable'} & set(known)
