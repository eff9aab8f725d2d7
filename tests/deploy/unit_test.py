#!/usr/bin/env python3
"""Is the unit that is installed one that systemd understands, and one that gives the kiosk no more than it needs?

`systemd-analyze security` counts from 0 (nothing can be done by it) to 10; where systemd is not installed the test is skipped."""

import pathlib
import re
import shutil
import subprocess
import sys

SKIPPED = 77
MOST_EXPOSED = 1.0


def main() -> int:
    units = [pathlib.Path(name) for name in sys.argv[1:]]
    if not shutil.which("systemd-analyze"):
        print("skipped: systemd-analyze is not installed (package systemd)")
        return SKIPPED
    failures = 0
    for unit in units:
        # fmt: off
        asked = subprocess.run(["systemd-analyze", "security", "--no-pager", "--offline=true", str(unit)],
                               capture_output=True, text=True)
        # fmt: on
        found = re.search(r"Overall exposure level for \S+: ([0-9.]+)", asked.stdout)
        if not found:
            print(f"{unit.name}: systemd-analyze does not judge it: {asked.stdout}{asked.stderr}")
            failures += 1
            continue
        print(f"{unit.name}: exposure {found[1]} of 10, at most {MOST_EXPOSED}")
        if float(found[1]) > MOST_EXPOSED:
            print(asked.stdout)
            failures += 1
        for line in (asked.stdout + asked.stderr).splitlines():
            if f"{unit.name}:" in line and "Overall" not in line:
                print(f"systemd does not understand: {line}")
                failures += 1
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
