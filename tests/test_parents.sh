#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# test_parents.sh -- builds Scree as part of other projects: their flags and variables leave the same hash, their warnings do not
# reach its sources, and wrong options are refused with a sentence.
set -euo pipefail
scratch=$SCREE_BUILD/parents_test
rm -rf "$scratch"
mkdir -p "$scratch"
trap 'rm -rf "$scratch"' EXIT

complain()
{
	echo "$*"
	exit 1
}

# ----- options that are refused -----

for lanes in 2 "1;3" 32; do
	if cmake -S "$SCREE_SOURCE" -B "$scratch/lanes" -G Ninja -DSCREE_LANES="$lanes" -DSCREE_BUILD_TESTS=OFF -DSCREE_BUILD_CLI=OFF \
		>"$scratch/log" 2>&1; then
		complain "SCREE_LANES=$lanes is accepted"
	fi
	tr -s ' \n' '  ' <"$scratch/log" | grep -qF "SCREE_LANES is \"$lanes\", must be a list of 1, 4, 8 and 16" ||
		complain "SCREE_LANES=$lanes: $(<"$scratch/log")"
done

# ----- projects -----

cat >"$scratch/CMakeLists.txt" <<'CMAKE'
cmake_minimum_required(VERSION 3.22)
project(parent C CXX)
include(CTest)
separate_arguments(flags UNIX_COMMAND "$ENV{FLAGS}")
add_compile_options(${flags})
add_link_options(${flags})
set(SCREE_OPENCL OFF)
add_subdirectory($ENV{SCREE_SOURCE} scree)
add_executable(hello game.cpp)
target_link_libraries(hello PRIVATE scree::scree)
if(BUILD_TESTING AND TARGET programs)
	message(FATAL_ERROR "the tests of Scree are part of the parent project")
endif()
CMAKE
# hello.c as C++, with functions that have names of internal functions
{
	cat "$SCREE_SOURCE/examples/hello.c"
	echo 'extern "C" { void launch(int x) { (void)x; } int grow = 1; float vec_distance(float x) { return x; } }'
} >"$scratch/game.cpp"

# hash_of PROGRAM: the hash that hello prints
hash_of()
{
	"$1" | sed 's/.*hash //'
}
cc -std=c17 -I "$SCREE_SOURCE/include" "$SCREE_SOURCE/examples/hello.c" "$SCREE_BUILD/libscree.a" -lm -lpthread -ldl -o "$scratch/expected"
expected=$(hash_of "$scratch/expected")

# parent NAME COMPILER FLAGS OPTION...: the project builds, and its program prints the expected hash
parent()
{
	local name=$1 compiler=$2 flags=$3 build=$scratch/$1 found cxx=clang++
	shift 3
	[ "$compiler" = clang ] || cxx=g++
	command -v "$compiler" >/dev/null || { echo "$name: left out, because there is no $compiler"; return; }
	FLAGS=$flags cmake -S "$scratch" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_C_COMPILER="$compiler" \
		-DCMAKE_CXX_COMPILER=$cxx -DSCREE_LANES="1;4" "$@" >"$build.log" 2>&1 &&
		cmake --build "$build" --target hello >>"$build.log" 2>&1 || { tail -n 30 "$build.log"; complain "$name does not build"; }
	grep -q 'warning:' "$build.log" && complain "$name: $(grep -m1 'warning:' "$build.log")"
	found=$(hash_of "$build/hello")
	[ "$found" = "$expected" ] || complain "$name: the hash is $found, not $expected"
	echo "$name, $compiler $flags $*: same"
	[ "$name" != shared ] || objdump -p "$build/hello" | grep -q 'NEEDED.*libscree' || complain "BUILD_SHARED_LIBS is ignored"
	rm -rf "$build"
}

parent shared gcc "-Wall -Wextra -Werror -Wconversion -Wpedantic -ffast-math" -DBUILD_SHARED_LIBS=ON -DCMAKE_UNITY_BUILD=ON
[ "$SCREE_QUICK" != 1 ] || exit 0
parent warnings clang "-Wall -Wextra -Wconversion -Wshadow -Wpedantic -Werror" -DCMAKE_C_FLAGS=-Weverything
parent static gcc "-pedantic-errors -Wall -Wextra -Wconversion -Werror" -DBUILD_TESTING=OFF
parent sanitized gcc "-O1 -fsanitize=address,undefined"
parent interprocedural gcc "-O2" -DCMAKE_INTERPROCEDURAL_OPTIMIZATION=ON
parent lto_clang clang "-flto -O1"
parent debug gcc "-O0 -g -ftrapv -funsigned-char"
parent unity gcc "-Os -ffunction-sections -fdata-sections -fshort-enums" -DCMAKE_UNITY_BUILD=ON
parent contract gcc "-march=native -ffp-contract=fast -funsafe-math-optimizations"
