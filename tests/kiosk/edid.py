"""What screens say of themselves (VESA E-EDID 1.4), as well-kept and as odd as they come."""

import struct


def edid(width: int, height: int, centimetres: tuple[int, int], millimetres: tuple[int, int], interlaced: bool = False) -> bytes:
    """A screen with one mode of this size at about 60 Hz. Sizes of the picture are told twice: in whole centimetres for all of
    it, and in millimetres beside the mode."""
    blank_x, blank_y = 160, 30
    clock = (width + blank_x) * (height + blank_y) * 60 // 10_000  # tens of kilohertz
    timing = struct.pack(
        "<HBBBBBBBBBBBBBBBB",
        clock,
        width & 255,
        blank_x,
        (width >> 8) << 4,
        height & 255,
        blank_y,
        (height >> 8) << 4,
        48,  # front porch and sync
        32,
        (3 << 4) | 6,
        0,
        millimetres[0] & 255,
        millimetres[1] & 255,
        (millimetres[0] >> 8) << 4 | millimetres[1] >> 8,
        0,
        0,
        0x1A | (0x80 if interlaced else 0),
    )
    name = b"\0\0\0\xfc\0" + b"odd screen\n".ljust(13)
    limits = b"\0\0\0\xfd\0" + bytes([1, 200, 1, 200, 60, 0, 10]) + b" " * 6
    nothing = b"\0\0\0\x10\0" + bytes(13)
    block = (
        b"\0\xff\xff\xff\xff\xff\xff\0"
        + struct.pack(">H", 0x10AC)
        + bytes([1, 0, 1, 0, 0, 0, 1, 30, 1, 4, 0xA5, *centimetres, 120, 0x02])
        + bytes(10)  # colours
        + bytes(3)  # no established timings
        + b"\1\1" * 8  # no standard timings
        + timing
        + name
        + limits
        + nothing
        + b"\0"  # no extensions
    )
    return block + bytes([-sum(block) & 255])


def odd_screens(width: int, height: int) -> dict[str, bytes]:
    """By what is odd about them."""
    whole = edid(width, height, (53, 30), (531, 299))
    return {
        "that gives no size": edid(width, height, (0, 0), (0, 0)),
        "of one millimetre": edid(width, height, (0, 0), (1, 1)),
        "whose size is its proportions": edid(width, height, (16, 9), (160, 90)),
        "whose description is damaged": whole[:60] + b"\xff" + whole[61:],
        "with interlaced modes only": edid(width, height, (53, 30), (531, 299), interlaced=True),
    }
