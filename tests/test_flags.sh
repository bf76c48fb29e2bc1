#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# test_flags.sh -- checks that careless compiler flags leave the same bits or are refused with a sentence.
#
# It checks that every file of src/ and scene/ refuses -ffast-math; that public functions set the floating-point mode; that
# each flag is refused, undone, or found by the self-test; that the built libraries have no fused instructions. In make
# test-full it also builds Scree as part of other projects that set flags, and compares the hashes of all scenes.
set -euo pipefail
scratch=$SCREE_BUILD/flags_test
rm -rf "$scratch"
mkdir -p "$scratch"
trap 'rm -rf "$scratch"' EXIT
cd "$SCREE_SOURCE"
failed=0
complain()
{
	echo "$*"
	failed=1
}
machine=$(uname -m)
includes=(-Iinclude -Isrc -I. -D_GNU_SOURCE= -DSCREE_LANES=1 -Wno-psabi)

# ----- every file refuses -ffast-math -----

options=("${includes[@]}" -DSCREE_NO_OPENCL -DSCREE_SCENE_DIR='""' -DSCREE_INSTALLED_SCENE_DIR='""')
find src scene -name '*.c' | sort >"$scratch/files"
xargs -P "$(nproc)" -I{} sh -c '"$@" -E {} 2>&1 >/dev/null | sed "s#^#{} #"' sh \
	gcc -std=c17 "${options[@]}" -ffast-math -Wfatal-errors <"$scratch/files" >"$scratch/log"
grep 'error.*scree: -ffast-math' "$scratch/log" | cut -d' ' -f1 | sort | comm -23 "$scratch/files" - >"$scratch/careless"
[ ! -s "$scratch/careless" ] ||
	complain "these files accept -ffast-math; they must include platform/exact_floats.h:" $(<"$scratch/careless")
[ "$(wc -l <"$scratch/files")" -gt 150 ] || complain "only $(wc -l <"$scratch/files") files were found"

# ----- every public function that has a status or calls a driver enters the library's floating-point mode -----

awk '/^(scree_status scree_|void scree_world_(destroy|unshare)|const char\* scree_opencl_hint)/ {
		match($0, /scree_[a-z0-9_]+\(/); name = substr($0, RSTART, RLENGTH - 1) }
	name && $0 == "{" { getline; if ($0 != "\tFLOAT_MODE_HERE;") print name; name = "" }
	/;$/ { name = "" }' src/api/*/*.c >"$scratch/modeless"
[ ! -s "$scratch/modeless" ] || complain "these functions do not begin with FLOAT_MODE_HERE:" $(<"$scratch/modeless")

# ----- each flag is refused, undone or found -----

# The library that the operations are linked with has the right flags.
for file in src/cpu/self_test.c src/cpu/self_test_host.c src/platform/error.c src/platform/processor.c; do
	gcc -std=c17 -O2 -ffp-contract=off "${includes[@]}" -c "$file" -o "$scratch/$(basename "$file" .c).o"
done
gcc -std=c17 -O2 -ffp-contract=off "${includes[@]}" -DLANES=1 -DSELF_TEST=self_test_lanes1 -xc -c - -o "$scratch/lanes1.o" \
	<<<'#include "cpu/self_test_lanes.h"'
ar rcs "$scratch/right.a" "$scratch"/*.o

# run_operations COMPILER LANES FLAG...: prints the sentence of a refusal, or the fault that the self-test finds
run_operations()
{
	local compiler=$1 lanes=$2
	shift 2
	if "$compiler" -std=gnu17 -O2 -ftree-vectorize "${includes[@]}" -DLANES="$lanes" "$@" tests/tools/wrong_flags.c "$scratch/right.a" -lm \
		-o "$scratch/operations" >"$scratch/log" 2>&1; then
		"$scratch/operations"
	else
		grep -m1 'error' "$scratch/log" | sed -E 's/.*error: *//; s/^(#error|static assertion failed:?|static_assert failed) *//; s/"//g'
	fi
}

# row COMPILER FOUND FLAG...: without the checks of exact_floats.h, the self-test finds FOUND, a pattern; with them, the
# flags are refused with a sentence, or there is no fault. Some flags of clang leave no trace, so only the self-test
# refuses them.
row()
{
	local compiler=$1 found=$2 result
	shift 2
	command -v "$compiler" >/dev/null || { echo "$compiler $*: left out, because $compiler is not installed"; return 0; }
	for lanes in $tested_lanes; do
		result=$(run_operations "$compiler" "$lanes" -DEXACT_FLOATS_H "$@")
		grep -qE "$found" <<<"$result" || complain "$compiler, $lanes lanes, $*: found \"$result\" instead of \"$found\""
	done
	result=$(run_operations "$compiler" 1 "$@")
	case $result in
	"no fault") result=same ;;
	scree:*) result=refused ;;
	*)
		[ "$compiler" = clang ] && grep -qE "$found" <<<"$result" ||
			complain "$compiler $*: neither refused nor the same: $result"
		result="refused when a world is created"
		;;
	esac
	echo "$compiler $*: $result"
}

tested_lanes="1 4" levels="-march=x86-64-v3 -march=x86-64-v4"
[ "$SCREE_QUICK" != 1 ] || tested_lanes=1 levels=-march=x86-64-v4
for compiler in gcc clang; do
	row $compiler 'signs of zeros' -ffast-math
	row $compiler 'signs of zeros' -funsafe-math-optimizations
	row $compiler 'reciprocal' -freciprocal-math
	row $compiler 'NaN' -ffinite-math-only
	row $compiler 'signs of zeros' -fno-signed-zeros
	[ "$machine" != x86_64 ] || row $compiler 'one rounding' -march=x86-64-v3 -ffp-contract=fast
	[ "$SCREE_QUICK" != 1 ] || continue
	row $compiler 'no fault' -ffp-contract=off
	row $compiler 'signs of zeros' -Ofast
	row $compiler 'signs of zeros' -fassociative-math -fno-signed-zeros -fno-trapping-math
	row $compiler 'no fault' -frounding-math
	row $compiler 'no fault' -O0
	[ "$machine" != x86_64 ] || row $compiler 'one rounding' -mfma -ffp-contract=fast
done
if [ "$machine" = x86_64 ]; then
	# gcc 12 fuses in spite of -ffp-contract=off
	row gcc 'one rounding|no fault' -mfma -ffp-contract=off
	grep -q '^scree: floats are computed with excess precision' <<<"$(run_operations gcc 1 -mfpmath=387)" ||
		complain "gcc -mfpmath=387 is not refused"
fi
grep -q '^scree: -fsingle-precision-constant' <<<"$(run_operations gcc 1 -fsingle-precision-constant)" ||
	complain "gcc -fsingle-precision-constant is not refused"

# ----- no fused instructions -----

# fused OBJDUMP FILE...: prints the number of instructions that compute a * b + c, of x86 and ARM64
fused()
{
	"$1" -d --no-show-raw-insn "${@:2}" | grep -cE '[[:space:]](v4?fc?n?m(add|sub)[a-z0-9]*|fn?m(add|sub)|fml[as]l?2?|fcmla)[[:space:]]' || true
}

# files that gcc 12 or clang would fuse, and the function that proves that fused finds something
sources=(src/cpu/self_test_host.c src/api/query/shape_query.c scene/evaluate_joints.c)
check_fused()
{
	local compiler=$1 dump=$2 file number
	shift 2
	command -v "$compiler" >/dev/null || return 0
	"$compiler" -O3 "$@" -ffp-contract=fast -xc -c - -o "$scratch/fused.o" <<<'float f(float a, float b, float c) { return a * b + c; }'
	[ "$(fused "$dump" "$scratch/fused.o")" = 1 ] || complain "$compiler $*: the search finds no fused instruction"
	for file in "${sources[@]}"; do
		"$compiler" -std=gnu17 -O3 "${options[@]}" "$@" -c "$file" -o "$scratch/fused.o"
		number=$(fused "$dump" "$scratch/fused.o")
		[ "$number" = 0 ] || complain "$compiler $*: $file has $number fused instructions"
	done
}
if [ "$machine" = x86_64 ]; then
	for compiler in gcc clang; do
		for level in $levels; do
			check_fused $compiler objdump "$level"
		done
	done
fi
check_fused aarch64-linux-gnu-gcc aarch64-linux-gnu-objdump -march=armv8.3-a
for built in "$SCREE_BUILD/libscree.a" "$SCREE_BUILD/libscree.so" "$SCREE_BINARY"; do
	[ -e "$built" ] || continue
	number=$(fused objdump "$built")
	[ "$number" = 0 ] || complain "$built has $number fused instructions"
done

# ----- each language gets the flags of its own compiler -----

if command -v clang >/dev/null && command -v g++ >/dev/null; then
	cmake -S . -B "$scratch/mixed" -G Ninja -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=g++ -DSCREE_BUILD_TESTS=OFF \
		-DCMAKE_EXPORT_COMPILE_COMMANDS=ON >"$scratch/log" 2>&1 || complain "clang with g++: $(<"$scratch/log")"
	commands=$(grep '"command"' "$scratch/mixed/compile_commands.json")
	grep -q 'clang.*-fdenormal-fp-math=ieee' <<<"$commands" || complain "clang with g++: clang lacks -fdenormal-fp-math"
	if grep 'g++' <<<"$commands" | grep -q 'fdenormal'; then
		complain "clang with g++: g++ gets -fdenormal-fp-math, which it refuses"
	fi
fi

# ----- projects that set flags -----

cat >"$scratch/CMakeLists.txt" <<'CMAKE'
cmake_minimum_required(VERSION 3.22)
project(careless C)
separate_arguments(flags UNIX_COMMAND "$ENV{CARELESS}")
add_compile_options(${flags})
set(SCREE_BUILD_CLI ON)
set(SCREE_OPENCL OFF)
add_subdirectory($ENV{SCREE_SOURCE} scree)
CMAKE

# project COMPILER FLAGS: all scenes have the hashes of tests/golden.txt, and their program has no fused instructions
project()
{
	local compiler=$1 flags=$2 build=$scratch/project lanes equal all number
	command -v "$compiler" >/dev/null || return 0
	CARELESS=$flags cmake -S "$scratch" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_C_COMPILER="$compiler" \
		-DCMAKE_C_FLAGS="$flags" -DCMAKE_C_FLAGS_RELEASE="-O3 -DNDEBUG $flags" >"$scratch/log" 2>&1 &&
		cmake --build "$build" --target golden >>"$scratch/log" 2>&1 ||
		{ complain "$compiler $flags: $(grep -m1 error "$scratch/log")"; return; }
	all=$(($(grep -vc '^#' tests/golden.txt) / 2))
	for lanes in 1 4 8 16; do
		SCREE_SCENES=$SCREE_SOURCE/scenes "$build/scree/golden" "$lanes" 1 4 >"$scratch/hashes" 2>"$scratch/log" ||
			{ grep -q 'lanes' "$scratch/log" && continue; }
		equal=$(grep -cxFf tests/golden.txt "$scratch/hashes") || true
		[ "$equal" = "$all" ] || complain "$compiler $flags, $lanes lanes: $equal of $all hashes are equal; $(<"$scratch/log")"
	done
	number=$(fused objdump "$build/scree/golden")
	[ "$number" = 0 ] || complain "$compiler $flags: $number fused instructions"
	echo "project, $compiler $flags: same"
	rm -rf "$build"
}

if [ "$SCREE_QUICK" != 1 ]; then
	project gcc "-ffast-math"
	project gcc "-Ofast -funsafe-math-optimizations -ffinite-math-only -fno-signed-zeros -freciprocal-math"
	project gcc "-O0"
	project clang "-ffast-math -fassociative-math -freciprocal-math"
	if [ "$machine" = x86_64 ]; then
		project gcc "-march=native -ffp-contract=fast -flto"
		project gcc "-mfma -flto -frounding-math -funroll-loops -fno-strict-aliasing"
		project gcc "-mfpmath=387 -O1"
		project clang "-march=native -ffp-contract=fast -Os"
	fi
fi
exit $failed
