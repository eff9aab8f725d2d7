"""A stock Debian to boot: its kernel, an initial root that finds the disk, and the disk. Made once with mmdebstrap from
the mirror that this machine uses, and kept; about a minute and a half the first time, nothing afterwards.

What is in it: `mmdebstrap --variant=minbase`, what every Debian has beside that (systemd, udev, logind), docent's
`packages_kiosk`, a small Python for the touch screen, and a root shell on a virtio port, which is the test's way in.
Nothing of docent: that is installed by the test, in the running machine, as deploy/README.md says.
"""

import hashlib
import os
import pathlib
import platform
import shutil
import subprocess
import tempfile
from dataclasses import dataclass

STOCK = "systemd systemd-sysv udev dbus libpam-systemd kmod".split()
FOR_THE_TEST = ["python3-minimal"]
# What this machine needs by itself to reach the disk; everything else is loaded by udev, as on any Debian.
TO_REACH_THE_DISK = ["virtio_pci", "virtio_blk", "ext4", "crc32c_generic"]
TO_BE_FIRST = ["virtio_gpu"]  # of several graphics cards
FOR_UDEV = ["virtio_console", "virtio_gpu", "bochs", "uhid", "hid_generic", "hid_multitouch", "evdev"]
FOR_HEADPHONES = ["snd_usb_audio"]
FOR_A_STICK = ["xhci_pci", "usb_storage", "sd_mod", "vfat", "nls_cp437", "nls_ascii", "nls_iso8859-1"]
FREE_MIB = 600

SHELL_UNIT = """\
[Unit]
Description=A shell for the test
BindsTo=dev-vport1p1.device
After=dev-vport1p1.device multi-user.target
[Service]
ExecStart=/bin/bash -c 'echo "a shell is there"; exec /bin/bash'
StandardInput=file:/dev/vport1p1
StandardOutput=file:/dev/vport1p1
WorkingDirectory=/root
KillMode=process
[Install]
WantedBy=dev-vport1p1.device
"""

INIT = """\
#!/bin/busybox sh
export PATH=/bin
busybox mkdir -p /proc /sys /dev /disk
busybox mount -t proc none /proc
busybox mount -t sysfs none /sys
busybox mount -t devtmpfs none /dev
for module in {modules}; do busybox insmod "/$module"; done
until busybox mount -t ext4 /dev/vda /disk 2>/dev/null; do busybox sleep 0.1; done
busybox mount --move /dev /disk/dev
exec busybox switch_root /disk /sbin/init
"""


class NotHere(Exception):
    """Why the test cannot run on this machine."""


@dataclass(frozen=True)
class RootImage:
    kernel: pathlib.Path
    initial_root: pathlib.Path
    disk: pathlib.Path
    further: str = ""  # arguments of the kernel

    def arguments(self) -> list[str]:
        """For QEMU; what is written is forgotten."""
        # fmt: off
        return ["-kernel", str(self.kernel), "-initrd", str(self.initial_root),
                "-append", f"console=ttyS0 quiet mitigations=off nokaslr systemd.show_status=0 {self.further}",
                "-drive", f"file={self.disk},if=virtio,format=raw,snapshot=on"]
        # fmt: on


def require_tools() -> None:
    if platform.machine() != "x86_64":
        raise NotHere(f"only amd64 is booted, and this is {platform.machine()}")
    if os.geteuid() != 0:
        raise NotHere("making a Debian root needs root rights")
    needed = {
        "qemu-system-x86_64": "qemu-system-x86",
        "mmdebstrap": "mmdebstrap",
        "mke2fs": "e2fsprogs",
        "mkfs.vfat": "dosfstools",
        "mcopy": "mtools",
        "sfdisk": "fdisk",
        "busybox": "busybox-static",
        "cpio": "cpio",
        "modprobe": "kmod",
        "apt-get": "apt",
    }
    missing = [package for program, package in needed.items() if not shutil.which(program)]
    if missing:
        raise NotHere(f"packages are missing: {' '.join(missing)}")


def root_image(cache: pathlib.Path, packages: list[str]) -> RootImage:
    """The image of these packages, made now or an earlier time."""
    recipe = pathlib.Path(__file__).read_bytes() + " ".join(packages).encode() + codename().encode()
    folder = cache / f"root-{hashlib.sha256(recipe).hexdigest()[:16]}"
    if not folder.exists():
        cache.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=cache, prefix="making-") as scratch:
            make(pathlib.Path(scratch), packages)
            for old in cache.glob("root-*"):
                shutil.rmtree(old)
            (pathlib.Path(scratch) / "image").rename(folder)
    return RootImage(folder / "vmlinuz", folder / "initrd", folder / "disk")


def make(scratch: pathlib.Path, packages: list[str]) -> None:
    image = scratch / "image"
    image.mkdir()
    modules = unpack_kernel(scratch, image)
    root = scratch / "root"
    bootstrap(scratch, root, packages)
    furnish(root, modules)
    make_initial_root(scratch, modules, image / "initrd")
    make_disk(root, image / "disk")


def unpack_kernel(scratch: pathlib.Path, image: pathlib.Path) -> pathlib.Path:
    """Debian's newest kernel, unpacked and not installed; returns its folder of modules. The cloud kernel has no display."""
    depends = run("apt-cache", "depends", "linux-image-amd64").stdout.split()
    names = [word for word in depends if word.startswith("linux-image-") and word != "linux-image-amd64"]
    if not names:
        raise NotHere("apt knows no kernel: run apt-get update")
    fetched = run("apt-get", "-o", "APT::Sandbox::User=root", "download", names[0], cwd=scratch, check=False)
    if fetched.returncode != 0:
        raise NotHere(f"no Debian mirror can be reached: {fetched.stderr.strip()}")
    run("dpkg", "-x", str(next(scratch.glob("linux-image-*.deb"))), "kernel", cwd=scratch)
    shutil.copy(next((scratch / "kernel/boot").glob("vmlinuz-*")), image / "vmlinuz")
    modules = next((scratch / "kernel/lib/modules").iterdir())
    run("depmod", "-b", str(scratch / "kernel"), modules.name)
    return modules


def module_files(modules: pathlib.Path, names: list[str]) -> list[pathlib.Path]:
    """The files of kernel modules and of what those need, in the order in which they can be loaded."""
    files: dict[pathlib.Path, None] = {}
    for name in names:
        tree = str(modules.parents[2])
        for line in run("modprobe", "-d", tree, "-S", modules.name, "-D", name).stdout.splitlines():
            if line.startswith("insmod "):
                files[pathlib.Path(line.split()[1])] = None
    return list(files)


def codename() -> str:
    return platform.freedesktop_os_release().get("VERSION_CODENAME", "")


def sources() -> str:
    """Where this machine has its Debian packages from, as lines of a sources.list."""
    form = "deb $(REPO_URI) $(RELEASE) $(COMPONENT)|$(ORIGIN)|$(CODENAME)"
    lines = set()
    for target in run("apt-get", "indextargets", "--format", form, "Identifier: Packages").stdout.splitlines():
        line, origin, name = target.split("|")
        if origin == "Debian" and name.split("-")[0] == codename():
            lines.add(line)
    if not lines:
        raise NotHere("apt knows no mirror of this Debian: run apt-get update")
    return "\n".join(sorted(lines)) + "\n"


def bootstrap(scratch: pathlib.Path, root: pathlib.Path, packages: list[str]) -> None:
    (scratch / "sources.list").write_text(sources())
    wanted = ",".join(STOCK + FOR_THE_TEST + packages)
    # fmt: off
    made = run("mmdebstrap", "--variant=minbase", f"--include={wanted}",
               "--dpkgopt=path-exclude=/usr/share/doc/*", "--dpkgopt=path-exclude=/usr/share/man/*",
               codename(), str(root), str(scratch / "sources.list"), check=False)
    # fmt: on
    if made.returncode != 0:
        raise RuntimeError(f"mmdebstrap failed:\n{made.stderr}")


def furnish(root: pathlib.Path, modules: pathlib.Path) -> None:
    """The kernel's modules, and the test's way in."""
    inside = root / "usr/lib/modules" / modules.name
    for file in module_files(modules, TO_REACH_THE_DISK + FOR_UDEV + FOR_HEADPHONES + FOR_A_STICK):
        copy = inside / file.relative_to(modules)
        copy.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(file, copy)
    for name in ("modules.builtin", "modules.builtin.modinfo", "modules.order"):
        shutil.copy(modules / name, inside / name)
    run("depmod", "-b", str(root), modules.name)
    (root / "etc/hostname").write_text("kiosk\n")
    (root / "etc/systemd/system/shell.service").write_text(SHELL_UNIT)
    run("systemctl", f"--root={root}", "enable", "shell.service")


def make_initial_root(scratch: pathlib.Path, modules: pathlib.Path, out: pathlib.Path) -> None:
    tree = scratch / "initial"
    (tree / "bin").mkdir(parents=True)
    shutil.copy(shutil.which("busybox"), tree / "bin/busybox")
    files = module_files(modules, TO_REACH_THE_DISK + TO_BE_FIRST)
    for file in files:
        shutil.copy(file, tree / file.name)
    (tree / "init").write_text(INIT.format(modules=" ".join(file.name for file in files)))
    (tree / "init").chmod(0o755)
    names = "\n".join(str(path.relative_to(tree)) for path in sorted(tree.rglob("*")))
    packed = subprocess.run(["cpio", "-o", "-H", "newc", "--quiet"], cwd=tree, input=names.encode(), capture_output=True, check=True)
    out.write_bytes(packed.stdout)


def make_disk(root: pathlib.Path, disk: pathlib.Path) -> None:
    used = int(run("du", "-sm", str(root)).stdout.split()[0])
    run("mke2fs", "-q", "-t", "ext4", "-d", str(root), str(disk), f"{used * 11 // 10 + FREE_MIB}M")


def run(*command: str, check: bool = True, cwd: pathlib.Path | None = None) -> subprocess.CompletedProcess:
    done = subprocess.run(command, cwd=cwd, capture_output=True, text=True)
    if check and done.returncode != 0:
        raise RuntimeError(f"{' '.join(command)} failed:\n{done.stdout}{done.stderr}")
    return done
