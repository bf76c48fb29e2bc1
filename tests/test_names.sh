#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# test_names.sh -- builds the static libraries in three ways, and checks that a program may define every name that does not
# begin with scree_.
set -euo pipefail
scratch=$SCREE_BUILD/names_test
rm -rf "$scratch"
mkdir -p "$scratch"
trap 'rm -rf "$scratch"' EXIT

# a program that defines names of internal functions of the library
cat >"$scratch/game.c" <<'C'
#include <scree/scree.h>
#include <stdio.h>
int fail(void) { return 1; }
int launch(void) { return 2; }
int grow(void) { return 3; }
int finish(void) { return 4; }
int world_create(void) { return 5; }
int opencl = 6;
float vec_distance(scree_vec a, scree_vec b) { return a.x - b.x; }
int main(void)
{
	scree_world_def def = scree_world_def_default();
	scree_world* world;
	def.device = "cpu";
	if (scree_world_create(&def, &world) != SCREE_OK)
		return 1;
	scree_world_destroy(world);
	printf("%d\n", fail() + launch() + grow() + finish() + world_create() + opencl);
	return 0;
}
C

# check NAME COMPILER FLAGS OPTION...: builds the library and checks its names; for one number of lanes only, because
# this saves time and leaves out no name
check()
{
	local name=$1 compiler=$2 flags=$3 build=$scratch/$1 strangers
	shift 3
	command -v "$compiler" >/dev/null || { echo "$name: left out, because there is no $compiler"; return; }
	cmake -S "$SCREE_SOURCE" -B "$build" -G Ninja -DCMAKE_C_COMPILER="$compiler" -DCMAKE_C_FLAGS="$flags" -DSCREE_LANES=1 \
		-DSCREE_BUILD_CLI=OFF -DSCREE_BUILD_TESTS=OFF -DSCREE_BUILD_PEERS=OFF -DSCREE_BUILD_SHARED=OFF "$@" >"$build.log" 2>&1 &&
		cmake --build "$build" --target $targets >>"$build.log" 2>&1 || { tail -n 30 "$build.log"; exit 1; }
	strangers=$(nm -g --defined-only "$build/libscree.a" | awk 'NF == 3 { print $3 }' | grep -v '^scree_' || true)
	[ -z "$strangers" ] || { echo "$name: libscree.a has the global names" $strangers; exit 1; }
	if [ -f "$build/libscree_scene.a" ]; then
		strangers=$(nm -g --defined-only "$build/libscree_scene.a" | awk 'NF == 3 { print $3 }' | grep -v '^scree_scene_' || true)
		[ -z "$strangers" ] || { echo "$name: libscree_scene.a has the global names" $strangers; exit 1; }
	fi
	if [ -f "$build/libscree_mpi.a" ]; then
		strangers=$(nm -g --defined-only "$build/libscree_mpi.a" | awk 'NF == 3 { print $3 }' | grep -v '^scree_mpi_' || true)
		[ -z "$strangers" ] || { echo "$name: libscree_mpi.a has the global names" $strangers; exit 1; }
	fi
	"$compiler" -std=c17 $flags -I "$SCREE_SOURCE/include" "$scratch/game.c" "$build/libscree.a" -lm -lpthread -ldl -o "$build/game"
	[ "$("$build/game")" = 21 ] || { echo "$name: the program prints something else"; exit 1; }
	echo "$name: $(nm -g --defined-only "$build/libscree.a" | grep -c ' scree_') names, all scree_*"
}

# the library of scene files is built if Jansson is installed
targets=scree_static
pkg-config --exists jansson && targets="scree_static scree_scene_static"
# so is the library for MPI
command -v mpicc >/dev/null && targets="$targets scree_mpi_static"
check debug clang "-O0" -DCMAKE_BUILD_TYPE=Debug
check lto gcc "-O0 -flto" -DCMAKE_BUILD_TYPE=None -DCMAKE_INTERPROCEDURAL_OPTIMIZATION=ON
check lto_clang clang "-O0 -flto" -DCMAKE_BUILD_TYPE=None
