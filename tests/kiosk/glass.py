#!/usr/bin/env python3
"""A multi-touch screen that is not there: runs inside the machine, plugs itself in through /dev/uhid and is touched by
lines of text. Needs python3-minimal only.

    glass.py FIFO [DESCRIPTOR]    each line "X Y" written to FIFO, in [0, 1] from the top left, is one short touch; the file
                                  FIFO.reports gets the time of its first report, nanoseconds of the monotonic clock
    glass.py storm SECONDS        three screens that are plugged in and pulled out all the time, for so long

DESCRIPTOR is a report descriptor in hexadecimal bytes; without one it is `OWN`. Either has the input report that `report`
makes: identifier 1, two contacts, how many of them count.
"""

import os
import select
import struct
import sys
import time

# A touch screen as Windows 8 asks for: two contacts of tip switch, identifier, x and y in 0 to 4095, then the contact
# count; a feature report with the most contacts (HID Usage Tables, digitizer page).
CONTACT = (
    "09 22 a1 02"  # finger, logical collection
    " 09 42 15 00 25 01 75 01 95 01 81 02"  # tip switch, one bit
    " 95 07 81 03"  # seven bits of nothing
    " 09 51 25 7f 75 08 95 01 81 02"  # contact identifier
    " 05 01 26 ff 0f 75 10 55 0e 65 11"  # generic desktop, 0 to 4095, hundredths of a centimetre
    " 35 00 46 fa 14 09 30 81 02"  # x, 53.70 cm
    " 46 cc 0b 09 31 81 02"  # y, 30.20 cm
    " c0 05 0d"
)
OWN = (
    "05 0d 09 04 a1 01 85 01"  # digitizer, touch screen, application collection, report 1
    f" {CONTACT} {CONTACT}"
    " 09 54 15 00 25 02 75 08 95 01 81 02"  # contact count
    " 85 08 09 55 b1 02 c0"  # report 8, feature: contact count maximum
)

# linux/uhid.h
GET_REPORT, GET_REPORT_REPLY, CREATE2, INPUT2, SET_REPORT, SET_REPORT_REPLY = 9, 10, 11, 12, 13, 14
EVENT_BYTES = 4380
USB = 3


def plug_in(descriptor: bytes) -> int:
    """Makes the device; it is there as long as the file is open."""
    device = os.open("/dev/uhid", os.O_RDWR)
    name, place = b"a touch screen of the test", b"uhid/0"
    size = len(descriptor)
    create = struct.pack("<I128s64s64sHHIIII", CREATE2, name, place, b"", size, USB, 0x1209, 0x0001, 0, 0)
    os.write(device, create + descriptor)
    return device


def answer(device: int) -> None:
    """The kernel asks for the feature reports while it takes the device up."""
    event = os.read(device, EVENT_BYTES)
    kind, request, report_id = struct.unpack_from("<IIB", event)
    if kind == GET_REPORT:
        most_contacts = bytes([report_id, 2])
        os.write(device, struct.pack("<IIHH", GET_REPORT_REPLY, request, 0, len(most_contacts)) + most_contacts)
    elif kind == SET_REPORT:
        os.write(device, struct.pack("<IIH", SET_REPORT_REPLY, request, 0))


def report(down: bool, x: float, y: float) -> bytes:
    contact = struct.pack("<BBHH", down, 0, round(x * 4095), round(y * 4095))
    nobody = struct.pack("<BBHH", 0, 1, 0, 0)
    data = b"\x01" + contact + nobody + b"\x01"
    return struct.pack("<IH", INPUT2, len(data)) + data


def touch(device: int, x: float, y: float) -> None:
    for _ in range(5):
        os.write(device, report(True, x, y))
        time.sleep(0.02)
    os.write(device, report(False, x, y))


def come_and_go(seconds: float) -> None:
    """A screen that is there for a moment, again and again: what the kernel says of it vanishes while it is read."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        device = plug_in(bytes.fromhex(OWN))
        until = time.monotonic() + 0.005 + os.urandom(1)[0] / 255 * 0.03
        while (left := until - time.monotonic()) > 0:
            if select.select([device], [], [], left)[0]:
                answer(device)
        os.close(device)


def storm(seconds: float) -> None:
    children = []
    for _ in range(3):
        child = os.fork()
        if child == 0:
            come_and_go(seconds)
            os._exit(0)
        children.append(child)
    for child in children:
        os.waitpid(child, 0)


def main(fifo: str, descriptor: str = OWN) -> None:
    if not os.path.exists(fifo):
        os.mkfifo(fifo)
    lines = os.fdopen(os.open(fifo, os.O_RDWR), buffering=1)  # for writing too: then it never ends
    device = plug_in(bytes.fromhex(descriptor))
    while True:
        ready, _, _ = select.select([device, lines], [], [])
        if device in ready:
            answer(device)
        if lines in ready:
            x, y = lines.readline().split()
            reported = time.monotonic_ns()
            touch(device, float(x), float(y))
            with open(f"{fifo}.reports", "a") as times:
                print(reported, file=times)


if __name__ == "__main__":
    if sys.argv[1] == "storm":
        storm(float(sys.argv[2]))
    else:
        main(*sys.argv[1:])
