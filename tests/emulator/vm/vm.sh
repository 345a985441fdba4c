#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# tests/emulator/vm/vm.sh BUILD [soak MINUTES]: boots Debian's kernel in QEMU (no KVM, no network) with vhci_hcd
# and runs falcon_vm_check in it, or falcon_vm_soak for that long by the guest's clock. Nothing is installed: the kernel package is only unpacked into BUILD/vm.
set -uo pipefail
build=$1
program=falcon_vm_check
limit=1500
if [ "${2:-}" = soak ]; then
  program=falcon_vm_soak
  limit=$((1500 + ${3:-1} * 300))
fi
here=$build/vm

fail() {
  echo "$1" >&2
  exit 1
}

for tool in qemu-system-x86_64 busybox cpio dpkg-deb; do
  command -v "$tool" >/dev/null ||
    fail "'$tool' is missing: apt-get install qemu-system-x86 busybox-static cpio dpkg"
done
mkdir -p "$here" || exit 1

if [ ! -d "$here/kernel/boot" ]; then
  package=$(apt-cache depends linux-image-amd64 | sed -n 's/.*Depends: \(linux-image-[0-9][^ ]*\)/\1/p' | head -1)
  (cd "$here" && apt-get -q download "$package") || fail "Debian's kernel could not be fetched."
  dpkg-deb -x "$here/$package"_*.deb "$here/kernel" || fail "The kernel could not be unpacked."
fi
kernel=$(echo "$here"/kernel/boot/vmlinuz-*)
modules=$(echo "$here"/kernel/lib/modules/*)

# The initial file system: busybox, the check with its libraries, the modules in their order.
tree=$here/tree
rm -rf "$tree"
mkdir -p "$tree"/{bin,dev,proc,sys,tmp,modules,run}
cp "$(command -v busybox)" "$tree/bin/busybox"
cp "$build/tests/$program" "$tree/bin/"
ldd "$build/tests/$program" | grep -o '/[^ ]*' | sort -u | while read -r library; do
  mkdir -p "$tree$(dirname "$library")"
  cp -L "$library" "$tree$library"
done
# Built libraries are found where the program looks for them.
load=()
for name in usb-common usbcore usbip-core vhci-hcd usbserial ftdi_sio; do
  file=$(find "$modules" -name "$name.ko*" | head -1)
  [ -n "$file" ] || fail "This kernel has no module $name."
  cp "$file" "$tree/modules/"
  load+=("$(basename "$file")")
done
cat >"$tree/init" <<INIT
#!/bin/busybox sh
/bin/busybox mount -t proc none /proc
/bin/busybox mount -t sysfs none /sys
/bin/busybox mount -t devtmpfs none /dev
for module in ${load[*]}; do /bin/busybox insmod /modules/\$module || echo "VM FAILED: insmod \$module"; done
/bin/$program ${3:-}
/bin/busybox poweroff -f
INIT
chmod +x "$tree/init"
(cd "$tree" && find . | cpio -o -H newc --quiet | gzip -1) >"$here/initrd.gz" || exit 1

# One processor: with two, emulated without KVM, USB runs ten times slower. The guest's clock counts its
# instructions (4 ns each) and skips what it sleeps: a busy host makes the run longer, never an answer late.
timeout "$limit" qemu-system-x86_64 -M q35 -accel tcg -cpu max -smp 1 -m 512 -nographic -no-reboot -nic none \
  -icount shift=2,sleep=off -rtc clock=vm \
  -kernel "$kernel" -initrd "$here/initrd.gz" \
  -append "console=ttyS0 quiet panic=-1 rdinit=/init" </dev/null | tee "$here/log" |
  grep --line-buffered -aE '^(ok:|   |\| |VM )'
grep -aq '^VM PASSED' "$here/log" || fail "The check in the virtual machine did not pass; see $here/log."
