#!/usr/bin/env bash
# platforms.sh -- builds Scree for other processors and systems, runs it, and compares hashes with those of this machine.
#
# usage: tests/platforms.sh [ROW...]
#   ROW  a row of the table below; default: all
# A row compares the hashes of all scenes with tests/golden.txt for each number of lanes, and the hash of random programs
# with that of this machine; it checks that calls set the floating-point mode. The row "windows" also tests the DLL, the
# command line and all unit tests, in wine. Each row is printed as a line. Exit 1 if a row differs, cannot be built, or
# lacks its compiler or emulator. The rows "musl" and, where the kernel can run it, "i686" have no emulator.
#
# Variables:
#   PART=4               divisor of the steps of the scenes: 1 or 4, for which tests/golden.txt has hashes
#   LANES=...            numbers of lanes; default: 1 4, on x86-64 1 4 8 16
#   OPTIMIZE=...         level of optimization; default: -O1, on x86-64 -O3. gcc needs minutes for wider vectors than those of
#                        the processor, and for -O3.
#   PROGRAMS=20          number of random programs; 0 for none
#   CALLS=60             number of calls of a random program
#   UNITS=test_float_mode  unit tests that are built and run; empty for none
#   MISSING=install      missing packages: install, or skip for rows that are left out with a sentence and exit 77
#   BUILD=build/platforms  folder of the builds and their logs
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/usage.sh
part=${PART:-4} programs=${PROGRAMS:-20} calls=${CALLS:-60} units=${UNITS-test_float_mode}
missing=${MISSING:-install}
build=$(realpath -m "${BUILD:-build/platforms}")

# row, GNU name of the system, architecture in the names of Debian's packages, emulator, C flags
rows='
aarch64      aarch64-linux-gnu      arm64    qemu-aarch64
aarch64-lto  aarch64-linux-gnu      arm64    qemu-aarch64  -flto
armhf        arm-linux-gnueabihf    armhf    qemu-arm      -mfpu=neon-vfpv4
riscv64      riscv64-linux-gnu      riscv64  qemu-riscv64
ppc64le      powerpc64le-linux-gnu  ppc64el  qemu-ppc64le
s390x        s390x-linux-gnu        s390x    qemu-s390x    -march=z14
i686         i686-linux-gnu         i386     qemu-i386     -static -msse2 -mfpmath=sse
musl         here-linux-musl        -        -             -static
windows      x86_64-w64-mingw32     -        wine          -static
'

# Sets the variables of a row: target, emulator, flags, lanes, optimize, packages.
choose()
{
	local line debian
	line=$(grep "^$1 " <<<"$rows") ||
		{ echo "platforms.sh: there is no row $1; the rows are" $(awk '{ print $1 }' <<<"$rows") >&2; exit 2; }
	read -r _ target debian emulator flags <<<"$line"
	emulator=${emulator#-} target=${target/#here/$(uname -m)}
	lanes=${LANES:-1 4} optimize=${OPTIMIZE:--O1}
	[[ $target != x86_64* ]] || lanes=${LANES:-1 4 8 16} optimize=${OPTIMIZE:--O3}
	case $target in
	*musl) packages="musl-tools" ;;
	*mingw32) packages="gcc-mingw-w64-x86-64 wine wine64" ;;
	*) packages="gcc-$target libc6-dev-$debian-cross" ;;
	esac
	case $emulator in
	qemu*) emulator="$emulator -L /usr/$target" packages="$packages qemu-user" ;;
	esac
}

# Prints the program that a row lacks, if it lacks one.
lacking()
{
	local program
	for program in "$target-gcc" ${emulator%% *}; do
		command -v "$program" >/dev/null || { echo "$program"; return; }
	done
}

# configure FOLDER OPTION... : calls CMake for a build without OpenCL
configure()
{
	local folder=$1
	shift
	# without the kernels of one lane, some functions would be unused
	cmake -S . -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_C_FLAGS_RELEASE="$optimize -DNDEBUG" \
		-DSCREE_QUICK=ON -DSCREE_WERROR=OFF -DSCREE_OPENCL=OFF -DSCREE_BUILD_PEERS=OFF -DSCREE_INSTALL=OFF \
		-DSCREE_LANES="1;${lanes// /;}" "$@"
}

# Builds what a row needs, and prepares its emulator. -flto reaches the library only without the tool that makes names local
# (cmake/names.cmake).
build_row()
{
	local options=(-DSCREE_BUILD_SHARED=OFF) targets=(golden $units)
	[ "$programs" = 0 ] || targets+=(programs)
	[[ $flags != *-flto* ]] || options+=(-DCMAKE_OBJCOPY=)
	[ "$row" != windows ] || { options=(-DSCREE_BUILD_SHARED=ON -DSCREE_WERROR=ON) targets=(golden all); }
	configure "$folder" -DCMAKE_TOOLCHAIN_FILE="$PWD/cmake/cross.cmake" -DSCREE_TARGET="$target" \
		-DSCREE_EMULATOR="${emulator// /;}" -DCMAKE_C_FLAGS="$flags" "${options[@]}" &&
		ninja -j "$(nproc)" -C "$folder" "${targets[@]}" || return
	# creates the configuration folder of wine; otherwise the first programs, which run at the same time, both create it
	[ "$row" != windows ] || timeout 300 wine cmd /c exit
}

# scenes LANES: prints the number of scenes whose hashes are equal; 4 lanes have two threads
scenes()
{
	local threads=$((1 + ($1 == 4)))
	timeout 1500 $emulator "$folder/golden$end" "$1" $threads "$part" 2>"$folder.$1.err" |
		tr -d '\r' >"$folder.$1.hashes" || true
	grep -cxFf <(grep -v '^#' tests/golden.txt) "$folder.$1.hashes" || true
}

# compare WHAT FOUND EXPECTED: adds to the line of the row whether two texts are equal and not empty
compare()
{
	if [ -n "$2" ] && [ "$2" = "$3" ]; then
		line="$line, $1 equal"
	else
		line="$line, $1 differ"
		failed=1
	fi
}

# Runs the random programs of a build and prints the hash of the summary.
program_hash()
{
	$emulator "$1/tests/programs$end" --programs "$programs" --calls "$calls" --threads 2 --out "$1" 2>"$1.programs.err" |
		tee "$1.programs.log" | sed -n 's/.*, 0 failures, hash \([0-9a-f]*\),.*/\1/p'
}

# Runs the unit tests of a row and adds their results to its line.
unit_tests()
{
	local unit
	for unit in $units; do
		if timeout 600 $emulator "$folder/tests/$unit" >"$folder.$unit" 2>&1; then
			line="$line, $unit passed"
		else
			line="$line, $unit failed"
			failed=1
		fi
	done
}

# Prints the output of the command line, without the device and times.
scree_output() { "$@" 2>"$build/scree.err" | tr -d '\r' | grep -Ev '^(device|steps|ms/step| )'; }

# Compares a program that is linked with the DLL and the command line with those of this machine, and runs the unit tests.
windows()
{
	local command
	"$target-gcc" -std=c17 -O2 -Iinclude examples/hello.c "$folder/libscree.dll.a" -o "$folder/hello.exe" \
		>>"$folder.log" 2>&1 || true
	compare "hello.c with the DLL" "$(wine "$folder/hello.exe" 2>"$folder.dll.err" | tr -d '\r')" "$("$here/hello")"
	for command in "hash pond --steps 30" "run pile --steps 30" "scenes --names"; do
		# word splitting of $command is intended
		compare "scree $command" "$(scree_output wine "$folder/scree.exe" $command)" "$(scree_output "$here/scree" $command)"
	done
	ctest --test-dir "$folder" -L unit -j "$(nproc)" >"$folder.units" 2>&1 || failed=1
	line="$line, unit tests: $(sed -n 's/^\([0-9]*% tests passed, .*\)/\1/p' "$folder.units")"
}

chosen=("$@") failed=0
[ $# -gt 0 ] || mapfile -t chosen < <(awk 'NF { print $1 }' <<<"$rows")
wanted="gcc libc6-dev cmake ninja-build"
for row in "${chosen[@]}"; do
	choose "$row"
	wanted="$wanted $packages"
done
case $missing in
install) tools/packages.sh $(tr ' ' '\n' <<<"$wanted" | sort -u) ;;
skip)
	left=()
	for row in "${chosen[@]}"; do
		choose "$row"
		program=$(lacking)
		if [ -n "$program" ]; then
			echo "$row: skipped, because $program is not installed; Debian's packages are: $packages"
		else
			left+=("$row")
		fi
	done
	[ ${#left[@]} -gt 0 ] || exit 77
	chosen=("${left[@]}")
	;;
*) echo "platforms.sh: MISSING is $missing, must be install or skip" >&2; exit 2 ;;
esac
if ! tools/source.sh jansson build/sources/jansson; then
	echo "skipped: the sources of jansson, which a build for another system needs, cannot be fetched"
	[ "$missing" = skip ] && exit 77
	exit 1
fi
[[ -z "$units" && " ${chosen[*]} " != *" windows "* ]] || tools/source.sh cmocka build/sources/cmocka
mkdir -p "$build"
export SCREE_SCENES=$PWD/scenes WINEDEBUG=-all WINEPREFIX=$build/wine
here=$build/here all=$(($(grep -vc '^#' tests/golden.txt) / 2))
emulator= end= lanes="1 4" optimize=${OPTIMIZE:--O1}
# the build of this machine, whose results are the expected ones
targets=()
[ "$programs" = 0 ] || targets+=(programs)
[[ " ${chosen[*]} " != *" windows "* ]] || targets+=(scree_cli scree_static)
if [ ${#targets[@]} -gt 0 ]; then
	configure "$here" -DSCREE_BUILD_SHARED=OFF >"$here.log" 2>&1 &&
		ninja -j "$(nproc)" -C "$here" "${targets[@]}" >>"$here.log" 2>&1 || { tail -n 20 "$here.log"; exit 1; }
fi
[ "$programs" = 0 ] || expected=$(program_hash "$here")
[[ " ${chosen[*]} " != *" windows "* ]] ||
	gcc -std=c17 -O2 -Iinclude examples/hello.c "$here/libscree.a" -lm -lpthread -ldl -o "$here/hello"

for row in "${chosen[@]}"; do
	choose "$row"
	start=$SECONDS folder=$build/$row end= line= counts=
	[ "$row" != windows ] || end=.exe
	program=$(lacking)
	[ -z "$program" ] || { echo "$row: $program is not installed; Debian's packages are: $packages"; failed=1; continue; }
	build_row >"$folder.log" 2>&1 ||
		{ echo "$row: cannot be built: $folder.log"; grep -E 'error:|undefined|CMake Error' "$folder.log" | head -n 5; failed=1; continue; }
	built=$SECONDS
	[ "$row" != i686 ] || ! "$folder/golden" 2>&1 | grep -q usage || emulator=
	# two numbers of lanes at a time
	export -f scenes
	export folder end emulator part
	for count in $lanes; do
		echo "$count"
	done | xargs -P "$(nproc)" -I '{}' bash -c 'scenes {} >"$folder.{}.equal"'
	for count in $lanes; do
		counts="$counts $count: $(cat "$folder.$count.equal")/$all"
		[ "$(cat "$folder.$count.equal")" != "$all" ] || continue
		failed=1
		cat "$folder.$count.err"
		grep -vxFf <(grep -v '^#' tests/golden.txt) "$folder.$count.hashes" | sed "s/^/$row, $count lanes, differs: /" || true
	done
	[ "$programs" = 0 ] || compare "$programs programs" "$(program_hash "$folder")" "$expected"
	if [ "$row" = windows ]; then
		windows
	else
		unit_tests
	fi
	echo "$row: scenes by lanes$counts$line; built in $((built - start)) s, run in $((SECONDS - built)) s"
done
exit $failed
