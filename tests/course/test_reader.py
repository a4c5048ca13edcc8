"""`edulaunch course reader`: pages that give nothing away to students, and everything to teachers."""

from __future__ import annotations

import re
from html.parser import HTMLParser
from pathlib import Path

import pytest

from edulaunch.course import reader as pages
from edulaunch.course.reader import course_title, read_pages
from edulaunch.desk.cli.main import main

pytest.importorskip('nbconvert', reason='nbconvert is not installed')
VOID = {'meta', 'link', 'img', 'br', 'hr', 'input'}


class Outline(HTMLParser):
    """What a screen reader makes of a page; fails when elements are not closed in their order."""

    def __init__(self, html: str) -> None:
        super().__init__()
        self.headings: list[int] = []
        self.ids: list[str] = []
        self.links: list[str] = []
        self.pictures: list[str | None] = []
        self.seen: list[str] = []
        self._open: list[str] = []
        self.feed(html)
        assert self._open == []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        given = dict(attrs)
        self.seen.append(tag)
        self.ids += [given['id'] or ''] if 'id' in given else []
        self.links += [given['href'] or ''] if tag in ('a', 'link') else []
        self.headings += [int(tag[1])] if re.fullmatch(r'h[1-6]', tag) else []
        self.pictures += [given.get('alt')] if tag == 'img' else []
        assert tag != 'th' or given.get('scope') in ('col', 'row')
        if tag not in VOID:
            self._open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self._open.pop() == tag, f'</{tag}> at {self.getpos()}'


@pytest.fixture
def mine(tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv('XDG_CACHE_HOME', str(tmp_path / 'cache'))
    assert main(['course', 'new', str(tmp_path / 'mine')]) == 0
    notes = tmp_path / 'mine' / 'lessons' / 'notes'
    notes.mkdir()
    (notes / '01_circle.md').write_text('# Notes on 1\n\n| minutes | section |\n|---|---|\n| 10 | 1.1 Drive |\n\n$r = v$\n')
    capsys.readouterr()
    return tmp_path / 'mine'


def reader(course: Path, *words: str) -> Path:
    out = course.parent / 'out'
    assert main(['course', 'reader', str(out), '--course', str(course), *words]) == 0
    return out


def test_every_page_can_be_read_in_order_and_leads_only_to_what_is_there(mine: Path) -> None:
    second = mine / 'lessons' / '02_more.ipynb'
    second.write_bytes((mine / 'lessons' / '01_circle.ipynb').read_bytes())
    (mine / 'lessons' / '.outputs' / '02_more.json').write_bytes((mine / 'lessons' / '.outputs' / '01_circle.json').read_bytes())
    out = reader(mine, '--kept')
    pages = {path.name: Outline(path.read_text()) for path in out.glob('*.html')}
    assert sorted(pages) == ['01_circle.html', '02_more.html', 'course.html', 'index.html']
    for name, page in pages.items():
        text = (out / name).read_text()
        assert '<html lang="en">' in text and 'class="skip" href="#content"' in text and page.seen.count('main') == 1
        assert page.headings[0] == 1 and page.headings.count(1) == 1
        assert all(after - before <= 1 for before, after in zip(page.headings, page.headings[1:], strict=False)), name
        assert len(page.ids) == len(set(page.ids)) and None not in page.pictures
        for link in page.links:
            file, _, ident = link.partition('#')
            assert (out / (file or name)).is_file(), link
            assert not ident or ident in pages[file or name].ids, link
        assert 'http' not in re.sub(r'data:[^"]*', '', text)
    turns = (out / '01_circle.html').read_text()
    assert 'rel="next" href="02_more.html"' in turns and 'rel="prev"' not in turns


def test_students_are_not_told_what_was_right(mine: Path) -> None:
    out = reader(mine, '--kept')
    for name in ('01_circle.html', 'course.html'):
        text = (out / name).read_text()
        assert '4.0 m' in text and '2.0 m/s / 0.5 rad/s' not in text and 'Right.' not in text
        assert 'It was' not in text and "compare('" not in text and 'Notes on 1' not in text and 'Your guess' in text
    page = (out / '01_circle.html').read_text()
    folded = page[page.index('<details class="came">') :]
    assert (
        'turtle1 at (5.449, 7.541)' in folded and 'turtle1 at (5.449, 7.541)' not in page[: page.index('<details class="came">')]
    )
    paper = (out / 'course.html').read_text()
    assert paper.index('What came stands at the end') < paper.index('On a real robot') < paper.index('turtle1 at (5.449, 7.541)')


def test_teachers_are_told_what_was_right_and_have_the_notes(mine: Path) -> None:
    text = (reader(mine, '--kept', '--teacher') / '01_circle.html').read_text()
    assert (
        '<b>It was</b> 2</p>' in text
        and '<b>Right.</b> The radius is the speed divided' in text
        and 'the other way round' in text
    )
    assert 'class="came"' not in text and 'Notes on 1' in text and 'href="#01_circle-notes"' in text
    assert 'class="formula"' in text and 'alt="r = v"' in text and 'dc:date' not in text
    Outline(text)


@pytest.mark.whole
def test_a_run_gives_pictures(mine: Path) -> None:
    page = next(read_pages(str(mine), teacher=False, kept=False))
    pictures = [output for part in page.parts for output in part.outputs if output.kind == 'picture']
    assert [picture.data[:4] for picture in pictures] == [b'\x89PNG'] and page.title == '1. A turtle on a circle'
    (mine.parent / 'cache').rename(mine.parent / 'older')  # it runs a second time
    assert next(read_pages(str(mine), teacher=False, kept=False)) == page


def test_a_folder_with_other_files_is_refused_and_an_older_reader_goes(mine: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = reader(mine, '--kept')
    (out / '09_gone.html').write_text('old')
    reader(mine, '--kept')
    assert not (out / '09_gone.html').exists()
    (mine.parent / 'full').mkdir()
    (mine.parent / 'full' / 'thesis.html').write_text('years')
    assert main(['course', 'reader', str(mine.parent / 'full'), '--course', str(mine), '--kept']) == 2
    assert 'other files' in capsys.readouterr().err and (mine.parent / 'full' / 'thesis.html').read_text() == 'years'


def test_without_a_browser_there_is_a_sentence_and_no_pdf(
    mine: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(pages, 'which', lambda name: None)
    assert main(['course', 'reader', str(mine.parent / 'out'), '--course', str(mine), '--kept', '--pdf']) == 1
    assert 'no PDF, because no Chromium is installed' in capsys.readouterr().out
    assert 'course.pdf' not in (mine.parent / 'out' / 'index.html').read_text()


def test_with_a_browser_there_is_a_pdf(mine: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    browser = tmp_path / 'browser'
    browser.write_text('#!/bin/sh\nfor word; do case $word in --print-to-pdf=*) echo %PDF > "${word#*=}";; esac; done\n')
    browser.chmod(0o755)
    monkeypatch.setattr(pages, 'which', lambda name: str(browser))
    out = reader(mine, '--kept', '--pdf')
    assert (out / 'course.pdf').is_file() and 'href="course.pdf"' in (out / 'index.html').read_text()


def test_a_course_is_called_by_its_title(mine: Path) -> None:
    assert course_title(str(mine)) == 'mine'
    path = mine / 'course.toml'
    path.write_text(f"title = 'Turtles'\n{path.read_text()}")
    assert course_title(str(mine)) == 'Turtles'
