"""The two C functions that copy a message's CDR bytes to and from Fast CDR's buffer."""

from __future__ import annotations

import ctypes as c
from collections.abc import Callable
from typing import Any

from edulaunch.extras.native.typesupport import abi

_cdr = c.CDLL('libfastcdr.so.2')
_write = _cdr._ZN8eprosima7fastcdr3Cdr15serialize_arrayEPKcm
_write.restype, _write.argtypes = c.c_void_p, (c.c_void_p, c.c_void_p, c.c_size_t)
_position = _cdr._ZN8eprosima7fastcdr3Cdr20get_current_positionEv
_position.restype, _position.argtypes = c.c_void_p, (c.c_void_p,)
_new_buffer = _cdr._ZN8eprosima7fastcdr10FastBufferC1EPcm
_new_buffer.restype, _new_buffer.argtypes = None, (c.c_void_p, c.c_void_p, c.c_size_t)
_new_cdr = _cdr._ZN8eprosima7fastcdr3CdrC1ERNS0_10FastBufferENS1_10EndiannessENS0_10CdrVersionE
_new_cdr.restype, _new_cdr.argtypes = None, (c.c_void_p, c.c_void_p, c.c_uint8, c.c_int)
_LITTLE_ENDIAN, _XCDR1 = 1, 1
_SIZE = 424242  # a length that no pointer or counter in a new object equals


def _places() -> tuple[int, int, int]:
    """Return where a Cdr stores its buffer, and where a buffer stores the start and the length of its bytes.

    The function finds these offsets in objects that it creates for this purpose.

    :raises ImportError: when this Fast CDR has another layout.
    """
    memory, buffer, cdr = c.create_string_buffer(64), c.create_string_buffer(256), c.create_string_buffer(4096)
    _new_buffer(c.addressof(buffer), c.addressof(memory), _SIZE)
    _new_cdr(c.addressof(cdr), c.addressof(buffer), _LITTLE_ENDIAN, _XCDR1)
    try:
        return (_find(cdr, c.addressof(buffer)), _find(buffer, c.addressof(memory)), _find(buffer, _SIZE))
    except ValueError:
        raise ImportError('this version of Fast CDR stores its buffer in a layout that edulaunch does not know') from None


def _find(block: c.Array[c.c_char], value: int) -> int:
    words = (c.c_size_t * (len(block) // 8)).from_buffer(block)
    return 8 * list(words).index(value)


_BUFFER, _START, _LENGTH = _places()


def fill(block: int, body: bytes) -> None:
    """Set the CDR bytes of a message, without the header."""
    held = abi.Block.from_address(block)
    if held.data:
        abi.libc.free(held.data)
    held.data, held.size = abi.libc.malloc(len(body) or 1), len(body)
    c.memmove(held.data, body, len(body))


def content(block: int) -> bytes:
    """Return the CDR bytes of a message."""
    held = abi.Block.from_address(block)
    return c.string_at(held.data, held.size) if held.size else b''


def _serialize(block: int, cdr: int) -> bool:
    """Write a message at the current position of the stream."""
    held = abi.Block.from_address(block)
    _write(cdr, held.data, held.size)
    return True


def _deserialize(cdr: int, block: int) -> bool:
    """Read from the current position of the stream to its end. The codec finds the end of the message."""
    buffer = c.c_size_t.from_address(cdr + _BUFFER).value
    end = c.c_size_t.from_address(buffer + _START).value + c.c_size_t.from_address(buffer + _LENGTH).value
    position = _position(cdr)
    fill(block, c.string_at(position, end - position))
    return True


def _size(block: int) -> int:
    """Return the number of bytes of a message."""
    return int(abi.Block.from_address(block).size)


def _largest_size(bounds: int) -> int:
    """Set the flags behind `bounds`: no type has a fixed or bounded size."""
    c.c_uint8.from_address(bounds).value = 0
    return 0


def _create() -> int:
    """Create an empty message."""
    made: int = abi.libc.calloc(1, c.sizeof(abi.Block))
    return made


def _destroy(block: int) -> None:
    """Free a message."""
    held = abi.Block.from_address(block)
    if held.data:
        abi.libc.free(held.data)
    abi.libc.free(block)


def _made(function: Callable[..., object], *types: Any) -> int:
    return abi.address_of(abi.keep(c.CFUNCTYPE(*types)(function)))


SERIALIZE = _made(_serialize, c.c_bool, c.c_void_p, c.c_void_p)
DESERIALIZE = _made(_deserialize, c.c_bool, c.c_void_p, c.c_void_p)
SIZE = _made(_size, c.c_uint32, c.c_void_p)
LARGEST_SIZE = _made(_largest_size, c.c_size_t, c.c_void_p)
CREATE = _made(_create, c.c_void_p)
DESTROY = _made(_destroy, None, c.c_void_p)
"""The addresses of the C functions of all messages."""
