"""A machine in QEMU: switched on, asked, looked at and switched off."""

import json
import pathlib
import socket
import struct
import subprocess
import tempfile
import time
from collections.abc import Callable
from typing import Protocol

from picture import Picture, read_ppm
from sound import RATE


class Bootable(Protocol):
    """What a machine starts from."""

    def arguments(self) -> list[str]:
        """For QEMU; what is written is forgotten."""
        ...


class Failure(Exception):
    """What is not as it should be, in one sentence."""


class Line:
    """One end of a pair of sockets, the other end of which is QEMU's."""

    def __init__(self) -> None:
        self.mine, self.theirs = socket.socketpair()
        self.read = b""

    def send(self, data: bytes) -> None:
        self.mine.sendall(data)

    def until(self, end: bytes, patience: float) -> str:
        """Waits for `end`; what came before it, without it."""
        deadline = time.monotonic() + patience
        while end not in self.read:
            left = deadline - time.monotonic()
            if left <= 0:
                raise TimeoutError
            self.mine.settimeout(left)
            data = self.mine.recv(65536)
            if not data:
                raise Failure("the machine has gone away")
            self.read += data
        before, self.read = self.read.split(end, 1)
        return before.decode(errors="replace")


class Viewer:
    """Somebody who looks at the machine's screen from afar, by RFB (RFC 6143), and may give it another size: the machine's
    graphics card then tells its kernel that another screen was plugged in."""

    def __init__(self, address: str) -> None:
        self.socket = socket.socket(socket.AF_UNIX)
        self.socket.settimeout(60)
        self.socket.connect(address)
        self.read(12)
        self.socket.sendall(b"RFB 003.008\n")
        self.read(self.read(1)[0])  # kinds of security, of which the first is none
        self.socket.sendall(b"\1")
        self.read(4)
        self.socket.sendall(b"\1")  # others may look too
        self.read(20)
        self.read(struct.unpack(">I", self.read(4))[0])

    def read(self, count: int) -> bytes:
        data = b""
        while len(data) < count:
            more = self.socket.recv(count - len(data))
            if not more:
                raise Failure("QEMU's screen cannot be looked at from afar")
            data += more
        return data

    def set_size(self, width: int, height: int) -> None:
        extended_desktop_size, set_encodings, request_update, set_desktop_size = -308, 2, 3, 251
        self.socket.sendall(struct.pack(">BxHi", set_encodings, 1, extended_desktop_size))
        self.socket.sendall(struct.pack(">BBHHHH", request_update, 0, 0, 0, 1, 1))
        time.sleep(0.5)
        self.socket.sendall(struct.pack(">BxHHBxIHHHHI", set_desktop_size, width, height, 1, 0, 0, 0, width, height, 0))
        time.sleep(0.5)

    def close(self) -> None:
        self.socket.close()


class Machine:
    """A running machine with a screen of the given size. What it says is kept under `logs`. Nobody waits for anything on
    its screen beyond `deadline`, a time of the monotonic clock. `devices` are further arguments of QEMU."""

    # fmt: off
    def __init__(self, image: Bootable, luggage: pathlib.Path, size: tuple[int, int], logs: pathlib.Path, deadline: float,
                 devices: tuple[str, ...] = ()) -> None:
        # fmt: on
        self.logs, self.deadline = logs, deadline
        self.heard = logs / "heard.wav"
        self.shell, self.monitor = Line(), Line()
        self.folder = tempfile.TemporaryDirectory(prefix="machine-")  # a socket's address has to be short
        self.viewers = f"{self.folder.name}/screen"
        ends = {line: line.theirs.fileno() for line in (self.shell, self.monitor)}
        # fmt: off
        command = [
            "setpriv", "--pdeathsig", "KILL",  # ends with this test, however that ends
            "qemu-system-x86_64", "-accel", "tcg,thread=multi,tb-size=512",  # a KVM that is there and gets nowhere has been seen
            "-smp", "2", "-cpu", "Nehalem", "-m", "1536",
            "-nodefaults", "-display", "none", "-vga", "none", "-nic", "none",
            "-vnc", f"unix:{self.viewers}",
            *image.arguments(),
            "-device", f"virtio-gpu-pci,id=screen,xres={size[0]},yres={size[1]}",
            "-drive", f"file={luggage},if=virtio,format=raw,readonly=on",
            "-device", "virtio-serial-pci", "-chardev", f"socket,id=shell,fd={ends[self.shell]}",
            "-device", "virtserialport,chardev=shell,name=shell",
            "-chardev", f"socket,id=monitor,fd={ends[self.monitor]}", "-mon", "chardev=monitor,mode=control",
            "-serial", f"file:{logs / 'serial.log'}",
            "-audiodev", f"wav,id=loudspeaker,path={self.heard},out.frequency={RATE}", *devices,
        ]
        # fmt: on
        with open(logs / "qemu.log", "wb") as log:
            self.process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=log, stderr=log, pass_fds=list(ends.values()))
        for line in ends:
            line.theirs.close()
        self.monitor.until(b"\n", patience=60)  # its greeting
        self.ask_monitor("qmp_capabilities")

    def __enter__(self) -> "Machine":
        return self

    def __exit__(self, *_: object) -> None:
        self.process.kill()
        self.process.wait()
        self.folder.cleanup()

    def ask_monitor(self, command: str, **arguments: object) -> None:
        self.monitor.send(json.dumps({"execute": command, "arguments": arguments}).encode() + b"\n")
        while True:  # events come in between
            reply = json.loads(self.monitor.until(b"\n", patience=60))
            if "error" in reply:
                raise Failure(f"QEMU: {reply['error']['desc']}")
            if "return" in reply:
                return

    def wait_for_shell(self, patience: float) -> None:
        """After power-on or a reboot."""
        try:
            self.shell.until(b"a shell is there\n", patience)
        except TimeoutError:
            serial = (self.logs / "serial.log").read_text(errors="replace")
            raise Failure(f"the machine did not start within {patience:.0f} s; its last words: {serial[-500:]}") from None

    def run(self, command: str, patience: float = 240) -> tuple[int, str]:
        """Runs a command as root; what it printed, and its exit status."""
        self.shell.send(f"{{ {command}\n}} </dev/null 2>&1; printf '\\1%d\\n' $?\n".encode())
        try:
            said = self.shell.until(b"\1", patience)
            status = int(self.shell.until(b"\n", patience))
        except TimeoutError:
            raise Failure(f"`{command}` was not done after {patience:.0f} s") from None
        return status, said.strip()

    def must(self, command: str, patience: float = 240) -> str:
        status, said = self.run(command, patience)
        if status != 0:
            raise Failure(f"`{command}` ended with {status}: {said}")
        return said

    def plug_in_screen(self, width: int, height: int) -> None:
        """Another screen takes the place of the one that is plugged in."""
        viewer = Viewer(self.viewers)
        viewer.set_size(width, height)
        viewer.close()

    def plug_in_stick(self, file: pathlib.Path) -> None:
        """A USB stick with these bytes; the machine has a controller `usb`."""
        self.ask_monitor("blockdev-add", **{"driver": "raw", "node-name": "stick", "file": {"driver": "file", "filename": str(file)}})
        self.ask_monitor("device_add", driver="usb-storage", id="plugged", bus="usb.0", drive="stick", removable=True)

    def pull_out_stick(self) -> None:
        self.ask_monitor("device_del", id="plugged")

    def plug_in_headphones(self) -> None:
        """With a sound card, by USB; the machine has a controller `usb`. What they play is in the file `heard`."""
        self.ask_monitor("device_add", driver="usb-audio", id="headphones", bus="usb.0", audiodev="loudspeaker")

    def pull_out_headphones(self) -> None:
        self.ask_monitor("device_del", id="headphones")

    def cut_power(self) -> None:
        """And gives it again at once: what had not come to the disk is lost."""
        self.shell.read = b""
        self.ask_monitor("system_reset")

    def picture(self, screen: str = "screen") -> Picture:
        """What is on a screen, named as its graphics card is among `devices`."""
        file = self.logs / "now.ppm"
        self.ask_monitor("screendump", filename=str(file), device=screen, head=0)
        return read_ppm(file)

    def keep_picture(self, name: str, screen: str = "screen") -> None:
        self.ask_monitor("screendump", filename=str(self.logs / f"{name}.png"), format="png", device=screen, head=0)

    def wait_until(self, what: str, is_so: Callable[[], bool], patience: float) -> float:
        """Waits for what is slow here and quick on a device; returns how many seconds it took."""
        begun = time.monotonic()
        while not is_so():
            if time.monotonic() > min(begun + patience, self.deadline):
                raise Failure(f"{what}: not seen for {time.monotonic() - begun:.0f} s")
            time.sleep(0.5)
        return time.monotonic() - begun
