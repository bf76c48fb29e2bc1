#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# test_one_file.sh -- writes the library as one file, scree_all.c, and compiles it with gcc and clang: without warnings, with no
# global names but scree_*, with the hash of the library. Wrong options are refused. make test-full also compares the hashes of all
# scenes.
set -euo pipefail
scratch=$SCREE_BUILD/one_file_test
rm -rf "$scratch"
mkdir -p "$scratch"
trap 'rm -rf "$scratch"' EXIT
"$SCREE_SOURCE/tools/one_file.sh" "$scratch"
cd "$scratch"

complain()
{
	echo "$*"
	exit 1
}

# refused SENTENCE COMPILER FLAG...
refused()
{
	local sentence=$1
	shift
	if "$@" -I. -fsyntax-only scree_all.c 2>log; then
		complain "$*: is accepted"
	fi
	grep -q "error.*$sentence" log || complain "$*: $(head -n 3 log)"
}
refused 'scree: SCREE_LANES must be' gcc -DSCREE_LANES=2 -fmax-errors=1
refused 'scree: SCREE_LANES must be' gcc -DSCREE_LANES=8 -fmax-errors=1
refused 'scree: -ffast-math' gcc -ffast-math -fmax-errors=1
refused 'scree: -ffast-math' gcc -Ofast -fmax-errors=1

# hash_of COMPILER FLAG...: builds hello with scree_all.c, and prints its hash
hash_of()
{
	"$@" -I. -c scree_all.c -o scree_all.o || complain "$*: does not compile"
	local strangers
	strangers=$(nm -g --defined-only scree_all.o | awk '{ print $3 }' | grep -v '^scree_' || true)
	[ -z "$strangers" ] || complain "$*: scree_all.o has the global names" $strangers
	"$1" -std=c17 -I. "$SCREE_SOURCE/examples/hello.c" scree_all.o -lm -lpthread -o hello
	./hello | sed 's/.*hash //'
}

cc -std=c17 -I. "$SCREE_SOURCE/examples/hello.c" "$SCREE_BUILD/libscree.a" -lm -lpthread -ldl -o expected
expected=$(./expected | sed 's/.*hash //')

# check COMPILER LANES FLAG...: hello and the scenes, for each number of lanes in LANES, have the hashes of the library
check()
{
	command -v "$1" >/dev/null || { echo "$1: left out, because it is not installed"; return; }
	local compiler=$1 lanes=$2 found all equal
	shift 2
	found=$(hash_of "$compiler" "$@" -Wall -Wextra -Werror) || complain "$found"
	[ "$found" = "$expected" ] || complain "$compiler $*: the hash is $found, not $expected"
	echo "$compiler $*: $(size scree_all.o | awk 'NR == 2 { print $1 }') bytes of code, same hash"
	# the reader of scenes is not a part of the library
	[ -e "$SCREE_BUILD/libscree_scene_internals.a" ] || return 0
	$compiler -std=c17 -D_GNU_SOURCE= -DSCREE_SCENE_DIR='""' "-I$SCREE_SOURCE/include" "-I$SCREE_SOURCE/src" "-I$SCREE_SOURCE" \
		"$SCREE_SOURCE/tests/tools/golden.c" scree_all.o "$SCREE_BUILD/libscree_scene_internals.a" "$SCREE_BUILD/libscree_common.a" \
		"$SCREE_BUILD/libscree_internals.a" -ljansson -lcairo -lm -lpthread -ldl -o golden
	all=$(($(grep -vc '^#' "$SCREE_SOURCE/tests/golden.txt") / 2))
	for number in $lanes; do
		SCREE_SCENES=$SCREE_SOURCE/scenes ./golden "$number" 1 4 >hashes 2>log || { grep -q 'lanes' log && continue; }
		equal=$(grep -cxFf "$SCREE_SOURCE/tests/golden.txt" hashes) || true
		[ "$equal" = "$all" ] ||
			complain "$compiler $*, $number lanes: $equal of $all hashes are equal; $(grep -vxFf "$SCREE_SOURCE/tests/golden.txt" hashes); $(<log)"
		echo "$compiler $*, $number lanes: $equal scenes, same hashes"
	done
}

check gcc 1 -std=c17 -O1 -DSCREE_LANES=1
[ "$SCREE_QUICK" != 1 ] || exit 0
check clang "1 4" -std=gnu17 -Os -DSCREE_LANES=5
check gcc "1 4" -std=c17 -O0 -DSCREE_LANES=5
check clang "1 4 8 16" -std=gnu17 -O2
check gcc "1 4 8 16" -std=gnu17 -O2 -march=native
