"""random, uuid, secrets and numpy.random inside: equal in equal runs."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest


def test_unseeded_randomness_repeats_with_the_seed_and_differs_by_name(make_world: Callable[[int], Any]) -> None:
    text = 'import random\nfrom random import randint\nprint(randint(0, 10**9), random.random(), random.Random().random())'
    first, again, other_seed = (make_world(seed).run(text) for seed in (1, 1, 2))
    assert first == again != other_seed
    assert make_world(1).run(text, 'another-2') != first


def test_the_shared_random_module_is_left_alone(world: Any) -> None:
    import random

    random.seed(5)
    expected = random.Random(5).random()
    world.run('import random\nrandom.seed(1)\nrandom.random()')
    assert random.random() == expected


def test_randomness_of_numpy_repeats_and_the_shared_one_is_left_alone(make_world: Callable[[int], Any]) -> None:
    import numpy

    before = numpy.random.get_state()[2]
    text = """
        import numpy as np
        from numpy.random import rand
        print(rand(2).tolist(), np.random.default_rng().random(), np.random.randint(10**6), np.random.RandomState().rand(), np.linalg.norm([3, 4]))
        """
    first, again, other_seed = (make_world(seed).run(text) for seed in (1, 1, 2))
    assert first == again != other_seed and first.endswith(' 5.0\n')
    assert numpy.random.get_state()[2] == before


def test_a_given_seed_counts(world: Any) -> None:
    import numpy

    expected = numpy.random.RandomState(3).rand()
    assert world.run('import numpy.random\nnumpy.random.seed(3)\nprint(float(numpy.random.rand()))') == f'{expected}\n'


@pytest.mark.parametrize('text', ['import secrets\nprint(secrets.token_hex(8))', 'import os\nprint(os.urandom(8).hex())'])
def test_even_the_machines_own_randomness_repeats(make_world: Callable[[int], Any], text: str) -> None:
    first, again, other_seed = (make_world(seed).run(text) for seed in (1, 1, 2))
    assert first == again != other_seed


def test_identifiers_are_random_and_of_their_version(world: Any) -> None:
    assert world.run('import uuid\nprint(uuid.uuid4().version, uuid.uuid4() == uuid.uuid4())') == '4 False\n'


@pytest.mark.parametrize('made', ['random.Random(5)', 'random.Random("five")'])
def test_a_generator_with_a_seed_gives_the_numbers_that_it_gives_everywhere(world: Any, made: str) -> None:
    import random

    generator = eval(made, {'random': random})
    text = f'import random\none = {made}\nprint(one.random(), one.randint(1, 9))\none.seed(7)\nprint(one.random())'
    expected = f'{generator.random()} {generator.randint(1, 9)}\n{random.Random(7).random()}\n'
    assert world.run(text) == expected


def test_a_generator_that_is_seeded_anew_without_a_seed_repeats_with_the_run(make_world: Callable[[int], Any]) -> None:
    text = 'import random\none = random.Random(5)\none.seed()\nprint(one.random())'
    first, again, other_seed = (make_world(seed).run(text) for seed in (1, 1, 2))
    assert first == again != other_seed
