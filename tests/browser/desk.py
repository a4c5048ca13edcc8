"""What somebody does at the live desk, wherever it stands."""

from __future__ import annotations

import re
from typing import Any

from tests.browser.lab import WAIT_MS


class Desk:
    """The desk in a page. Shadow roots are open: selectors reach into them.

    :ivar errors: what the page's console complained of, and addresses of other machines that it asked.
    :ivar processes: what stands behind the page, where a test started it: 'launch' and 'view'; its address.
    """

    def __init__(self, page: Any, own: tuple[str, ...] = ()) -> None:
        self.page = page
        self.errors: list[str] = []
        self.processes: dict[str, Any] = {}
        self.address = ''
        self.env: dict[str, str] = {}
        page.set_default_timeout(WAIT_MS)
        page.on('console', lambda message: self.errors.append(message.text) if message.type == 'error' else None)
        page.on('pageerror', lambda error: self.errors.append(str(error)))
        if own:
            page.on('request', lambda request: None if request.url.startswith(own) else self.errors.append(request.url))

    def label(self) -> str:
        """What the first picture says of itself."""
        return str(self.page.locator('.worlds canvas').first.get_attribute('aria-label'))

    def pose(self, name: str) -> tuple[float, float]:
        """Where a turtle is shown."""
        found = re.search(rf'{name} at \((-?[\d.]+), (-?[\d.]+)\)', self.label())
        assert found, self.label()
        return float(found[1]), float(found[2])

    def pixel(self, x: float, y: float) -> tuple[int, int, int]:
        """The colour of the first picture at a place, in metres of a turtlesim window."""
        red, green, blue, _ = self.page.locator('.worlds canvas').first.evaluate(
            '(canvas, [x, y]) => [...canvas.getContext("2d").getImageData(x / 11.088889 * canvas.width, '
            '(1 - y / 11.088889) * canvas.height, 1, 1).data]',
            [x, y],
        )
        return red, green, blue

    def time(self) -> float:
        """What the clock shows."""
        return float(self.page.locator('.clock').inner_text().split()[0])

    def open(self, tab: str) -> None:
        self.page.locator(f'[data-tab={tab}]').click()

    def seek(self, part: float) -> None:
        """Move the slider to a part of the run."""
        slider = self.page.get_by_label('time in the run')
        slider.evaluate(f'slider => {{ slider.value = {round(part * 1e6)}; slider.dispatchEvent(new Event("input")); }}')
        self.frame()

    def seek_first(self, name: str) -> None:
        """Go to the first instant at which somebody is there. That is not the first of the run: the machine may be older than the launch."""
        self.seek(0.0)
        while name not in self.label():
            before = self.time()
            self.press('one step forward')
            self.frame()
            assert self.time() > before, f'{name} is never there: {self.label()}'

    def frame(self) -> None:
        """Wait until what was asked for is drawn."""
        self.page.evaluate('() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))')

    def until(self, what: str, expected: str) -> None:
        """Wait until an element's text holds something."""
        try:
            self.page.locator(what).filter(has_text=expected).first.wait_for()
        except Exception:
            raise AssertionError(f'{expected!r} never came; there is {self.page.locator(what).all_inner_texts()}') from None

    def until_js(self, condition: str) -> None:
        """Wait for a condition of the desk (`desk`)."""
        self.page.wait_for_function(
            '() => { const host = [...document.querySelectorAll("*")].find(e => e.shadowRoot?.querySelector(".desk"));'
            f' const root = host?.shadowRoot; return root && ({condition}); }}'
        )

    def press(self, title: str) -> None:
        """Press a button by the beginning of its title."""
        self.page.locator(f'button[title^="{title}"]').click()
