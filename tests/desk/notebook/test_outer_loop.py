"""The kernel of a notebook runs an asyncio loop; simulated programs have their own."""

from __future__ import annotations

import asyncio
from typing import Any


def test_the_outer_loop_still_runs_after_a_launch_that_goes_on_living(desk: Any) -> None:
    async def cells() -> list[str]:
        said = []
        desk.ros2('launch sim.launch.py --for 1')
        await asyncio.create_task(asyncio.sleep(0))
        desk.ros2('node list')
        said.append(desk.output)
        await asyncio.create_task(asyncio.sleep(0))
        desk.ros2('launch sim.launch.py --for 1')
        await asyncio.create_task(asyncio.sleep(0))
        desk.ros2('topic echo /turtle1/pose --once --field x')
        return [*said, desk.output]

    assert asyncio.run(cells()) == ['/sim\n', '5.544444561004639\n---\n']
