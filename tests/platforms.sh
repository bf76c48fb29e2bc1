#!/usr/bin/env bash
# platforms.sh -- builds Scree for other processors and systems, runs the builds by emulators, and compares the hashes of all scenes
# and of random programs with those of this machine.
#
# usage: tests/platforms.sh [ROW...]
#   ROW  a row of the table below; default: all
# Variables and their defaults: PART (4), by which the steps of the scenes are divided, as in tests/golden.txt: 1 or 4; PROGRAMS (40)
# and CALLS (60) of the random programs; BUILD (build/platforms), the folder of the builds. It prints one line per row: hashes that
# equal tests/golden.txt for each number of lanes, the random programs, and the time. Exit 1 if a hash differs.
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/usage.sh
part=${PART:-4} programs=${PROGRAMS:-40} calls=${CALLS:-60} build=${BUILD:-build/platforms}

# row: GNU name of the target: emulator: C flags: Debian packages
rows='aarch64: aarch64-linux-gnu: qemu-aarch64 -L /usr/aarch64-linux-gnu: : gcc-aarch64-linux-gnu libc6-dev-arm64-cross qemu-user
aarch64-lto: aarch64-linux-gnu: qemu-aarch64 -L /usr/aarch64-linux-gnu: -flto: gcc-aarch64-linux-gnu libc6-dev-arm64-cross qemu-user
armhf: arm-linux-gnueabihf: qemu-arm -L /usr/arm-linux-gnueabihf: -mfpu=neon-vfpv4: gcc-arm-linux-gnueabihf libc6-dev-armhf-cross qemu-user
riscv64: riscv64-linux-gnu: qemu-riscv64 -L /usr/riscv64-linux-gnu: : gcc-riscv64-linux-gnu libc6-dev-riscv64-cross qemu-user
ppc64le: powerpc64le-linux-gnu: qemu-ppc64le -L /usr/powerpc64le-linux-gnu: : gcc-powerpc64le-linux-gnu libc6-dev-ppc64el-cross qemu-user
s390x: s390x-linux-gnu: qemu-s390x -L /usr/s390x-linux-gnu: : gcc-s390x-linux-gnu libc6-dev-s390x-cross qemu-user
i686: i686-linux-gnu: qemu-i386 -L /usr/i686-linux-gnu: -msse2 -mfpmath=sse: gcc-i686-linux-gnu libc6-dev-i386-cross qemu-user
musl: x86_64-linux-musl: : -static: musl-tools
windows: x86_64-w64-mingw32: wine: -static: gcc-mingw-w64-x86-64 wine'

chosen=("$@")
[ $# -gt 0 ] || mapfile -t chosen < <(cut -d: -f1 <<<"$rows")
tools/source.sh jansson build/sources/jansson
tools/packages.sh gcc libc6-dev cmake ninja-build
mkdir -p "$build"
export SCREE_SCENES=$PWD/scenes WINEDEBUG=-all

# The random programs of this machine; hash_of prints the hash of a summary.
hash_of() { sed -n 's/.*, hash \([0-9a-f]*\),.*/\1/p'; }
cmake -S . -B "$build/here" -G Ninja -DCMAKE_BUILD_TYPE=Release -DSCREE_OPENCL=OFF -DSCREE_BUILD_SHARED=OFF >"$build/here.log" 2>&1
ninja -C "$build/here" programs >>"$build/here.log" 2>&1 || { tail -n 20 "$build/here.log"; exit 1; }
expected=$("$build/here/tests/programs" --programs "$programs" --calls "$calls" | hash_of)

failed=0
for row in "${chosen[@]}"; do
	IFS=: read -r name target emulator flags packages < <(grep "^$row:" <<<"$rows" | sed 's/: */:/g') ||
		{ echo "platforms.sh: no row is called $row" >&2; exit 2; }
	start=$SECONDS folder=$build/$name
	# word splitting of $packages and $emulator is intended
	tools/packages.sh $packages
	cmake -S . -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_TOOLCHAIN_FILE="$PWD/cmake/cross.cmake" -DSCREE_WERROR=ON \
		-DSCREE_TARGET="$target" -DSCREE_EMULATOR="${emulator// /;}" -DCMAKE_C_FLAGS="$flags" -DSCREE_OPENCL=OFF -DSCREE_INSTALL=OFF \
		-DSCREE_BUILD_SHARED="$([ "$name" = windows ] && echo ON || echo OFF)" >"$folder.log" 2>&1 &&
		ninja -C "$folder" golden all >>"$folder.log" 2>&1 ||
		{ echo "$name: cannot be built:"; grep -E 'error|undefined' "$folder.log" | head -n 5; failed=1; continue; }
	end= result=
	[ "$name" != windows ] || end=.exe
	for lanes in 1 4 8 16; do
		timeout 900 $emulator "$folder/golden$end" "$lanes" 2 "$part" 2>"$folder.err" | tr -d '\r' >"$folder.hashes" || true
		equal=$(grep -cxFf tests/golden.txt "$folder.hashes") || true
		all=$(($(grep -vc '^#' tests/golden.txt) / 2))
		[ "$equal" = "$all" ] || { failed=1; cat "$folder.err"; }
		result="$result $equal/$all"
	done
	if [ -e "$folder/tests/programs" ]; then
		found=$(timeout 900 $emulator "$folder/tests/programs" --programs "$programs" --calls "$calls" 2>"$folder.err" | hash_of) || true
		[ "$found" = "$expected" ] || { failed=1; cat "$folder.err"; }
		result="$result, $programs programs $([ "$found" = "$expected" ] && echo equal || echo differ)"
	fi
	echo "$name: scenes with 1, 4, 8, 16 lanes$result, $((SECONDS - start)) s"
done
exit $failed
