"""A machine with docent in it, as somebody sees it who stands before it and may ask its root shell."""

import shlex
from collections.abc import Callable

from expected import RIBBON_PIXELS, SAME_SCREEN, Expected
from machine import Failure, Machine
from picture import Picture
from report import say

TO_BOOT = TO_DRAW = 400.0  # seconds; a busy machine may need as much
TO_OPEN = 60.0
MANY_COLOURS = 12  # a console has fewer
CHECKOUT = "/root/docent"  # in the machine
GLASS = "/run/glass"


class Kiosk:
    """The machine as somebody sees it who stands before it."""

    def __init__(self, machine: Machine, expect: Expected, rehearse: Callable[..., Expected]) -> None:
        self.machine, self.expect, self.rehearse = machine, expect, rehearse
        self.quarters = 0  # by which the screen hangs turned clockwise, and the glass with it
        self.screen = "screen"

    def picture(self) -> Picture:
        """As somebody sees it who stands before it."""
        return self.machine.picture(self.screen).turned(self.quarters)

    def property(self, unit: str, name: str) -> str:
        return self.machine.must(f"systemctl show -P {name} {unit}")

    def shows_welcome(self) -> bool:
        return self.picture().difference(self.expect.welcome) < SAME_SCREEN

    def shows_choosing(self) -> bool:
        return self.picture().difference(self.expect.choosing) < SAME_SCREEN

    def shows_way(self) -> bool:
        now = self.picture()
        return now.ribbon() >= RIBBON_PIXELS and now.panel().difference(self.expect.way.panel()) < SAME_SCREEN

    def plug_in_glass(self, descriptor: str) -> None:
        self.machine.must(
            f"rm -f {GLASS}; systemd-run --quiet --unit=glass python3 {CHECKOUT}/glass.py {GLASS} {shlex.quote(descriptor) if descriptor else ''}; "
            f"until [ -p {GLASS} ] && [ -e /dev/hidraw0 ]; do systemctl -q is-active glass || exit 1; sleep 0.1; done"
        )

    def has_glass(self) -> bool:
        return "/dev/hidraw0" in self.machine.must("ls -l /proc/$(systemctl show -P MainPID docent)/fd")

    def until_ready(self, when: str) -> float:
        """The poster of the last run is on the screen before: it feels nothing, and is no picture of the program's."""
        return self.machine.wait_until(f"{when}: docent is ready", lambda: self.property("docent", "ActiveState") == "active", TO_DRAW)

    def touch(self, when: str) -> None:
        self.until_ready(when)
        x, y = self.expect.touch
        for _ in range(self.quarters):  # as the glass has it
            x, y = y, 1 - x
        self.machine.must(f"echo {x:.4f} {y:.4f} >{GLASS}")

    def draws(self, when: str) -> None:
        took = self.until_ready(when) + self.machine.wait_until(f"{when}: the welcome screen", self.shows_welcome, TO_DRAW)
        self.machine.keep_picture(f"{when}-welcome", self.screen)
        say(f"{when}: the welcome screen is there ({took:.0f} s)")

    def leads_the_way(self, when: str) -> None:
        """Two touches of the same exhibit: the first begins, the second chooses."""
        self.touch(when)
        self.machine.wait_until(f"{when}: a touch begins, and the choice is shown", self.shows_choosing, TO_DRAW)
        self.machine.keep_picture(f"{when}-choosing", self.screen)
        self.touch(when)
        self.machine.wait_until(f"{when}: a touch of an exhibit, and its way is shown", self.shows_way, TO_DRAW)
        self.machine.keep_picture(f"{when}-way", self.screen)
        say(f"{when}: two touches, and the guide shows the way")

    def console_is_quiet(self, when: str) -> None:
        """KD_GRAPHICS and K_OFF (linux/kd.h): no letters over the picture, no typed keys in a shell behind it."""
        ask = (
            "import array, fcntl, os; tty = os.open('/dev/tty1', os.O_RDONLY | os.O_NOCTTY); state = array.array('i', [0, 0]); "
            "fcntl.ioctl(tty, 0x4B3B, state, True); mode = state[0]; fcntl.ioctl(tty, 0x4B44, state, True); print(mode, state[0])"
        )
        mode = self.machine.must(f'python3 -c "{ask}"')
        if mode != "1 4":
            raise Failure(f"{when}: the console is not quiet: its display and keyboard modes are {mode} instead of 1 4")

    def journal_says(self, words: str, times: int) -> bool:
        pid = self.property("docent", "MainPID")
        return self.machine.must(f"journalctl --no-pager -o cat _PID={pid}").count(words) >= times

    def hears(self, when: str, words: str, times: int = 1) -> None:
        self.machine.wait_until(f"{when}: the journal says '{words}'", lambda: self.journal_says(words, times), TO_DRAW)

    def shows_something_of(self, size: tuple[int, int]) -> bool:
        now = self.picture()
        return (now.width, now.height) == size and now.colours() >= MANY_COLOURS

    def owns_console(self, when: str) -> None:
        self.until_ready(when)
        if (state := self.property("getty@tty1", "ActiveState")) != "inactive":
            raise Failure(f"{when}: getty@tty1 is {state} and not inactive")
        self.console_is_quiet(when)


def unpack(machine: Machine) -> None:
    machine.must(f"mkdir -p {CHECKOUT} && tar -xf /dev/vdb -C {CHECKOUT}")


def install(kiosk: Kiosk, commands: list[str]) -> None:
    for command in commands:
        kiosk.machine.must(f"cd {CHECKOUT} && {command}", TO_DRAW)  # the service is started when it has drawn
    say(f"installed by the {len(commands)} commands of deploy/README.md")


def glass_is_open(kiosk: Kiosk, when: str) -> None:
    said = kiosk.machine.must("runuser -u docent -G input -- docent hid list")
    if "touch screen" not in said or "cannot open" in said:
        raise Failure(f"{when}: `docent hid list`, as the user docent, says: {said}")
    kiosk.machine.wait_until(f"{when}: the service has /dev/hidraw0 open", kiosk.has_glass, TO_OPEN)
    say(f"{when}: the user docent has opened the touch screen")
