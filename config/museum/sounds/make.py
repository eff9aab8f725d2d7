#!/usr/bin/env python3
"""Makes the sample museum's sound: config/museum/sounds/make.py writes one WAV file beside itself.

The bells are invented, and so is their sound: a few inharmonic partials that die away, the higher ones sooner, as those of a cast bell do. Such bells
are flat, so that one has two notes, a third apart: one where it is struck in the middle, the other at its side. Standard library only; the same bytes
every time.
"""
import array
import math
import pathlib
import sys
import wave

RATE = 16_000  # samples a second: its highest partial is far below half of that
HERE = pathlib.Path(__file__).parent

# Each partial: its frequency as a multiple of the note, how loud it is, and seconds until a third of that is left.
PARTIALS = [(1.0, 1.0, 1.15), (1.51, 0.35, 0.8), (2.34, 0.5, 0.55), (3.19, 0.28, 0.35), (4.27, 0.2, 0.2), (5.62, 0.14, 0.12), (7.3, 0.1, 0.06)]
MIDDLE, SIDE = 261.6, 311.1  # Hz
STRIKES = [(0.1, MIDDLE, 1.0), (3.4, SIDE, 0.9)]  # seconds, note, how hard
LENGTH = 6.6


def bell(note, seconds):
    """One strike: partials that begin together, within 2 ms, and slowly beat against their twins."""
    value = 0.0
    for ratio, loud, decay in PARTIALS:
        for detune in (1.0, 1.0015):
            value += 0.5 * loud * math.exp(-seconds / decay) * math.sin(2 * math.pi * note * ratio * detune * seconds)
    return value * min(1.0, seconds / 0.002)


def sound():
    samples = []
    for i in range(int(LENGTH * RATE)):
        at = i / RATE
        value = sum(hard * bell(note, at - begin) for begin, note, hard in STRIKES if at >= begin)
        value *= min(1.0, (LENGTH - at) / 0.4)  # the end is silence
        samples.append(round(0.3 * value * 32767))
    return array.array('h', samples)


def main():
    samples = sound()
    if sys.byteorder == 'big':
        samples.byteswap()
    with wave.open(str(HERE / 'chime-bell.wav'), 'wb') as out:
        out.setnchannels(1)
        out.setsampwidth(2)
        out.setframerate(RATE)
        out.writeframes(samples.tobytes())


if __name__ == '__main__':
    main()
