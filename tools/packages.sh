#!/bin/sh
# packages.sh -- installs missing Debian packages.
#
# usage: tools/packages.sh PACKAGE...
set -eu
. "$(dirname "$0")/usage.sh"

if ! command -v dpkg-query >/dev/null 2>&1; then
	# not Debian: continues if cmake and ninja are there, because CMake reports all other missing packages
	if ! command -v cmake >/dev/null 2>&1 || ! command -v ninja >/dev/null 2>&1; then
		echo "scree: this is not Debian, so install the software of these Debian packages, then try again: $*" >&2
		exit 1
	fi
	exit 0
fi

missing=
for package in "$@"; do
	case $(dpkg-query -W -f '${Status}' "$package" 2>/dev/null || true) in
	*" installed") ;;
	*) missing="$missing $package" ;;
	esac
done
[ -n "$missing" ] || exit 0

if [ "$(id -u)" -eq 0 ]; then
	as_root=
elif command -v sudo >/dev/null 2>&1; then
	as_root=sudo
else
	echo "scree: packages are missing, and only root can install them; sudo was not found. As root: apt-get install$missing" >&2
	exit 1
fi

echo "scree: installing$missing"
log=$(mktemp)
trap 'rm -f "$log"' EXIT
install_missing()
{
	# word splitting of $as_root and $missing is intended
	$as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $missing >"$log" 2>&1 </dev/null
}
# the package lists are fetched only if the first attempt fails, because they may be recent enough
if ! install_missing; then
	$as_root apt-get update >"$log" 2>&1 </dev/null || true
	if ! install_missing; then
		tail -n 5 "$log" >&2
		echo "scree: apt-get could not install the packages (no network?). As root: apt-get update; apt-get install$missing" >&2
		exit 1
	fi
fi
