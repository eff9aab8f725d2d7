"""What card_recorder.cpp wrote down in the machine, and the troubles that it makes."""

import statistics

from machine import Machine

PRELOAD = "/usr/local/lib/libcard_recorder.so"


class Commits:
    """Times are nanoseconds of the machine's monotonic clock."""

    def __init__(self, machine: Machine, folder: str) -> None:
        self.machine, self.folder, self.file = machine, folder, f"{folder}/commits"

    def all(self) -> list[tuple[int, str]]:
        lines = self.machine.must(f"cat {self.file} 2>/dev/null || true").splitlines()
        return [(int(time), what) for time, what, _ in (line.split() for line in lines)]

    def first(self, what: str, after: int = 0) -> int | None:
        return next((time for time, kind in self.all() if kind == what and time > after), None)

    def count(self, what: str, after: int = 0, until: int = 1 << 62) -> int:
        return sum(kind == what and after < time <= until for time, kind in self.all())

    def frame_seconds(self, until: int) -> float:
        """What a frame of a picture that moved then took."""
        times = [time for time, what in self.all() if what == "commit" and time < until][-8:]
        return statistics.median((later - earlier) / 1e9 for earlier, later in zip(times, times[1:]))

    def trouble(self, name: str, meanwhile: str) -> str:
        """Asks for a trouble; `meanwhile` is a command, in which FILE is what asks for it."""
        file = f"{self.folder}/{name}"
        return self.machine.must(f"touch {file}; chown docent {file}; {meanwhile.replace('FILE', file)}")

    def now(self) -> int:
        return int(self.machine.must("python3 -c 'import time; print(time.monotonic_ns())'"))
