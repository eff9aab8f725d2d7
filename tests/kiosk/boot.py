"""What every test in a booted machine begins and ends with: docent's package is made, a stock Debian is switched on with it,
and where something is not as it should be, pictures and logs are kept."""

import argparse
import functools
import pathlib
import re
import shlex
import shutil
import subprocess
import tarfile
import traceback
from collections.abc import Callable
from dataclasses import dataclass, replace

from expected import SIZE, expected
from kiosk import Kiosk
from machine import Failure, Machine
from report import say, started
from root_image import NotHere, require_tools, root_image

SKIPPED = 77


@dataclass(frozen=True)
class Story:
    """What is played in the machine."""

    manual: str
    proves: str  # a sentence, said when all was as it should be
    play: Callable[[Kiosk, list[str], str], None]  # with the commands of an installation, and a touch screen's descriptor
    altogether: float  # seconds; less than ctest's patience, so that there is time to keep the evidence
    devices: tuple[str, ...] = ()  # further arguments of QEMU
    kernel: str = ""  # and of the kernel
    luggage: Callable[[argparse.Namespace, pathlib.Path], list[pathlib.Path]] = lambda options, database: []  # made for the machine


def package(source: pathlib.Path, docent: pathlib.Path, out: pathlib.Path) -> pathlib.Path:
    """The kiosk's package, of the programs that were built."""
    if not shutil.which("dpkg-buildpackage") or not shutil.which("dh"):
        raise NotHere("packages are missing: debhelper dpkg-dev")
    subprocess.run([source / "deploy/package", "--bin", docent.parent, "--out", out], check=True, stdout=subprocess.DEVNULL)
    return next(out.glob("docent_*.deb"))


def luggage(kiosk: pathlib.Path, database: pathlib.Path, tools: list[pathlib.Path], out: pathlib.Path) -> None:
    """What an integrator carries to the device: the package, a museum's database, and the tools of the test. An archive, which
    the machine sees as a disk."""
    with tarfile.open(out, "w") as archive:
        archive.add(kiosk, kiosk.name)
        archive.add(database, "museum.db")
        for tool in [pathlib.Path(__file__).parent / "glass.py", *tools]:
            archive.add(tool, tool.name)


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


def keep_evidence(machine: Machine) -> None:
    """As much as the machine still says."""
    machine.keep_picture("last")
    for name, command in {
        "journal.log": "journalctl --no-pager -o short-monotonic",
        "units.log": "systemctl status --no-pager docent getty@tty1; ls -l /dev/hidraw* /dev/dri; docent hid list",
    }.items():
        (machine.logs / name).write_text(machine.run(command, patience=60)[1])


def tell(story: Story, options: argparse.Namespace) -> None:
    require_tools()
    image = replace(root_image(options.cache, packages_kiosk(options.source)), further=story.kernel)
    say("a Debian to boot is there")
    shutil.rmtree(options.work, ignore_errors=True)
    options.work.mkdir(parents=True)
    database, disk = options.work / "museum.db", options.work / "luggage.tar"
    shutil.copy(options.museum, database)
    rehearse = functools.partial(expected, options.docent, database)
    expect = rehearse(options.source / "config/kiosk.toml", options.work)
    luggage(package(options.source, options.docent, options.work / "package"), database, [*options.tool, *story.luggage(options, database)], disk)
    commands = install_commands(options.source / "deploy/README.md")
    say(f"an exhibit can be touched at {expect.touch[0]:.2f} {expect.touch[1]:.2f}; the machine is switched on")
    with Machine(image, disk, SIZE, options.work, started + story.altogether, story.devices) as machine:
        try:
            story.play(Kiosk(machine, expect, rehearse), commands, recorded_descriptor(options.reference))
        except BaseException:
            try:
                keep_evidence(machine)
            except Exception as silent:
                print(f"the machine says no more: {silent}")
            raise


def run(story: Story) -> int:
    """The whole of a test's program; its exit status."""
    parser = argparse.ArgumentParser(description=story.manual, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--docent", type=pathlib.Path, required=True)
    parser.add_argument("--docent-content", type=pathlib.Path, required=True)
    parser.add_argument("--museum", type=pathlib.Path, required=True, help="the sample museum, compiled")
    parser.add_argument("--source", type=pathlib.Path, required=True, help="the tree that holds deploy/ and config/")
    parser.add_argument("--cache", type=pathlib.Path, required=True, help="where the Debian is kept that is booted")
    parser.add_argument("--work", type=pathlib.Path, required=True, help="an own folder: pictures and logs; is emptied")
    parser.add_argument("--reference", type=pathlib.Path, default=pathlib.Path("/nonexistent"), help="recordings, where there are some")
    parser.add_argument("--tool", type=pathlib.Path, action="append", default=[], help="a program that the machine is given, too")
    options = parser.parse_args()
    try:
        tell(story, options)
    except NotHere as reason:
        print(f"skipped: {reason}")
        return SKIPPED
    except Failure as failure:
        say(f"FAILED: {failure}")
    except Exception:
        traceback.print_exc()
    else:
        shutil.rmtree(options.work)
        say(story.proves)
        return 0
    print(f"pictures and logs are in {options.work}")
    return 1
