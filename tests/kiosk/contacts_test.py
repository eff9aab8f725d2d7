#!/usr/bin/env python3
"""Does the kiosk feel what the kernel feels? Every recording of a touch screen that there is becomes a device in a booted Debian,
and its reports go to the kernel's driver and to the kiosk's readers at the same time (kernel_contacts.py, felt_contacts.cpp).

Prints how many agree, and for each of the others how often it does not. It needs what booted_test.py needs, and recordings, and
takes some minutes, so .ci/long has it.
"""

import argparse
import json
import pathlib
import sys

sys.dont_write_bytecode = True

from boot import Story, run
from kiosk import CHECKOUT, TO_BOOT, Kiosk, unpack
from machine import Failure
from report import say
from root_image import NotHere

FEW = 0.01  # of the reports: the kernel filters jitter, and steps of its filter come a report late
TO_PLAY = 1500.0
# Where the notes of the recordings (hid/SOURCES.md) say that this kernel is wrong: it leaves lifted contacts stuck, or its own
# driver for the device is another.
KERNEL_IS_WRONG = {"win7_nexio_1870_0100", "win7_n-trig_1b96_0001"}


def recordings(options: argparse.Namespace, _: pathlib.Path) -> list[pathlib.Path]:
    folder = options.reference / "hid/mt"
    if not folder.is_dir():
        raise NotHere(f"there are no recordings in {folder}")
    return [folder]


def play(kiosk: Kiosk, _: list[str], __: str) -> None:
    kiosk.machine.wait_for_shell(TO_BOOT)
    unpack(kiosk.machine)
    said = kiosk.machine.must(f"cd {CHECKOUT} && python3 kernel_contacts.py ./felt_contacts mt/*.hid", TO_PLAY)
    devices = [json.loads(line) for line in said.splitlines() if line.startswith("{")]
    wrong = [device for device in devices if device["differ"] < 0 or device["differ"] > FEW * device["reports"]]
    for device in devices:
        if device["differ"] != 0:
            say(f"{device['name']} ({device['driver']}): {device['differ']} of {device['reports']} reports differ; {device['first']}")
    say(f"{len(devices) - len(wrong)} of {len(devices)} touch screens are felt as the kernel feels them")
    if not_expected := [device["name"] for device in wrong if device["name"] not in KERNEL_IS_WRONG]:
        raise Failure(f"these are not felt as the kernel feels them: {' '.join(not_expected)}")


if __name__ == "__main__":
    sys.exit(run(Story(__doc__, "the kiosk feels what the kernel feels", play, altogether=2400.0, luggage=recordings)))
