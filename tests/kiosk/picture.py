"""Pictures of a screen, as rows of red, green and blue bytes: read, compared, and asked for a colour."""

import pathlib
import re
import struct
import zlib
from dataclasses import dataclass

RIBBON = (0xD2, 0x45, 0x2D)  # the vermilion of the way on the floor
CLOSE = 24  # in each channel: light falls on the ribbon


@dataclass(frozen=True)
class Picture:
    width: int
    height: int
    rgb: bytes

    def ribbon(self) -> int:
        """How many pixels have the colour of the way."""
        red, green, blue = (self.rgb[channel::3] for channel in range(3))
        near = [bytes(abs(value - wanted) <= CLOSE for value in range(256)) for wanted in RIBBON]
        channels = (int.from_bytes(part.translate(table), "big") for part, table in zip((red, green, blue), near))
        first, second, third = channels
        return (first & second & third).bit_count()

    def colours(self) -> int:
        """How many there are, of some of its pixels."""
        return len({self.rgb[at : at + 3] for at in range(0, len(self.rgb) - 2, 303)})

    def panel(self) -> "Picture":
        """The part on the left with the words; it stays still while the guide walks."""
        width, row = self.width * 3 // 8, self.width * 3
        return Picture(width, self.height, b"".join(self.rgb[at : at + 3 * width] for at in range(0, len(self.rgb), row)))

    def turned(self, quarters: int) -> "Picture":
        """Turned clockwise."""
        turned = self
        for _ in range(quarters % 4):
            row = turned.width * 3
            columns = (b"".join(turned.rgb[at + x : at + x + 3] for at in range(len(turned.rgb) - row, -1, -row)) for x in range(0, row, 3))
            turned = Picture(turned.height, turned.width, b"".join(columns))
        return turned

    def shifted(self, right: int) -> "Picture":
        """Moved to the right; the left edge fills what is left free."""
        row = self.width * 3
        rows = (self.rgb[at : at + 3] * right + self.rgb[at : at + row - 3 * right] for at in range(0, len(self.rgb), row))
        return Picture(self.width, self.height, b"".join(rows))

    def difference(self, other: "Picture") -> float:
        """The mean difference of a channel, 0 to 255; of every seventh byte, which is enough and quick."""
        if (self.width, self.height) != (other.width, other.height):
            return 255.0
        mine, theirs = self.rgb[::7], other.rgb[::7]
        return sum(abs(a - b) for a, b in zip(mine, theirs)) / len(mine)


def read_ppm(file: pathlib.Path) -> Picture:
    """A binary PPM as QEMU writes it."""
    data = file.read_bytes()
    header = re.match(rb"P6\s+(\d+)\s+(\d+)\s+255\s", data)
    if not header:
        raise ValueError(f"{file}: not a PPM of 8 bits")
    return Picture(int(header[1]), int(header[2]), data[header.end() :])


def read_png(file: pathlib.Path) -> Picture:
    """A PNG of 8 bits a channel, RGB or RGBA, not interlaced (PNG 1.2, sections 4.1 and 6)."""
    data = file.read_bytes()
    at, packed, width, height, channels = 8, b"", 0, 0, 3
    while at < len(data):
        size, kind = struct.unpack_from(">I4s", data, at)
        chunk = data[at + 8 : at + 8 + size]
        if kind == b"IHDR":
            width, height, bits, colour, _, _, interlaced = struct.unpack(">IIBBBBB", chunk)
            if bits != 8 or colour not in (2, 6) or interlaced:
                raise ValueError(f"{file}: a PNG of a kind that is not read here")
            channels = 3 if colour == 2 else 4
        elif kind == b"IDAT":
            packed += chunk
        at += 12 + size
    rows = unfiltered(zlib.decompress(packed), width * channels, channels)
    if channels == 4:
        del rows[3::4]
    return Picture(width, height, bytes(rows))


def unfiltered(data: bytes, row_bytes: int, step: int) -> bytearray:
    """Takes back the filter of each row of a PNG."""
    out, above = bytearray(), bytearray(row_bytes)
    for start in range(0, len(data), row_bytes + 1):
        kind, row = data[start], bytearray(data[start + 1 : start + 1 + row_bytes])
        for i in range(row_bytes) if kind else ():
            left = row[i - step] if i >= step else 0
            corner = above[i - step] if i >= step else 0
            row[i] = (row[i] + predicted(kind, left, above[i], corner)) & 255
        out += row
        above = row
    return out


def predicted(kind: int, left: int, above: int, corner: int) -> int:
    if kind == 1:
        return left
    if kind == 2:
        return above
    if kind == 3:
        return (left + above) // 2
    guess = left + above - corner  # Paeth
    return min((left, above, corner), key=lambda value: abs(value - guess))
