#!/usr/bin/env python3
"""Does a kiosk work as installed? A stock Debian is booted, the package docent is made and the commands of deploy/README.md,
"On a device", install it there, and from then on everything is judged by pictures of its screen, taken from outside.

What is proved, with the unit and the udev rule of the package:
 - a screen that was plugged in before the installation is opened by the user docent, and its touch is shown; so is one
   that is plugged in later, the first HID device of the machine;
 - the service takes the first console over from getty, keeps it quiet, and getty is not there after a reboot either;
 - systemd is told when it is ready, `docent status` says how it is, the journal's lines have their identifiers, and the sandbox
   is as tight as promised;
 - a screen that is pulled out and put back, or replaced by one of another size, ends nothing, and the guide is there again;
 - another terminal of the console can be looked at meanwhile;
 - killed or restarted, the service draws again, and takes touches again;
 - touch screens that come and go every few hundredths of a second do it no harm;
 - who wants the console gets it by starting getty, and the guide comes back by starting docent;
 - nobody ends it by a hang-up.

It needs amd64, root rights, the packages of `packages_booted` (deploy/packages.sh) and, the first time, a Debian mirror;
without them it is skipped and says why. There is no hardware acceleration, so it judges order and not speed: four minutes were
seen on two quiet cores, eighteen beside other work, and a minute and a half more the first time. What it saw is in a folder that it names when it
fails.
"""

import argparse
import json
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tarfile
import time
import traceback
from dataclasses import dataclass

sys.dont_write_bytecode = True

from machine import Failure, Machine
from picture import Picture, read_png
from root_image import NotHere, require_tools, root_image

SKIPPED = 77
SIZE = (320, 200)  # small: every pixel is drawn by a processor that is itself simulated
TO_BOOT = TO_DRAW = 400.0  # seconds; a busy machine may need as much
TO_OPEN = 60.0
STORM_SECONDS = 20
ALTOGETHER = 1400.0  # less than ctest's patience, so that there is time to keep the evidence
SAME_SCREEN = 2.0  # the mean difference of a channel: of one screen 0.01, of two of them 8
RIBBON_PIXELS = 150  # the way on the floor has at least 399; welcome and choosing have at most 7 of that colour
OTHER_SIZE = (400, 300)
MANY_COLOURS = 12  # a console has fewer
SCREEN = "/sys/class/drm/card0-Virtual-1/status"
CHECKOUT = "/root/docent"  # in the machine
DATABASE = "/var/lib/docent/museum.db"
GLASS = "/run/glass"
MOST_EXPOSED = 1.0  # of 10, as systemd-analyze counts

started = time.monotonic()


def say(sentence: str) -> None:
    print(f"{time.monotonic() - started:6.1f} s  {sentence}", flush=True)


# ------------------------------------------------------------------ on this machine


@dataclass(frozen=True)
class Expected:
    """Where to touch, and what the screen then shows, as the same program says that runs here without a display."""

    touch: tuple[float, float]
    welcome: Picture
    choosing: Picture
    way: Picture


def expected(docent: pathlib.Path, database: pathlib.Path, config: pathlib.Path, scratch: pathlib.Path) -> Expected:
    """Looks for a place on the welcome screen where a touch begins, and a second one chooses an exhibit."""
    rows, columns = (0.48, 0.38, 0.58, 0.68, 0.32), [0.40 + 0.02 * i for i in range(28)]
    for at in ((x, y) for y in rows for x in columns):
        visit, stats = scratch / "touch.visit", scratch / "stats.json"
        x, y = at
        visit.write_text(
            f"0.5 shot {scratch}/welcome.png\n1 tap {x:.3f} {y:.3f}\n2.5 shot {scratch}/choosing.png\n"
            f"3 tap {x:.3f} {y:.3f}\n4.5 shot {scratch}/way.png\n4.6 quit\n"
        )
        # fmt: off
        subprocess.run([docent, "--display", "headless", "--size", f"{SIZE[0]}x{SIZE[1]}", "--content", database,
                        "--config", config, "--visit", visit, "--stats", stats], check=True)
        # fmt: on
        if json.loads(stats.read_text())["routes"] == 1:
            break
    else:
        raise Failure("no place was found on the welcome screen where two touches lead to an exhibit: has its layout changed?")
    found = Expected(at, *(read_png(scratch / f"{name}.png") for name in ("welcome", "choosing", "way")))
    if found.way.ribbon() < 2 * RIBBON_PIXELS or found.welcome.difference(found.choosing) < 2 * SAME_SCREEN:
        raise Failure("the screens of the kiosk cannot be told apart any more: look at picture.py's colour of the way")
    return found


def package(source: pathlib.Path, docent: pathlib.Path, out: pathlib.Path) -> pathlib.Path:
    """The kiosk's package, of the programs that were built."""
    if not shutil.which("dpkg-buildpackage") or not shutil.which("dh"):
        raise NotHere("packages are missing: debhelper dpkg-dev")
    subprocess.run([source / "deploy/package", "--bin", docent.parent, "--out", out], check=True, stdout=subprocess.DEVNULL)
    return next(out.glob("docent_*.deb"))


def luggage(kiosk: pathlib.Path, database: pathlib.Path, out: pathlib.Path) -> None:
    """What an integrator carries to the device: the package and a museum's database. An archive, which the machine sees as a
    disk."""
    with tarfile.open(out, "w") as archive:
        archive.add(kiosk, kiosk.name)
        archive.add(database, "museum.db")
        archive.add(pathlib.Path(__file__).parent / "glass.py", "glass.py")


def install_commands(readme: pathlib.Path) -> list[str]:
    """The commands of "On a device"."""
    section = re.search(r"^## On a device\n(.*?)^## ", readme.read_text(), re.MULTILINE | re.DOTALL)
    commands = re.findall(r"^    (.*)$", section[1], re.MULTILINE) if section else []
    if not any("systemctl start docent" in command for command in commands):
        raise Failure(f'{readme}: "On a device" has no command that starts the service')
    return commands


def recorded_descriptor(reference: pathlib.Path) -> str:
    """The report descriptor of a touch screen that somebody had; the test's own where there are no recordings."""
    recording = reference / "hid/mt/win7_elo-touchsystems_04e7_0022.hid"
    if not recording.exists():
        return ""
    return re.search(r"^R: \d+ (.*)$", recording.read_text(), re.MULTILINE)[1]


def packages_kiosk(source: pathlib.Path) -> list[str]:
    script = f'. {shlex.quote(str(source / "deploy/packages.sh"))}; printf "%s\\n" "${{packages_kiosk[@]}}"'
    return subprocess.run(["bash", "-c", script], capture_output=True, text=True, check=True).stdout.split()


# ------------------------------------------------------------------ in the booted one


class Kiosk:
    """The machine as somebody sees it who stands before it."""

    def __init__(self, machine: Machine, expect: Expected) -> None:
        self.machine, self.expect = machine, expect

    def property(self, unit: str, name: str) -> str:
        return self.machine.must(f"systemctl show -P {name} {unit}")

    def shows_welcome(self) -> bool:
        return self.machine.picture().difference(self.expect.welcome) < SAME_SCREEN

    def shows_choosing(self) -> bool:
        return self.machine.picture().difference(self.expect.choosing) < SAME_SCREEN

    def shows_way(self) -> bool:
        now = self.machine.picture()
        return now.ribbon() >= RIBBON_PIXELS and now.panel().difference(self.expect.way.panel()) < SAME_SCREEN

    def plug_in_glass(self, descriptor: str) -> None:
        self.machine.must(
            f"rm -f {GLASS}; systemd-run --quiet --unit=glass python3 {CHECKOUT}/glass.py {GLASS} {shlex.quote(descriptor)}; "
            f"until [ -p {GLASS} ] && [ -e /dev/hidraw0 ]; do systemctl -q is-active glass || exit 1; sleep 0.1; done"
        )

    def has_glass(self) -> bool:
        return "/dev/hidraw0" in self.machine.must("ls -l /proc/$(systemctl show -P MainPID docent)/fd")

    def touch(self) -> None:
        x, y = self.expect.touch
        self.machine.must(f"echo {x:.4f} {y:.4f} >{GLASS}")

    def draws(self, when: str) -> None:
        took = self.machine.wait_until(f"{when}: the welcome screen", self.shows_welcome, TO_DRAW)
        self.machine.keep_picture(f"{when}-welcome")
        say(f"{when}: the welcome screen is there ({took:.0f} s)")

    def leads_the_way(self, when: str) -> None:
        """Two touches of the same exhibit: the first begins, the second chooses."""
        self.touch()
        self.machine.wait_until(f"{when}: a touch begins, and the choice is shown", self.shows_choosing, TO_DRAW)
        self.machine.keep_picture(f"{when}-choosing")
        self.touch()
        self.machine.wait_until(f"{when}: a touch of an exhibit, and its way is shown", self.shows_way, TO_DRAW)
        self.machine.keep_picture(f"{when}-way")
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
        now = self.machine.picture()
        return (now.width, now.height) == size and now.colours() >= MANY_COLOURS

    def owns_console(self, when: str) -> None:
        for unit, wanted in (("docent", "active"), ("getty@tty1", "inactive")):
            state = self.property(unit, "ActiveState")
            if state != wanted:
                raise Failure(f"{when}: {unit} is {state} and not {wanted}")
        self.console_is_quiet(when)


def unpack(machine: Machine) -> None:
    machine.must(f"mkdir -p {CHECKOUT} && tar -xf /dev/vdb -C {CHECKOUT}")


def is_stock(kiosk: Kiosk) -> None:
    kiosk.machine.wait_until("getty on the first console", lambda: kiosk.property("getty@tty1", "ActiveState") == "active", TO_BOOT)
    say("a stock Debian: getty has the first console")


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


def answers_for_itself(kiosk: Kiosk) -> None:
    """To systemd, to `docent status`, to the journal, and as to what it may do."""
    kiosk.machine.wait_until("systemd is told that it is ready", lambda: kiosk.property("docent", "ActiveState") == "active", TO_DRAW)
    text = kiosk.property("docent", "StatusText")
    if "Museum of the Three Rivers" not in text:
        raise Failure(f"systemd is told '{text}', and not which museum is shown")
    status = json.loads(kiosk.machine.must("docent status --json"))
    if status["frames"] < 1 or not any(device["used"] for device in status["devices"]) or status["content"]["path"] != DATABASE:
        raise Failure(f"`docent status --json` says: {status}")
    for message, what in (("1f67ddceca984559b931dec9c982f135", "shows"), ("33f43e9612a847aa837781dffcd3dca1", "is read as")):
        lines = kiosk.machine.must(f"journalctl --no-pager -x -u docent MESSAGE_ID={message}")
        if what not in lines or "Subject:" not in lines:
            raise Failure(f"the journal does not know message {message}, or not its explanation: {lines}")
    judged = kiosk.machine.must("systemd-analyze security --no-pager docent.service")
    exposure = re.search(r"Overall exposure level for \S+: ([0-9.]+)", judged)
    if not exposure or float(exposure[1]) > MOST_EXPOSED:
        raise Failure(f"the sandbox has more holes than {MOST_EXPOSED}: {judged}")
    say(f"it answers for itself: {status['frames']} frames, exposure {exposure[1]}, {text}")


def killed(kiosk: Kiosk) -> None:
    before = kiosk.property("docent", "MainPID")
    kiosk.machine.must(f"kill -KILL {before}")
    kiosk.machine.wait_until("systemd starts it again", lambda: kiosk.property("docent", "MainPID") not in ("0", before), TO_DRAW)
    say("killed: systemd has started it again")


def console_and_back(kiosk: Kiosk) -> None:
    kiosk.machine.must("systemctl restart getty@tty1")
    if kiosk.property("docent", "ActiveState") != "inactive":
        raise Failure("getty was started on the first console, and docent is still there")
    kiosk.machine.keep_picture("console")
    say("getty was started: the console is there, and docent has ended")
    kiosk.machine.must("systemctl --no-block start docent")


def screen_comes_and_goes(kiosk: Kiosk) -> None:
    """The kernel is told that the screen has gone, and that it is back: what it says to programs is what a cable says."""
    before = kiosk.property("docent", "MainPID")
    tell = "echo change >/sys/class/drm/card0/uevent"
    kiosk.machine.must(f"echo off >{SCREEN}; {tell}")
    kiosk.hears("pulled out", "no screen is connected")
    kiosk.machine.must(f"echo detect >{SCREEN}; {tell}")
    kiosk.hears("put back", "draws on", 2)
    kiosk.draws("put-back")
    kiosk.machine.plug_in_screen(*OTHER_SIZE)
    kiosk.machine.wait_until("a screen of another size shows the guide", lambda: kiosk.shows_something_of(OTHER_SIZE), TO_DRAW)
    kiosk.machine.keep_picture("another-screen")
    kiosk.machine.plug_in_screen(*SIZE)
    kiosk.draws("first-screen-again")
    if kiosk.property("docent", "MainPID") != before:
        raise Failure("screens came and went, and the service was another afterwards: see journal.log")
    say("a screen was pulled out, put back and replaced: the service is still the same")


def other_terminal(kiosk: Kiosk) -> None:
    switch = "python3 -c \"import fcntl, os; fcntl.ioctl(os.open('/dev/tty0', os.O_RDWR | os.O_NOCTTY), 0x5606, {})\""  # VT_ACTIVATE
    kiosk.machine.must(switch.format(2))
    kiosk.hears("another terminal", "shows another terminal")
    kiosk.machine.wait_until("the other terminal", lambda: not kiosk.shows_welcome(), TO_DRAW)
    kiosk.machine.must(switch.format(1))
    kiosk.hears("back from it", "is the guide's again")
    kiosk.draws("after-another-terminal")


def storm(kiosk: Kiosk) -> None:
    """Devices that come and go all the time cost the kiosk no more than a look at each."""
    before = kiosk.property("docent", "MainPID")
    kiosk.machine.must(f"python3 {CHECKOUT}/glass.py storm {STORM_SECONDS}")
    if kiosk.property("docent", "MainPID") != before:
        raise Failure(f"after {STORM_SECONDS} s of touch screens that came and went, the service was another: see journal.log")
    say(f"{STORM_SECONDS} s of touch screens that come and go: the service is still the same")


def reboot(kiosk: Kiosk) -> None:
    kiosk.machine.run("systemctl --no-block reboot")
    kiosk.machine.wait_for_shell(TO_BOOT)
    say("rebooted")


def no_hang_up(kiosk: Kiosk) -> None:
    journal = kiosk.machine.must("journalctl -b --no-pager -u docent")
    ends = [line for line in journal.splitlines() if "status=1/HUP" in line or "status=208" in line]
    if ends:
        raise Failure(f"the service was ended by its terminal: {ends[0]}")


def play(kiosk: Kiosk, commands: list[str], descriptor: str) -> None:
    kiosk.machine.wait_for_shell(TO_BOOT)
    is_stock(kiosk)
    unpack(kiosk.machine)
    kiosk.plug_in_glass(descriptor)
    install(kiosk, commands)
    kiosk.draws("installed")
    kiosk.owns_console("installed")
    glass_is_open(kiosk, "installed")
    answers_for_itself(kiosk)
    kiosk.leads_the_way("installed")

    killed(kiosk)
    kiosk.draws("killed")
    kiosk.owns_console("killed")
    kiosk.leads_the_way("killed")

    kiosk.machine.must("systemctl --no-block restart docent")
    kiosk.draws("restarted")
    kiosk.owns_console("restarted")
    screen_comes_and_goes(kiosk)
    other_terminal(kiosk)
    kiosk.owns_console("after-another-terminal")
    storm(kiosk)
    kiosk.leads_the_way("after-the-storm")

    console_and_back(kiosk)
    kiosk.draws("back-again")
    kiosk.owns_console("back-again")
    no_hang_up(kiosk)

    reboot(kiosk)
    kiosk.draws("rebooted")
    kiosk.owns_console("rebooted")
    kiosk.plug_in_glass(descriptor)
    glass_is_open(kiosk, "plugged-in-later")
    kiosk.leads_the_way("rebooted")
    no_hang_up(kiosk)


def keep_evidence(machine: Machine) -> None:
    """As much as the machine still says."""
    machine.keep_picture("last")
    for name, command in {
        "journal.log": "journalctl --no-pager -o short-monotonic",
        "units.log": "systemctl status --no-pager docent getty@tty1; ls -l /dev/hidraw* /dev/dri; docent hid list",
    }.items():
        (machine.logs / name).write_text(machine.run(command, patience=60)[1])


def test(options: argparse.Namespace) -> None:
    require_tools()
    image = root_image(options.cache, packages_kiosk(options.source))
    say("a Debian to boot is there")
    shutil.rmtree(options.work, ignore_errors=True)
    options.work.mkdir(parents=True)
    database, disk = options.work / "museum.db", options.work / "luggage.tar"
    subprocess.run([options.docent_content, "compile", options.source / "config/museum", "-o", database, "--quiet"], check=True)
    expect = expected(options.docent, database, options.source / "config/kiosk.toml", options.work)
    luggage(package(options.source, options.docent, options.work / "package"), database, disk)
    commands = install_commands(options.source / "deploy/README.md")
    say(f"an exhibit can be touched at {expect.touch[0]:.2f} {expect.touch[1]:.2f}; the machine is switched on")
    with Machine(image, disk, SIZE, options.work, deadline=started + ALTOGETHER) as machine:
        try:
            play(Kiosk(machine, expect), commands, recorded_descriptor(options.reference))
        except BaseException:
            try:
                keep_evidence(machine)
            except Exception as silent:
                print(f"the machine says no more: {silent}")
            raise


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--docent", type=pathlib.Path, required=True)
    parser.add_argument("--docent-content", type=pathlib.Path, required=True)
    parser.add_argument("--source", type=pathlib.Path, required=True, help="the tree that holds deploy/ and config/")
    parser.add_argument("--cache", type=pathlib.Path, required=True, help="where the Debian is kept that is booted")
    parser.add_argument("--work", type=pathlib.Path, required=True, help="an own folder: pictures and logs; is emptied")
    parser.add_argument("--reference", type=pathlib.Path, default=pathlib.Path("/nonexistent"), help="recordings, where there are some")
    options = parser.parse_args()
    try:
        test(options)
    except NotHere as reason:
        print(f"skipped: {reason}")
        return SKIPPED
    except Failure as failure:
        say(f"FAILED: {failure}")
    except Exception:
        traceback.print_exc()
    else:
        shutil.rmtree(options.work)
        say("a kiosk works as installed")
        return 0
    print(f"pictures and logs are in {options.work}")
    return 1


if __name__ == "__main__":
    sys.exit(main())
