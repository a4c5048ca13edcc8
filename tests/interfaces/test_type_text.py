import pytest
from hypothesis import given
from hypothesis import strategies as st

from edulaunch.errors import InterfaceError
from edulaunch.interfaces.sections import Line
from edulaunch.interfaces.spec import FieldType
from edulaunch.interfaces.type_text import field_type, split_type

SIZES = st.integers(1, 999)


@given(
    st.sampled_from(['int32', 'string', 'p/msg/T']),
    st.none() | SIZES,
    st.sampled_from(['', 'fixed', 'bounded', 'unbounded']),
    SIZES,
)
def test_the_text_of_a_type_reads_back_as_the_type(base, bound, array, size):
    one = FieldType(base, bound, array, size if array in ('fixed', 'bounded') else 0)
    assert split_type(one.text) == one


@pytest.mark.parametrize(
    ('text', 'message'),
    [
        ('int32[', "'int32[' is not a type"),
        ('int32<=3', "only strings have a bound, not 'int32'"),
        ('int32[0]', "'int32[0]' has room for nothing: a size must be at least 1"),
        ('point', "unknown type 'point'"),
        ('a/b/c/D', "unknown type 'a/b/c/D'"),
    ],
)
def test_a_wrong_type_is_named(text, message):
    with pytest.raises(InterfaceError) as caught:
        field_type(Line('f', 7, ''), text, 'p')
    assert caught.value.message == f'f:7: {message}'
