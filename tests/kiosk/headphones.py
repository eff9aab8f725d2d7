#!/usr/bin/env python3
"""A socket for headphones that tells: runs inside the machine, and gives its first sound card the control that drivers of such
sockets give, a switch "Headphone Jack". Needs python3-minimal only.

    headphones.py in|out    they are plugged in, or pulled out
"""

import errno
import fcntl
import os
import struct
import sys

# sound/asound.h
IFACE_CARD, BOOLEAN, READ_AND_WRITE = 0, 1, 3
WHO = struct.pack("<IiII44sI", 0, IFACE_CARD, 0, 0, b"Headphone Jack", 0)
INFO = WHO + struct.pack("<iIIi192x", BOOLEAN, READ_AND_WRITE, 1, 0)
ADD, WRITE = 0x17, 0x13


def value(is_in: bool) -> bytes:
    return WHO + struct.pack("<8xq1144x", is_in)


def ask(card: int, number: int, what: bytes) -> None:
    both_ways = 3
    fcntl.ioctl(card, both_ways << 30 | len(what) << 16 | ord("U") << 8 | number, bytearray(what))


def main(where: str) -> None:
    card = os.open("/dev/snd/controlC0", os.O_RDWR)
    try:
        ask(card, ADD, INFO)
    except OSError as error:
        if error.errno != errno.EBUSY:  # it is there already
            raise
    ask(card, WRITE, value(where == "in"))


if __name__ == "__main__":
    main(sys.argv[1])
