#!/usr/bin/env python3
"""Plays recorded touch screens to a kernel, and compares what it makes of them with what the kiosk's readers feel at the same
time. Runs inside the machine, as root. Needs python3-minimal only.

    kernel_contacts.py FELT_CONTACTS RECORDING.hid...

Each recording (hid-recorder's text form) becomes a device of /dev/uhid with its descriptor and numbers; its reports are sent one
by one. The kernel's contacts come from the event device of its driver, ours from the program FELT_CONTACTS, which reads hidraw
as the kiosk does. Prints a JSON object a recording: `name`, `driver`, how many `reports` changed the kernel's contacts, in how
many of those ours `differ` by number or by more than 0.6 % of an axis (as the kernel, or one report before or after it), and the
`first` such.
"""

import fcntl
import glob
import json
import os
import re
import select
import struct
import subprocess
import sys
import time

from glass import CREATE2, EVENT_BYTES, GET_REPORT, GET_REPORT_REPLY, INPUT2, SET_REPORT, SET_REPORT_REPLY

BETWEEN_REPORTS = 0.02  # seconds; a reader of ours is heard within a few milliseconds
TO_APPEAR = 30.0
MOST_CONTACTS = 10  # what a device that is asked answers; recordings do not hold it
CLOSE = 0.006
EV_SYN, EV_KEY, EV_ABS = 0, 1, 3
BTN_TOUCH = 0x14A
ABS_X, ABS_Y, MT_SLOT, MT_X, MT_Y, MT_TRACKING = 0, 1, 47, 53, 54, 57
INPUT_EVENT = struct.Struct("llHHi")


class Recording:
    def __init__(self, path: str) -> None:
        self.name, self.number = os.path.basename(path)[: -len(".hid")], (3, 0, 0)
        self.descriptor, self.reports = b"", []
        for line in open(path, encoding="utf-8", errors="replace"):
            words = line.split()
            if line.startswith("R:"):
                self.descriptor = bytes(int(word, 16) for word in words[2:])
            elif line.startswith("I:"):
                self.number = tuple(int(word, 16) for word in words[1:4])
            elif line.startswith("E:"):
                self.reports.append(bytes(int(word, 16) for word in words[3:]))


class Device:
    """There as long as it is open."""

    def __init__(self, recording: Recording) -> None:
        before = set(os.listdir("/sys/bus/hid/devices"))
        self.uhid = os.open("/dev/uhid", os.O_RDWR)
        bus, vendor, product = recording.number
        size = len(recording.descriptor)
        create = struct.pack("<I128s64s64sHHIIII", CREATE2, recording.name.encode()[:127], b"uhid/0", b"", size, bus, vendor, product, 0, 0)
        os.write(self.uhid, create + recording.descriptor)
        self.folder = self.wait_for(lambda: next((f"/sys/bus/hid/devices/{new}" for new in set(os.listdir("/sys/bus/hid/devices")) - before), None))
        self.hidraw = "/dev/" + os.path.basename(self.wait_for(lambda: next(iter(glob.glob(f"{self.folder}/hidraw/hidraw*")), None)))

    def wait_for(self, find):
        end = time.monotonic() + TO_APPEAR
        while time.monotonic() < end:
            self.answer(0.01)
            found = find()
            if found:
                return found
        raise TimeoutError

    def answer(self, seconds: float) -> None:
        """What the kernel asks."""
        end = time.monotonic() + seconds
        while True:
            left = max(0.0, end - time.monotonic())
            if not select.select([self.uhid], [], [], left)[0]:
                return
            kind, request, report_id = struct.unpack_from("<IIB", os.read(self.uhid, EVENT_BYTES))
            if kind == GET_REPORT:
                data = bytes([report_id]) + bytes([MOST_CONTACTS]) * 63
                os.write(self.uhid, struct.pack("<IIHH", GET_REPORT_REPLY, request, 0, len(data)) + data)
            elif kind == SET_REPORT:
                os.write(self.uhid, struct.pack("<IIH", SET_REPORT_REPLY, request, 0))

    def send(self, report: bytes) -> None:
        os.write(self.uhid, struct.pack("<IH", INPUT2, len(report)) + report)

    def driver(self) -> str:
        return os.path.basename(os.path.realpath(f"{self.folder}/driver"))

    def close(self) -> None:
        os.close(self.uhid)


class KernelContacts:
    """The event device on which the kernel tells of contacts."""

    def __init__(self, device: Device) -> None:
        self.slots, self.slot, self.is_single, self.touched, self.at = {}, 0, False, False, [0, 0]
        self.fd = device.wait_for(lambda: self.find(device.folder))
        axes = (ABS_X, ABS_Y) if self.is_single else (MT_X, MT_Y)
        self.ranges = [self.axis(self.fd, axis) for axis in axes]

    @staticmethod
    def axis(fd: int, axis: int) -> tuple[int, int]:
        data = fcntl.ioctl(fd, 0x80184540 + axis, bytes(24))  # EVIOCGABS
        return struct.unpack_from("ii", data, 4)

    def find(self, folder: str):
        """The one with contacts, else the one that can be touched."""
        single = None
        for events in sorted(glob.glob(f"{folder}/input/input*/event*")):
            path = "/dev/input/" + os.path.basename(events)
            if not os.path.exists(path):
                return None
            capabilities = [int(word, 16) for word in open(f"{os.path.dirname(events)}/capabilities/abs").read().split()]
            axes = sum(word << (64 * i) for i, word in enumerate(reversed(capabilities)))
            if axes >> MT_X & 1:
                self.is_single = False
                return os.open(path, os.O_RDONLY | os.O_NONBLOCK)
            if axes & 3 == 3:
                single = path
        if single is None:
            return None
        self.is_single = True
        return os.open(single, os.O_RDONLY | os.O_NONBLOCK)

    def take(self) -> bool:
        """Reads what there is; true where the kernel told of something."""
        told = False
        while True:
            try:
                data = os.read(self.fd, INPUT_EVENT.size * 64)
            except BlockingIOError:
                return told
            for _, _, kind, code, value in INPUT_EVENT.iter_unpack(data):
                told |= kind == EV_SYN
                self.note(kind, code, value)

    def note(self, kind: int, code: int, value: int) -> None:
        if kind == EV_KEY and code in (BTN_TOUCH, 0x110):
            self.touched = value != 0
        if kind != EV_ABS:
            return
        if code in (ABS_X, ABS_Y):
            self.at[code] = value
        elif code == MT_SLOT:
            self.slot = value
        else:
            slot = self.slots.setdefault(self.slot, {MT_TRACKING: -1, MT_X: 0, MT_Y: 0})  # a slot keeps its last x and y
            slot[code] = value

    def now(self) -> list[tuple[float, float]]:
        if self.is_single:
            down = [tuple(self.at)] if self.touched else []
        else:
            down = [(slot[MT_X], slot[MT_Y]) for slot in self.slots.values() if slot[MT_TRACKING] >= 0]
        return [tuple((value - low) / max(1, high - low) for value, (low, high) in zip(place, self.ranges)) for place in down]

    def close(self) -> None:
        os.close(self.fd)


class FeltContacts:
    """What the kiosk feels, by the times at which it did."""

    def __init__(self, program: str, hidraw: str) -> None:
        self.process = subprocess.Popen([program, hidraw], stdout=subprocess.PIPE)
        self.rest, self.events = b"", []
        if self.process.stdout.readline() != b"ready\n":
            raise RuntimeError(f"{program} cannot read {hidraw}")
        os.set_blocking(self.process.stdout.fileno(), False)

    def take(self) -> None:
        while data := self.process.stdout.read():
            self.rest += data
        *lines, self.rest = self.rest.split(b"\n")
        for line in lines:
            when, kind, contact, x, y = line.split()
            self.events.append((int(when), kind.decode(), int(contact), float(x), float(y)))

    def until(self, times: list[int]) -> list[list[tuple[float, float]]]:
        """The contacts at each of these times."""
        states, down, at = [], {}, 0
        for end in times:
            while at < len(self.events) and self.events[at][0] < end:
                _, kind, contact, x, y = self.events[at]
                if kind == "up":
                    down.pop(contact, None)
                elif kind != "key":
                    down[contact] = (x, y)
                at += 1
            states.append(list(down.values()))
        return states

    def close(self) -> None:
        self.process.kill()
        self.process.wait()


def agree(kernel: list[tuple[float, float]], ours: list[tuple[float, float]]) -> bool:
    left = list(ours)
    for x, y in kernel:
        near = next((place for place in left if abs(place[0] - x) <= CLOSE and abs(place[1] - y) <= CLOSE), None)
        if near is None:
            return False
        left.remove(near)
    return not left


def compare(recording: Recording, program: str) -> dict:
    device = Device(recording)
    kernel = KernelContacts(device)
    device.answer(0.2)
    felt = FeltContacts(program, device.hidraw)
    states, told, times = [], [], []
    for report in recording.reports:
        device.send(report)
        device.answer(BETWEEN_REPORTS)
        told.append(kernel.take())
        felt.take()
        states.append(kernel.now())
        times.append(time.monotonic_ns())
    time.sleep(BETWEEN_REPORTS)
    felt.take()
    ours = felt.until(times)
    differ = [
        i for i, state in enumerate(states)
        if told[i] and not any(agree(state, ours[k]) for k in range(max(0, i - 1), min(len(ours), i + 2)))
    ]  # fmt: skip
    driver = device.driver()
    felt.close()
    kernel.close()
    device.close()
    first = f"report {differ[0]}: kernel {states[differ[0]]}, ours {ours[differ[0]]}" if differ else ""
    return {"name": recording.name, "driver": driver, "reports": sum(told), "differ": len(differ), "first": first}


def main(program: str, paths: list[str]) -> None:
    for path in paths:
        recording = Recording(path)
        try:
            found = compare(recording, program)
        except Exception as why:
            found = {"name": recording.name, "driver": "", "reports": 0, "differ": -1, "first": f"{type(why).__name__}: {why}"}
        print(json.dumps(found), flush=True)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2:])
