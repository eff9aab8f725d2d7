"""What is heard: how loud it is from moment to moment, and whether one sound is in another."""

import array
import pathlib

RATE = 48000  # of samples in two channels, each of 16 bits
MOMENT = 0.02  # seconds
HEADER = 44  # bytes; what they say of the length is not true before the recorder is switched off


def loudness(file: pathlib.Path) -> list[float]:
    """The mean size of a WAV file's samples, for each moment of it."""
    sound = file.read_bytes()[HEADER:]
    samples = array.array("h", sound[: len(sound) // 4 * 4])[::2]
    step = round(MOMENT * RATE)
    return [sum(map(abs, samples[at : at + step])) / step for at in range(0, len(samples) - step + 1, step)]


def alike(one: list[float], other: list[float]) -> float:
    """The correlation of two: 1 where one is the other, louder or softer; 0 where they have nothing in common."""
    mean_one, mean_other = sum(one) / len(one), sum(other) / len(other)
    both = sum((a - mean_one) * (b - mean_other) for a, b in zip(one, other, strict=True))
    alone = sum((a - mean_one) ** 2 for a in one) * sum((b - mean_other) ** 2 for b in other)
    return both / alone**0.5 if alone > 0 else 0.0


def found_in(heard: list[float], said: list[float]) -> float:
    """How much of what is said is heard, second by second and in its order: the share of its seconds. The first may be lost while a
    device is opened, and there may be gaps where the machine stood still, but none of long_gap seconds."""
    second, same, long_gap = round(1 / MOMENT), 0.85, 5
    pieces = [said[at : at + second] for at in range(0, len(said) - second + 1, second)]
    best = 0
    for start in range(len(pieces)):
        begun = place_of(heard, pieces[start], 0, len(heard), same)
        if begun is None:
            continue
        found, after = 1, begun + second
        for piece in pieces[start + 1 :]:
            place = place_of(heard, piece, after - 2, after + long_gap * second, same)
            if place is not None:
                found, after = found + 1, place + second
        best = max(best, found)
    return best / max(len(pieces), 1)


def place_of(heard: list[float], piece: list[float], first: int, last: int, same: float) -> int | None:
    """Where from `first` on the piece is heard first, if it is before `last`."""
    ends = min(last, len(heard) - len(piece) + 1)
    return next((at for at in range(max(first, 0), ends) if alike(heard[at : at + len(piece)], piece) > same), None)
