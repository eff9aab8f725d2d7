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
 - killed or restarted, the service draws again, and takes touches again, and by then what the integrator has set holds: nothing moves
   but a guide on its way, which leaves the simulated processors to everything else;
 - headphones that are plugged in are read to, and what is heard of the service is what was to be said, in its order, but for what is
   lost while the device is opened; they are pulled out in mid-sentence, which ends nothing else;
 - touch screens that come and go every few hundredths of a second do it no harm;
 - a signed release comes over the network and another on a USB stick, by the package's own units, and is shown; power that is cut
   in the middle of an installation leaves the old one or the new, and the next look finishes it;
   a kiosk that starts three times after an update goes back by itself;
 - a hang is ended by the watchdog;
 - who wants the console gets it by starting getty, and the guide comes back by starting docent, also where the end of the kiosk
   asks for a login late;
 - nobody ends it by a hang-up.

It needs amd64, root rights, the packages of `packages_booted` (deploy/packages.sh) and, the first time, a Debian mirror;
without them it is skipped and says why. There is no hardware acceleration, so it judges order and not speed: four minutes were
seen on two quiet cores, eighteen beside other work, and a minute and a half more the first time. What it saw is in a folder that it names when it
fails.
"""

import json
import re
import sys

sys.dont_write_bytecode = True

from boot import Story, run
from expected import SIZE
from hearing import Speech, speaks
from kiosk import CHECKOUT, TO_BOOT, TO_DRAW, Kiosk, glass_is_open, install, unpack
from machine import Failure
from releases import Releases
from report import say
from updates import fetched, from_stick, goes_back, hangs, power_cut

STORM_SECONDS = 20
OTHER_SIZE = (400, 300)
SCREEN = "/sys/class/drm/card0-Virtual-1/status"
DATABASE = "/var/lib/docent/museum.db"
MOST_EXPOSED = 1.0  # of 10, as systemd-analyze counts


def is_stock(kiosk: Kiosk) -> None:
    kiosk.machine.wait_until("getty on the first console", lambda: kiosk.property("getty@tty1", "ActiveState") == "active", TO_BOOT)
    say("a stock Debian: getty has the first console")


def answers_for_itself(kiosk: Kiosk) -> None:
    """To systemd, to `docent status`, to the journal, and as to what it may do."""
    kiosk.until_ready("answering")
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


def sets_reduced_motion(kiosk: Kiosk) -> None:
    """As deploy/README.md says: a line of kiosk.toml, which holds from the next start."""
    kiosk.machine.must("sed -i 's/^reduced_motion = false/reduced_motion = true/' /etc/docent/kiosk.toml && grep -q '^reduced_motion = true' /etc/docent/kiosk.toml")


def console_and_back(kiosk: Kiosk) -> None:
    kiosk.machine.must("systemctl restart getty@tty1")
    if kiosk.property("docent", "ActiveState") != "inactive":
        raise Failure("getty was started on the first console, and docent is still there")
    kiosk.machine.keep_picture("console")
    say("getty was started: the console is there, and docent has ended")
    late = "systemctl start --no-block --job-mode=fail docent-console"  # as docent-lock asks, when the kiosk has been asked back meanwhile
    kiosk.machine.must(f"systemctl --no-block start docent; ! {late}")


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
    """Devices that come and go all the time cost the kiosk no more than a look at each; so does a screen whose plug is loose."""
    before = kiosk.property("docent", "MainPID")
    loose_plug = f"timeout {STORM_SECONDS} sh -c 'while :; do echo change >/sys/class/drm/card0/uevent; sleep 0.02; done'"
    kiosk.machine.must(f"{loose_plug} & python3 {CHECKOUT}/glass.py storm {STORM_SECONDS}")
    kiosk.machine.must(f"{loose_plug} || true")
    if kiosk.property("docent", "MainPID") != before:
        raise Failure(f"after {2 * STORM_SECONDS} s of touch screens and a screen that came and went, the service was another: see journal.log")
    say(f"{2 * STORM_SECONDS} s of touch screens and a screen that come and go: the service is still the same")


def reboot(kiosk: Kiosk) -> None:
    kiosk.machine.run("systemctl --no-block reboot")
    kiosk.machine.wait_for_shell(TO_BOOT)
    say("rebooted")


def no_hang_up(kiosk: Kiosk) -> None:
    journal = kiosk.machine.must("journalctl -b --no-pager -u docent")
    ends = [line for line in journal.splitlines() if "status=1/HUP" in line or "status=208" in line]
    if ends:
        raise Failure(f"the service was ended by its terminal: {ends[0]}")


def play(kiosk: Kiosk, commands: list[str], descriptor: str, releases: Releases, speech: Speech) -> None:
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

    sets_reduced_motion(kiosk)
    killed(kiosk)
    kiosk.draws("killed")
    kiosk.owns_console("killed")
    speaks(kiosk, speech)

    kiosk.machine.must("systemctl restart docent", TO_DRAW)
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

    for step in (fetched, from_stick, power_cut, goes_back, hangs):
        step(kiosk, releases)


def story(releases: Releases, speech: Speech) -> Story:
    return Story(
        __doc__,
        "a kiosk works as installed",
        lambda *of_the_machine: play(*of_the_machine, releases, speech),
        altogether=2900.0,
        devices=("-device", "qemu-xhci,id=usb"),
        luggage=lambda *of_the_museum: releases.make(*of_the_museum) + speech.rehearse(*of_the_museum),
    )


if __name__ == "__main__":
    sys.exit(run(story(Releases(), Speech())))
