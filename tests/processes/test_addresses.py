"""Addresses are numbered, so that recordings repeat."""

from __future__ import annotations

from typing import Any

from edulaunch.processes.addresses import Addresses


def test_addresses_are_numbered_in_the_order_of_their_appearance() -> None:
    steady = Addresses().steady
    assert steady('<A at 0x7f34123fd410>, <B object at 0x55d0a1b2>') == '<A at 0x7f0000000010>, <B object at 0x7f0000000020>'
    assert steady('again <A at 0x7f34123fd410>') == 'again <A at 0x7f0000000010>'


def test_what_is_numbered_stays_as_it_is() -> None:
    addresses = Addresses()
    once = addresses.steady('<A at 0x7f34123fd410> <B at 0x7f34123fd420>')
    assert addresses.steady(once) == once


def test_other_numbers_are_left_alone() -> None:
    text = 'port 0x7f34123fd410 at 0x10, mask at 0xZZ, at 0x'
    assert Addresses().steady(text) == text


def test_a_printed_object_looks_the_same_in_every_run(world: Any) -> None:
    program = 'class A: pass\nkept = [A() for _ in range(3)]\nprint(kept[2], kept[0].__init__)\nprint(kept[0])'
    assert world.run(program) == (
        '<__main__.A object at 0x7f0000000010> '
        "<method-wrapper '__init__' of A object at 0x7f0000000020>\n<__main__.A object at 0x7f0000000020>\n"
    )


def test_a_logged_object_too(world: Any) -> None:
    world.write('p.py', "import rclpy\nrclpy.init()\nnode = rclpy.create_node('n')\nnode.get_logger().info(str(object()))")
    assert '[n]: <object object at 0x7f0000000010>\n' in world.run((world.folder / 'p.py').read_text())
