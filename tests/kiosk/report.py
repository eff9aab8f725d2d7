"""What a test says while it runs."""

import time

started = time.monotonic()


def say(sentence: str) -> None:
    print(f"{time.monotonic() - started:6.1f} s  {sentence}", flush=True)
