from array import array
from struct import calcsize

import pytest

from edulaunch.interfaces.kinds import KINDS, primitive_name

NUMBERS = [kind for kind in KINDS.values() if kind.is_number]


@pytest.mark.parametrize('kind', NUMBERS, ids=lambda kind: kind.name)
def test_the_code_of_a_number_has_its_size_in_struct_and_array(kind):
    assert (calcsize(f'<{kind.code}'), array(kind.code).itemsize) == (kind.size, kind.size)


def test_ranges_are_worded_as_ros_words_them():
    assert KINDS['int32'].range_words == 'integer in [-2147483648, 2147483647]'
    assert KINDS['uint8'].range_words == 'unsigned integer in [0, 255]'
    assert KINDS['float32'].range_words == 'float in [-3.402823466e+38, 3.402823466e+38]'


def test_char_is_uint8():
    assert primitive_name('char') == 'uint8'
