"""`edulaunch course`: commands for authors, teachers and students of a course."""

from __future__ import annotations

import argparse
import importlib.util
import os
import sys
from typing import Any

from edulaunch.course import progress
from edulaunch.errors import MissingExtra, UnusableInput


def add_verbs(verbs: Any) -> None:
    """Add the sub-verbs for pages, slides and notes, each with an argument for the course."""
    reader = verbs.add_parser('reader', help='write accessible HTML pages of all lessons, which need no Jupyter and no network')
    reader.add_argument('out', metavar='OUT', help='folder for the pages')
    reader.add_argument('--teacher', action='store_true', help='include right answers and the notes for teachers')
    reader.add_argument(
        '--kept', action='store_true', help='use the stored outputs, without pictures, instead of running lessons'
    )
    reader.add_argument('--pdf', action='store_true', help='also write OUT/course.pdf with the Chromium on this computer')
    slides = verbs.add_parser('slides', help='write slides of a lesson as one HTML file that needs no network')
    slides.add_argument('lesson', metavar='LESSON', help='name or number of the lesson')
    slides.add_argument('out', nargs='?', metavar='OUT', help='name of the file (default: LESSON.slides.html)')
    slides.add_argument(
        '--kept', action='store_true', help='use the stored outputs, without pictures, instead of running the lesson'
    )
    notes = verbs.add_parser('notes', help='show the notes for teachers on a lesson, or list all notes')
    notes.add_argument('lesson', nargs='?', metavar='LESSON', help='name or number of the lesson')
    for parser in (reader, slides, notes):
        parser.add_argument(
            '--course',
            metavar='COURSE',
            help='folder of the course (default: the course around this folder, or that of edulaunch)',
        )


def _progress(line: str) -> None:
    """Print one line of progress to standard error, so that standard output contains only the result."""
    print(line, file=sys.stderr, flush=True)


def _reader(arguments: argparse.Namespace) -> int:
    """Run `edulaunch course reader OUT`."""
    from edulaunch.course.reader import write_reader

    out = arguments.out
    names, problem = write_reader(
        _chosen_course(arguments), out, teacher=arguments.teacher, kept=arguments.kept, pdf=arguments.pdf, say=_progress
    )
    print(f'{out}: {len(names)} pages. Open {os.path.join(out, names[0])} first')
    if arguments.pdf:
        print(problem or f'{os.path.join(out, "course.pdf")}: the whole course')
    return 1 if problem else 0


def _slides(arguments: argparse.Namespace) -> int:
    """Run `edulaunch course slides LESSON [OUT]`."""
    from edulaunch.course.slides import write_slides

    out, count = write_slides(_chosen_course(arguments), arguments.lesson, arguments.out, kept=arguments.kept, say=_progress)
    print(f'{out}: {count} slides. Open it in a browser, and use the arrow keys (N: the whole text, O: all slides)')
    return 0


def _notes(arguments: argparse.Namespace) -> int:
    """Run `edulaunch course notes [LESSON]`."""
    from edulaunch.course.lessons import list_of_notes, notes_of

    course = _chosen_course(arguments)
    print(notes_of(course, arguments.lesson) if arguments.lesson else list_of_notes(course))
    return 0


def _class(arguments: argparse.Namespace) -> int:
    """Run `edulaunch course class FOLDER`."""
    from edugrade.files import write_whole

    from edulaunch.course.class_page import Class, page_of_class, read_course_of
    from edulaunch.course.handed_in import read_class

    standings, refused = read_class(arguments.folder)
    write_whole(arguments.out, page_of_class(Class(*read_course_of(_chosen_course(arguments)), standings, refused)))
    for item in refused:
        print(f'skipped {item.path}: {item.why}'.encode('ascii', 'backslashreplace').decode(), file=sys.stderr)
    count = len(standings)
    print(f'{arguments.out}: {count} {"student" if count == 1 else "students"}. Open it in a browser')
    return 1 if refused else 0


def _chosen_course(arguments: argparse.Namespace) -> str:
    from edulaunch.course.lessons import course_around, given_course

    return given_course(arguments.course) if arguments.course else course_around('.')


def course_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the sub-verbs of `edulaunch course`."""
    verbs = parser.add_subparsers(dest='what', metavar='VERB', required=True)
    new = verbs.add_parser('new', help='create your own course, with a first lesson and a first exercise')
    new.add_argument('folder', metavar='DIR')
    copy = verbs.add_parser('copy', help='copy the course to a folder, as students get it')
    copy.add_argument('folder', metavar='DIR')
    copy.add_argument('--update', action='store_true', help='keep the files that you changed, and copy the new ones')
    copy.add_argument('--course', metavar='COURSE', help='folder of another course (default: the course of edulaunch)')
    copy.add_argument(
        '--student', metavar='NAME', help='create a personalised course, with names and numbers of exercises chosen for NAME'
    )
    copy.add_argument(
        '--course-secret-file', metavar='FILE', help='file with the secret that chooses them; give edugrade batch the same one'
    )
    lint = verbs.add_parser('lint', help='check that lessons, exercises, solutions and rubrics match')
    lint.add_argument('folder', nargs='?', default='.', metavar='DIR')
    lint.add_argument('--quick', action='store_true', help='launch nothing')
    listed = verbs.add_parser(
        'list', help='list the lessons and exercises of the course around this folder, or of that of edulaunch'
    )
    listed.add_argument('folder', nargs='?', metavar='DIR')
    verbs.add_parser('status', help='show your progress, and what to repeat')
    opened = verbs.add_parser('open', help='open the lessons in JupyterLab')
    opened.add_argument('folder', nargs='?', default='.', metavar='DIR')
    release = verbs.add_parser('release', help='write the version of your course for students, to a folder or a zip file')
    release.add_argument('folder', metavar='DIR')
    release.add_argument('out', metavar='OUT', help='folder, or name of a file that ends in .zip')
    release.add_argument('--with-rubrics', action='store_true', help="include the rubrics, which check('...') needs")
    template = verbs.add_parser('template', help='add the files with which a platform opens, checks or grades a course')
    template.add_argument(
        'name', metavar='NAME', help='github, classroom, gradescope, devcontainer, binder, docker, jupyterhub or vscode'
    )
    template.add_argument('folder', nargs='?', default='.', metavar='DIR')
    lite = verbs.add_parser('lite', help='write the edition that runs in a browser, for any web server')
    lite.add_argument('out', metavar='OUT')
    lite.add_argument('--pyodide', metavar='FOLDER', required=True, help='folder of Pyodide, such as node_modules/pyodide')
    lite.add_argument(
        '--course', metavar='COURSE', help='folder of the course with the exercises (default: the course of edulaunch)'
    )
    store = verbs.add_parser('store', help='run lessons, and store their outputs beside them for nbval')
    store.add_argument('notebooks', nargs='+', metavar='LESSON.ipynb')
    add_verbs(verbs)
    _class_arguments(
        verbs.add_parser('class', help='write a page on a class: progress, difficult exercises, students who are stuck')
    )


def _class_arguments(of_class: argparse.ArgumentParser) -> None:
    of_class.add_argument(
        'folder', metavar='FOLDER', help='folder with what each student handed in: my_progress.toml, or a folder with it'
    )
    of_class.add_argument('--out', metavar='FILE', default='class.html', help='name of the page (default: class.html)')
    of_class.add_argument(
        '--course', metavar='COURSE', help='folder of the course (default: the course around this folder, or that of edulaunch)'
    )


def course_verb(arguments: argparse.Namespace) -> int:
    """Run the sub-verb, and return the exit code."""
    code: int = globals()[f'_{arguments.what}'](arguments)
    return code


def _new(arguments: argparse.Namespace) -> int:
    from edulaunch.course.copying import new_course

    for name in new_course(arguments.folder):
        print(f'  {name}')
    print(f'created the course {arguments.folder}. Check it with: edulaunch course lint {arguments.folder}')
    return 0


def _copy(arguments: argparse.Namespace) -> int:
    from edulaunch.course.copying import copy_files, student_files
    from edulaunch.course.lessons import given_course, our_course

    course = given_course(arguments.course or our_course())
    _not_into_itself(course, arguments.folder)
    files = student_files(course)
    if arguments.student:
        files = _personal(files, course, arguments.student, arguments.course_secret_file)
    done = copy_files(files, arguments.folder, update=arguments.update)
    for name in done.left_alone:
        print(f'kept, because you changed it: {name}')
    print(f'{arguments.folder}: {len(done.written)} files copied. Open them with: edulaunch course open {arguments.folder}')
    return 0


def _personal(files: dict[str, bytes], course: str, student: str, secret: str | None) -> dict[str, bytes]:
    from edugrade.variant import CourseSecret

    from edulaunch.course.copying import personal_files

    if secret is None:
        raise UnusableInput(
            '--student needs the secret of the course, which chooses the variants', help='name it with --course-secret-file FILE'
        )
    return personal_files(files, course, student, CourseSecret(secret))


def _lint(arguments: argparse.Namespace) -> int:
    from edugrade.course_check import listed
    from edugrade.course_check import main as check

    from edulaunch.course.lesson_form import lesson_problems
    from edulaunch.course.lessons import given_course, has_manifest

    try:
        problems = list(listed(lesson_problems(given_course(arguments.folder))))
    except UnusableInput:  # if the manifest exists, the check below reports all its problems
        if not has_manifest(arguments.folder):
            raise
        problems = []
    return check([arguments.folder, *(['--quick'] if arguments.quick else [])], problems)


def _list(arguments: argparse.Namespace) -> int:
    from edulaunch.course.lessons import contents, course_around, given_course

    print(contents(given_course(arguments.folder) if arguments.folder else course_around('.')))
    return 0


def _status(arguments: argparse.Namespace) -> int:
    print(progress())
    return 0


def _open(arguments: argparse.Namespace) -> int:
    from subprocess import call

    from edulaunch.course.lessons import LESSONS, given_course

    folder = given_course(arguments.folder)
    if importlib.util.find_spec('jupyterlab') is None:
        raise MissingExtra('edulaunch course open', 'JupyterLab', 'notebook')
    lessons = [f'--LabApp.default_url=/lab/tree/{LESSONS}'] if os.path.isdir(os.path.join(folder, LESSONS)) else []
    try:
        return call([sys.executable, '-m', 'jupyterlab', *lessons], cwd=folder)
    except KeyboardInterrupt:
        return 130


def _release(arguments: argparse.Namespace) -> int:
    from edulaunch.course.copying import copy_files, student_files, write_zip
    from edulaunch.course.lessons import given_course

    course, out = given_course(arguments.folder), arguments.out
    files = student_files(course, rubrics=arguments.with_rubrics)
    if out.endswith('.zip'):
        write_zip(files, out)
    else:
        _not_into_itself(course, out)
        if os.path.isdir(out) and os.listdir(out):
            raise UnusableInput(f'{out} is not empty, and its files would be released, too', help='name a new folder')
        copy_files(files, out)
    kept_back = 'solutions and outputs' if arguments.with_rubrics else 'solutions, outputs and rubrics'
    print(f'{out}: {len(files)} files, without {kept_back}')
    return 0


def _not_into_itself(course: str, target: str) -> None:
    if os.path.realpath(course) == os.path.realpath(target):
        raise UnusableInput(f'{target} is the course itself', help='name another folder')


def _template(arguments: argparse.Namespace) -> int:
    from edulaunch.course.templates import NEXT, write_template

    for path in write_template(arguments.name, arguments.folder):
        print(f'  {path}')
    print(f'Next: {NEXT[arguments.name]}')
    return 0


def _lite(arguments: argparse.Namespace) -> int:
    from edulaunch.course.lessons import given_course, our_course
    from edulaunch.course.lite.site import make_site

    for note in make_site(arguments.out, arguments.pyodide, given_course(arguments.course or our_course())):
        print(f'note: {note}')
    print(f'wrote the web site {arguments.out}. View it with: python -m http.server --directory {arguments.out}')
    return 0


def _store(arguments: argparse.Namespace) -> int:
    from edulaunch.course.stored import store_outputs
    from edulaunch.engine.nearest import nearest_file

    for notebook in arguments.notebooks:
        if not os.path.isfile(notebook):
            folder, name = os.path.split(notebook)
            beside = os.listdir(folder or '.') if os.path.isdir(folder or '.') else []
            near = nearest_file(name, [file for file in beside if file.endswith('.ipynb')])
            raise UnusableInput(f'{notebook} does not exist', help=near and f'did you mean {os.path.join(folder, near)!r}?')
        store_outputs(notebook)
        print(f'stored the outputs of {notebook}; the notebook itself has no outputs')
    return 0
