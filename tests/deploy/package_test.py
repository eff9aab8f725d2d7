#!/usr/bin/env python3
"""Are the Debian packages what an integrator needs? They are made of the programs that were just built, and then judged:

 - lintian finds nothing;
 - the kiosk's is under 3 MB and depends on no compiler, no X server and nothing of the content compiler;
 - in a fresh Debian with nothing else, apt installs it, and the kiosk draws a museum there: so no dependency is missing;
 - an upgrade keeps what staff changed in kiosk.toml; a purge leaves nothing but the museum's database.

The last two need root rights, mmdebstrap and a Debian mirror; without them the test ends after the first two and says so. It is a minute
of work for a processor, and waits for the mirror and the disk. What it saw is in the folder --work when it fails."""

import argparse
import os
import pathlib
import platform
import re
import shlex
import shutil
import subprocess
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "kiosk"))

from root_image import NotHere, codename, run, sources

SKIPPED = 77
MOST_BYTES = 3_000_000
# What Mesa and cairo bring is theirs; these the kiosk itself must not name.
NEVER = r"\b(libx11|xserver|xorg|gcc-|g\+\+|clang|libcgal|libgmp|libmpfr|libboost|librsvg)"

# What tells an integrator and a museum's staff how to go on.
MANUALS = {
    "docent": ("docent.1", "docent-update.1", "docent-database.5", "docent-visit.5", "kiosk.toml.5"),
    "docent-content": ("docent-content.1", "museum.toml.5"),
}
COMPLETED = {"docent": ("docent", "docent-update"), "docent-content": ("docent-content",)}

LIVES = """set -ex
id -u docent
id -u docent-update
test "$(stat -c '%a %U' /var/lib/docent)" = '755 docent-update'
test -e /etc/systemd/system/multi-user.target.wants/docent.service
grep -q GROUP=\\"input\\" /lib/udev/rules.d/70-docent.rules
journalctl --list-catalog 1f67ddceca984559b931dec9c982f135 | grep docent
test -s /usr/share/bash-completion/completions/docent
test -s /usr/share/man/man1/docent.1.gz
install -m 644 /root/museum.db /var/lib/docent/museum.db
docent check /var/lib/docent/museum.db
docent-update --version
for unit in lock start update; do test -s /lib/systemd/system/docent-$unit.service; done
test ! -e /etc/systemd/system/timers.target.wants/docent-update.timer
setpriv --reuid docent --regid docent --clear-groups env HOME=/tmp docent --display headless --size 320x180 --seconds 1 --stats /tmp/stats.json
grep '"frames": 6[0-9],' /tmp/stats.json
setpriv --reuid docent-update --regid docent-update --clear-groups docent-update --starting
test -e /var/lib/docent/update.state
"""
CHANGE = "sed -i 's/^idle_reset = 60 /idle_reset = 90 /' /etc/docent/kiosk.toml && grep -q '= 90' /etc/docent/kiosk.toml"
UPGRADED = """set -ex
dpkg-query -W docent | grep 99
grep -q '^idle_reset = 90' /etc/docent/kiosk.toml
test ! -e /etc/docent/kiosk.toml.dpkg-new
docent check /var/lib/docent/museum.db
"""
# The user stays, as Debian's do: files of it may lie somewhere.
PURGED = """set -ex
test "$(find / -xdev -iname '*docent*' -not -path '/proc/*' -not -path '/root/*' -not -path '/var/lib/dpkg/*' -not -path '/var/log/*' \
  -not -path '/var/cache/*' | sort | tr '\\n' ' ')" = '/var/lib/docent '
test "$(ls /var/lib/docent)" = museum.db
"""


class Failure(Exception):
    """What is not as it should be, in one sentence."""


def package(source: pathlib.Path, bin: pathlib.Path, out: pathlib.Path, version: str | None = None) -> dict[str, pathlib.Path]:
    command = [str(source / "deploy/package"), "--bin", str(bin), "--out", str(out)] + (["--version", version] if version else [])
    made = subprocess.run(command, capture_output=True, text=True)
    if made.returncode != 0:
        raise Failure(f"deploy/package failed: {made.stdout}{made.stderr}")
    return {file.name.split("_")[0]: file for file in out.glob(f"*_{version or '*'}_*.deb")}


def file_of(deb: pathlib.Path, part: str, name: str) -> str:
    """A file of a package, or of what controls it."""
    archive = subprocess.run(["dpkg-deb", part, str(deb)], capture_output=True, check=True).stdout
    return subprocess.run(["tar", "-xO", name], input=archive, capture_output=True, check=True).stdout.decode()


def judge(packages: dict[str, pathlib.Path], out: pathlib.Path) -> None:
    kiosk = packages["docent"]
    size = kiosk.stat().st_size
    print(f"{kiosk.name}: {size} bytes; {packages['docent-content'].name}: {packages['docent-content'].stat().st_size} bytes")
    if size >= MOST_BYTES:
        raise Failure(f"the kiosk's package is {size} bytes, and should be under {MOST_BYTES}")
    depends = run("dpkg-deb", "-f", str(kiosk), "Depends", "Pre-Depends", "Recommends").stdout
    if found := re.search(NEVER, depends):
        raise Failure(f"the kiosk's package names {found[0]}: {depends}")
    if "GPL-3" not in file_of(packages["docent-content"], "--fsys-tarfile", "./usr/share/doc/docent-content/copyright"):
        raise Failure("the copyright file of docent-content does not say GPL-3")
    if "/etc/docent/kiosk.toml" not in file_of(kiosk, "--ctrl-tarfile", "./conffiles"):
        raise Failure("kiosk.toml is no conffile")
    for name, deb in packages.items():
        listed = run("dpkg-deb", "-c", str(deb)).stdout
        helps = [f"/usr/share/man/man{manual[-1]}/{manual}.gz\n" for manual in MANUALS[name]]
        helps += [f"/usr/share/bash-completion/completions/{program}\n" for program in COMPLETED[name]]
        helps += [f"/usr/share/zsh/vendor-completions/_{program}\n" for program in COMPLETED[name]]
        if missing := [file.strip() for file in helps if file not in listed]:
            raise Failure(f"the package {name} lacks {missing}")
    if not shutil.which("lintian"):
        print("lintian is not installed, and not asked")
        return
    said = subprocess.run(["lintian", "--allow-root", str(next(out.glob("*.changes")))], capture_output=True, text=True)
    if said.returncode != 0 or said.stdout.strip():
        raise Failure(f"lintian says: {said.stdout}{said.stderr}")


def require_root() -> None:
    if os.geteuid() != 0:
        raise NotHere("making a Debian root needs root rights")
    if not shutil.which("mmdebstrap"):
        raise NotHere("package mmdebstrap is missing")


def live(first: dict[str, pathlib.Path], second: dict[str, pathlib.Path], database: pathlib.Path, work: pathlib.Path) -> None:
    """Installs, upgrades and purges in a Debian that is there for nothing else, and forgotten afterwards."""
    (work / "sources.list").write_text(sources())
    apt = "DEBIAN_FRONTEND=noninteractive apt-get --yes --no-install-recommends -o Dpkg::Options::=--force-confdef"

    def carry(file: pathlib.Path, name: str) -> str:
        return f'--customize-hook=cp -L {shlex.quote(str(file))} "$1"/{name}'

    # Each in the new root: apt as mmdebstrap calls it, from outside, would install on this machine.
    def inside(script: str) -> str:
        return f'--customize-hook=chroot "$1" sh -c {shlex.quote(script)}'

    # fmt: off
    made = subprocess.run(
        ["mmdebstrap", "--variant=minbase",
         carry(pathlib.Path("/etc/resolv.conf"), "etc/resolv.conf"), carry(database, "root/museum.db"),
         carry(first["docent"], "root/first.deb"), carry(second["docent"], "root/second.deb"),
         inside(f"{apt} install /root/first.deb"), inside(LIVES), inside(CHANGE),
         inside(f"{apt} install /root/second.deb"), inside(UPGRADED),
         inside(f"{apt} purge docent"), inside(PURGED),
         "--format=null", codename(), "/dev/null", str(work / "sources.list")],
        stdin=subprocess.DEVNULL, capture_output=True, text=True)
    # fmt: on
    (work / "life.log").write_text(made.stdout + made.stderr)
    if made.returncode != 0 and re.search("Could not resolve|Failed to fetch", made.stderr):
        raise NotHere("no Debian mirror can be reached")
    if made.returncode != 0:
        raise Failure(f"install, upgrade and purge: see {work / 'life.log'}, which ends: {made.stderr[-2500:]}")
    print("installed, upgraded and purged in a fresh Debian")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--source", type=pathlib.Path, required=True)
    parser.add_argument("--bin", type=pathlib.Path, required=True, help="where docent and docent-content are")
    parser.add_argument("--database", type=pathlib.Path, required=True)
    parser.add_argument("--work", type=pathlib.Path, required=True, help="an own folder; is emptied")
    options = parser.parse_args()
    if not shutil.which("dpkg-buildpackage") or not shutil.which("dh"):
        print("skipped: packages are missing: debhelper dpkg-dev")
        return SKIPPED
    shutil.rmtree(options.work, ignore_errors=True)
    try:
        first = package(options.source, options.bin, options.work / "first")
        judge(first, options.work / "first")
        require_root()
        live(first, package(options.source, options.bin, options.work / "second", "99.0"), options.database, options.work)
    except NotHere as reason:
        print(f"skipped: {reason}; what needs no root was judged")
        return SKIPPED
    except Failure as failure:
        print(f"FAILED: {failure}")
        return 1
    shutil.rmtree(options.work)
    return 0


if __name__ == "__main__":
    sys.exit(main())
