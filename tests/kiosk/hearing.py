"""What somebody hears who plugs headphones into a kiosk, beside what the same program says that runs here without a display."""

import argparse
import pathlib
import subprocess
import time

from kiosk import CHECKOUT, TO_DRAW, Kiosk
from machine import Failure, Machine
from report import say
from sound import MOMENT, found_in, loudness

ENOUGH = 0.75  # of the sentence's seconds; of other sounds a tenth, of noise none
TIMES = 3  # that they are plugged in: a machine that stands still for seconds tears a sentence to pieces
PATIENCE = TO_DRAW / 4
LOUD = 100  # of 32,767; speech has 300 to 600
CARD = "/dev/snd/controlC0"
IN, OUT = (f"python3 {CHECKOUT}/headphones.py {where}" for where in ("in", "out"))


class Speech:
    """The sentence that a kiosk begins with."""

    def __init__(self) -> None:
        self.said: list[float] = []

    def rehearse(self, options: argparse.Namespace, database: pathlib.Path) -> list[pathlib.Path]:
        """Says it into a file; what the machine is given to hear it, too."""
        visit, config, sound = (options.work / f"hearing.{kind}" for kind in ("visit", "toml", "wav"))
        visit.write_text("1 headphones in\n1.5 quit\n")
        config.write_text(f'[sound]\ndevice = "file:{sound}"\n')
        # fmt: off
        subprocess.run([options.docent, "--display", "headless", "--size", "320x200", "--content", database, "--config", config,
                        "--visit", visit], check=True)
        # fmt: on
        self.said = loudness(sound)
        if max(self.said, default=0) < LOUD:
            raise Failure("the museum's first sentence is silent: was it compiled without espeak-ng?")
        return [pathlib.Path(__file__).parent / "headphones.py"]


def is_heard(machine: Machine, speech: Speech) -> tuple[float, float]:
    """Seconds until enough of it is, or all that there is time for, and how much is."""
    begun = time.monotonic()
    while True:
        part = found_in(loudness(machine.heard), speech.said)
        took = time.monotonic() - begun
        if part >= ENOUGH or took > PATIENCE:
            return took, part
        time.sleep(2)


def speaks(kiosk: Kiosk, speech: Speech) -> None:
    """Headphones with a sound card of their own come by USB, as the kiosk runs, are read to, and go in mid-sentence."""
    machine, before = kiosk.machine, kiosk.property("docent", "MainPID")
    for attempt in range(1, TIMES + 1):
        machine.plug_in_headphones()
        machine.wait_until("a sound card", lambda: machine.run(f"ls {CARD}")[0] == 0, TO_DRAW)
        machine.must(f"{OUT} && {IN}")
        took, part = is_heard(machine, speech)
        if part >= ENOUGH:
            break
        if attempt == TIMES:
            raise Failure(f"of what is said {part:.0%} are heard, {TIMES} times: see heard.wav")
        machine.must(OUT)
        machine.pull_out_headphones()
        machine.wait_until("no sound card", lambda: machine.run(f"ls {CARD}")[0] != 0, TO_DRAW)
    say(f"headphones were plugged in: {part:.0%} of {len(speech.said) * MOMENT:.1f} s of speech were heard ({took:.0f} s, try {attempt})")
    machine.pull_out_headphones()
    kiosk.hears("headphones pulled out", "nothing is heard until it is there")
    if kiosk.property("docent", "MainPID") != before:
        raise Failure("headphones came and went, and the service was another afterwards: see journal.log")
