"""Layers and the order within them."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from edulaunch.canvas.layout import crossings, make_layers

graphs = st.integers(2, 9).flatmap(
    lambda count: st.tuples(
        st.just(count),
        st.lists(
            st.tuples(st.integers(0, count - 1), st.integers(0, count - 1)).filter(lambda edge: edge[0] != edge[1]), max_size=14
        ),
    )
)


def test_a_chain_takes_one_layer_each() -> None:
    assert make_layers(3, [(0, 1), (1, 2)]).layers == [[0], [1], [2]]


def test_the_arrow_that_closes_a_loop_is_turned() -> None:
    layers = make_layers(3, [(0, 1), (1, 2), (2, 0)])
    assert layers.turned == [False, False, True]
    assert layers.chains[2] == [0, 3, 2]


def test_what_nothing_leads_to_stands_next_to_what_it_leads_to() -> None:
    assert make_layers(4, [(0, 1), (1, 2), (3, 2)]).layers == [[0], [1, 3], [2]]


def test_crossing_arrows_are_untangled() -> None:
    layers = make_layers(4, [(0, 3), (1, 2)]).layers
    assert crossings(layers, [(0, 3), (1, 2)]) == 0


@given(graphs)
def test_every_chain_goes_one_layer_at_a_time(graph: tuple[int, list[tuple[int, int]]]) -> None:
    found = make_layers(*graph)
    layer_of = {item: number for number, layer in enumerate(found.layers) for item in layer}
    for chain in found.chains:
        assert [layer_of[item] - layer_of[chain[0]] for item in chain] == list(range(len(chain)))
    assert sorted(item for layer in found.layers for item in layer) == list(range(len(layer_of)))
