"""Releases of a museum, as an integrator makes them on a desk: signed, for a web server and on a USB stick."""

import argparse
import itertools
import pathlib
import shutil
import subprocess

from expected import SIZE
from machine import Failure
from picture import Picture, read_png

TITLE = "Museum of the Three Rivers"
OTHER_TITLES = ("Museum of the Four Rivers", "Museum of the Five Rivers")
SPARE_ON_A_STICK = 16 << 20  # bytes
SAME_PANEL = 0.03  # the mean difference of a channel: of one museum 0.002, of two with other titles from 0.12
BEFORE_PARTITION = 1 << 20  # bytes


class Releases:
    """Three of them: another title, the first museum again, and a third title. The second goes by stick."""

    def __init__(self) -> None:
        self.panel: dict[int, Picture] = {}  # the words that a kiosk shows of each
        self.stick = pathlib.Path()

    def make(self, options: argparse.Namespace, database: pathlib.Path) -> list[pathlib.Path]:
        """What the machine is given: the folder of a web server, the public key, and a web server."""
        self.options, self.work, self.site = options, options.work, options.work / "site"
        self.run("keygen", "-o", self.work / "museum")
        others = [self.compiled(title) for title in OTHER_TITLES]
        for number, content in enumerate((others[0], database, others[1]), start=1):
            self.run("release", content, "-o", self.site, "--key", self.work / "museum.key")
            shutil.copy(self.site / "release.txt", self.site / f"release-{number}.txt")
            self.panel[number] = self.shown(content, f"release-{number}").panel()
            if content == database:
                self.stick = self.stick_with(self.site)
        (self.site / "release.txt").unlink()
        if min(a.difference(b) for a, b in itertools.combinations(self.panel.values(), 2)) < 3 * SAME_PANEL:
            raise Failure("the welcome screens of museums with other titles cannot be told apart")
        return [self.site, self.work / "museum.pub", pathlib.Path(shutil.which("busybox"))]

    def run(self, *arguments: object) -> None:
        subprocess.run([self.options.docent_content, *map(str, arguments)], check=True, stdout=subprocess.DEVNULL)

    def compiled(self, title: str) -> pathlib.Path:
        museum, out = self.work / "museum", self.work / f"{title}.db"
        shutil.copytree(self.options.source / "config/museum", museum)
        words = museum / "museum.toml"
        words.write_text(words.read_text().replace(TITLE, title))
        shutil.copy(self.options.museum, out)  # whose speech is kept where it is the same
        self.run("compile", museum, "-o", out, "--quiet")
        shutil.rmtree(museum)
        return out

    def shown(self, database: pathlib.Path, name: str) -> Picture:
        picture, visit = self.work / f"{name}.png", self.work / f"{name}.visit"
        visit.write_text(f"0.5 shot {picture}\n0.6 quit\n")
        # fmt: off
        subprocess.run([self.options.docent, "--display", "headless", "--size", f"{SIZE[0]}x{SIZE[1]}", "--content", database,
                        "--config", self.options.source / "config/kiosk.toml", "--visit", visit], check=True)
        # fmt: on
        return read_png(picture)

    def stick_with(self, site: pathlib.Path) -> pathlib.Path:
        """A stick as they are sold: one partition with FAT; in its folder "docent" the release that `site` holds now."""
        stick, partition, folder = self.work / "stick", self.work / "partition", self.work / "docent"
        shutil.copytree(site, folder)
        partition.write_bytes(b"")
        with partition.open("r+b") as file:
            file.truncate(sum(each.stat().st_size for each in folder.rglob("*") if each.is_file()) + SPARE_ON_A_STICK)
        subprocess.run(["mkfs.vfat", partition], check=True, stdout=subprocess.DEVNULL)
        subprocess.run(["mcopy", "-s", "-i", partition, folder, "::docent"], check=True)
        stick.write_bytes(bytes(BEFORE_PARTITION) + partition.read_bytes())
        layout = "label: dos\nstart=1MiB, type=c\n"
        subprocess.run(["sfdisk", "--quiet", stick], input=layout, text=True, check=True, capture_output=True)
        shutil.rmtree(folder)
        partition.unlink()
        return stick
