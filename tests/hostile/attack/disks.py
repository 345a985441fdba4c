# SPDX-License-Identifier: BSD-3-Clause
"""Disks that become full: file systems of ten sizes, mounted where nobody else sees them."""
import ctypes
import os
import shutil
import subprocess

from bed import clear, contents, faults_of
from cases import CASES, Stage

NEW_NAMESPACE = 0x00020000  # CLONE_NEWNS
NEW_USER = 0x10000000  # CLONE_NEWUSER
PAGE = 4096
# Of what the new outputs take; the last two are enough.
SHARES = (0, 0.02, 0.1, 0.25, 0.5, 0.75, 0.9, 0.99, 1.3, 3)


def may_mount():
    """Moves this process to a mount namespace of its own; to be called before any thread begins."""
    libc = ctypes.CDLL(None, use_errno=True)
    user, group = os.getuid(), os.getgid()
    if user != 0:
        if libc.unshare(NEW_USER | NEW_NAMESPACE) != 0:
            return False
        for name, text in (("setgroups", "deny"), ("uid_map", f"0 {user} 1"),
                           ("gid_map", f"0 {group} 1")):
            with open("/proc/self/" + name, "w", encoding="ascii") as stream:
                stream.write(text)
    elif libc.unshare(NEW_NAMESPACE) != 0:
        return False
    return subprocess.run(["mount", "--make-rprivate", "/"], check=False,
                          stderr=subprocess.DEVNULL).returncode == 0


def pages(size):
    return (size + PAGE - 1) // PAGE


class Disk:
    """A file system in memory with so many pages."""

    def __init__(self, bed, page_count):
        self.folder = bed.folder()
        subprocess.run(["mount", "-t", "tmpfs", "-o", f"nr_blocks={page_count},mode=700", "disk",
                        self.folder], check=True)

    def close(self):
        subprocess.run(["umount", "-l", self.folder], check=False)
        clear(self.folder)


def one(stage, share):
    """@return faults"""
    taken = sum(pages(len(data)) for data in contents(stage.template).values())
    wanted = sum(pages(len(data)) for data in stage.new.values())
    # The folders take a page or two.
    disk = Disk(stage.bed, taken + 4 + int(share * wanted))
    shutil.copytree(stage.template, disk.folder, dirs_exist_ok=True)
    run = stage.bed.run(stage.case.command, disk.folder)
    faults = faults_of(run, False)
    if run.code not in (0, 3, 4):
        faults.append("It did not say that the output could not be written.")
    if run.code == 3 and b"o space left" not in run.err and b"disk full" not in run.err:
        faults.append("It does not say that the disk is full.")
    faults += stage.judge(disk.folder)
    if run.code == 3:
        now = contents(disk.folder)
        faults += [f"It failed and {os.fsdecode(name)} is not the earlier one."
                   for name, data in stage.old.items() if now.get(name) != data]
    left = stage.strange(disk.folder)
    if left:
        faults.append("It left " + ", ".join(left) + ".")
    disk.close()
    return run.code, [f"{share} of what it needs: {fault}\n    {run.text()}" for fault in faults]


def attack(bed, shares, table, only=None):
    """Every case on disks of these sizes."""
    for case in CASES:
        if only and only not in case.name:
            continue
        stage = Stage(bed, case)
        results = [one(stage, share) for share in shares]
        full = sum(1 for code, _ in results if code == 3)
        table.add(f"full disks: {case.name}", len(results),
                  stage.faults + [fault for _, faults in results for fault in faults],
                  f"{full} were too small")
        stage.close()
