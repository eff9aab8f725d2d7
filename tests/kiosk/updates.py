"""Updates of a booted kiosk, by the units of the package: over the network, from a stick, cut off from power, and back again."""

import json

from expected import SIZE
from kiosk import CHECKOUT, TO_BOOT, TO_DRAW, Kiosk
from machine import Failure
from releases import SAME_PANEL, Releases
from report import say

SITE = "/srv/kiosks"
# What deploy/README.md has an integrator add to kiosk.toml, "Signed" and "A fleet".
SETTINGS = 'keys = ["museum.pub"]\nsource = "http://127.0.0.1:8000/kiosks"\n'


def shows(kiosk: Kiosk, releases: Releases, number: int) -> bool:
    now = kiosk.machine.picture()
    return (now.width, now.height) == SIZE and now.panel().difference(releases.panel[number]) < SAME_PANEL


def draws(kiosk: Kiosk, releases: Releases, number: int, when: str) -> None:
    took = kiosk.until_ready(when) + kiosk.machine.wait_until(f"{when}: release {number}", lambda: shows(kiosk, releases, number), TO_DRAW)
    kiosk.machine.keep_picture(when)
    say(f"{when}: release {number} is on the screen ({took:.0f} s)")


def serve(kiosk: Kiosk) -> None:
    """A web server like any other, which knows nothing of docent."""
    kiosk.machine.must(
        f"systemd-run --quiet --unit=server {CHECKOUT}/busybox httpd -f -p 127.0.0.1:8000 -h /srv && "
        f"until {CHECKOUT}/busybox wget -q -O /dev/null http://127.0.0.1:8000/kiosks/release-1.txt; do sleep 0.2; done",
        TO_DRAW,
    )


def publish(kiosk: Kiosk, number: int) -> None:
    """On the disk too: the museum's server does not lose what it serves because a kiosk loses its power."""
    kiosk.machine.must(f"cp {SITE}/release-{number}.txt {SITE}/release.txt && sync")


def look_now(kiosk: Kiosk) -> None:
    """What the timer does every quarter of an hour."""
    ended, _ = kiosk.machine.run("systemctl start docent-update", TO_DRAW)
    if ended != 0:
        said = kiosk.machine.must("journalctl --no-pager -o cat -b -u docent-update")
        raise Failure(f"docent-update failed, and said:\n{said[-2000:]}")


def content(kiosk: Kiosk) -> dict:
    return json.loads(kiosk.machine.must("docent status --json"))["content"]


def fetched(kiosk: Kiosk, releases: Releases) -> None:
    """Over the network, by the timer's unit; then the kiosk takes no unsigned database any more."""
    kiosk.machine.must("systemctl restart docent", TO_DRAW)  # nobody is in the middle of something
    kiosk.draws("before-the-updates")
    kiosk.machine.must(
        f"mkdir -p /srv && mv {CHECKOUT}/site {SITE} && install -m 644 {CHECKOUT}/museum.pub /etc/docent/ && "
        f"printf '%s' '{SETTINGS}' >/tmp/settings && cat /etc/docent/kiosk.toml >>/tmp/settings && cp /tmp/settings /etc/docent/kiosk.toml"
    )
    serve(kiosk)
    before = content(kiosk)
    publish(kiosk, 1)
    kiosk.machine.must("systemctl enable --now docent-update.timer", TO_DRAW)
    look_now(kiosk)
    draws(kiosk, releases, 1, "fetched")
    kiosk.machine.must("systemctl restart docent", TO_DRAW)  # from here on it knows the key
    draws(kiosk, releases, 1, "with-a-key")
    after = content(kiosk)
    if after["checksum"] == before["checksum"] or after["signature"] in ("none", before["signature"]):
        raise Failure(f"`docent status --json` said {before}, and after a signed release {after}")
    say(f"fetched: checksum {after['checksum'][:16]}, signature: {after['signature']}")


def from_stick(kiosk: Kiosk, releases: Releases) -> None:
    """Plugged in, and nothing else done."""
    kiosk.machine.plug_in_stick(releases.stick)
    draws(kiosk, releases, 2, "from-a-stick")
    mounted = "grep docent-stick /proc/mounts"
    kiosk.machine.wait_until("the stick is let go of", lambda: kiosk.machine.run(mounted)[0] != 0, TO_DRAW)
    kiosk.machine.pull_out_stick()


def power_cut(kiosk: Kiosk, releases: Releases) -> None:
    """While a release is being installed. Old or new, never none; and the next look finishes it."""
    publish(kiosk, 3)
    # Who is looking already has seen the old manifest, perhaps: so it is told again, now and then.
    begun = "ls /var/lib/docent/releases/*.part /var/lib/docent/releases/parts/* >/dev/null 2>&1"
    kiosk.machine.must(
        f"for look in $(seq 20); do systemctl start --no-block docent-update; "
        f"for time in $(seq 300); do if {begun}; then break 2; fi; done; done; {begun}",
        TO_DRAW,
    )
    kiosk.machine.cut_power()
    kiosk.machine.wait_for_shell(TO_BOOT)
    kiosk.machine.wait_until("old or new", lambda: shows(kiosk, releases, 2) or shows(kiosk, releases, 3), TO_DRAW)
    kiosk.machine.keep_picture("after-the-power-cut")
    found = 2 if shows(kiosk, releases, 2) else 3
    say(f"cut off from power in the middle of an installation of release 3: release {found} is on the screen")
    serve(kiosk)
    look_now(kiosk)
    draws(kiosk, releases, 3, "after-the-next-look")


def goes_back(kiosk: Kiosk, releases: Releases) -> None:
    """Killed three times within ten minutes of an update."""
    for time in range(3):
        before = kiosk.property("docent", "MainPID")
        kiosk.machine.must(f"kill -KILL {before}")
        kiosk.machine.wait_until("it starts again", lambda: kiosk.property("docent", "MainPID") not in ("0", before), TO_DRAW)
    draws(kiosk, releases, 2, "gone-back")
    said = kiosk.machine.must("journalctl --no-pager -o cat -b -u docent-start")
    if "went back from release 3 to release 2" not in said:
        raise Failure(f"it shows release 2 again, and docent-start does not say why: {said}")
    looked = kiosk.machine.must("systemctl start docent-update; journalctl --no-pager -o cat -b -u docent-update | tail -n 5", TO_DRAW)
    if not shows(kiosk, releases, 2):
        raise Failure(f"it took release 3 again: {looked}")
    say("three starts after an update: it went back by itself, and does not take it again")


def hangs(kiosk: Kiosk, releases: Releases) -> None:
    """Stopped, it draws no frame and feeds no watchdog. That is armed once the service is ready, which its first picture is before."""
    kiosk.until_ready("before-a-hang")
    before = kiosk.property("docent", "MainPID")
    patience = kiosk.property("docent", "WatchdogUSec")
    kiosk.machine.must(f"kill -STOP {before}")
    took = kiosk.machine.wait_until("the watchdog ends it", lambda: kiosk.property("docent", "MainPID") not in ("0", before), TO_DRAW)
    said = kiosk.machine.must("journalctl --no-pager -o cat -b -u docent")
    if "Watchdog timeout" not in said:
        raise Failure(f"it was stopped and is another now, and not because of the watchdog: {said[-2000:]}")
    draws(kiosk, releases, 2, "after-a-hang")
    say(f"a hang was ended by the watchdog after {took:.0f} s (its patience: {patience})")
