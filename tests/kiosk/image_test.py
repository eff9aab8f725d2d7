#!/usr/bin/env python3
"""Does the disk that deploy/image makes start by UEFI, and does its other half? (.ci/image makes what this boots.)

What is proved, by OVMF and by the disk's own boot loader and kernel:
 - system A starts with its root read-only, shows the guide, and is then told to be good;
 - rauc installs a bundle beside it, and system B starts, on trial until it shows the guide, with the settings, the identity and the
   journal of the device;
 - a B that is broken is left after three tries, and A shows the guide again.

It needs amd64 and the packages of `packages_image` and `packages_booted`. A processor is simulated, so it judges order and not speed.
"""

import argparse
import pathlib
import shutil
import sys
import tarfile
from dataclasses import dataclass

sys.dont_write_bytecode = True

from kiosk import MANY_COLOURS, TO_BOOT, TO_DRAW
from machine import Failure, Machine
from report import say, started

ALTOGETHER = 3600.0
SIZE = (320, 200)
TO_INSTALL = 1200.0
FIRMWARE = pathlib.Path("/usr/share/OVMF")
ENVIRONMENT = "/efi/EFI/BOOT/grubenv"
MARK = "# a line of its own"


@dataclass(frozen=True)
class DiskImage:
    """A whole disk, started as UEFI does."""

    disk: pathlib.Path

    def arguments(self) -> list[str]:
        # fmt: off
        return ["-drive", f"if=pflash,format=raw,readonly=on,file={FIRMWARE}/OVMF_CODE_4M.fd",
                "-drive", f"if=pflash,format=raw,snapshot=on,file={FIRMWARE}/OVMF_VARS_4M.fd",
                "-drive", f"file={self.disk},if=virtio,format=raw,snapshot=on"]
        # fmt: on


def shows_the_guide(machine: Machine, slot: str, when: str) -> None:
    """This system, and no other; and the boot loader has been told."""
    machine.wait_for_shell(TO_BOOT)
    command_line = machine.must("cat /proc/cmdline")
    if f"rauc.slot={slot} " not in command_line:
        raise Failure(f"{when}: system {slot} should have started, and this did: {command_line}")
    if machine.run("touch /usr/a-file")[0] == 0:
        raise Failure(f"{when}: the root can be written to")
    active = "systemctl -q is-active docent"
    machine.wait_until(f"{when}: docent is active", lambda: machine.run(active)[0] == 0, TO_DRAW)
    machine.wait_until(f"{when}: a picture", lambda: machine.picture().colours() >= MANY_COLOURS, TO_DRAW)
    machine.keep_picture(when)
    # A disk is made with GOOD=A, but the start before this one counted: only who shows the guide takes that back.
    good = f"grub-editenv {ENVIRONMENT} list | grep -cx -e GOOD={slot} -e {slot}_TRY=0 | grep -x 2"
    machine.wait_until(f"{when}: the boot loader is told", lambda: machine.run(good)[0] == 0, TO_DRAW)
    say(f"{when}: system {slot} shows the guide, and the boot loader knows")


def play(machine: Machine) -> None:
    shows_the_guide(machine, "A", "first-start")
    identity = machine.must("cat /etc/machine-id")
    machine.must(f"echo '{MARK}' >>/etc/docent/kiosk.toml")

    machine.must("tar -xf /dev/vdb -C /var/tmp")
    machine.must("rauc install /var/tmp/kiosk.raucb", TO_INSTALL)
    say("a bundle is installed beside the system that runs")
    machine.run("systemctl --no-block reboot")
    shows_the_guide(machine, "B", "after-the-update")
    if machine.must("cat /etc/machine-id") != identity:
        raise Failure("the device has another identity after the update")
    machine.must(f"grep -x '{MARK}' /etc/docent/kiosk.toml")
    boots = machine.must("journalctl --no-pager --list-boots").splitlines()
    if len(boots) < 2:
        raise Failure(f"the journal knows one start only: {boots}")

    machine.must("dd if=/dev/zero of=/dev/disk/by-partlabel/docent-root-b bs=1M count=64 conv=fsync")
    machine.cut_power()
    say("system B is overwritten with zeros, and power is cut")
    shows_the_guide(machine, "A", "fallen-back")


def test(options: argparse.Namespace) -> None:
    shutil.rmtree(options.work, ignore_errors=True)
    options.work.mkdir(parents=True)
    luggage = options.work / "luggage.tar"
    with tarfile.open(luggage, "w") as archive:
        archive.add(options.bundle, "kiosk.raucb")
    with Machine(DiskImage(options.disk), luggage, SIZE, options.work, started + ALTOGETHER) as machine:
        try:
            play(machine)
        except BaseException:
            machine.keep_picture("last")
            asked = f"rauc status; grub-editenv {ENVIRONMENT} list; journalctl -b --no-pager -o short-monotonic"
            (options.work / "journal.log").write_text(machine.run(asked, patience=120)[1])
            raise


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--disk", type=pathlib.Path, required=True)
    parser.add_argument("--bundle", type=pathlib.Path, required=True)
    parser.add_argument("--work", type=pathlib.Path, required=True, help="an own folder: pictures and logs; is emptied")
    options = parser.parse_args()
    try:
        test(options)
    except Failure as failure:
        say(f"FAILED: {failure}")
        print(f"pictures and logs are in {options.work}")
        return 1
    say("either half of the disk starts, and a broken one is left")
    return 0


if __name__ == "__main__":
    sys.exit(main())
