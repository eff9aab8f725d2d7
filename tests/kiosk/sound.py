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
    """How alike what is said is to the part of what is heard that is most like it."""
    return max((alike(heard[at : at + len(said)], said) for at in range(len(heard) - len(said) + 1)), default=0.0)
