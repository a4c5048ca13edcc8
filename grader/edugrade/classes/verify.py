"""Verifies reports: ``edugrade verify`` repeats the grading with the same inputs, and ``edugrade sign`` signs a report.

Signatures are ed25519, so that every change of a report is detected. The keys are PEM files, as OpenSSL writes them.
"""

from __future__ import annotations

import argparse
import json
import os
from base64 import b64decode, b64encode
from collections.abc import Iterator, Sequence
from contextlib import suppress
from typing import Any

from edulaunch.errors import MissingExtra, UnusableInput

from ..files import read_given, write_whole
from ..grading import grade, plan_work
from ..job import Limits
from ..options import add_common
from ..reports.document import document, json_text, receipt
from ..reports.terminal import printable
from ..submission import Submission
from ..variant import CourseSecret, Variant, variant_for

LARGEST_KEY, LARGEST_REPORT = 10_000, 50_000_000
MAKE = 'openssl genpkey -algorithm ed25519 -out key.pem; openssl pkey -in key.pem -pubout -out public.pem'


def sign_parser() -> argparse.ArgumentParser:
    """Return the parser of the words after ``edugrade sign``."""
    parser = argparse.ArgumentParser(
        prog='edugrade sign', description='Sign reports in place, with an ed25519 key.', epilog=f'keys: {MAKE}'
    )
    parser.add_argument('reports', metavar='REPORT', nargs='+', help='a JSON report, or a result of a batch')
    parser.add_argument('--key', metavar='FILE', required=True, help='the private key, PEM')
    return parser


def sign_command(words: Sequence[str]) -> int:
    """Run the command ``edugrade sign``, and return its exit code."""
    options = sign_parser().parse_args(words)
    for path in options.reports:
        write_whole(path, json_text(signed(read_report(path), options.key)))
    return 0


def read_report(path: str) -> dict[str, Any]:
    """Return a JSON report.

    :raises UnusableInput: when the file cannot be read, or is not a JSON report with a receipt and checks.
    """
    data = read_given(path, LARGEST_REPORT, 'the report ')
    try:
        found = json.loads(data)
    except (ValueError, RecursionError) as error:
        raise UnusableInput(f'{path} is not a JSON report: {error}') from None
    if not isinstance(found, dict) or not isinstance(found.get('receipt'), dict) or not isinstance(found.get('checks'), list):
        raise UnusableInput(
            f'{path} is not a report with a receipt', help='write one with edugrade FILE --json, or with edugrade batch'
        )
    return found


def signed(report: dict[str, Any], key: str) -> dict[str, Any]:
    """Return the report with its signature, which replaces any earlier signature."""
    serialization, ed25519 = _library()
    private = _loaded(lambda data: serialization.load_pem_private_key(data, password=None), key)
    if not isinstance(private, ed25519.Ed25519PrivateKey):
        raise UnusableInput(f'the key {key} is not a private ed25519 key', help=MAKE)
    bare = {name: value for name, value in report.items() if name != 'signature'}
    value = b64encode(private.sign(_signed_bytes(bare))).decode()
    return {**bare, 'signature': {'algorithm': 'ed25519', 'key': _name(private.public_key(), serialization), 'value': value}}


def is_signed_by(report: dict[str, Any], key: str) -> bool:
    """Return whether the owner of this public key has signed exactly this report."""
    serialization, ed25519 = _library()
    public = _loaded(serialization.load_pem_public_key, key)
    if not isinstance(public, ed25519.Ed25519PublicKey):
        raise UnusableInput(f'the key {key} is not a public ed25519 key', help=MAKE)
    bare = {name: value for name, value in report.items() if name != 'signature'}
    try:
        public.verify(b64decode(report['signature']['value'], validate=True), _signed_bytes(bare))
    except Exception:  # InvalidSignature, or any error that a forged signature causes
        return False
    return True


def _signed_bytes(report: dict[str, Any]) -> bytes:
    """Return the bytes to sign, which do not depend on the order of keys or on spaces."""
    return json.dumps(report, sort_keys=True, separators=(',', ':')).encode()


def _name(public: Any, serialization: Any) -> str:
    raw: bytes = public.public_bytes(serialization.Encoding.Raw, serialization.PublicFormat.Raw)
    return raw.hex()


def _loaded(load: Any, key: str) -> Any:
    data = read_given(key, LARGEST_KEY, 'the key ', help=MAKE)
    try:
        return load(data)
    except Exception as error:
        raise UnusableInput(f'the key {key} is not a PEM key without a password: {error}', help=MAKE) from None


def _library() -> tuple[Any, Any]:
    try:
        from cryptography.hazmat.primitives import serialization
        from cryptography.hazmat.primitives.asymmetric import ed25519
    except ImportError:
        raise MissingExtra('a signature', 'cryptography', 'sign') from None
    return serialization, ed25519


MOST_BESIDE = 1000  # most entries in the folder of a report
MOST_PLACES = 20_000  # most files that a search for a submission reads
NAMES = {'submission': 'the text of the submission', 'rubric': 'the text of the rubric', 'edulaunch': 'the version of edulaunch'}


def verify_parser() -> argparse.ArgumentParser:
    """Return the parser of the words after ``edugrade verify``."""
    parser = argparse.ArgumentParser(
        prog='edugrade verify',
        description='Grade the same submission again with the same rubric and seed, and report whether the mark is the same.',
    )
    parser.add_argument('report', metavar='REPORT', help='a JSON report, or a result of a batch')
    parser.add_argument('--submission', metavar='PATH', help='the graded submission (default: the file beside the report)')
    parser.add_argument('--key', metavar='FILE', help='the report must be signed by this public key (PEM)')
    add_common(parser)
    return parser


def main(words: Sequence[str]) -> int:
    """Run the command. Return 0 if the report is confirmed, 1 if it is not, and 2 if it cannot be checked."""
    options = verify_parser().parse_args(words)
    report = read_report(options.report)
    differences = [*_of_the_signature(report, options.key), *_made_again(report, options)]
    for line in differences:
        print(printable(f'  {line}'))
    points, rubric = report.get('points', {}), report.get('rubric', {})
    mark = f'{rubric.get("name")}: {points.get("earned")} of {points.get("possible")} points'
    print(printable(f'{options.report} DOES NOT HOLD ({mark}).' if differences else f'{options.report} holds: {mark}.'))
    return 1 if differences else 0


def _of_the_signature(report: dict[str, Any], key: str | None) -> Iterator[str]:
    if key is not None and not is_signed_by(report, key):
        yield (
            'signature: none' if 'signature' not in report else 'signature: the report is not as the owner of this key signed it'
        )


def _made_again(report: dict[str, Any], options: argparse.Namespace) -> Iterator[str]:
    """Yield the differences after grading again: in the mark, its reasons, and the inputs."""
    before, seed = report['receipt'], report['receipt'].get('seed')
    if type(seed) is not int:
        raise UnusableInput(f'the receipt of {options.report} has no seed')
    submission = Submission(options.submission or find_submission(report, options.report))
    rubric = options.rubric or report['rubric']['name'] if submission.exercise != report['rubric']['name'] else options.rubric
    claimed = _variant(report)
    variant = _known_variant(claimed, report, options) if claimed else None
    if claimed != variant:
        yield 'variant: not the one that the course gives this student'
    work = plan_work(submission, rubric, seed, variant=variant)
    yield from _of_the_seed(report, options, submission)
    now = receipt(work)
    yield from (f'{words}: another one' for key, words in NAMES.items() if before.get(key) != now[key])
    (made,) = grade([work], Limits(options.limit, sandbox=options.sandbox), options.workspace)
    again = document(made)
    for key in ('points', 'verdict'):
        if report.get(key) != again[key]:
            yield f'{key}: {_words(report.get(key))} in the report, {_words(again[key])} now'
    yield from _of_the_list('check', report['checks'], again['checks'], ('status', 'points', 'earned', 'reason', 'seen'))
    yield from _of_the_list(
        'run', report.get('scenarios'), again['scenarios'], ('arguments', 'duration_s', 'seed', 'outcome', 'digest')
    )


def _variant(report: dict[str, Any]) -> Variant | None:
    """Return the variant that a report names. An invalid variant changes the rubric, so that its hash differs."""
    try:
        found = report['variant']
        return Variant(str(found['student']), str(found['tag']), {str(key): str(text) for key, text in found['values'].items()})
    except (KeyError, TypeError, AttributeError):
        return None


def _known_variant(claimed: Variant, report: dict[str, Any], options: argparse.Namespace) -> Variant | None:
    """Return the variant according to the course's secret or the student's copy of the course, because a report could name any
    variant.

    :raises UnusableInput: when there is neither a secret nor a copy.
    """
    secret = CourseSecret(options.course_secret_file) if options.course_secret_file else None
    found = variant_for(str(report['rubric']['name']), str(report.get('student') or claimed.student), secret)
    if found is None and secret is None:
        words = 'the report is of a personal exercise, and nothing here says whose values are whose'
        raise UnusableInput(words, help='add --course-secret-file FILE')
    return found


def _of_the_seed(report: dict[str, Any], options: argparse.Namespace, submission: Submission) -> Iterator[str]:
    """Check that the seed comes from the submitted text, the course's secret or the caller. Otherwise, the student may have
    chosen it.

    :raises UnusableInput: when a secret determined the seed, and the caller does not have the secret.
    """
    if options.course_secret_file is None:
        if report['receipt'].get('secret') is not None and options.seed is None:
            raise UnusableInput('a course secret has chosen the runs of this report', help='add --course-secret-file FILE')
        if report['receipt'].get('seed') != (submission.seed if options.seed is None else options.seed):
            yield 'seed: it does not follow from the text, so the grader of this report chose it (--seed N accepts it)'
        return
    secret = CourseSecret(options.course_secret_file)
    student = str(report.get('student_id') or report.get('student') or '')
    if report['receipt'].get('seed') != secret.seed(report['rubric']['name'], student, submission.sha256):
        yield 'seed: not the one that this course secret chooses for this student and text'


def _of_the_list(what: str, before: Any, now: list[dict[str, Any]], keys: Sequence[str]) -> Iterator[str]:
    known = {item.get('name'): item for item in before if isinstance(item, dict)} if isinstance(before, list) else {}
    for item in now:
        found = known.pop(item['name'], None)
        if found is None:
            yield f'{what} {item["name"]}: not in the report'
        else:
            for key in keys:
                if found.get(key) != item[key]:
                    yield f'{what} {item["name"]}: {key} {_words(found.get(key))} in the report, {_words(item[key])} now'
    yield from (f'{what} {name}: only in the report' for name in known)


def _words(value: Any) -> str:
    if isinstance(value, dict) and set(value) == {'earned', 'possible'}:
        return f'{value["earned"]} of {value["possible"]}'
    text = str(value)
    return text if len(text) <= 80 else f'{text[:80]}...'


def find_submission(report: dict[str, Any], path: str) -> str:
    """Return the submission with the report's hash, from the report's folder, the current folder, or the folders of a batch.

    :raises UnusableInput: when no submission has this hash.
    """
    file, wanted = str(report.get('submission', {}).get('file')), report['receipt'].get('submission')
    for place in _places(report, file, os.path.abspath(path)):
        try:
            if os.path.isfile(place) and Submission(place).sha256 == wanted:
                return place
        except UnusableInput:
            continue
    raise UnusableInput(
        f'{file}, which the report names, is missing or has changed since it was graded', help='add --submission PATH'
    )


def _places(report: dict[str, Any], file: str, path: str) -> Iterator[str]:
    folder = os.path.dirname(path)
    yield from (os.path.join(folder, file), file)
    with suppress(OSError):  # the report may be beside a package
        yield from (os.path.join(folder, name, file) for name in sorted(os.listdir(folder))[:MOST_BESIDE])
    while os.path.dirname(folder) != folder:
        if os.path.exists(os.path.join(folder, '.lock')):  # the results of a batch
            inside = str(report.get('path'))
            if folder.endswith('.results'):
                yield from (os.path.join(folder[: -len('.results')], inside, *rest) for rest in ((), (file,)))
            count = 0
            for place, _, names in os.walk(os.path.join(folder, '.unpacked')):
                count += len(names)
                if count > MOST_PLACES:
                    return
                yield os.path.join(place, file)
            return
        folder = os.path.dirname(folder)
