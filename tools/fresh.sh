#!/usr/bin/env bash
# fresh.sh -- runs the commands of README.md in a new Debian that has only git and make, and prints the time of each.
#
# usage: tools/fresh.sh [SUITE [COMMAND...]]
#   SUITE    bookworm, trixie (default)
#   COMMAND  instead of "make run" and "make test"
# It needs root, debootstrap and a network. The Debian gets a clone of the last commit, in a folder that is removed at the end.
# Exit 1 when a command fails.
set -euo pipefail
. "$(dirname "$0")/usage.sh"
suite=${1:-trixie}
shift || true
[ $# -gt 0 ] || set -- "make run" "make test"
cd "$(dirname "$0")/.."
command -v debootstrap >/dev/null || { echo "fresh.sh: debootstrap is missing: apt-get install debootstrap" >&2; exit 2; }
[ "$(id -u)" -eq 0 ] || { echo "fresh.sh: only root can make a Debian in a folder" >&2; exit 2; }

root=$(mktemp -d)
leave()
{
	umount -R "$root/proc" "$root/dev" 2>/dev/null || true
	# a folder that is still mounted is not removed
	mountpoint -q "$root/dev" || mountpoint -q "$root/proc" || rm -rf --one-file-system "$root"
}
trap leave EXIT
debootstrap --variant=minbase --include=ca-certificates,git,make "$suite" "$root" >"$root.log" ||
	{ tail -n 3 "$root.log" >&2; exit 2; }
rm -f "$root.log"
cp /etc/resolv.conf /etc/hosts "$root/etc/"
find /etc/apt/apt.conf.d -name '99*' -exec cp {} "$root/etc/apt/apt.conf.d/" \;
mount -t proc proc "$root/proc"
mount --rbind /dev "$root/dev"
mount --make-rslave "$root/dev"
git clone --quiet --no-local . "$root/root/scree"

failed=0
for command in "$@"; do
	begin=$SECONDS
	result=passes
	chroot "$root" env -i HOME=/root TERM=dumb LANG=C.UTF-8 PATH=/usr/sbin:/usr/bin:/sbin:/bin \
		bash -c "cd /root/scree && $command" </dev/null || { result=FAILS; failed=1; }
	echo "$suite: $command $result in $((SECONDS - begin)) s"
done
exit $failed
