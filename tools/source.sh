#!/bin/sh
# source.sh -- unpacks the upstream sources of a Debian source package. If the folder exists, it is not changed.
#
# usage: tools/source.sh PACKAGE FOLDER
# Debian does not build its packages for WebAssembly or Windows, so they are compiled from these sources. apt fetches and checks the sources.
# Its package lists are in a temporary folder: the lists of the system do not change, and root is not needed.
set -eu
. "$(dirname "$0")/usage.sh"
package=${1:?is the name of the source package} folder=${2:?is the folder for the sources}
[ ! -d "$folder" ] || exit 0
if ! command -v apt-get >/dev/null 2>&1; then
	echo "scree: this is not Debian, so unpack the sources of $package into $folder, then try again" >&2
	exit 1
fi

echo "scree: fetching the sources of $package"
mkdir -p "$(dirname "$folder")"
work=$(mktemp -d "$(dirname "$(realpath "$folder")")/fetch.XXXXXX")
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/parts" "$work/lists" "$work/cache"
# sources are fetched from the servers that the system uses for packages
for list in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
	[ ! -f "$list" ] || sed -n 's/^deb\(-src\)\{0,1\}[[:space:]]/deb-src /p' "$list" >>"$work/parts/system.list"
done
for list in /etc/apt/sources.list.d/*.sources; do
	[ ! -f "$list" ] || sed 's/^Types:.*/Types: deb-src/' "$list" >"$work/parts/$(basename "$list")"
done
fetch()
{
	(cd "$work" && apt-get -q -o Dir::Etc::SourceList="$work/none" -o Dir::Etc::SourceParts="$work/parts" \
		-o Dir::State::Lists="$work/lists" -o Dir::Cache="$work/cache" "$@") >"$work/log" 2>&1 </dev/null
}
if ! fetch update || ! fetch source --download-only "$package"; then
	tail -n 5 "$work/log" >&2
	echo "scree: apt-get could not fetch the sources of $package (no network?)" >&2
	exit 1
fi
mkdir "$work/unpacked"
rm -f "$work/$package"_*.orig.tar.*.asc # the signature of the archive
tar -xf "$work/$package"_*.orig.tar.* -C "$work/unpacked" --strip-components=1
mv "$work/unpacked" "$folder"
