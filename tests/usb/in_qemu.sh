#!/bin/bash
# Runs tests/usb on a real USB stack, in a QEMU guest with a kernel that has vhci-hcd. Run as root, on Debian or Ubuntu:
#
#   apt-get install qemu-system-x86 busybox-static cpio kmod libusb-1.0-0
#   apt-get download linux-image-6.1.0-NN-amd64   # the dependency of linux-image-amd64
#   tests/usb/in_qemu.sh linux-image-6.1.0-NN-amd64*.deb
#
# The guest has this machine's files, read-only, as its root, so it runs the same Python and the same checkout. It is
# emulated; KVM=1 makes it faster if the machine permits KVM.
set -euo pipefail

package=$1
project=$(cd "$(dirname "$0")/../.." && pwd)
python=${PYTHON:-$project/.venv/bin/python}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

dpkg-deb -x "$package" "$work/kernel"
release=$(ls "$work/kernel/lib/modules")
depmod -b "$work/kernel" "$release"

mkdir -p "$work/root/bin" "$work/root/modules"
cp "$(command -v busybox)" "$work/root/bin/busybox"
for module in virtio_pci 9pnet_virtio 9p vhci-hcd ftdi_sio; do
	modprobe -d "$work/kernel" -S "$release" --show-depends "$module" | while read -r _ path _; do
		name=$(basename "$path")
		# Copy each module once, in the order of the dependencies.
		ls "$work/root/modules" | grep -q -- "-$name$" || cp "$path" "$work/root/modules/$(ls "$work/root/modules" | wc -l | xargs printf %03d)-$name"
	done
done

cat > "$work/root/init" << END
#!/bin/busybox sh
export PATH=/bin:/usr/bin:/sbin:/usr/sbin
/bin/busybox --install -s /bin
mkdir -p /proc /sys /dev /machine
mount -t proc proc /proc
mount -t sysfs sys /sys
for module in /modules/*; do insmod \$module || echo "no \$module"; done
mount -t 9p -o ro,trans=virtio,version=9p2000.L,msize=262144,cache=loose machine /machine
mount -t proc proc /machine/proc
mount -t sysfs sys /machine/sys
mount -t devtmpfs dev /machine/dev
mount -t tmpfs tmp /machine/tmp
ifconfig lo 127.0.0.1 up
# Each test in a process of its own: without udevd, libusb finds only devices that were connected before it started.
cat > /machine/tmp/run << INSIDE
cd $project
export HOME=/tmp PYTHONDONTWRITEBYTECODE=1 HYPOTHESIS_STORAGE_DIRECTORY=/tmp/hypothesis
pytest="$python -m pytest -p no:cacheprovider --color=no --tb=short tests/usb"
failed=0
for test in \\\$(\\\$pytest --collect-only -q | grep ::); do
	$python -m pytest -p no:cacheprovider --color=no --tb=short -q "\\\$test" || failed=1
done
echo "exit \\\$failed"
INSIDE
chroot /machine /bin/bash /tmp/run
poweroff -f
END
chmod +x "$work/root/init"
(cd "$work/root" && find . | cpio --quiet -o -H newc | gzip) > "$work/initrd"

acceleration=(-cpu max)
[ -n "${KVM:-}" ] && acceleration=(-enable-kvm -cpu host,arch-capabilities=off)
timeout "${TIMEOUT:-600}" qemu-system-x86_64 "${acceleration[@]}" -m 1024 -smp 2 -nographic -no-reboot \
	-kernel "$work/kernel/boot/vmlinuz-$release" -initrd "$work/initrd" \
	-append "console=ttyS0 quiet panic=-1" \
	-virtfs "local,path=/,mount_tag=machine,security_model=none,readonly=on,multidevs=remap" | tee "$work/log"
grep -q "exit 0" "$work/log"
