"""Signs reports with ed25519, so that nobody can change one unseen. The keys are PEM files, as OpenSSL writes them."""

from __future__ import annotations

import argparse
import json
from base64 import b64decode, b64encode
from collections.abc import Sequence
from typing import Any

from edulaunch.errors import UnusableInput

from .document import json_text
from .regular_file import read_regular
from .whole_file import write_whole

LARGEST_KEY, LARGEST_REPORT = 10_000, 50_000_000
MAKE = 'openssl genpkey -algorithm ed25519 -out key.pem; openssl pkey -in key.pem -pubout -out public.pem'


def main(words: Sequence[str]) -> int:
    """The command ``edugrade sign``."""
    parser = argparse.ArgumentParser(
        prog='edugrade sign', description='Sign reports in place, with an ed25519 key.', epilog=f'keys: {MAKE}'
    )
    parser.add_argument('reports', metavar='REPORT', nargs='+', help='a JSON report, or a result of a batch')
    parser.add_argument('--key', metavar='FILE', required=True, help='the private key, PEM')
    options = parser.parse_args(words)
    for path in options.reports:
        write_whole(path, json_text(signed(read_report(path), options.key)))
    return 0


def read_report(path: str) -> dict[str, Any]:
    """A JSON report.

    :raises UnusableInput: when it cannot be read, or is none.
    """
    try:
        found = json.loads(read_regular(path, LARGEST_REPORT))
    except OSError as error:
        raise UnusableInput(f'the report {path} cannot be read: {error.strerror or error}') from None
    except (ValueError, RecursionError) as error:
        raise UnusableInput(f'{path} is no JSON report: {error}') from None
    if not isinstance(found, dict) or not isinstance(found.get('receipt'), dict) or not isinstance(found.get('checks'), list):
        raise UnusableInput(f'{path} is no report with a receipt', help='edugrade FILE --json writes one, and edugrade batch')
    return found


def signed(report: dict[str, Any], key: str) -> dict[str, Any]:
    """The report with its signature; an earlier one is replaced."""
    serialization, ed25519 = _library()
    private = _loaded(lambda data: serialization.load_pem_private_key(data, password=None), key)
    if not isinstance(private, ed25519.Ed25519PrivateKey):
        raise UnusableInput(f'the key {key} is no private ed25519 key', help=MAKE)
    bare = {name: value for name, value in report.items() if name != 'signature'}
    value = b64encode(private.sign(_bytes(bare))).decode()
    return {**bare, 'signature': {'algorithm': 'ed25519', 'key': _name(private.public_key(), serialization), 'value': value}}


def is_signed_by(report: dict[str, Any], key: str) -> bool:
    """Whether the report is as the owner of this key (the public half) signed it."""
    serialization, ed25519 = _library()
    public = _loaded(serialization.load_pem_public_key, key)
    if not isinstance(public, ed25519.Ed25519PublicKey):
        raise UnusableInput(f'the key {key} is no public ed25519 key', help=MAKE)
    bare = {name: value for name, value in report.items() if name != 'signature'}
    try:
        public.verify(b64decode(report['signature']['value'], validate=True), _bytes(bare))
    except Exception:  # InvalidSignature, or whatever else a made-up signature runs into
        return False
    return True


def _bytes(report: dict[str, Any]) -> bytes:
    """The bytes that are signed: another order of keys or other spaces make no difference."""
    return json.dumps(report, sort_keys=True, separators=(',', ':')).encode()


def _name(public: Any, serialization: Any) -> str:
    raw: bytes = public.public_bytes(serialization.Encoding.Raw, serialization.PublicFormat.Raw)
    return raw.hex()


def _loaded(load: Any, key: str) -> Any:
    try:
        return load(read_regular(key, LARGEST_KEY))
    except OSError as error:
        raise UnusableInput(f'the key {key} cannot be read: {error.strerror or error}', help=MAKE) from None
    except Exception as error:
        raise UnusableInput(f'the key {key} is no PEM key without a password: {error}', help=MAKE) from None


def _library() -> tuple[Any, Any]:
    try:
        from cryptography.hazmat.primitives import serialization
        from cryptography.hazmat.primitives.asymmetric import ed25519
    except ImportError:
        raise UnusableInput('signatures need the package cryptography', help="pip install 'edulaunch[sign]'") from None
    return serialization, ed25519
