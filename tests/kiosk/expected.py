"""What a kiosk shows that works, as the same program says that runs here without a display."""

import json
import pathlib
import subprocess
from dataclasses import dataclass

from machine import Failure
from picture import Picture, read_png

SIZE = (320, 200)  # small: every pixel is drawn by a processor that is itself simulated
SAME_SCREEN = 2.0  # the mean difference of a channel: of one screen 0.01, of two of them 8
RIBBON_PIXELS = 45  # the way on the floor, seen from above, has 101; welcome and choosing have at most 7 of that colour


@dataclass(frozen=True)
class Expected:
    """Where to touch, and what the screen then shows, as the same program says that runs here without a display."""

    touch: tuple[float, float]
    welcome: Picture
    choosing: Picture
    way: Picture


# Beginning where the sample museum has one.
ANYWHERE = [(0.52, 0.48)] + [(0.40 + 0.02 * i, y) for y in (0.48, 0.38, 0.58, 0.68, 0.32) for i in range(28)]


# fmt: off
def expected(docent: pathlib.Path, database: pathlib.Path, config: pathlib.Path, scratch: pathlib.Path,
             places: list[tuple[float, float]] = ANYWHERE, *further: str, size: tuple[int, int] = SIZE) -> Expected:
    # fmt: on
    """Looks for a place on the welcome screen where a touch begins, and a second one chooses an exhibit. `further` are options
    of the program; `size` is the screen's, before it is turned."""
    for at in places:
        visit, stats = scratch / "touch.visit", scratch / "stats.json"
        x, y = at
        visit.write_text(
            f"0.5 shot {scratch}/welcome.png\n1 tap {x:.3f} {y:.3f}\n2.5 shot {scratch}/choosing.png\n"
            f"3 tap {x:.3f} {y:.3f}\n4.5 shot {scratch}/way.png\n4.6 quit\n"
        )
        # fmt: off
        subprocess.run([docent, "--display", "headless", "--size", f"{size[0]}x{size[1]}", "--content", database,
                        "--config", config, "--visit", visit, "--stats", stats, *further], check=True)
        # fmt: on
        if json.loads(stats.read_text())["routes"] == 1:
            break
    else:
        raise Failure("no place was found on the welcome screen where two touches lead to an exhibit: has its layout changed?")
    found = Expected(at, *(read_png(scratch / f"{name}.png") for name in ("welcome", "choosing", "way")))
    if found.way.ribbon() < 2 * RIBBON_PIXELS or found.welcome.difference(found.choosing) < 2 * SAME_SCREEN:
        raise Failure("the screens of the kiosk cannot be told apart any more: look at picture.py's colour of the way")
    return found
